# SPDX-License-Identifier: BSD-3-Clause
"""Models and their cuts, as VTK data that numpy can look at."""
from __future__ import annotations

import math
import os
from collections.abc import Mapping

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4

from . import vtkMultiTriangulation, vtkMultiTriangulationReader
from ._errors import Listener, fail

_ASSOCIATIONS = {"point": vtkDataObject.POINT, "cell": vtkDataObject.CELL}


class Arrays(Mapping):
    """Arrays of points or of cells by their names, as numpy arrays that share VTK's memory."""

    def __init__(self, attributes):
        self._attributes = attributes

    def __getitem__(self, name):
        array = self._attributes.GetAbstractArray(name)
        if array is None:
            raise KeyError(f"no array '{name}'; there are {', '.join(self) or 'none'}")
        if not hasattr(array, "GetVoidPointer"):
            return [array.GetValue(i) for i in range(array.GetNumberOfValues())]
        return vtk_to_numpy(array)

    def __iter__(self):
        names = (self._attributes.GetArrayName(i) for i in range(self._attributes.GetNumberOfArrays()))
        return (name for name in names if name)

    def __len__(self):
        return sum(1 for _ in self)

    def __repr__(self):
        return f"<arrays {', '.join(self) or 'none'}>"


class Triangles(vtkPolyData):
    """
    A triangle mesh: a vtkPolyData with its data as numpy arrays, without copies.

    The arrays share VTK's memory and keep it alive; what is written to them is in the mesh (call Modified() then).
    """

    @property
    def points(self) -> numpy.ndarray:
        """Places of the points: float32 or float64, shape (points, 3), in the input's units."""
        points = self.GetPoints()
        return vtk_to_numpy(points.GetData()) if points else numpy.empty((0, 3), numpy.float32)

    @property
    def triangles(self) -> numpy.ndarray:
        """Indices of the corners' points: int64 or int32, shape (triangles, 3), anticlockwise from outside."""
        return vtk_to_numpy(self.GetPolys().GetConnectivityArray()).reshape(-1, 3)

    @property
    def point_data(self) -> Arrays:
        """Arrays of the points by name: numpy arrays of the shape (points,) or (points, components)."""
        return Arrays(self.GetPointData())

    @property
    def cell_data(self) -> Arrays:
        """Arrays of the triangles by name: numpy arrays of the shape (triangles,) or (triangles, components)."""
        return Arrays(self.GetCellData())


class Cut(Triangles):
    """A conforming triangle mesh at a chosen resolution, as `cut` gives it."""

    #: Largest certified distance to the input, in its units, both ways; 0 where the cut is the input bit for bit.
    error = math.inf
    #: No point of the cut is farther from the input; none of the input is farther from the cut.
    distance_to_input = math.inf
    distance_from_input = math.inf
    #: Levels of the finest and the coarsest patch; 0 is the model's finest.
    finest_level = 0
    coarsest_level = 0
    #: Number of patches.
    patches = 0
    #: Whether the points are the input's own, bit for bit.
    exact = False

    def __repr__(self):
        return f"<Cut of {self.GetNumberOfPolys():,} triangles, error {self.error:.3g}>"

    __str__ = __repr__


