# SPDX-License-Identifier: BSD-3-Clause
"""
Models in PyVista: read, wrapped, built, drawn.

    import pyvista as pv
    import multitriangulation.pyvista               # has PyVista know the toolkit

    model = pv.read("scan.bmt")                     # or pv.wrap(mt.read("scan.bmt"))
    model = mesh.mt.build("scan.bmt")               # of any pyvista.PolyData
    plotter = pv.Plotter()
    plotter.add_mesh(model, scalars="height", pixel_error=1)
    coarse = model.mt.cut(triangles=100_000)        # a pyvista.PolyData

Importing this module calls `install`; nothing else in the package needs PyVista. PyVista 0.48 and later find the reader
and the accessor without it, by the package's entry points. `add_mesh` of this module is a function for those who want
PyVista's own methods left alone: uninstall() and add_mesh(plotter, model).
"""
from __future__ import annotations

import functools
import inspect
import os
from typing import Any

import numpy
import pyvista
from pyvista.core.utilities import reader as _pyvista_reader
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkRenderingCore import vtkMapper

import multitriangulation as toolkit

from ._draw import configure
from ._model import Model

__all__ = ["Accessor", "Mapper", "MultiTriangulation", "add_mesh", "install", "read", "uninstall"]

ENDING = ".bmt"
NAMESPACE = "mt"
ERROR_FIELD = "CertifiedError"


class MultiTriangulation(pyvista.PolyData, Model):
    """
    A model as a PyVista dataset: the polydata of its coarsest cut, with the patches that finer cuts are made of.

    Every filter of PyVista takes it, and gives what it makes of the coarsest cut; `mt.cut` gives any other one to begin
    with, and `Plotter.add_mesh` draws the patches. It has the figures of `multitriangulation.Model`: triangles, levels,
    patches, array_range ... Points, cells and bounds are those of the coarsest cut. It is pickled like a Model, as the name
    of its file and its place.
    """

    def __init__(self, data=None, deep=False):
        super().__init__()
        if data is not None:
            (self.DeepCopy if deep else self.ShallowCopy)(data)
            self.path = getattr(data, "path", None)

    def copy_meta_from(self, other, *args, **kwargs):
        """What PyVista's copy calls: its own attributes, and the name of the file."""
        super().copy_meta_from(other, *args, **kwargs)
        self.path = getattr(other, "path", None)

    def __reduce__(self):
        return _unpickle, Model.__reduce__(self)

    def __reduce_ex__(self, protocol):
        return self.__reduce__()

    def __repr__(self):
        return f"{Model.__repr__(self)}, its coarsest cut:\n{pyvista.PolyData.__repr__(self)}"

    __str__ = __repr__


def _unpickle(restore, arguments):
    return MultiTriangulation(restore(*arguments))


# The class beside the VTK mapper that pyvista.DataSetMapper is made of; it is called otherwise from version to version.
_MapperAttributes = next(base for base in pyvista.DataSetMapper.__bases__ if not issubclass(base, vtkMapper))


class Mapper(_MapperAttributes, toolkit.vtkMultiTriangulationMapper):
    """The toolkit's mapper with the attributes of pyvista.DataSetMapper: lookup_table, scalar_range, dataset ..."""


class Accessor:
    """What `mesh.mt` is, for every pyvista.PolyData `mesh`."""

    def __init__(self, mesh):
        self._mesh = mesh

    def build(self, out: str | os.PathLike | None = None, **settings: Any) -> MultiTriangulation:
        """Builds a model of the mesh, in the file `out` or in memory: see multitriangulation.build for the settings."""
        return MultiTriangulation(toolkit.build(self._mesh, out, **settings))

    def cut(self, **choices: Any) -> pyvista.PolyData:
        """
        A cut of a model: see multitriangulation.cut for the choices (triangles, error, level, camera, region ...).

        Its certified distance to the input is in the field data, as "CertifiedError".
        """
        cut = toolkit.cut(self._mesh, **choices)
        mesh = pyvista.PolyData(cut)
        mesh.field_data[ERROR_FIELD] = numpy.array([cut.error])
        return mesh


def read(path: str | os.PathLike) -> MultiTriangulation:
    """What pyvista.read calls for .bmt: see multitriangulation.read. Files elsewhere are brought by PyVista first."""
    if "://" in os.fspath(path):
        from pyvista.core.utilities.reader_registry import LocalFileRequiredError

        raise LocalFileRequiredError
    return MultiTriangulation(toolkit.read(path))


class _Reader(_pyvista_reader.BaseReader):
    """For pyvista.get_reader, where there is no register_reader."""

    _class_reader = toolkit.vtkMultiTriangulationReader

    def _update_information(self):
        pass

    def read(self):
        """A MultiTriangulation."""
        return read(self.path)


