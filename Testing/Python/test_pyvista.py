#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""multitriangulation.pyvista: models in PyVista, read, wrapped, built, drawn. Needs a display; left out where there is no PyVista."""
import importlib.util
import os
import pickle
import subprocess
import sys
import tempfile
import unittest

import numpy

import multitriangulation as mt

if importlib.util.find_spec("pyvista") is None:
    print("there is no PyVista: these tests are left out")
    sys.exit(77)

import pyvista as pv  # noqa: E402

import multitriangulation.pyvista as mtpv  # noqa: E402

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from test_functions import make_sphere  # noqa: E402

pv.OFF_SCREEN = True
SIZE = (400, 300)


def make_mesh():
    mesh = pv.PolyData(make_sphere())
    mesh.points = mesh.points * 10.0
    mesh.point_data["height"] = mesh.points[:, 2]
    mesh.point_data["place"] = mesh.points
    mesh.cell_data["sector"] = numpy.floor(mesh.cell_centers().points[:, 0]).astype(numpy.float32)
    shades = numpy.clip((mesh.points + 5.0) * 25.5, 0, 255)
    mesh.point_data["paint"] = shades.astype(numpy.uint8)
    return mesh


def take_picture(mesh, *args, **kwargs):
    plotter = pv.Plotter(window_size=SIZE, lighting="light kit")
    plotter.set_background("white")
    actor = plotter.add_mesh(mesh, *args, **kwargs)
    plotter.camera_position = [(33, 4, 5), (0, 0, 0), (0, 0, 1)]
    picture = plotter.screenshot(return_img=True).astype(int)
    return picture, plotter, actor


def count_different(one, other, by=8):
    return int((numpy.abs(one - other).max(axis=2) > by).sum())


