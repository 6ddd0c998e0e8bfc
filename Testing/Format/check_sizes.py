#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Holds the sizes of files, functions and folders of the modules and of Applications.

usage: check_sizes.py SOURCE_DIRECTORY

A function is counted from the first line of its head to its last brace; clang-format has put its braces into lines of
their own, at the same indentation. Exit code 0 and the figures, or 1 and one line for each violation.
"""
import re
import sys
from pathlib import Path

import public_headers
from check_language import list_files

FOLDERS = ("Module/", "Filters/", "IO/", "Rendering/", "Interaction/", "Applications/", "ParaView/")
SOURCES = (".h", ".hxx", ".cxx", ".glsl")
FILE_LINES = 450
LONG_FILES = 5
FUNCTION_LINES = 60
FOLDER_FILES = 65
APPLICATION_LINES = 2500
INSTALLED_HEADERS = 51

NO_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)
SCOPE = re.compile(r"^(inline |typedef )*(namespace|class|struct|union|enum)\b")
HEAD_ENDS = re.compile(r"[;{]$|^[:\w ]*:$|^#|^[})]+;?$|^$")


def find_functions(text):
    """(first line, name, number of lines) of every function; what is within one belongs to it."""
    # Digits may be parted by a quote; it begins no character then.
    text = re.sub(r"(?<=[0-9a-fA-F])'(?=[0-9a-fA-F])", "", text)
    lines = NO_CODE.sub(lambda match: '""' + "\n" * match.group(0).count("\n"), text).split("\n")
    lines = ["" if line.strip() == '""' else line.replace('""', "").rstrip() for line in lines]
    functions, i = [], 0
    while i < len(lines):
        if lines[i].strip() != "{":
            i += 1
            continue
        first = i
        while first > 0:
            above = lines[first - 1].strip()
            if HEAD_ENDS.search(above) or (above.endswith("}") and above[0] not in ":,"):
                break
            first -= 1
        head = " ".join(line.strip() for line in lines[first:i])
        head = re.sub(r"^(template ?<[^()]*?> )+(?=\w)", "", head)
        end = lines[i].replace("{", "}")
        if "(" in head and not SCOPE.match(head):
            last = next((j for j in range(i, len(lines)) if re.match(rf"{end}(?!\w)", lines[j])), len(lines) - 1)
            functions.append((first + 1, head.split("(", 1)[0].split(" ")[-1], last - first + 1))
            i = last
        i += 1
    return functions


def check(root):
    """All violations, and a line of figures."""
    long_files, functions, folders, application_lines, violations = [], [], {}, 0, []
    for name in list_files(root):
        if not name.startswith(FOLDERS):
            continue
        folder = name.rsplit("/", 1)[0]
        folders[folder] = folders.get(folder, 0) + (not name.endswith(".in"))  # what CMake makes is generated
        if not name.endswith(SOURCES):
            continue
        text = (root / name).read_text(encoding="utf-8")
        lines = text.count("\n")
        application_lines += lines if name.startswith("Applications/") else 0
        if lines > FILE_LINES:
            long_files.append(f"{name}: {lines} lines")
        functions += [(length, f"{name}:{line}: {function} has {length} lines")
            for line, function, length in find_functions(text)]
    if len(long_files) > LONG_FILES:
        violations += [f"{entry}, of {len(long_files)} files above {FILE_LINES}" for entry in long_files]
    violations += [f"{entry}, more than {FUNCTION_LINES}" for length, entry in functions if length > FUNCTION_LINES]
    violations += [f"{folder}: {count} files, more than {FOLDER_FILES}"
        for folder, count in folders.items() if count > FOLDER_FILES]
    if application_lines > APPLICATION_LINES:
        violations.append(f"Applications: {application_lines} lines, more than {APPLICATION_LINES}")
    installed = len(public_headers.find(root))
    if installed > INSTALLED_HEADERS:
        violations.append(f"{installed} installed headers, more than {INSTALLED_HEADERS}")
    if not functions:
        violations.append(f"{root}: no functions found")
    lengths = sorted(length for length, _ in functions) or [0]
    figures = (f"{len(long_files)} files above {FILE_LINES} lines; {len(lengths)} functions, 90 % within "
        f"{lengths[len(lengths) * 9 // 10]} lines, the largest {lengths[-1]}; the largest folder has "
        f"{max(folders.values(), default=0)} files; Applications {application_lines} lines; {installed} installed headers")
    return violations, figures


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    violations, figures = check(Path(arguments[0]))
    for violation in violations:
        print(violation)
    print(figures)
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
