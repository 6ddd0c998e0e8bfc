#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""test_docstrings.py SOURCE_DIRECTORY: the classes of the README's table are in Python, with the text of their headers.

VTK's wrapping gives a comment to the method behind it only: what else sets or gets the same property, and the rest of a
group (///@{ ... ///@}) that begins with a comment, is documented by it as well.
"""
import re
import sys
import unittest
from pathlib import Path

import multitriangulation

ROW = re.compile(r"^\| `(vtkM\w+)` \| (MT\w+) \|", re.MULTILINE)
GROUP = re.compile(r"///@\{\s*(?:/\*\*(.*?)\*/|///(?!@)(.*?)\n)(.*?)///@\}", re.DOTALL)
OF_TYPE_MACRO = {"IsA", "IsTypeOf", "NewInstance", "SafeDownCast", "GetNumberOfGenerationsFromBase",
    "GetNumberOfGenerationsFromBaseType"}


def get_text(name, docstring):
    """What a docstring says beside the signatures."""
    paragraphs = [paragraph.strip() for paragraph in (docstring or "").split("\n\n")]
    return "\n".join(p for p in paragraphs if p and not p.startswith((f"{name}(", "C++:")))


def get_property(method):
    """The name of what a method sets or gets, as VTK's macros make it."""
    name = re.sub(r"^(Set|Get)", "", method)
    setters_alone = "" if method.startswith("Get") else r"|To[A-Z]\w*" # SetModeToFast; GetDistanceToInput is a name
    return re.sub(rf"(On|Off|MinValue|MaxValue{setters_alone})$", "", name)


def find_grouped(header):
    """Names within groups that begin with a comment."""
    grouped = set()
    for block, line, members in GROUP.findall(header):
        if (block + line).strip():
            grouped.update(re.findall(r"\w+", members))
    return grouped


def find_undocumented(name, methods, header):
    """The methods without a text, neither of their own nor of their group, that do not override another."""
    grouped = find_grouped(header)
    documented = {get_property(method) for method, docstring in methods.items() if get_text(method, docstring)}
    overrides = set(re.findall(r"(\w+)\([^;{]*\)(?: const)? override", header))
    return [method for method, docstring in methods.items()
        if not get_text(method, docstring) and method not in OF_TYPE_MACRO and method not in overrides
        and method not in grouped and get_property(method) not in grouped | documented]


class Docstrings(unittest.TestCase):
    root = Path()

    def setUp(self):
        self.rows = ROW.findall((self.root / "README.md").read_text(encoding="utf-8"))
        self.assertTrue(0 < len(self.rows) <= 17, self.rows)

    def find_header(self, name):
        """The class's header, or what CMake makes it of."""
        headers = [file for folder in ("Module", "Filters", "IO", "Rendering", "Interaction")
            for ending in (".h", ".h.in") for file in (self.root / folder).rglob(name + ending)]
        self.assertEqual(len(headers), 1, name)
        return headers[0]

    def test_every_class_of_the_readme_is_in_the_package(self):
        for name, _ in self.rows:
            with self.subTest(name):
                self.assertIn(name, multitriangulation.__all__)

    def test_every_class_of_the_readme_is_in_the_module_that_is_named(self):
        for name, module in self.rows:
            with self.subTest(name):
                described = (self.find_header(name).parent / "vtk.module").read_text(encoding="utf-8")
                self.assertIn(f"MultiTriangulation::{module}\n", described.split("LIBRARY_NAME")[0])

    def test_every_wrapped_class_has_docstrings(self):
        methods_seen = 0
        for name in (each for each in multitriangulation.__all__ if each.startswith("vtk")):
            with self.subTest(name):
                each = getattr(multitriangulation, name)
                title = (each.__doc__ or "").split("\n\n")[0]
                self.assertRegex(title, rf"^{name} - \S")
                paragraphs = [p for p in each.__doc__.split("\n\n")[1:] if p.strip() and "Superclass:" not in p]
                self.assertTrue(paragraphs, "nothing but a title")
                header = self.find_header(name)
                methods = {method: value.__doc__ for method, value in vars(each).items()
                    if callable(value) and not isinstance(value, type) and not method.startswith("_")}
                methods_seen += len(methods)
                self.assertEqual(find_undocumented(name, methods, header.read_text(encoding="utf-8")), [])
        print(f"{len(multitriangulation.__all__)} classes, {methods_seen} methods")
        self.assertGreater(methods_seen, 100)

    def test_methods_without_a_text_are_found(self):
        header = ("///@{\n/** How many. */\nvtkSetMacro(Count, int);\nvtkGetMacro(Count, int);\n///@}\n"
            "///@{\nvtkGetMacro(Size, int);\n///@}\nint Find();\nvoid Run() override;\n")
        methods = {"SetCount": "SetCount(self)\nC++: x\n\nHow many.\n", "GetCount": "GetCount(self)\nC++: x\n\n\n",
            "GetSize": "GetSize(self)\nC++: x\n\n", "Find": "Find(self)\nC++: x\n\n", "Run": "Run(self)\nC++: x\n\n"}
        self.assertEqual(find_undocumented("vtkOne", methods, header), ["GetSize", "Find"])


if __name__ == "__main__":
    Docstrings.root = Path(sys.argv[1])
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
