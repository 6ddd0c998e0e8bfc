#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks what a program that reads, refines and draws a .bmt file must load (Documentation/architecture.md).

usage: check_libraries.py PROGRAM

Evidence: `ldd` says where each library is, `readelf -d` which ones (NEEDED) a program or library asks for by itself. All
that is reached from the program is looked at.

- GDAL, and CGAL with GMP and MPFR, must not be reached at all, whoever asks for them.
- VTK's mesh readers (IOGeometry, IOPLY, IOLegacy, IOXML, IOImport) must not be asked for by the program or by a library of
  the toolkit (libvtkMT...). What VTK's own libraries ask for is VTK's: its rendering brings IOLegacy and IOXML along. So a
  reader is allowed where a library of VTK asks for it and it would be loaded anyway, by the rendering and interaction
  libraries that the program itself asks for; any other reader is a violation.

Exit code 0 and what was looked at, or 1 and one line per violation, with the chain from the program to the library.
"""
import re
import subprocess
import sys
from pathlib import Path

NEVER = re.compile(r"^lib(gdal|gmp|gmpxx|mpfr|CGAL\w*)\.so")
READER = re.compile(r"^libvtkIO(Geometry|PLY|Legacy|XML|XMLParser|Import)(-[\d.]+)?\.so")
OURS = re.compile(r"^libvtkMT\w+\.so")
DRAWING = re.compile(r"^libvtk(Rendering|Interaction)\w+(-[\d.]+)?\.so")


def read_needed(program):
    """{name: [names that it asks for]} for the program and every library that is reached from it."""
    def ask(command):
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout

    def needed_by(file):
        return re.findall(r"\(NEEDED\)[^\[]*\[([^\]]+)\]", ask(["readelf", "-dW", file]))

    where = dict(re.findall(r"(\S+) => (/\S+) \(", ask(["ldd", program])))
    needed = {Path(program).name: needed_by(program)}
    for name, file in where.items():
        needed[name] = needed_by(file)
    return needed


def find_chains(needed, start):
    """{name: the chain of names from start to it}, by the fewest steps."""
    chains = {start: [start]}
    waiting = [start]
    while waiting:
        name = waiting.pop(0)
        for other in needed.get(name, []):
            if other not in chains:
                chains[other] = chains[name] + [other]
                waiting.append(other)
    return chains


def check(needed, program):
    """All violations, and the number of libraries that were looked at."""
    chains = find_chains(needed, program)
    drawing = set()
    for name in needed[program]:
        if DRAWING.match(name):
            drawing.update(find_chains(needed, name))
    violations = []
    for name, chain in sorted(chains.items()):
        asked_by_us = [each for each in chains if (each == program or OURS.match(each)) and name in needed.get(each, [])]
        if NEVER.match(name):
            violations.append(f"{' -> '.join(chain)}: must not be loaded")
        elif READER.match(name) and asked_by_us:
            violations.append(f"{' -> '.join(chains[asked_by_us[0]] + [name])}: a mesh reader of VTK that drawing has no use for")
        elif READER.match(name) and name not in drawing:
            violations.append(f"{' -> '.join(chain)}: a mesh reader of VTK that drawing alone would not load")
    return violations, len(chains) - 1


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    needed = read_needed(arguments[0])
    violations, libraries = check(needed, Path(arguments[0]).name)
    if not any(OURS.match(name) for name in needed):
        violations.append(f"{arguments[0]}: loads no library of the toolkit, so nothing was checked")
    for violation in violations:
        print(violation)
    print(f"{libraries} libraries, {sum(bool(OURS.match(name)) for name in needed)} of the toolkit, {len(violations)} violations")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
