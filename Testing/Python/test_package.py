#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The package can be imported beside vtkmodules, and its classes are VTK classes there."""
import unittest

import multitriangulation
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPolyData, vtkSphere
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersSources import vtkSphereSource


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

    def test_filters_of_a_pipeline(self):
        names = (
            "vtkMultiTriangulationBuilder", "vtkMultiTriangulationTransform", "vtkMultiTriangulationCutFilter",
            "vtkMultiTriangulationSection",
        )
        if not set(names) <= set(multitriangulation.__all__):
            self.skipTest("the toolkit was built without some of these")
        builder, moved, cut, section = (getattr(multitriangulation, name)() for name in names)
        mesh = vtkSphereSource()
        mesh.SetThetaResolution(80)
        mesh.SetPhiResolution(80)
        builder.SetInputConnection(mesh.GetOutputPort())
        builder.SetPatchTriangles(100)
        transform = vtkTransform()
        transform.Translate(10, 0, 0)
        moved.SetInputConnection(builder.GetOutputPort())
        moved.SetTransform(transform)
        cut.SetInputConnection(moved.GetOutputPort())
        cut.SetTriangleLimit(4000)
        region = vtkSphere()
        region.SetCenter(10.5, 0, 0)
        region.SetRadius(0.2)
        cut.SetRegion(region)
        cut.Update()
        self.assertEqual(cut.GetErrorMessage(), "")
        self.assertLessEqual(cut.GetOutput().GetNumberOfPolys(), 4000)
        self.assertGreater(cut.GetOutput().GetNumberOfPolys(), 0)
        section.SetInputConnection(moved.GetOutputPort())
        plane = vtkPlane()
        plane.SetOrigin(10, 0, 0)
        section.SetImplicitFunction(plane)
        section.Update()
        self.assertGreater(section.GetOutput().GetNumberOfLines(), 20)
        bounds = [0.0] * 6
        moved.GetOutput().GetModelBounds(bounds)
        self.assertAlmostEqual(bounds[0], 9.5, 2)

    def test_every_concrete_class_prints_itself(self):
        for name in multitriangulation.__all__:
            try:
                instance = getattr(multitriangulation, name)()
            except (TypeError, NotImplementedError):  # abstract
                continue
            self.assertIn(name, str(instance))


if __name__ == "__main__":
    unittest.main()
