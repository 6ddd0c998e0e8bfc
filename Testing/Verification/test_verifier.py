#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A model is built and verified in Python, and what came of it is read from tables."""
import unittest

from multitriangulation import vtkMTFractalSphereSource, vtkMultiTriangulationBuilder, vtkMultiTriangulationVerifier


class Verifier(unittest.TestCase):
    def setUp(self):
        self.sphere = vtkMTFractalSphereSource()
        self.sphere.SetNumberOfTriangles(5120)
        builder = vtkMultiTriangulationBuilder()
        builder.SetPatchTriangles(100)
        builder.SetInputConnection(self.sphere.GetOutputPort())
        self.verifier = vtkMultiTriangulationVerifier()
        self.verifier.SetInputConnection(0, builder.GetOutputPort())
        self.verifier.SetNumberOfCuts(20)
        self.verifier.SetNumberOfSamples(5000)

    def get_rows(self):
        table = self.verifier.GetOutput()
        return {
            table.GetValueByName(i, "name").ToString(): table.GetValueByName(i, "violations").ToInt()
            for i in range(table.GetNumberOfRows())
        }

    def test_model_alone(self):
        self.verifier.Update()
        self.assertEqual(list(self.get_rows()), ["checksums", "graph", "patches", "nesting", "pasting", "conformity"])
        self.assertTrue(self.verifier.IsValid())
        self.assertFalse(self.verifier.GetCertified())

    def test_model_against_its_input(self):
        self.verifier.SetInputConnection(1, self.sphere.GetOutputPort())
        self.verifier.Update()
        rows = self.get_rows()
        print(rows)
        self.assertEqual(set(rows.values()), {0})
        self.assertIn("certified_input_to_cut", rows)
        self.assertTrue(self.verifier.IsValid())
        levels = self.verifier.GetTightness()
        self.assertGreater(levels.GetNumberOfRows(), 2)
        self.assertGreaterEqual(levels.GetValueByName(0, "median").ToDouble(), 1.0)

    def test_another_mesh_is_not_taken_for_the_input(self):
        other = vtkMTFractalSphereSource()
        other.SetNumberOfTriangles(5120)
        other.SetSeed(9)
        self.verifier.SetInputConnection(1, other.GetOutputPort())
        self.verifier.Update()
        self.assertGreater(self.get_rows()["certified_patch_to_input"], 0)
        self.assertFalse(self.verifier.IsValid())


if __name__ == "__main__":
    unittest.main()