class InPyVista(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        print("PyVista", pv.__version__)
        cls.folder = tempfile.TemporaryDirectory()
        cls.name = os.path.join(cls.folder.name, "sphere.bmt")
        cls.mesh = make_mesh()
        cls.model = cls.mesh.mt.build(cls.name, patch_triangles=200)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def run_python(self, text):
        done = subprocess.run([sys.executable, "-c", text, self.name], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.strip()

    def test_package_does_not_import_pyvista(self):
        print_it = "import sys, multitriangulation; print('pyvista' in sys.modules)"
        self.assertEqual(self.run_python(print_it), "False")

    def test_entry_points_are_found_without_an_import(self):
        if not hasattr(pv, "register_reader"):
            self.skipTest("PyVista looks at entry points from 0.48 on")
        text = "import sys, pyvista; print(type(pyvista.read(sys.argv[1])).__name__, callable(pyvista.Sphere().mt.build))"
        self.assertEqual(self.run_python(text), "MultiTriangulation True")

    def test_read_gives_a_dataset_with_patches(self):
        model = pv.read(self.name)
        self.assertIsInstance(model, pv.PolyData)
        self.assertIsInstance(model, mt.Model)
        self.assertEqual(model.path, self.name)
        self.assertEqual(model.triangles, self.mesh.n_cells)
        self.assertLess(model.n_cells, self.mesh.n_cells)
        self.assertEqual(mt.cut(model, level=0).triangles.shape[0], self.mesh.n_cells)
        self.assertIn("Model", repr(model))
        with self.assertRaises(FileNotFoundError):
            pv.read(os.path.join(self.folder.name, "none.bmt"))
        damaged = os.path.join(self.folder.name, "damaged.bmt")
        with open(damaged, "wb") as file:
            file.write(b"nothing of ours" * 100)
        with self.assertRaises(mt.MultiTriangulationError):
            pv.read(damaged)

    def test_get_reader_reads(self):
        if hasattr(pv, "register_reader"):
            self.skipTest("a function is registered, and read calls it")
        self.assertEqual(pv.get_reader(self.name).read().triangles, self.mesh.n_cells)

    def test_wrapped_model_is_polydata_and_keeps_its_patches(self):
        model = pv.wrap(mt.read(self.name))
        self.assertIsInstance(model, mtpv.MultiTriangulation)
        self.assertEqual(model.triangles, self.mesh.n_cells)
        self.assertIs(pv.wrap(model), model)
        self.assertEqual(model.points.shape, (model.n_points, 3))
        self.assertLess(model.clip("x").n_cells, model.n_cells)
        for copy in (model.copy(), model.copy(deep=False), pickle.loads(pickle.dumps(model))):
            self.assertIsInstance(copy, mtpv.MultiTriangulation)
            self.assertEqual((copy.triangles, copy.path), (model.triangles, model.path))
        self.assertEqual(model.array_range("height"), (self.mesh["height"].min(), self.mesh["height"].max()))
        self.assertNotIsInstance(pv.wrap(make_sphere()), mt.Model)

    def test_moved_model_is_pickled_where_it_is(self):
        model = pv.read(self.name)
        model.ApplyTransform([1, 0, 0, 100, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])
        self.assertAlmostEqual(pickle.loads(pickle.dumps(model)).center[0], 100, delta=0.5)

    def test_accessor_builds_and_cuts(self):
        model = self.mesh.mt.build(patch_triangles=200)
        self.assertIsNone(model.path)
        self.assertEqual(model.triangles, self.mesh.n_cells)
        cut = model.mt.cut(triangles=3000)
        self.assertIsInstance(cut, pv.PolyData)
        self.assertTrue(cut.is_all_triangles if isinstance(cut.is_all_triangles, bool) else cut.is_all_triangles())
        self.assertEqual(cut.n_open_edges, 0)
        self.assertLessEqual(cut.n_cells, 3000)
        self.assertGreater(cut.n_cells, model.n_cells)
        self.assertGreater(cut.field_data[mtpv.ERROR_FIELD][0], 0.0)
        with self.assertRaises(TypeError):
            self.mesh.mt.cut(triangles=3000)
        with self.assertRaises(TypeError):
            self.mesh.mt.build(no_such_setting=1)

    def test_model_is_drawn_by_its_mapper_as_the_finest_mesh_looks(self):
        picture, plotter, actor = take_picture(self.model, color="tan", pixel_error=0, smooth_shading=False)
        mapper = actor.mapper
        self.assertIsInstance(mapper, mt.vtkMultiTriangulationMapper)
        drawn = mapper.GetNumberOfTriangles()
        finest, other, _ = take_picture(self.mesh, color="tan", smooth_shading=False)
        coarse, third, _ = take_picture(pv.PolyData(self.model), color="tan", smooth_shading=False)
        off, far = count_different(picture, finest), count_different(coarse, finest)
        print(f"{drawn} of {self.model.triangles} triangles; {off} pixels differ from the mesh, {far} where its coarsest cut is drawn")
        self.assertGreater(drawn, 2 * self.model.n_cells)
        self.assertLess(off, far // 20)
        numpy.testing.assert_allclose(mapper.bounds, self.mesh.bounds, atol=0.1)  # those of the lattice's boxes
        self.assertIs(plotter.mapper, mapper)
        for each in (plotter, other, third):
            each.close()

    def test_view_decides_how_much_is_drawn(self):
        counts = []
        for error in (0.2, 20):
            _, plotter, actor = take_picture(self.model, pixel_error=error)
            counts.append(actor.mapper.GetNumberOfTriangles())
            plotter.close()
        _, plotter, actor = take_picture(self.model, pixel_error=0, triangles=2000)
        counts.append(actor.mapper.GetNumberOfTriangles())
        plotter.close()
        print("triangles at 0.2 pixels, at 20, and where 2000 are allowed:", counts)
        self.assertGreater(counts[0], counts[1])
        self.assertLessEqual(counts[2], 2000)

    def check_colours(self, allowed=60, **settings):
        """The picture of the model is that of the mesh, scalar bar and all."""
        picture, plotter, actor = take_picture(self.model, pixel_error=0, **settings)
        expected, other, plain = take_picture(self.mesh, **settings)
        off = count_different(picture, expected, 24)
        print(settings, f"{off} pixels differ")
        self.assertLess(off, allowed)
        self.assertEqual(list(plotter.scalar_bars.keys()), list(other.scalar_bars.keys()))
        numpy.testing.assert_allclose(actor.mapper.scalar_range, plain.mapper.scalar_range, rtol=1e-5, atol=1e-5)
        plotter.close()
        other.close()
        return actor

    def test_colours_and_scalar_bar_are_those_of_the_mesh(self):
        self.check_colours(scalars="height")
        self.check_colours(scalars="height", cmap="coolwarm", clim=(-2, 3), below_color="black", above_color="red")
        self.check_colours(scalars="height", show_scalar_bar=False, n_colors=5, flip_scalars=True)
        self.check_colours(scalars="sector")
        self.check_colours(scalars="place", component=1, scalar_bar_args={"title": "y", "vertical": True})
        self.check_colours(scalars="paint", rgb=True)
        self.check_colours(scalars="height", opacity="linear", show_scalar_bar=False)
        self.check_colours(color="lightblue", opacity=0.5)

    def test_magnitude_spans_what_the_model_certifies(self):
        _, plotter, actor = take_picture(self.model, scalars="place")
        least, largest = actor.mapper.scalar_range
        self.assertLessEqual(least, 5.0)
        self.assertGreaterEqual(largest, 4.99)
        self.assertIn("place", plotter.scalar_bars)
        plotter.close()

    def test_active_scalars_are_drawn_where_nothing_is_said(self):
        model = self.model.copy(deep=False)
        model.set_active_scalars("height")
        _, plotter, actor = take_picture(model, pixel_error=0)
        self.assertTrue(actor.mapper.GetScalarVisibility())
        self.assertEqual(actor.mapper.array_name, "height")
        numpy.testing.assert_allclose(actor.mapper.scalar_range, (-5, 5), atol=1e-5)
        plotter.close()

    def test_one_scalar_bar_spans_two_models(self):
        plotter = pv.Plotter(window_size=SIZE)
        moved = self.mesh.copy()
        moved.points = moved.points + [12, 0, 0]
        moved["height"] = moved["height"] + 7
        actors = [plotter.add_mesh(each, scalars="height") for each in (self.model, moved.mt.build(patch_triangles=200))]
        plotter.show(auto_close=False)
        for actor in actors:
            numpy.testing.assert_allclose(actor.mapper.scalar_range, (-5, 12), atol=1e-4)
        plotter.close()

    def test_colours_of_the_cut(self):
        picture, plotter, actor = take_picture(self.model, color_by="patch", pixel_error=0)
        colours = len(numpy.unique(picture.reshape(-1, 3), axis=0))
        self.assertEqual(actor.mapper.GetColorBy(), actor.mapper.PATCH)
        self.assertEqual(len(plotter.scalar_bars), 0)
        plain, other, _ = take_picture(self.model, color="tan", pixel_error=0)
        print(colours, "colours where patches have their own,", len(numpy.unique(plain.reshape(-1, 3), axis=0)), "in one colour")
        self.assertGreater(count_different(picture, plain), 1000)
        plotter.close()
        other.close()

    def test_files_and_pipelines_are_drawn_too(self):
        reader = mt.vtkMultiTriangulationReader()
        reader.SetFileName(self.name)
        for source in (self.name, reader, mt.read(self.name)):
            plotter = pv.Plotter()
            self.assertIsInstance(plotter.add_mesh(source).mapper, mt.vtkMultiTriangulationMapper)
            plotter.close()

    def test_other_meshes_are_drawn_as_ever(self):
        plotter = pv.Plotter()
        self.assertNotIsInstance(plotter.add_mesh(pv.Sphere()).mapper, mt.vtkMultiTriangulationMapper)
        plotter.close()

    def test_what_cannot_be_is_refused(self):
        plotter = pv.Plotter()
        for error, settings in (
            (TypeError, {"scalars": numpy.arange(self.model.n_points)}),
            (ValueError, {"scalars": "height", "categories": True}),
            (ValueError, {"silhouette": True}),
            (ValueError, {"style": "points_gaussian"}),
            (ValueError, {"opacity": "height"}),
            (ValueError, {"pixel_error": float("nan")}),
            (ValueError, {"metric": "taste"}),
            (ValueError, {"scalars": "place", "component": 7}),
            (KeyError, {"scalars": "no such array"}),
            (TypeError, {"no_such_setting": 1}),
        ):
            with self.assertRaises(error, msg=str(settings)):
                plotter.add_mesh(self.model, **settings)
        changed = self.model.copy(deep=False)
        changed.point_data["added"] = numpy.zeros(changed.n_points)
        with self.assertRaises(ValueError):
            plotter.add_mesh(changed, scalars="added")
        self.assertEqual(len(plotter.actors), 0)
        plotter.close()

    def test_names_replace_actors(self):
        plotter = pv.Plotter()
        plotter.add_mesh(self.model, name="scan")
        actor = plotter.add_mesh(self.model, name="scan", color="red")
        self.assertEqual(list(plotter.actors), ["scan"])
        self.assertIs(plotter.actors["scan"], actor)
        self.assertTrue(plotter.remove_actor("scan"))
        plotter.close()

    def test_drawing_leaves_the_model_alone(self):
        before = (list(self.model.point_data.keys()), self.model.triangles, self.model.active_scalars_name)
        take_picture(self.model, scalars="place", component=0)[1].close()
        self.assertEqual((list(self.model.point_data.keys()), self.model.triangles, self.model.active_scalars_name), before)

    def test_uninstalled_and_installed_again(self):
        plain = pv.BasePlotter.add_mesh._plain
        mtpv.install()
        self.assertIs(pv.BasePlotter.add_mesh._plain, plain)
        mtpv.uninstall()
        try:
            self.assertIs(pv.BasePlotter.add_mesh, plain)
            plotter = pv.Plotter()
            self.assertIsInstance(mtpv.add_mesh(plotter, self.model).mapper, mt.vtkMultiTriangulationMapper)
            plotter.close()
            with self.assertRaises(TypeError):
                pv.wrap(mt.read(self.name))
        finally:
            mtpv.install()
        self.assertIsInstance(pv.wrap(mt.read(self.name)), mtpv.MultiTriangulation)


if __name__ == "__main__":
    unittest.main()
