#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The package can be imported beside vtkmodules, and its classes are VTK classes there."""
import tempfile
import unittest

import multitriangulation
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPolyData, vtkSphere
from vtkmodules.vtkCommonMisc import vtkErrorCode
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOPLY import vtkPLYWriter

# What is in the package beside them are functions and what these give (test_functions.py).
CLASSES = [name for name in multitriangulation.__all__ if name.startswith("vtk")]


class Package(unittest.TestCase):
    def test_every_exported_class_is_a_vtk_object(self):
        classes = [getattr(multitriangulation, name) for name in CLASSES]
        print(len(classes), "classes:", ", ".join(CLASSES))
        self.assertIn("vtkMultiTriangulation", multitriangulation.__all__)
        for each in classes:
            self.assertTrue(issubclass(each, vtkObject), each)

    def test_data_object_is_polydata_for_vtk(self):
        model = multitriangulation.vtkMultiTriangulation()
        self.assertIsInstance(model, vtkPolyData)
        self.assertEqual(model.GetNumberOfPatches(), 0)

    def test_a_file_is_built_of_a_file_and_opened(self):
        with tempfile.TemporaryDirectory() as folder:
            source = vtkSphereSource()
            source.SetThetaResolution(60)
            source.SetPhiResolution(60)
            writer = vtkPLYWriter()
            writer.SetInputConnection(source.GetOutputPort())
            writer.SetFileName(folder + "/sphere.ply")
            writer.Write()
            builder = multitriangulation.vtkMultiTriangulationFileBuilder()
            builder.AddFileName(folder + "/sphere.ply")
            builder.SetOutputFileName(folder + "/sphere.bmt")
            builder.SetPatchTriangles(200)
            progress = []
            builder.AddObserver("ProgressEvent", lambda caller, event: progress.append(caller.GetProgress()))
            self.assertEqual(builder.Write(), 1, builder.GetErrorMessage())
            self.assertEqual(progress[-1], 1.0)
            reader = multitriangulation.vtkMultiTriangulationReader()
            reader.SetFileName(folder + "/sphere.bmt")
            reader.Update()
            model = reader.GetOutput()
            print(model.GetNumberOfPatches(), "patches,", len(progress), "progress events")
            self.assertGreater(model.GetNumberOfPatches(), 10)

    def test_errors_of_a_build_have_codes_and_are_observed(self):
        builder = multitriangulation.vtkMultiTriangulationFileBuilder()
        errors = []
        builder.AddObserver("ErrorEvent", lambda caller, event: errors.append(caller.GetErrorMessage()))
        builder.GetExecutive().AddObserver("ErrorEvent", lambda caller, event: None)
        builder.SetFileName("no-such-file.ply")
        builder.SetOutputFileName("out.bmt")
        self.assertEqual(builder.Write(), 0)
        self.assertEqual(builder.GetErrorCode(), vtkErrorCode.FileNotFoundError)
        self.assertEqual(len(errors), 1)
        self.assertIn("no-such-file.ply", errors[0])

    def test_mapper_colours_by_elevation_and_by_material(self):
        mapper = multitriangulation.vtkMultiTriangulationMapper()
        errors = []
        mapper.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
        mapper.SetColorByElevation((0, 0, float("nan")), (0, 0, 2), (0, 100))
        mapper.SetColorByElevation((0, 0, 2), (0, 0, 2), (0, 100))
        self.assertEqual(len(errors), 2)
        self.assertEqual(mapper.GetColorBy(), mapper.NONE)
        mapper.SetColorByElevation((0, 0, -1), (0, 0, 2), (0, 100))
        self.assertEqual(mapper.GetColorBy(), mapper.ELEVATION)
        self.assertEqual(mapper.GetElevationLowPoint(), (0, 0, -1))
        self.assertEqual(mapper.GetElevationHighPoint(), (0, 0, 2))
        self.assertEqual(mapper.GetElevationRange(), (0, 100))
        self.assertEqual(mapper.GetScalarRange(), (0, 100))
        before = mapper.GetMTime()
        mapper.MapTextureToMaterial("", 3)
        self.assertEqual(mapper.GetMTime(), before)
        mapper.MapTextureToMaterial("bark", 3)
        self.assertGreater(mapper.GetMTime(), before)
        self.assertFalse(mapper.SelectColors())

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
        # They hold every cut, and coarse ones pass the sphere by as much as their error.
        self.assertLess(bounds[0], 9.501)
        self.assertGreater(bounds[0], 9.45)

    def test_every_concrete_class_prints_itself(self):
        for name in CLASSES:
            try:
                instance = getattr(multitriangulation, name)()
            except (TypeError, NotImplementedError):  # abstract
                continue
            self.assertIn(name, str(instance))


if __name__ == "__main__":
    unittest.main()
