#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The check of the layers is checked: each kind of violation, planted in a small tree, is found."""
import tempfile
import unittest
from pathlib import Path

import check_layers


class PlantedViolations(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(self.folder.name)
        self.write("Module/vtk.module", "NAME\n  MultiTriangulation::MTCore\nDEPENDS\n  VTK::CommonCore\n")
        self.write("Module/vtkMTGraph.h", '#include "vtkMTCoreModule.h"\n#include <vector>\n')
        self.write("IO/MultiTriangulation/vtk.module", "NAME\n  MultiTriangulation::MTIO\nDEPENDS\n  MultiTriangulation::MTCore\n  VTK::IOCore\n")
        self.write("IO/MultiTriangulation/vtkMTFile.h", '#include "vtkMTGraph.h"\n')
        self.write("IO/MultiTriangulation/vtkMTFile.cxx", '#include "vtkMTFile.h"\n#include "vtkMTCoreModule.h"\n')
        self.write("Filters/Partition/vtk.module", "DEPENDS\n  MultiTriangulation::MTCore\n")
        self.write("Applications/main.cxx", '#include "vtkMTFile.h"\n')

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, text):
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def assert_one_violation(self, *words):
        violations, _ = check_layers.check(self.root)
        self.assertEqual(len(violations), 1, violations)
        for word in words:
            self.assertIn(word, violations[0])

    def test_clean_tree_has_none(self):
        violations, counts = check_layers.check(self.root)
        self.assertEqual(violations, [])
        self.assertEqual(counts, (3, 4, 6))

    def test_include_of_a_forbidden_layer_is_found(self):
        self.write("Filters/Partition/vtkMTSeeds.cxx", '// comment\n#include "vtkMTFile.h"\n')
        self.assert_one_violation("Filters/Partition/vtkMTSeeds.cxx:2", "must not include vtkMTFile.h of IO/MultiTriangulation")

    def test_include_with_blanks_and_angle_brackets_is_found(self):
        self.write("Filters/Partition/vtkMTSeeds.cxx", "  #  include <vtkMTFile.h>\n")
        self.assert_one_violation("must not include vtkMTFile.h of IO/MultiTriangulation")

    def test_layer_zero_includes_no_other_layer(self):
        self.write("Module/vtkMTCut.cxx", '#include "vtkMTIOModule.h"\n')
        self.assert_one_violation("Module must not include vtkMTIOModule.h of IO/MultiTriangulation")

    def test_depends_on_a_forbidden_module_is_found(self):
        self.write("Filters/Partition/vtk.module", "DEPENDS\n  MultiTriangulation::MTCore\nPRIVATE_DEPENDS\n  MultiTriangulation::MTIO\n")
        self.assert_one_violation("Filters/Partition/vtk.module", "MultiTriangulation::MTIO")

    def test_rendering_in_a_filter_is_found(self):
        self.write("Filters/Partition/vtk.module", "DEPENDS\n  MultiTriangulation::MTCore\n  VTK::RenderingCore\n")
        self.assert_one_violation("VTK::RenderingCore")

    def test_cgal_outside_simplification_is_found(self):
        self.write("Applications/extra.cxx", "#include <CGAL/Surface_mesh.h>\n")
        self.assert_one_violation("Applications/extra.cxx:1", "CGAL")

    def test_cgal_in_simplification_is_allowed(self):
        self.write("Filters/Simplification/vtkMTEdgeCollapse.cxx", "#include <CGAL/Surface_mesh.h>\n")
        self.assertEqual(check_layers.check(self.root)[0], [])

    def test_cgal_in_the_oracle_of_the_report_is_allowed(self):
        self.write("Testing/Report/MTReportCgal.cxx", "#include <CGAL/Surface_mesh.h>\n")
        self.write("Testing/Report/CMakeLists.txt", "add_executable(report MTReportCgal.cxx) # no install()\n")
        self.assertEqual(check_layers.check(self.root)[0], [])

    def test_cgal_in_anything_else_of_the_report_is_found(self):
        for name in ("MTReportCgal.h", "MTReportStiff.cxx", "sub/MTReportCgal.cxx", "MTReportCgal2.cxx"):
            self.write(f"Testing/Report/{name}", "#include <CGAL/Surface_mesh.h>\n")
            self.assert_one_violation(f"Testing/Report/{name}:1", "CGAL")
            (self.root / "Testing/Report" / name).unlink()

    def test_cgal_elsewhere_in_the_tests_is_found(self):
        self.write("Testing/Common/MTReportCgal.cxx", "#include <CGAL/Surface_mesh.h>\n")
        self.assert_one_violation("Testing/Common/MTReportCgal.cxx:1", "CGAL")

    def test_installing_the_report_is_found(self):
        self.write("Testing/Report/CMakeLists.txt", "add_executable(report MTReportCgal.cxx)\n  INSTALL (TARGETS report)\n")
        self.assert_one_violation("Testing/Report/CMakeLists.txt:2", "is not installed")

    def test_opengl_in_the_cut_is_found(self):
        self.write("Rendering/Core/vtkMTCache.cxx", '#include "vtkOpenGLPolyDataMapper.h"\n')
        self.assert_one_violation("OpenGL")

    def test_vtk_in_what_runs_without_it_is_found(self):
        self.write("Module/vtkMTLattice.h", '#include "vtkType.h"\n#include "vtkMath.h"\n')
        self.write("Module/vtkMTGraph.h", '#include "vtkMTCoreModule.h"\n#include "vtkMTLattice.h"\n')
        self.assert_one_violation("Module/vtkMTGraph.h is to run without VTK", "vtkMTLattice.h includes vtkMath.h")

    def test_json_in_the_graph_is_found(self):
        self.write("Module/vtkMTPatch.cxx", "#include <nlohmann/json.hpp>\n")
        self.assert_one_violation("Module/vtkMTPatch.cxx:1", "JSON")

    def test_include_without_depends_is_found(self):
        self.write("Filters/Partition/vtk.module", "DEPENDS\n  VTK::CommonCore\n")
        self.write("Filters/Partition/vtkMTSeeds.cxx", '#include "vtkMTGraph.h"\n')
        self.assert_one_violation("vtk.module does not name MTCore")

    def test_module_outside_the_layers_is_found(self):
        self.write("Filters/Extra/vtk.module", "DEPENDS\n  MultiTriangulation::MTCore\n")
        self.assert_one_violation("Filters/Extra/vtk.module")

    def test_the_command_fails_on_a_violation_and_on_an_empty_tree(self):
        self.assertEqual(check_layers.main([str(self.root)]), 0)
        self.write("Module/vtkMTCut.cxx", '#include "vtkMTIOModule.h"\n')
        self.assertEqual(check_layers.main([str(self.root)]), 1)
        with tempfile.TemporaryDirectory() as empty:
            self.assertEqual(check_layers.main([empty]), 1)


if __name__ == "__main__":
    unittest.main()
