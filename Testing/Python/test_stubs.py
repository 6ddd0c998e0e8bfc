#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The type stubs name every class, method and function of the package, and nothing that is not there."""
import ast
import os
import unittest

import multitriangulation as mt


class Stubs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = os.path.dirname(mt.__file__)
        cls.typed = os.path.exists(os.path.join(folder, "py.typed"))
        with open(os.path.join(folder, "__init__.pyi"), encoding="utf-8") as file:
            cls.tree = ast.parse(file.read())
        cls.classes = {node.name: node for node in cls.tree.body if isinstance(node, ast.ClassDef)}

    def test_every_exported_name_is_there(self):
        imported = {alias.asname for node in self.tree.body if isinstance(node, ast.ImportFrom) for alias in node.names}
        print(len(self.classes), "classes,", sorted(name for name in imported if name))
        self.assertTrue(self.typed)
        self.assertEqual(set(mt.__all__) - set(self.classes) - imported, set())
        self.assertEqual(set(self.classes) - set(mt.__all__), set())

    def test_every_method_has_a_signature(self):
        methods = 0
        for name, node in self.classes.items():
            stubbed = {each.name for each in node.body if isinstance(each, ast.FunctionDef)}
            methods += len(stubbed)
            real = {
                each for each, value in vars(getattr(mt, name)).items()
                if not each.startswith("__") and callable(value) and not isinstance(value, type)}
            self.assertEqual(real - stubbed, set(), name)
            self.assertEqual(stubbed - real, set(), name)
        print(methods, "methods")
        self.assertGreater(methods, 300)

    def test_types_are_known(self):
        pixel_error = next(
            each for each in self.classes["vtkMultiTriangulationMapper"].body
            if isinstance(each, ast.FunctionDef) and each.name == "SetPixelError")
        self.assertEqual(ast.unparse(pixel_error), "def SetPixelError(self, pixels: float) -> None:\n    ...")
        unknown = [ast.unparse(node) for node in ast.walk(self.tree) if isinstance(node, ast.Name) and node.id == "Any"]
        print(len(unknown), "types that are not known")
        self.assertLess(len(unknown), 5)


if __name__ == "__main__":
    unittest.main()