# What add_mesh of PyVista draws from the values of a mesh's points and cells, which of a model are those of its coarsest cut.
_NEEDS_VALUES = {
    "categories": "the number of different values is not known: name the colours with cmap and annotations",
    "show_vertices": "vertices are not drawn",
    "silhouette": "silhouettes are made of a mesh: model.mt.cut(...) gives one",
    "multi_colors": "there are no blocks",
}


def _get_options(plain, plotter, model, args, kwargs):
    """The arguments of PyVista's add_mesh by name, without its first two."""
    options = inspect.signature(plain).bind(plotter, model, *args, **kwargs).arguments
    options = dict(list(options.items())[2:])
    options.update(options.pop("kwargs", {}))
    if "rng" in options:
        options["clim"] = options.pop("rng")
    for name, reason in _NEEDS_VALUES.items():
        if options.get(name):
            raise ValueError(f"{name}: {reason}")
    if options.get("style") == "points_gaussian":
        raise ValueError("style='points_gaussian' is for point clouds; a model is a surface")
    if not isinstance(options.get("scalars"), (str, type(None))):
        raise TypeError(
            "scalars of a model are the name of one of its arrays: values for the points of its coarsest cut say nothing "
            "about its patches. Build the model from a mesh that has them")
    opacity = options.get("opacity")
    if isinstance(opacity, str) and opacity in model.point_data.keys() + model.cell_data.keys():
        raise ValueError(f"opacity='{opacity}': the values of an array cannot be opacities; a transfer function can be one")
    return options


def _find(model, name, preference):
    """'point' or 'cell': where PyVista finds an array."""
    places = {"point": model.point_arrays, "cell": model.cell_arrays}
    first = "cell" if preference == "cell" else "point"
    return first if name in places[first] else model.find_array(name)


def _get_range(model, name, association, component):
    data = model.GetAttributes(vtkDataObject.POINT if association == "point" else vtkDataObject.CELL)
    single = data.GetAbstractArray(name).GetNumberOfComponents() == 1
    try:
        return model.array_range(name, 0 if single else -1 if component is None else component, association)
    except KeyError:
        raise ValueError(
            f"'{name}' is no array of the model, or has no such component: values that were added to its coarsest cut say "
            "nothing about its patches. Build the model from a mesh that has them") from None


def _color(mapper, name, association, component, rgb):
    mapper.SelectColorArray(name)
    mapper.scalar_map_mode = f"{association}_field"
    mapper.scalar_visibility = True
    if rgb:
        mapper.color_mode = "direct"
    elif component is None:
        mapper.lookup_table.SetVectorModeToMagnitude()
    else:
        mapper.lookup_table.SetVectorModeToComponent()
        mapper.lookup_table.SetVectorComponent(component)


def _choose_scalars(model, stand_in, options, color_by):
    """Completes the options: which array, of what, with which range. Gives its name and place, or None."""
    name, component = options.get("scalars"), options.get("component")
    if color_by is not None or any(options.get(each) is not None for each in ("color", "texture")) and name is None:
        return None, None
    if name is None:
        name = stand_in.active_scalars_name
    if name is None:
        return None, None
    association = _find(model, name, options.get("preference"))
    if options.get("rgb") is None:
        options["rgb"] = name.endswith(("_rgb", "_rgba"))
    limits = _get_range(model, name, association, component)
    if options.get("clim") is None and not options["rgb"]:
        options["clim"] = limits
    options.update(scalars=name, preference=association)
    return name, association


def _add_scalar_bar(plotter, mapper, name, show, options):
    if not (plotter.theme.show_scalar_bar if show is None else show):
        return
    settings = dict(options.get("scalar_bar_args") or {})
    settings.setdefault("title", name)
    settings.setdefault("n_colors", options.get("n_colors", 256))
    for side in ("above", "below"):
        if options.get(f"{side}_color"):
            settings.setdefault(f"{side}_label", side)
    plotter.add_scalar_bar(mapper=mapper, render=False, **settings)


