#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Doxygen says nothing about the installed headers: no class without a description, no reference to nothing.

usage: check_doxygen.py SOURCE_DIRECTORY DOXYGEN OUTPUT_DIRECTORY [HEADER...]

With HEADERs it looks at these. Exit code 0, or 1 and the warnings.
"""
import re
import subprocess
import sys
from pathlib import Path

import public_headers


def find_warnings(root, doxygen, output, headers):
    """Doxygen's warnings about the headers, and classes that have no description."""
    output.mkdir(parents=True, exist_ok=True)
    configuration = (root / "Doxyfile").read_text(encoding="utf-8") + (
        f'OUTPUT_DIRECTORY = "{output}"\nGENERATE_HTML = NO\nGENERATE_XML = YES\nXML_PROGRAMLISTING = NO\n'
        'USE_MDFILE_AS_MAINPAGE =\nINPUT = ' + " ".join(f'"{header}"' for header in headers) + "\n")
    run = subprocess.run([doxygen, "-"], input=configuration, capture_output=True, text=True, cwd=root)
    warnings = [line for line in run.stderr.splitlines() if line.strip()]
    if run.returncode:
        warnings.append(f"{doxygen} gave {run.returncode}")
    for header in headers:
        text = header.read_text(encoding="utf-8")
        name = header.name.split(".", 1)[0]
        if not re.search(rf"@(class|file) {name}\b[^@]*@brief \S", text):
            warnings.append(f"{header}: no '@class {name}' (or '@file') with a '@brief'")
    return warnings


def main(arguments):
    if len(arguments) < 3:
        print(__doc__, file=sys.stderr)
        return 2
    root, doxygen, output = Path(arguments[0]), arguments[1], Path(arguments[2])
    headers = [Path(header) for header in arguments[3:]] or public_headers.find(root)
    warnings = find_warnings(root, doxygen, output, headers)
    for warning in warnings:
        print(warning)
    print(f"{len(headers)} headers, {len(warnings)} warnings")
    return 1 if warnings or not headers else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
