#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The package can be imported beside vtkmodules, and its classes are VTK classes there."""
import unittest

import multitriangulation
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkPolyData


class Package(unittest.TestCase):
    def test_every_exported_class_is_a_vtk_object(self):
        classes = [getattr(multitriangulation, name) for name in multitriangulation.__all__]
        print(len(classes), "classes:", ", ".join(multitriangulation.__all__))
        self.assertIn("vtkMultiTriangulation", multitriangulation.__all__)
        for each in classes:
            self.assertTrue(issubclass(each, vtkObject), each)

    def test_data_object_is_polydata_for_vtk(self):
        model = multitriangulation.vtkMultiTriangulation()
        self.assertIsInstance(model, vtkPolyData)
        self.assertEqual(model.GetNumberOfPatches(), 0)

    def test_every_concrete_class_prints_itself(self):
        for name in multitriangulation.__all__:
            try:
                instance = getattr(multitriangulation, name)()
            except (TypeError, NotImplementedError):  # abstract
                continue
            self.assertIn(name, str(instance))


if __name__ == "__main__":
    unittest.main()
