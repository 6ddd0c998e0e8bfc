#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""read, build, cut and verify: what they give, and what they say when something is wrong."""
import copy
import os
import pickle
import sys
import tempfile
import threading
import time
import types
import unittest
import warnings

import numpy

import multitriangulation as mt
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkSphere
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkRenderingCore import vtkCamera


def make_sphere(resolution=80):
    source = vtkSphereSource()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.GenerateNormalsOff()
    source.Update()
    mesh = source.GetOutput()
    heights = vtkFloatArray()
    heights.SetName("height")
    for i in range(mesh.GetNumberOfPoints()):
        heights.InsertNextValue(mesh.GetPoint(i)[2])
    mesh.GetPointData().AddArray(heights)
    return mesh


def count_edges(triangles):
    """How many triangles each edge has."""
    edges = numpy.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    return numpy.unique(edges, axis=0, return_counts=True)[1]


class Functions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.mesh = make_sphere()
        cls.file = os.path.join(cls.folder.name, "sphere.ply")
        writer = vtkPLYWriter()
        writer.SetInputData(cls.mesh)
        writer.SetFileName(cls.file)
        writer.Write()
        cls.name = os.path.join(cls.folder.name, "sphere.bmt")
        cls.model = mt.build(cls.mesh, cls.name, patch_triangles=200)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_partition_builds(self):
        for name in ("v", "regular", "kd", "quad", "quad-sphere", "hexagon", "hexagon-plane"):
            file = os.path.join(self.folder.name, name + ".bmt")
            model = mt.build(self.mesh, file, partition=name, patch_triangles=200)
            self.assertEqual(model.triangles, self.mesh.GetNumberOfPolys(), name)

    def test_model_says_what_it_is(self):
        model = mt.read(self.name)
        print(model)
        self.assertIsInstance(model, vtkPolyData)
        self.assertEqual(model.path, self.name)
        self.assertEqual(model.triangles, self.mesh.GetNumberOfPolys())
        self.assertGreater(model.patches, 50)
        self.assertGreater(model.levels, 3)
        self.assertIn("height", model.point_arrays)
        numpy.testing.assert_allclose(model.array_range("height"), (-0.5, 0.5), atol=1e-6)
        with self.assertRaisesRegex(KeyError, "no array 'depth'; there are"):
            model.array_range("depth")
        numpy.testing.assert_allclose(model.bounds, (-0.5, 0.5) * 3, atol=0.1)

    def test_cuts_go_by_triangles_error_level_view_and_region(self):
        by_triangles = mt.cut(self.model, triangles=2000)
        self.assertLessEqual(len(by_triangles.triangles), 2000)
        self.assertGreater(len(by_triangles.triangles), 1000)
        by_error = mt.cut(self.name, error=by_triangles.error)
        self.assertLessEqual(by_error.error, by_triangles.error)
        finest = mt.cut(self.model, level=0)
        self.assertEqual(len(finest.triangles), self.model.triangles)
        self.assertEqual((finest.finest_level, finest.coarsest_level), (0, 0))
        coarsest = mt.cut(self.model)
        self.assertLess(len(coarsest.triangles), len(by_triangles.triangles))
        camera = vtkCamera()
        camera.SetPosition(0, 0, 5)
        camera.SetClippingRange(1, 10)
        near = len(mt.cut(self.model, camera=camera, size=(4000, 4000), pixel_error=0.5).triangles)
        far = len(mt.cut(self.model, camera=camera, size=(100, 100), pixel_error=0.5).triangles)
        self.assertGreater(near, far)
        region = vtkSphere()
        region.SetCenter(0.5, 0, 0)
        region.SetRadius(0.1)
        local = mt.cut(self.model, error=1e-4, region=region)
        boxed = mt.cut(self.model, error=1e-4, region=(0.4, 0.6, -0.1, 0.1, -0.1, 0.1))
        for each in (local, boxed):
            self.assertLess(len(each.triangles), len(mt.cut(self.model, error=1e-4).triangles))
            self.assertLess(each.finest_level, each.coarsest_level)
        for each in (by_triangles, by_error, finest, coarsest, local, boxed):
            self.assertTrue((count_edges(each.triangles) == 2).all(), each)
        print(by_triangles, by_error, local, boxed, f"{far} and {near} triangles seen from afar and near")

    def test_arrays_of_cuts_share_the_memory_of_vtk(self):
        cut = mt.cut(self.model, triangles=2000)
        self.assertEqual(cut.points.shape, (cut.GetNumberOfPoints(), 3))
        self.assertEqual(cut.point_data["height"].shape, (cut.GetNumberOfPoints(),))
        numpy.testing.assert_allclose(cut.point_data["height"], cut.points[:, 2], atol=0.1)
        cut.points[7] = (1, 2, 3)
        self.assertEqual(cut.GetPoint(7), (1.0, 2.0, 3.0))
        cut.point_data["height"][7] = 42
        self.assertEqual(cut.GetPointData().GetArray("height").GetValue(7), 42)
        self.assertEqual(cut.GetCell(11).GetPointIds().GetId(2), cut.triangles[11, 2])
        points, triangles = cut.points, cut.triangles
        expected = points.copy()
        del cut
        numpy.testing.assert_array_equal(points, expected)
        self.assertLess(triangles.max(), len(points))
        few = mt.cut(self.model, triangles=2000, arrays=[])
        self.assertEqual(list(few.point_data), [])
        with self.assertRaisesRegex(KeyError, "no array 'height'; there are none"):
            few.point_data["height"]

    def test_models_are_pickled_as_file_and_place(self):
        model = mt.read(self.name)
        model.ApplyTransform([0, -2, 0, 5, 2, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1])
        data = pickle.dumps(model)
        print(len(data), "bytes")
        self.assertLess(len(data), 1000)
        for other in (pickle.loads(data), copy.copy(model), copy.deepcopy(model)):
            self.assertEqual(other.path, model.path)
            self.assertEqual(other.bounds, model.bounds)
            self.assertEqual(other.patches, model.patches)
        with self.assertRaisesRegex(TypeError, "only in memory cannot be pickled"):
            pickle.dumps(mt.build(self.mesh))

    def test_meshes_of_numpy_of_filters_and_of_files_give_the_same(self):
        source = vtkSphereSource()
        source.SetThetaResolution(30)
        source.SetPhiResolution(20)
        source.GenerateNormalsOff()
        source.Update()
        data = source.GetOutput()
        points = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())], numpy.float32)
        triangles = numpy.array(
            [[data.GetCell(i).GetPointId(c) for c in range(3)] for i in range(data.GetNumberOfCells())])
        trimesh = types.SimpleNamespace(vertices=points, faces=triangles)
        cuts = [mt.cut(mt.build(each, patch_triangles=100), level=0)
                for each in (data, source, (points, triangles), trimesh, (points.tolist(), triangles.tolist()))]
        for each in cuts:
            numpy.testing.assert_array_equal(each.points, cuts[0].points)
            numpy.testing.assert_array_equal(each.triangles, cuts[0].triangles)
        self.assertEqual(mt.build(self.file).triangles, self.model.triangles)
        self.assertEqual(mt.build([self.file, self.file]).triangles, 2 * self.model.triangles)

    def test_a_model_without_a_name_lives_as_long_as_it_is_used(self):
        before = set(os.listdir(tempfile.gettempdir()))
        model = mt.build(self.file, patch_triangles=200)
        left = [name for name in set(os.listdir(tempfile.gettempdir())) - before if name.startswith("multitriangulation")]
        self.assertEqual(left, [])
        self.assertIsNone(model.path)
        self.assertEqual(len(mt.cut(model, level=0).triangles), model.triangles)

    def test_progress_rises_to_one_and_what_it_raises_ends_the_build(self):
        steps = []
        mt.build(self.file, progress=lambda fraction, text: steps.append((fraction, text)))
        fractions = [fraction for fraction, _ in steps]
        print(len(steps), "steps, such as", steps[len(steps) // 2])
        self.assertEqual(fractions, sorted(fractions))
        self.assertEqual(fractions[-1], 1.0)
        self.assertTrue(any(text for _, text in steps))

        def end(fraction, text):
            raise InterruptedError("enough")

        out = os.path.join(self.folder.name, "ended.bmt")
        for source in (self.file, self.mesh):
            with self.assertRaisesRegex(InterruptedError, "enough"):
                mt.build(source, out, progress=end)
            self.assertFalse(os.path.exists(out))

    def test_other_threads_run_while_a_model_is_built(self):
        counted = [0]
        over = threading.Event()

        def count():
            while not over.is_set():
                counted[0] += 1
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        try:
            start = counted[0]
            mt.build(make_sphere(300), patch_triangles=100)
            during = counted[0] - start
        finally:
            over.set()
            thread.join()
        print(during, "steps of another thread")
        self.assertGreater(during, 10)

    def test_verify_finds_a_model_of_another_mesh(self):
        good = mt.verify(self.model, self.mesh, cuts=10, samples=2000)
        self.assertTrue(good, good)
        self.assertTrue(good.certified)
        of_file = mt.verify(mt.build(self.file), self.file, cuts=10, samples=2000)
        self.assertTrue(of_file, of_file)
        self.assertTrue(of_file.input_checked)
        bad = mt.verify(self.model, make_sphere(60), cuts=10, samples=2000)
        print(good, bad, of_file.input_reading)
        self.assertFalse(bad)
        self.assertTrue(any(check.violations and check.message for check in bad.checks))

    def test_errors_say_what_is_wrong(self):
        missing = os.path.join(self.folder.name, "missing.bmt")
        damaged = os.path.join(self.folder.name, "damaged.bmt")
        with open(self.name, "rb") as good, open(damaged, "wb") as bad:
            bad.write(good.read()[:1000])
        cases = [
            (FileNotFoundError, "missing", lambda: mt.read(missing)),
            (FileNotFoundError, "missing", lambda: mt.build(missing)),
            (mt.MultiTriangulationError, "damaged", lambda: mt.read(damaged)),
            (mt.MultiTriangulationError, "not a Multi-Triangulation", lambda: mt.read(self.file)),
            (mt.MultiTriangulationError, "no level 99", lambda: mt.cut(self.model, level=99)),
            (mt.MultiTriangulationError, "triangles", lambda: mt.cut(self.model, triangles=1)),
            (TypeError, "triangles and level are given", lambda: mt.cut(self.model, triangles=1, level=2)),
            (ValueError, "no distance", lambda: mt.cut(self.model, error=float("nan"))),
            (TypeError, "no setting 'patch'", lambda: mt.build(self.file, patch=3)),
            (TypeError, "no setting 'resume' of a mesh in memory", lambda: mt.build(self.mesh, resume=True)),
            (ValueError, "memory='much'", lambda: mt.build(self.file, memory="much")),
            (ValueError, "none of v,", lambda: mt.build(self.file, partition="quads")),
            (ValueError, "none of v,", lambda: mt.build(self.file, partition="kd-plane")),
            (ValueError, "none of fast", lambda: mt.build(self.file, simplifier="good")),
            (ValueError, "not a number", lambda: mt.build(self.file, feature_angle=float("nan"))),
            (ValueError, r"shapes \(n, 3\)", lambda: mt.build((numpy.zeros((3, 2)), numpy.zeros((1, 3), int)))),
            (ValueError, "outside 0 to 2", lambda: mt.build((numpy.zeros((3, 3)), numpy.array([[0, 1, 3]])))),
            (TypeError, "neither the name of a file", lambda: mt.build(42)),
            (TypeError, "neither a model", lambda: mt.cut(42)),
            (mt.MultiTriangulationError, "folder|directory|exist",
             lambda: mt.build(self.file, os.path.join(self.folder.name, "none", "x.bmt"))),
            (mt.MultiTriangulationError, "none", lambda: mt.build(self.mesh, os.path.join(self.folder.name, "none", "x.bmt"))),
            (TypeError, "no setting 'iso' of a mesh", lambda: mt.build(self.mesh, iso=1.0)),
        ]
        for kind, text, call in cases:
            with self.subTest(text), self.assertRaisesRegex(kind, text) as caught:
                call()
            print(kind.__name__, "-", caught.exception)

    def test_warnings_are_python_s(self):
        mesh = make_sphere()
        mesh.GetPoints().SetPoint(50, 1e12, 0, 0)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            mt.build(mesh)
        print([str(each.message) for each in caught])
        self.assertEqual(len(caught), 1)
        self.assertIn("far", str(caught[0].message))

    def test_nothing_is_printed_by_vtk(self):
        # The errors of the tests before went to Python, not to standard error: VTK writes there itself.
        read, write = os.pipe()
        kept = os.dup(2)
        os.dup2(write, 2)
        try:
            for call in (lambda: mt.read("missing.bmt"), lambda: mt.cut(self.model, level=99), lambda: mt.build("missing.ply")):
                with self.assertRaises(Exception):
                    call()
        finally:
            sys.stderr.flush()
            os.dup2(kept, 2)
            os.close(write)
            os.close(kept)
        with os.fdopen(read, "rb") as pipe:
            printed = pipe.read()
        self.assertEqual(printed, b"")


if __name__ == "__main__":
    unittest.main()