def add_mesh(
    plotter: pyvista.BasePlotter,
    model: Any,
    *args: Any,
    pixel_error: float = 1.0,
    metric: str = "distance",
    triangles: int = 0,
    value: str | None = None,
    value_error: float = 0.0,
    color_by: str | None = None,
    **kwargs: Any,
) -> pyvista.Actor:
    """
    Adds a model to a plotter: pyvista.Plotter.add_mesh, drawn by the toolkit's mapper at the resolution of the view.

    pixel_error, metric, triangles, value, value_error: see multitriangulation.actor. color_by: "level", "patch" or
    "error". All else as for PyVista's method. Ranges of colours are those of the whole model. ValueError for what needs the values of a mesh:
    categories, silhouette, show_vertices, an array of opacities; TypeError for scalars that are no name.

    Gives a pyvista.Actor; its mapper is a `Mapper`, with all settings and figures.
    """
    plain = _plain_add_mesh(type(plotter))
    if not isinstance(model, MultiTriangulation):
        model = MultiTriangulation(model)
    options = _get_options(plain, plotter, model, args, kwargs)
    show_scalar_bar, render = options.pop("show_scalar_bar", None), options.pop("render", True)
    # PyVista makes property, lookup table, name and legend from the coarsest cut; what it adds to that is not the model's.
    stand_in = pyvista.PolyData()
    stand_in.ShallowCopy(model)
    name, association = _choose_scalars(model, stand_in, options, color_by)
    mapper = Mapper(theme=plotter.theme)
    configure(mapper, pixel_error, metric, triangles, color_by, value, value_error)
    actor = plain(plotter, stand_in, show_scalar_bar=False, render=False, **options)
    mapper.ShallowCopy(actor.mapper)
    mapper.SetInputDataObject(model)
    if name is not None:
        _color(mapper, name, association, options.get("component"), options["rgb"])
    actor.mapper = plotter.mapper = mapper
    plotter.mesh = model
    if name is not None and not options["rgb"]:
        _add_scalar_bar(plotter, mapper, name, show_scalar_bar, options)
    if render:
        plotter.render()
    return actor


def _find_model(mesh):
    """The model that an argument of add_mesh stands for, or None."""
    if isinstance(mesh, (str, os.PathLike)) and os.fspath(mesh).lower().endswith(ENDING):
        return read(mesh)
    if isinstance(mesh, vtkAlgorithm) and isinstance(mesh.GetOutputDataObject(0), toolkit.vtkMultiTriangulation):
        mesh.Update()
        mesh = mesh.GetOutputDataObject(0)
    return mesh if isinstance(mesh, toolkit.vtkMultiTriangulation) and mesh.GetNumberOfPatches() else None


def _plain_add_mesh(plotter_class):
    return getattr(plotter_class.add_mesh, "_plain", plotter_class.add_mesh)


def _install_add_mesh():
    plain = _plain_add_mesh(pyvista.BasePlotter)

    @functools.wraps(plain)
    def method(self, mesh, *args, **kwargs):
        model = _find_model(mesh)
        return plain(self, mesh, *args, **kwargs) if model is None else add_mesh(self, model, *args, **kwargs)

    method._plain = plain
    pyvista.BasePlotter.add_mesh = method


def install() -> None:
    """
    Has PyVista know the toolkit; a second call changes nothing. What importing this module does.

    - pyvista.read and get_reader for .bmt: register_reader, or the table of readers before PyVista 0.48;
    - the accessor `mt` of pyvista.PolyData: register_dataset_accessor, or a property before 0.48;
    - pyvista.wrap: the entry of vtkMultiTriangulation in PyVista's table of wrappers;
    - Plotter.add_mesh: a method that hands models to this module's `add_mesh`, and all else to PyVista's. PyVista has no
      hook for that.
    """
    if hasattr(pyvista, "register_reader"):
        known = pyvista.registered_readers() if hasattr(pyvista, "registered_readers") else ()
        if all(each.extension != ENDING for each in known):
            pyvista.register_reader(ENDING, read)
    else:
        _pyvista_reader.CLASS_READERS[ENDING] = _Reader
    if not hasattr(pyvista, "register_dataset_accessor"):
        setattr(pyvista.PolyData, NAMESPACE, property(Accessor))
    elif getattr(pyvista.PolyData, NAMESPACE, None) is not Accessor:
        pyvista.register_dataset_accessor(NAMESPACE, pyvista.PolyData)(Accessor)
    pyvista._wrappers["vtkMultiTriangulation"] = MultiTriangulation
    if not hasattr(pyvista.BasePlotter.add_mesh, "_plain"):
        _install_add_mesh()


def uninstall() -> None:
    """Takes back what `install` did, but for the reader and the accessor of PyVista 0.48 and later."""
    if not hasattr(pyvista, "register_reader"):
        _pyvista_reader.CLASS_READERS.pop(ENDING, None)
    if not hasattr(pyvista, "register_dataset_accessor") and NAMESPACE in vars(pyvista.PolyData):
        delattr(pyvista.PolyData, NAMESPACE)
    pyvista._wrappers.pop("vtkMultiTriangulation", None)
    pyvista.BasePlotter.add_mesh = _plain_add_mesh(pyvista.BasePlotter)


install()
