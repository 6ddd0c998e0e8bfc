#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The installed headers of all modules, one a line: those of CLASSES, NOWRAP_CLASSES and HEADERS.

usage: public_headers.py SOURCE_DIRECTORY
"""
import re
import sys
from pathlib import Path

FOLDERS = ("Module", "Filters", "IO", "Rendering", "Interaction")
SET = re.compile(r"\bset\((\w+)\s+([^)]*)\)")
ADD = re.compile(r"\bvtk_module_add_module\(([^)]*)\)")


def get_names(words, variables):
    """The words, with the values of variables."""
    for word in words:
        used = re.fullmatch(r"\$\{(\w+)\}", word)
        yield from variables.get(used.group(1), []) if used else [word]


def find(root):
    """The headers of every folder with a vtk.module, as paths."""
    headers = []
    for module in sorted(file for folder in FOLDERS for file in (root / folder).rglob("vtk.module")):
        text = re.sub(r"#[^\n]*", "", (module.parent / "CMakeLists.txt").read_text(encoding="utf-8"))
        variables = {name: words.split() for name, words in SET.findall(text)}
        for arguments in ADD.findall(text):
            kind = ""
            for word in arguments.split():
                if re.fullmatch(r"[A-Z_]+", word):
                    kind = word
                elif kind in ("CLASSES", "NOWRAP_CLASSES"):
                    headers += [module.parent / f"{name}.h" for name in get_names([word], variables)]
                elif kind == "HEADERS":
                    # CMake makes some in the build folder, of what ends with .in.
                    headers += [module.parent / Path(name.strip('"')).name for name in get_names([word], variables)]
    return [header if header.exists() else header.with_name(header.name + ".in") for header in headers]


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for header in find(Path(sys.argv[1])):
        print(header)
