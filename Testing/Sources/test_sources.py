#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The generators are sources of VTK pipelines in Python."""
import unittest

import multitriangulation
from multitriangulation import vtkMTFractalSphereSource, vtkMTPlaneSource, vtkMTVersion


class Sources(unittest.TestCase):
    def test_sphere(self):
        source = vtkMTFractalSphereSource()
        source.SetNumberOfTriangles(1000)
        source.Update()
        self.assertEqual(source.GetOutput().GetNumberOfPolys(), 1280)
        self.assertEqual(source.GetOutput().GetNumberOfPoints(), 642)
        first = source.GetOutput().GetPoint(0)
        source.SetSeed(5)
        source.Update()
        self.assertNotEqual(first, source.GetOutput().GetPoint(0))

    def test_plane(self):
        source = vtkMTPlaneSource()
        source.SetNumberOfTriangles(200)
        seen = []
        source.AddObserver("ProgressEvent", lambda caller, event: seen.append(caller.GetProgress()))
        source.Update()
        self.assertEqual(source.GetOutput().GetNumberOfPolys(), 200)
        self.assertEqual(source.GetOutput().GetBounds(), (0, 1, 0, 1, 0, 0))
        self.assertEqual(seen[-1], 1)

    def test_settings_are_described(self):
        self.assertIn("wanted", vtkMTPlaneSource.SetNumberOfTriangles.__doc__)

    def test_version(self):
        numbers = (vtkMTVersion.GetMajorVersion(), vtkMTVersion.GetMinorVersion(), vtkMTVersion.GetPatchVersion())
        self.assertEqual(vtkMTVersion.GetVersion(), ".".join(str(each) for each in numbers))
        self.assertGreater(numbers, (0, 0, 0))
        self.assertIn("vtkMTVersion", multitriangulation.__all__)


if __name__ == "__main__":
    unittest.main()
