#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The check of the libraries is checked: planted violations are found, and those of a program that does read meshes.

usage: test_check_libraries.py BMT [unittest options]
"""
import sys
import unittest

import check_libraries

BMT = ""


class PlantedViolations(unittest.TestCase):
    def setUp(self):
        self.needed = {
            "pipeline": ["libvtkMTIO.so.0.1", "libvtkRenderingOpenGL2-9.1.so.1"],
            "libvtkMTIO.so.0.1": ["libvtkIOCore-9.1.so.1"],
            "libvtkRenderingOpenGL2-9.1.so.1": ["libvtkParallelDIY-9.1.so.1"],
            "libvtkParallelDIY-9.1.so.1": ["libvtkIOXML-9.1.so.1"],
        }

    def check(self):
        return check_libraries.check(self.needed, "pipeline")[0]

    def assert_one_violation(self, *words):
        violations = self.check()
        self.assertEqual(len(violations), 1, violations)
        for word in words:
            self.assertIn(word, violations[0])

    def test_what_vtks_rendering_brings_is_allowed(self):
        self.assertEqual(self.check(), [])

    def test_gdal_is_found_however_it_is_reached(self):
        self.needed["libvtkIOCore-9.1.so.1"] = ["libgdal.so.32"]
        self.assert_one_violation("pipeline -> libvtkMTIO.so.0.1 -> libvtkIOCore-9.1.so.1 -> libgdal.so.32")

    def test_libraries_of_cgal_are_found(self):
        for name in ("libgmp.so.10", "libmpfr.so.6", "libCGAL.so.13"):
            self.needed["libvtkMTIO.so.0.1"] = [name]
            self.assert_one_violation(f"libvtkMTIO.so.0.1 -> {name}")

    def test_reader_that_our_library_asks_for_is_found_though_rendering_brings_it(self):
        self.needed["libvtkMTIO.so.0.1"].append("libvtkIOXML-9.1.so.1")
        self.assert_one_violation("pipeline -> libvtkMTIO.so.0.1 -> libvtkIOXML-9.1.so.1")

    def test_reader_that_the_program_asks_for_is_found(self):
        self.needed["pipeline"].append("libvtkIOPLY-9.1.so.1")
        self.assert_one_violation("pipeline -> libvtkIOPLY-9.1.so.1")

    def test_reader_behind_a_vtk_library_that_does_not_draw_is_found(self):
        self.needed["libvtkMTIO.so.0.1"].append("libvtkFiltersHybrid-9.1.so.1")
        self.needed["libvtkFiltersHybrid-9.1.so.1"] = ["libvtkIOGeometry-9.1.so.1"]
        self.assert_one_violation("libvtkFiltersHybrid-9.1.so.1 -> libvtkIOGeometry-9.1.so.1")

    def test_the_command_bmt_reads_meshes_but_loads_gdal_when_it_needs_it(self):
        violations = "\n".join(check_libraries.check(check_libraries.read_needed(BMT), "bmt")[0])
        self.assertIn("libvtkIOXML-", violations)
        self.assertNotIn("libgdal", violations)
        self.assertEqual(check_libraries.main([BMT]), 1)

    def test_a_program_without_the_toolkit_is_no_evidence(self):
        self.assertEqual(check_libraries.main([sys.executable]), 1)


if __name__ == "__main__":
    BMT = sys.argv.pop(1)
    unittest.main()
