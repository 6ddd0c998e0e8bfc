#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""actor, screenshot and show: what they draw. Needs a display."""
import os
import sys
import tempfile
import unittest

import numpy

import multitriangulation as mt
from vtkmodules.vtkCommonCore import vtkCommand
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkCamera, vtkPolyDataMapper, vtkRenderWindowInteractor
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from test_functions import make_sphere  # noqa: E402


class Drawing(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.name = os.path.join(cls.folder.name, "sphere.bmt")
        cls.model = mt.build(make_sphere(), cls.name, patch_triangles=200)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_picture_is_that_of_the_finest_level(self):
        camera = vtkCamera()
        camera.SetPosition(0.4, 1.1, 1.7)
        picture = mt.screenshot(self.model, pixel_error=0, size=(320, 240), camera=camera)
        plain = vtkPolyDataMapper()
        plain.SetInputData(mt.cut(self.model, level=0))
        plain.ScalarVisibilityOff()
        finest = vtkActor()
        finest.SetMapper(plain)
        expected = mt.screenshot(finest, size=(320, 240), camera=camera)
        self.assertEqual(picture.shape, (240, 320, 3))
        self.assertEqual(picture.dtype, numpy.uint8)
        off = numpy.abs(picture.astype(int) - expected).max(axis=2)
        drawn = int((picture != picture[0, 0]).any(axis=2).sum())
        print(f"{drawn} pixels drawn, the largest difference is {off.max()} of 255, {(off > 4).sum()} differ by more than 4")
        self.assertGreater(drawn, 10000)
        self.assertLess((off > 4).sum(), drawn // 1000)

    def test_first_row_is_the_top_and_the_file_holds_the_same(self):
        camera = vtkCamera()
        camera.SetPosition(0, 0, 6)
        camera.SetFocalPoint(0, -0.8, 0)  # so the sphere is in the upper half
        path = os.path.join(self.folder.name, "picture.png")
        picture = mt.screenshot(self.name, path=path, size=(200, 200), camera=camera, background=(0, 0, 0))
        self.assertGreater(picture[:100].sum(), 10 * max(int(picture[100:].sum()), 1))
        reader = vtkPNGReader()
        reader.SetFileName(path)
        reader.Update()
        stored = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(200, 200, 3)
        numpy.testing.assert_array_equal(stored[::-1], picture)

    def test_colours_span_the_whole_model(self):
        actor = mt.actor(self.model, color_by="height", triangles=300)
        numpy.testing.assert_allclose(actor.GetMapper().GetScalarRange(), (-0.5, 0.5), atol=1e-6)
        camera = vtkCamera()
        camera.SetPosition(3, 0, 0)
        camera.SetViewUp(0, 0, 1)
        picture = mt.screenshot(actor, camera=camera, size=(200, 200), background=(0, 0, 0)).astype(int)
        red = [picture[rows, :, 0].sum() for rows in (slice(0, 100), slice(100, 200))]
        blue = [picture[rows, :, 2].sum() for rows in (slice(0, 100), slice(100, 200))]
        print("red above and below", red, "blue", blue)
        self.assertGreater(red[0], 10 * red[1])
        self.assertGreater(blue[1], 10 * blue[0])
        narrow = mt.actor(self.model, color_by="height", clim=(0, 0.1))
        self.assertEqual(narrow.GetMapper().GetScalarRange(), (0, 0.1))
        levels = mt.actor(self.model, color_by="level").GetMapper()
        self.assertEqual(levels.GetColorBy(), levels.LEVEL)

    def test_settings_reach_the_mapper(self):
        mapper = mt.actor(self.name, pixel_error=3.5, metric="edges", triangles=1234).GetMapper()
        self.assertIsInstance(mapper, mt.vtkMultiTriangulationMapper)
        self.assertEqual(
            (mapper.GetPixelError(), mapper.GetErrorMetric(), mapper.GetTriangleLimit()), (3.5, mapper.EDGE_LENGTH, 1234))
        self.assertEqual((mapper.GetErrorMetricArray(), mapper.GetValueError()), ("", 0))
        mapper = mt.actor(self.name, value="height", value_error=0.25).GetMapper()
        self.assertEqual(
            (mapper.GetErrorMetric(), mapper.GetErrorMetricArray(), mapper.GetValueError()),
            (mapper.VALUE, "height", 0.25))
        for bad in (
            {"pixel_error": float("nan")},
            {"metric": "beauty"},
            {"metric": "value"},
            {"metric": "edges", "value": "height"},
            {"value": "height", "value_error": float("nan")},
        ):
            with self.assertRaises(ValueError):
                mt.actor(self.model, **bad)
        with self.assertRaisesRegex(KeyError, "no array 'depth'"):
            mt.actor(self.model, color_by="depth")

    def test_several_models_are_in_one_picture(self):
        other = mt.read(self.name)
        other.ApplyTransform([1, 0, 0, 2, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])
        picture = mt.screenshot(self.model, other, size=(300, 150), background=(0, 0, 0))
        lit = picture.any(axis=2).any(axis=0)
        changes = int((lit[1:] != lit[:-1]).sum())
        print(changes, "borders between model and background along a row")
        self.assertEqual(changes, 4)

    def test_window_opens_and_ends_with_its_key(self):
        ended = []
        init = vtkRenderWindowInteractor.Start

        def start(interactor):
            interactor.Initialize()
            interactor.CreateOneShotTimer(50)

            def end(caller, event):
                ended.append(caller.GetRenderWindow().GetSize())
                caller.SetKeyCode("q")
                caller.SetKeySym("q")
                caller.InvokeEvent(vtkCommand.CharEvent)

            interactor.AddObserver("TimerEvent", end)
            init(interactor)

        import multitriangulation._draw as draw

        class Interactor(vtkRenderWindowInteractor):
            Start = start

        kept, draw.vtkRenderWindowInteractor = draw.vtkRenderWindowInteractor, Interactor
        try:
            mt.show(self.model, size=(320, 200), title="a test")
        finally:
            draw.vtkRenderWindowInteractor = kept
        self.assertEqual(ended, [(320, 200)])


if __name__ == "__main__":
    unittest.main()
