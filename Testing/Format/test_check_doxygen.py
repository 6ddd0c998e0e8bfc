#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The check of the documentation is checked: what is wrong in a planted header is found.

usage: test_check_doxygen.py SOURCE_DIRECTORY DOXYGEN
"""
import sys
import tempfile
import unittest
from pathlib import Path

import check_doxygen

GOOD = """/**
 * @class vtkMTOne
 * @brief one of a few
 *
 * It has a method.
 */
class vtkMTOne
{
public:
  /// Gives a number, which is less than the limit.
  int Get(int limit) const;
};
"""


class PlantedFaults(unittest.TestCase):
    root = Path()
    doxygen = ""

    def warnings(self, text):
        with tempfile.TemporaryDirectory() as folder:
            header = Path(folder) / "vtkMTOne.h"
            header.write_text(text, encoding="utf-8")
            return check_doxygen.find_warnings(self.root, self.doxygen, Path(folder) / "output", [header])

    def assert_one_warning(self, text, words):
        warnings = self.warnings(text)
        self.assertTrue(warnings, words)
        self.assertTrue(any(words in warning for warning in warnings), warnings)

    def test_good_header_has_no_warning(self):
        self.assertEqual(self.warnings(GOOD), [])

    def test_parameter_that_does_not_exist_is_found(self):
        self.assert_one_warning(GOOD.replace("/// Gives", "/// @param count no such thing\n  /// Gives"), "count")

    def test_reference_to_nothing_is_found(self):
        self.assert_one_warning(GOOD.replace("It has", "See @ref vtkMTNowhere. It has"), "vtkMTNowhere")

    def test_unknown_command_is_found(self):
        self.assert_one_warning(GOOD.replace("@brief", "@breif"), "breif")

    def test_class_without_a_description_is_found(self):
        self.assert_one_warning(GOOD[GOOD.index("class vtkMTOne\n"):], "@brief")


if __name__ == "__main__":
    PlantedFaults.root, PlantedFaults.doxygen = Path(sys.argv[1]).resolve(), sys.argv[2]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
