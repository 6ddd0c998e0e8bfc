#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the sections of two files of one model, by their checksums and sizes, across versions 5 and 6 of the format.

usage: compare_sections.py OLD.bmt NEW.bmt

Every section of every patch (by arc and class) and every blob must be in both, with the same bytes. Exits with 1 where one is not.
"""
import struct
import sys


def align(size):
    return (size + 15) // 16 * 16


def read_five(data):
    arcs_at, directory, metadata = struct.unpack_from("<QQQ", data, 32)
    arcs, arrays = struct.unpack_from("<II", data, 76)
    blobs = struct.unpack_from("<I", data, 136)[0]
    sections = {}
    for arc in range(arcs):
        ends = struct.unpack_from("<II", data, arcs_at + 72 * arc)
        for number in range(1 + arrays):
            record = struct.unpack_from("<QIB", data, directory + 16 * (arc * (1 + arrays) + number))
            if record[1] > 0:
                sections[(arc, ends, number)] = record
    for blob in range(blobs):
        sections[("blob", blob)] = struct.unpack_from("<QIB", data, directory + 16 * (arcs * (1 + arrays) + blob))
    return sections


def read_six(data):
    blocks = {}
    for i in range(struct.unpack_from("<I", data, 52)[0]):
        kind, _, offset, size = struct.unpack_from("<IIQQ", data, 64 + 24 * i)
        blocks[kind] = (offset, size)
    sections, (arcs_at, arcs_size), (table, _) = {}, blocks[4], blocks[6]
    for arc in range(arcs_size // 96):
        ends = struct.unpack_from("<II", data, arcs_at + 96 * arc)
        count, first = struct.unpack_from("<HI", data, arcs_at + 96 * arc + 70)
        for i in range(first, first + count):
            checksum, size, codec, _, number = struct.unpack_from("<QIBBH", data, table + 16 * i)
            sections[(arc, ends, number)] = (checksum, size, codec)
    for blob in range(struct.unpack_from("<I", data, blocks[2][0] + 116)[0]):
        sections[("blob", blob)] = struct.unpack_from("<QIB", data, table + 16 * blob)
    return sections


def read(path):
    with open(path, "rb") as file:
        data = file.read()
    version = struct.unpack_from("<I", data, 8)[0]
    return {5: read_five, 6: read_six}[version](data), version, len(data)


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    (old, old_version, old_size), (new, new_version, new_size) = (read(path) for path in sys.argv[1:])
    differ = [key for key in sorted(set(old) | set(new), key=str) if old.get(key) != new.get(key)]
    stored = sum(align(size) for _, size, _ in new.values())
    print(f"version {old_version}: {len(old)} sections, {old_size} bytes; version {new_version}: {len(new)} sections, "
          f"{new_size} bytes, {stored} of them in sections; {len(differ)} sections differ")
    for key in differ[:10]:
        print(key, old.get(key), new.get(key))
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
