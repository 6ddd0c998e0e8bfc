#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The check of the sizes is checked: what is too large, planted in a small tree, is found."""
import tempfile
import unittest
from pathlib import Path

import check_sizes


def make_function(head, lines):
    """A function of so many lines."""
    return f"{head}\n{{\n" + "  Call();\n" * (lines - 3) + "}\n"


class PlantedSizes(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(self.folder.name)
        self.write("Module/vtk.module", "NAME\n  MultiTriangulation::MTCore\n")
        self.write("Module/CMakeLists.txt",
            "set(classes\n  vtkMTOne)\nset(headers \"${CMAKE_CURRENT_BINARY_DIR}/vtkMTTwo.h\")\n"
            "vtk_module_add_module(X\n  CLASSES ${classes}\n  HEADERS ${headers}\n  PRIVATE_HEADERS vtkMTThree.h)\n")
        self.write("Module/vtkMTOne.cxx", make_function("void vtkMTOne::Run()", 60))
        self.write("Applications/bmt.cxx", make_function("int main(int argc, char* argv[])", 20))

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, text):
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def assert_one_violation(self, *words):
        violations, _ = check_sizes.check(self.root)
        self.assertEqual(len(violations), 1, violations)
        for word in words:
            self.assertIn(word, violations[0])

    def test_small_tree_is_right(self):
        violations, figures = check_sizes.check(self.root)
        self.assertEqual(violations, [])
        self.assertIn("2 functions", figures)
        self.assertIn("the largest 60", figures)
        self.assertIn("2 installed headers", figures)

    def test_long_function_is_found(self):
        self.write("Module/vtkMTTwo.cxx", "#include \"a.h\"\n\nnamespace\n{\n" + make_function("template <class T>\nvoid Two(T x)", 61) + "}\n")
        self.assert_one_violation("Module/vtkMTTwo.cxx:5", "Two has 62 lines")

    def test_long_function_of_a_class_is_found(self):
        body = make_function("  void Three() const", 70).replace("\n{", "\n  {").replace("\n}", "\n  }")
        self.write("Module/vtkMTThree.h", "class vtkMTThree : public Two\n{\npublic:\n  int Get() const { return 1; }\n" + body + "};\n")
        self.assert_one_violation("Module/vtkMTThree.h:5", "Three has 70 lines")

    def test_braces_in_strings_comments_and_lambdas_do_not_count(self):
        functions = check_sizes.find_functions(
            "vtkFour::vtkFour()\n  : A{ 1 }\n  , B(\"}\")\n{\n  // }\n  const auto f = []()\n  {\n    return '{';\n  };\n"
            "  R\"(\n{\n}\n)\";\n}\n\nstatic void Five()\n{\n}\n")
        self.assertEqual(functions, [(1, "vtkFour::vtkFour", 14), (16, "Five", 3)])

    def test_the_sixth_long_file_is_found(self):
        for i in range(5):
            self.write(f"Module/vtkMTLong{i}.cxx", "\n" * 451)
        self.assertEqual(check_sizes.check(self.root)[0], [])
        self.write("Module/vtkMTLong5.cxx", "\n" * 451)
        self.assertEqual(len(check_sizes.check(self.root)[0]), 6)

    def test_large_folder_is_found(self):
        for i in range(62):
            self.write(f"Module/vtkMTFile{i}.h", "")
        self.assertEqual(check_sizes.check(self.root)[0], [])
        self.write("Module/vtkMTFile62.h", "")
        self.assert_one_violation("Module: 66 files")

    def test_large_applications_are_found(self):
        for i in range(6):
            self.write(f"Applications/bmt{i}.cxx", "\n" * 413)
        self.assertEqual(check_sizes.check(self.root)[0], [])
        self.write("Applications/bmt6.cxx", "\n\n\n")
        self.assert_one_violation("Applications: 2501 lines")

    def test_too_many_installed_headers_are_found(self):
        names = " ".join(f"vtkMTHeader{i}.h" for i in range(52))
        self.write("Module/CMakeLists.txt", f"vtk_module_add_module(X HEADERS {names})\n")
        self.assert_one_violation("52 installed headers")

    def test_the_command_fails_on_a_violation_and_on_an_empty_tree(self):
        self.assertEqual(check_sizes.main([str(self.root)]), 0)
        self.write("Module/vtkMTTwo.cxx", make_function("void Two()", 61))
        self.assertEqual(check_sizes.main([str(self.root)]), 1)
        with tempfile.TemporaryDirectory() as empty:
            self.assertEqual(check_sizes.main([empty]), 1)


if __name__ == "__main__":
    unittest.main()
