#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks what bmt-report has written.

usage: check_report.py shown FOLDER          every file that the page names is there, every picture shows something, and
                                             every table has rows
       check_report.py same FOLDER OTHER     the figures of all tables of OTHER are those of FOLDER, to the last digit;
                                             times are not compared

Exit code 0 and what was looked at, or 1 and one line for each fault.
"""
import json
import re
import struct
import sys
import zlib
from pathlib import Path

LEAST_INK = 0.005  # of the pixels of a picture


def read_png(path):
    """Width, height, and the pixels as rows of bytes; of 8 bits with one, three or four components."""
    data = path.read_bytes()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError("no PNG")
    place, packed, header = 8, b"", None
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        if struct.unpack(">I", data[place + 8 + length:place + 12 + length])[0] != zlib.crc32(kind + body):
            raise ValueError("a wrong checksum")
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        place += 12 + length
    width, height, depth, color = header[:4]
    components = {0: 1, 2: 3, 6: 4}[color]
    if depth != 8:
        raise ValueError(f"{depth} bits")
    return width, height, components, unfilter(zlib.decompress(packed), width * components, height, components)


def unfilter(data, size, height, step):
    """Rows of bytes, from rows that begin with their filter (PNG specification, section 9)."""
    rows, above = [], bytearray(size)
    for y in range(height):
        kind = data[y * (size + 1)]
        row = bytearray(data[y * (size + 1) + 1:(y + 1) * (size + 1)])
        if kind == 2:
            row = bytearray((a + b) & 255 for a, b in zip(row, above))
        elif kind != 0:
            for x in range(size):
                a = row[x - step] if x >= step else 0
                b = above[x]
                c = above[x - step] if x >= step else 0
                if kind == 1:
                    add = a
                elif kind == 3:
                    add = (a + b) // 2
                else:
                    add = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
                row[x] = (row[x] + add) & 255
        rows.append(bytes(row))
        above = row
    return rows


def check_picture(path):
    """What is wrong with it, or None."""
    try:
        width, height, components, rows = read_png(path)
    except (ValueError, KeyError, TypeError, struct.error, zlib.error) as fault:
        return f"cannot be decoded: {fault}"
    counts = {}
    for row in rows:
        for x in range(0, width * components, components):
            pixel = row[x:x + components]
            counts[pixel] = counts.get(pixel, 0) + 1
    ink = 1.0 - max(counts.values()) / (width * height)
    return f"is blank: {100 * ink:.2f} % of its pixels are drawn" if ink < LEAST_INK else None


def check_shown(folder):
    """All faults, and what was looked at."""
    page = (folder / "index.html").read_text(encoding="utf-8")
    files = sorted(set(re.findall(r'(?:src|href)="([^"]+)"', page)))
    faults = [f"{name}: is not there" for name in files if not (folder / name).is_file()]
    pictures = [name for name in files if name.endswith(".png") and (folder / name).is_file()]
    tables = sorted(folder.glob("*.json"))
    for name in pictures:
        fault = check_picture(folder / name)
        faults += [f"{name}: {fault}"] if fault else []
    if not pictures or not tables:
        faults.append(f"{folder}: no pictures or no tables")
    for table in tables:
        content = json.loads(table.read_text(encoding="utf-8"))
        if not (content["rows"] if isinstance(content, dict) else content):
            faults.append(f"{table.name}: has no rows")
    return faults, f"{len(pictures)} pictures and {len(tables)} tables"


def check_same(folder, other):
    """All faults, and what was looked at."""
    faults, numbers = [], 0
    for path in sorted(other.glob("*.json")):
        found = json.loads(path.read_text(encoding="utf-8"))
        if not isinstance(found, dict):
            continue  # claims.json, whose figures may be times
        expected = json.loads((folder / path.name).read_text(encoding="utf-8"))
        if found["columns"] != expected["columns"]:
            faults.append(f"{path.name}: other columns")
            continue
        if len(found["rows"]) != len(expected["rows"]):
            faults.append(f"{path.name}: {len(found['rows'])} rows and not {len(expected['rows'])}")
        for i, column in enumerate(found["columns"]):
            for row, (a, b) in enumerate(zip(expected["rows"], found["rows"])):
                if column["kind"] == "figure":
                    numbers += 1
                    if a[i] != b[i]:
                        faults.append(f"{path.name}: {column['name']} of row {row + 1}: {a[i]!r} and {b[i]!r}")
    return faults + ([] if numbers else [f"{other}: no figures"]), f"{numbers} figures"


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "shown":
        faults, looked_at = check_shown(Path(arguments[1]))
    elif len(arguments) == 3 and arguments[0] == "same":
        faults, looked_at = check_same(Path(arguments[1]), Path(arguments[2]))
    else:
        print(__doc__, file=sys.stderr)
        return 2
    for fault in faults:
        print(fault)
    print(f"{looked_at}, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
