#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""check_report.py finds what it must find."""
import json
import struct
import tempfile
import unittest
import zlib
from pathlib import Path

import check_report


def write_png(path, rows):
    """Rows of grey levels, as a PNG whose rows have all the filters in turn."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    packed, above = b"", [0] * len(rows[0])
    for y, row in enumerate(rows):
        kind = y % 5
        packed += bytes([kind])
        for x, value in enumerate(row):
            a, b, c = (row[x - 1] if x else 0), above[x], (above[x - 1] if x else 0)
            paeth = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            packed += bytes([(value - [0, a, b, (a + b) // 2, paeth][kind]) & 255])
        above = row
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0))
        + chunk(b"IDAT", zlib.compress(packed)) + chunk(b"IEND", b""))


PICTURE = [[(7 * x * y + x) % 251 if 5 < x < 30 else 255 for x in range(40)] for y in range(23)]


class Report(unittest.TestCase):
    def setUp(self):
        self.work = tempfile.TemporaryDirectory()
        self.addCleanup(self.work.cleanup)
        self.folder = Path(self.work.name)
        (self.folder / "index.html").write_text('<img src="chart.png"><a href="table.json">')
        write_png(self.folder / "chart.png", PICTURE)
        self.write_table(self.folder, 0.1, 2.0)

    @staticmethod
    def write_table(folder, figure, time):
        (folder / "table.json").write_text(json.dumps({"columns": [{"name": "error", "kind": "figure"},
            {"name": "duration", "kind": "time"}], "rows": [[figure, time], [1.0, 2.0]]}))

    def test_pictures_are_decoded(self):
        rows = check_report.read_png(self.folder / "chart.png")[3]
        self.assertEqual([list(row) for row in rows], PICTURE)

    def test_a_sound_report_passes(self):
        self.assertEqual(check_report.check_shown(self.folder)[0], [])

    def test_blank_pictures_are_found(self):
        write_png(self.folder / "chart.png", [[255] * 40 for _ in range(23)])
        self.assertIn("blank", check_report.check_shown(self.folder)[0][0])

    def test_damaged_pictures_are_found(self):
        data = bytearray((self.folder / "chart.png").read_bytes())
        data[60] ^= 1
        (self.folder / "chart.png").write_bytes(data)
        self.assertIn("decoded", check_report.check_shown(self.folder)[0][0])

    def test_missing_files_are_found(self):
        (self.folder / "chart.png").unlink()
        self.assertIn("chart.png: is not there", check_report.check_shown(self.folder)[0])

    def test_empty_tables_are_found(self):
        (self.folder / "table.json").write_text('{"columns": [], "rows": []}')
        self.assertIn("table.json: has no rows", check_report.check_shown(self.folder)[0])

    def test_other_figures_are_found_and_other_times_are_not(self):
        other = self.folder / "other"
        other.mkdir()
        self.write_table(other, 0.1, 3.0)
        self.assertEqual(check_report.check_same(self.folder, other)[0], [])
        self.write_table(other, 0.1 + 2.0 ** -55, 2.0)
        self.assertEqual(len(check_report.check_same(self.folder, other)[0]), 1)

    def test_other_columns_are_found(self):
        other = self.folder / "other"
        other.mkdir()
        (other / "table.json").write_text(json.dumps({"columns": [{"name": "error", "kind": "figure"}], "rows": [[0.1], [1.0]]}))
        self.assertIn("table.json: other columns", check_report.check_same(self.folder, other)[0])


if __name__ == "__main__":
    unittest.main()
