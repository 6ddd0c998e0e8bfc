#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""
make_stubs.py OUTPUT: writes the type stubs of the package multitriangulation, which must be importable.

Signatures of the wrapped classes are in the first lines of their docstrings, in VTK's way of writing types:
"SetRange(self, range:(float, float)) -> None". The functions have their annotations in their own files.
"""
import re
import sys

import vtkmodules.all as vtk

import multitriangulation

FUNCTIONS = {
    "_build": ["build"],
    "_cut": ["cut"],
    "_draw": ["actor", "screenshot", "show"],
    "_errors": ["MultiTriangulationError"],
    "_model": ["Cut", "Model", "read"],
    "_verify": ["Check", "Verification", "verify"],
    "_version": ["__version__"],
}
PLAIN = {"int", "float", "bool", "str", "None", "bytes"}
LONGEST_LINE = 120


def get_type(text):
    """VTK's way of writing a type as Python's."""
    text = text.strip()
    if text.startswith("("):
        parts = split(text[1:-1])
        return f"Sequence[{get_type(parts[0])}]" if parts else "tuple[()]"
    if text.startswith("["):
        parts = split(text[1:-1])
        return f"MutableSequence[{get_type(parts[0])}]" if parts else "MutableSequence[Any]"
    if text in PLAIN:
        return text
    if re.fullmatch(r"[A-Za-z_]\w*(\.\w+)*", text):
        name = text.split(".")[0]
        if name in multitriangulation.__all__:
            return name if "." not in text else "int"
        if hasattr(vtk, name):
            return f"vtk.{name}" if "." not in text else "int"
    return "Any"


def split(text):
    """At the commas that are in no brackets."""
    parts, depth, start = [], 0, 0
    for i, character in enumerate(text):
        depth += {"(": 1, "[": 1, ")": -1, "]": -1}.get(character, 0)
        if character == "," and depth == 0:
            parts.append(text[start:i])
            start = i + 1
    return [part.strip() for part in parts + [text[start:]] if part.strip()]


def get_argument(text):
    if ":" not in text:
        return text
    name, kind = text.split(":", 1)
    default = ""
    if "=" in kind:
        kind, default = kind.split("=", 1)
        default = " = ..."
    return f"{name.strip()}: {get_type(kind)}{default}"


def get_signatures(name, method):
    """(arguments, result) of every overload."""
    text = re.sub(r"\s*\n\s+", " ", method.__doc__ or "")
    for match in re.finditer(rf"^{name}\((.*)\) -> (.+)$", text, re.MULTILINE):
        yield [get_argument(each) for each in split(match[1])], match[2]


def get_result(text):
    text = text.strip()
    if text.startswith("("):
        return f"tuple[{', '.join(get_type(each) for each in split(text[1:-1]))}]"
    return get_type(text)


def write_method(name, method, out):
    signatures = list(get_signatures(name, method))
    for arguments, result in signatures:
        if len(signatures) > 1:
            out.append("    @overload")
        if "self" not in arguments[:1]:
            out.append("    @staticmethod")
        line = f"    def {name}({', '.join(arguments)}) -> {get_result(result)}: ..."
        if len(line) > LONGEST_LINE:
            line = f"    def {name}(\n        {', '.join(arguments)}\n    ) -> {get_result(result)}: ..."
        out.append(line)


def get_base(cls):
    base = cls.__mro__[1].__name__
    return base if base in multitriangulation.__all__ else f"vtk.{base}"


def write_class(cls, out):
    out.append(f"class {cls.__name__}({get_base(cls)}):")
    start = len(out)
    for name, value in vars(cls).items():
        if name.startswith("__"):
            continue
        if isinstance(value, type):
            out.append(f"    {name} = int")
        elif isinstance(value, int):
            out.append(f"    {name}: int")
        elif callable(value) or isinstance(value, staticmethod):
            write_method(name, getattr(cls, name), out)
    if len(out) == start:
        out.append("    ...")
    out.append("")


def order(classes):
    """Bases first."""
    return sorted(classes, key=lambda cls: (len(cls.__mro__), cls.__name__))


def main():
    out = [
        "# Made by make_stubs.py from the classes of the package.",
        "from collections.abc import MutableSequence, Sequence",
        "from typing import Any, overload",
        "",
        "import vtkmodules.all as vtk",
        "",
    ]
    for module, names in FUNCTIONS.items():
        there = [name for name in names if hasattr(multitriangulation, name)]
        if there:
            out.append(f"from .{module} import {', '.join(f'{name} as {name}' for name in there)}")
    out.append("")
    for cls in order(getattr(multitriangulation, name) for name in multitriangulation.__all__ if name.startswith("vtk")):
        write_class(cls, out)
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write("\n".join(out))


if __name__ == "__main__":
    main()
