#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""test_examples.py FOLDER: runs the examples of Examples/Python as their users do, and looks at what they draw and print. Needs a
display."""
import importlib.util
import os
import re
import subprocess
import sys
import tempfile
import unittest

import numpy

import multitriangulation as mt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from test_functions import make_sphere  # noqa: E402

FOLDER = sys.argv.pop(1)


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[::-1].astype(int)


class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.model = cls.path("sphere.bmt")
        mt.build(make_sphere(), cls.model, patch_triangles=200)
        cls.ran = set()

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    @classmethod
    def path(cls, name):
        return os.path.join(cls.scratch.name, name)

    def run_example(self, name, *arguments):
        done = subprocess.run(
            [sys.executable, os.path.join(FOLDER, name), *map(str, arguments)], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.ran.add(name)
        return done.stdout

    def get_share(self, picture):
        """Of the pixels, those that are not the background, which the corner shows."""
        pixels = read(picture)
        share = (pixels != pixels[0, 0]).any(axis=2).mean()
        print(f"{os.path.basename(picture)}: {100 * share:.1f} % drawn")
        return share

    def test_source_to_screen(self):
        mt_file = self.path("sphere.ply")
        from vtkmodules.vtkIOPLY import vtkPLYWriter

        writer = vtkPLYWriter()
        writer.SetInputData(make_sphere())
        writer.SetFileName(mt_file)
        writer.Write()
        self.run_example("source_to_screen.py", mt_file, self.path("source.png"))
        self.assertTrue(0.1 < self.get_share(self.path("source.png")) < 0.6)

    def test_terrain_of_two_tiles(self):
        for longitude in (5, 6):
            heights = numpy.add.outer(numpy.arange(1201), numpy.arange(1201)) if longitude == 5 else numpy.full((1201, 1201), 1200)
            with open(self.path(f"N45E{longitude:03d}.hgt"), "wb") as file:
                file.write(heights.astype(">i2").tobytes())
        self.run_example("terrain.py", self.path("terrain.png"), self.path("N45E005.hgt"), self.path("N45E006.hgt"))
        self.assertGreater(self.get_share(self.path("terrain.png")), 0.1)
        pixels = read(self.path("terrain.png"))
        drawn = pixels[(pixels != pixels[0, 0]).any(axis=2)]
        self.assertGreater(drawn[:, 0].max() - drawn[:, 0].min(), 60)  # colours rise with the height

    def test_isosurface(self):
        source, writer = vtkRTAnalyticSource(), vtkXMLImageDataWriter()
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetFileName(self.path("volume.vti"))
        writer.Write()
        self.run_example("isosurface.py", self.path("volume.vti"), 150, self.path("iso.png"))
        self.assertGreater(self.get_share(self.path("iso.png")), 0.05)

    def test_colour_by_array(self):
        self.run_example("colour_by_array.py", self.model, "height", self.path("colours.png"))
        pixels = read(self.path("colours.png"))
        colours = {tuple(each) for each in pixels.reshape(-1, 3)}
        print(len(colours), "colours")
        self.assertGreater(len(colours), 1000)

    def test_in_pyvista(self):
        self.ran.add("in_pyvista.py")
        if importlib.util.find_spec("pyvista") is None:
            self.skipTest("there is no PyVista")
        said = self.run_example("in_pyvista.py", self.model, "height", self.path("pyvista.png"))
        print(said, end="")
        self.assertRegex(said, r"^12,480 triangles, [\d,]+ of them drawn\n$")
        pixels = read(self.path("pyvista.png"))
        for half in (pixels[:, :600], pixels[:, 600:]):
            self.assertGreater((half != half[0, 0]).any(axis=2).mean(), 0.1)

    def test_pick(self):
        hit = self.run_example("pick.py", self.model, 400, 300)
        print(hit, end="")
        place = re.fullmatch(r"triangle (\d+) of the input at \((.*), (.*), (.*)\)\n", hit)
        self.assertIsNotNone(place, hit)
        self.assertLess(int(place[1]), 12480)
        self.assertAlmostEqual(sum(float(place[i]) ** 2 for i in (2, 3, 4)), 0.25, delta=0.01)
        self.assertEqual(self.run_example("pick.py", self.model, 2, 2), "nothing there\n")

    def test_several_models(self):
        self.run_example("several_models.py", self.path("several.png"), self.model, self.model, self.model)
        pixels = read(self.path("several.png"))
        drawn = (pixels != pixels[0, 0]).any(axis=2).any(axis=0)
        self.assertEqual(int((drawn[1:] != drawn[:-1]).sum()), 6)  # three spheres along a row

    def test_region_and_section(self):
        self.run_example("region_and_section.py", self.model, self.path("region.png"))
        pixels = read(self.path("region.png"))
        red = ((pixels[:, :, 0] > 150) & (pixels[:, :, 1] < 90)).sum()
        print(red, "pixels of the section")
        self.assertGreater(red, 200)

    def test_turntable(self):
        self.run_example("turntable.py", self.model, self.path("film"), 4)
        names = sorted(os.listdir(self.path("film")))
        self.assertEqual(names, [f"frame-{i:03d}.png" for i in range(4)])
        first, second = (read(os.path.join(self.path("film"), name)) for name in names[:2])
        self.assertGreater((first != first[0, 0]).any(axis=2).mean(), 0.1)
        self.assertTrue((first != second).any())

    def test_time_budget(self):
        said = self.run_example("time_budget.py", self.model, 20)
        print(said, end="")
        self.assertRegex(said, r"^[\d.]+ frames per second of 20 asked for, \d+ triangles in the last one, within [\d.e+-]+ pixels\n$")

    def test_zz_no_example_is_left_out(self):
        # A window that waits for its user is opened by the test of mt.show; pipeline.py has a test of its own.
        self.assertEqual(set(os.listdir(FOLDER)) - self.ran - {"__pycache__"}, {"open_file.py", "pipeline.py"})


if __name__ == "__main__":
    unittest.main()