class Model(vtkMultiTriangulation):
    """
    A Multi-Triangulation: a vtkPolyData (its coarsest cut) with patches that finer cuts are made of.

    VTK's filters and mappers take it as polydata; the toolkit's own take the patches. `read` and `build` make it.
    It is pickled as the name of its file, and its place; a model that has no file cannot be pickled.
    """

    #: The file that it was read from, absolute; None where it was built in memory.
    path = None

    @property
    def triangles(self) -> int:
        """Number of triangles of the finest level."""
        return self.GetNumberOfFinestTriangles()

    @property
    def levels(self) -> int:
        """Number of levels; 0 is the finest."""
        return self.GetNumberOfLevels()

    @property
    def patches(self) -> int:
        """Number of patches of all levels."""
        return self.GetNumberOfPatches()

    @property
    def bounds(self) -> tuple[float, ...]:
        """xmin, xmax, ymin, ymax, zmin, zmax that hold every cut, in the input's units."""
        bounds = [0.0] * 6
        self.GetModelBounds(bounds)
        return tuple(bounds)

    @property
    def point_arrays(self) -> list[str]:
        """Names of the arrays of points."""
        return list(Arrays(self.GetPointData()))

    @property
    def cell_arrays(self) -> list[str]:
        """Names of the arrays of cells."""
        return list(Arrays(self.GetCellData()))

    def find_array(self, name: str) -> str:
        """'point' or 'cell': where an array is; KeyError where it is not."""
        for association, names in (("point", self.point_arrays), ("cell", self.cell_arrays)):
            if name in names:
                return association
        raise KeyError(f"no array '{name}'; there are {', '.join(self.point_arrays + self.cell_arrays) or 'none'}")

    def array_range(self, name: str, component: int = 0, association: str | None = None) -> tuple[float, float]:
        """
        The least and the largest value of an array in the finest level; nothing is read.

        component: from 0; -1 is the magnitude, of which the range is a bound. association: 'point' or 'cell';
        None, the default: where the array is, points first. KeyError where there is no such array or component.
        """
        limits = [0.0, 0.0]
        place = _ASSOCIATIONS[association or self.find_array(name)]
        if not self.GetArrayRange(name, place, component, limits):
            raise KeyError(f"array '{name}' has no component {component}, or no value that is a number")
        return tuple(limits)

    def __reduce__(self):
        if self.path is None:
            raise TypeError("a model that is only in memory cannot be pickled: build it into a file (out=...)")
        frame = [0.0] * 16
        self.GetFrame(frame)
        return _restore, (self.path, tuple(frame))

    def __repr__(self):
        of = f"'{self.path}'" if self.path else "in memory"
        return f"<Model {of}: {self.triangles:,} triangles, {self.patches:,} patches, {self.levels} levels>"

    __str__ = __repr__


def wrap(data, path=None):
    """A Model of what a filter or reader gave."""
    model = Model()
    model.ShallowCopy(data)
    model.path = os.path.abspath(path) if path else None
    return model


def read(path: str | os.PathLike) -> Model:
    """
    Opens a Multi-Triangulation file (.bmt); its patches are read when they are needed.

    path: a name or a path object. FileNotFoundError where there is no such file; MultiTriangulationError where it is
    damaged or none of the toolkit's.
    """
    reader = vtkMultiTriangulationReader()
    reader.SetFileName(os.fspath(path))
    with Listener(reader) as listener:
        reader.Update()
    if reader.GetErrorCode():
        fail(reader.GetErrorCode(), "; ".join(listener.errors[:1]), os.fspath(path))
    return wrap(reader.GetOutput(), path)


def _restore(path, frame):
    """What pickle calls: the model of a file, where it was put."""
    model = read(path)
    present, inverse, step = [0.0] * 16, [0.0] * 16, [0.0] * 16
    model.GetFrame(present)
    if tuple(present) != frame:
        vtkMatrix4x4.Invert(present, inverse)
        vtkMatrix4x4.Multiply4x4(frame, inverse, step)
        model.ApplyTransform(step)
    return model


def open_model(model):
    """A model, given as such, as a vtkMultiTriangulation, as an algorithm that makes one, or as the name of a file."""
    if isinstance(model, vtkMultiTriangulation):
        return model
    if hasattr(model, "GetOutputDataObject"):
        model.Update()
        output = model.GetOutputDataObject(0)
        if isinstance(output, vtkMultiTriangulation):
            return output
    elif isinstance(model, (str, os.PathLike)):
        return read(model)
    raise TypeError(f"neither a model, nor what makes one, nor the name of its file: {type(model).__name__}")
