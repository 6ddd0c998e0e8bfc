# SPDX-License-Identifier: BSD-3-Clause
"""Building models: from files out of core, from meshes in memory."""
from __future__ import annotations

import math
import os
import re
import tempfile
from collections.abc import Callable
from typing import Any

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import multitriangulation as toolkit

from ._errors import Listener, MultiTriangulationError, fail
from ._model import Model, read, wrap
from ._progress import Progress

_UNITS = {"": 1, "k": 10**3, "m": 10**6, "g": 10**9, "t": 10**12, "ki": 2**10, "mi": 2**20, "gi": 2**30, "ti": 2**40}
_COMPRESSIONS = ("none", "fast", "small")
_INPUT_IDS = ("none", "finest", "all")
_SIMPLIFIERS = {"fast": "FAST", "best": "BEST", "lindstrom-turk": "LINDSTROM_TURK", "garland-heckbert": "GARLAND_HECKBERT"}
_PARTITIONS = {
    "v": "vtkMTVoronoiPartition",
    "regular": "vtkMTRegularPartition",
    "kd": "vtkMTKdPartition",
    "quad": "vtkMTQuadPartition",
    "hexagon": "vtkMTHexagonPartition",
}
_DOMAINS = {"plane": 1, "sphere": 2}


def _get_bytes(amount):
    if not isinstance(amount, str):
        return int(amount)
    match = re.fullmatch(r"\s*([\d.]+)\s*([kmgt]?i?)b?\s*", amount.lower())
    if not match or match[2] not in _UNITS:
        raise ValueError(f"memory='{amount}' is no amount such as '512MiB' or '2GiB'")
    return int(float(match[1]) * _UNITS[match[2]])


def _get_simplifier(name):
    if not isinstance(name, str):
        return name
    if name not in _SIMPLIFIERS:
        raise ValueError(f"simplifier='{name}' is none of {', '.join(_SIMPLIFIERS)}")
    collapse = toolkit.vtkMTEdgeCollapse()
    collapse.SetMode(getattr(collapse, _SIMPLIFIERS[name]))
    return collapse


def _get_partition(name):
    if not isinstance(name, str):
        return name
    stem, dash, domain = name.partition("-")
    if stem not in _PARTITIONS or (dash and (domain not in _DOMAINS or stem not in ("quad", "hexagon"))):
        raise ValueError(f"partition='{name}' is none of {', '.join(_PARTITIONS)}, or one of the last two with -plane "
                         "or -sphere")
    strategy = getattr(toolkit, _PARTITIONS[stem])()
    if dash:
        strategy.SetDomain(_DOMAINS[domain])
    return strategy


def _get_feature_angle(angle):
    return {"auto": -1.0, "none": 180.0}.get(angle, angle)


def _get_input_ids(name):
    name = {True: "finest", False: "none"}.get(name, name)
    if name not in _INPUT_IDS:
        raise ValueError(f"ids={name!r} is none of {', '.join(_INPUT_IDS)}")
    return _INPUT_IDS.index(name)


def _get_compression(name):
    if name not in _COMPRESSIONS:
        raise ValueError(f"compression='{name}' is none of {', '.join(_COMPRESSIONS)}")
    return _COMPRESSIONS.index(name)


def _add_all(add):
    def put(builder, names):
        for name in [names] if isinstance(names, str) else names:
            getattr(builder, add)(name)

    return put


def _keep_arrays(builder, names):
    builder.KeepAllArraysOff()
    _add_all("AddArrayName")(builder, names)


def _set(setter, convert=lambda value: value):
    def put(builder, value):
        getattr(builder, setter)(convert(value))

    return put


# The settings by name: those of 'bmt build', with underscores.
_SETTINGS = {
    "iso": _set("SetIsoValue"),
    "gradient_normals": _set("SetGradientNormals"),
    "vertical_scale": _set("SetVerticalScale"),
    "degrees": _set("SetDegrees"),
    "partition": _set("SetPartitionStrategy", _get_partition),
    "simplifier": _set("SetSimplifier", _get_simplifier),
    "memory": _set("SetMemoryLimit", _get_bytes),
    "patch_triangles": _set("SetPatchTriangles"),
    "lattice_bits": _set("SetLatticeBits"),
    "threads": _set("SetNumberOfThreads"),
    "precision": _set("SetPrecision"),
    "feature_angle": _set("SetFeatureAngle", _get_feature_angle),
    "normal_bits": _set("SetNormalBits"),
    "compression": _set("SetCompression", _get_compression),
    "arrays": _keep_arrays,
    "labels": _add_all("AddLabelArrayName"),
    "values": _add_all("AddValueArrayName"),
    "certify_values": _add_all("AddCertifiedArrayName"),
    "ids": _set("SetInputIds", _get_input_ids),
    "point_ids": _set("SetInputPointIds"),
    "exact": _set("SetExactPoints"),
    "certify_normals": _set("SetCertifyNormals"),
    "direct_levels": _set("SetDirectLevels"),
    "keep_far_outliers": _set("SetKeepFarOutliers"),
    "normals": _set("SetMakeNormals"),
    "resume": _set("SetResume"),
    "temp": _set("SetTemporaryFolder", os.fspath),
}
# Those that mean something for a mesh that is in memory.
_OF_MESHES = {
    "partition", "simplifier", "memory", "patch_triangles", "lattice_bits", "threads", "feature_angle", "normal_bits", "labels",
    "values", "ids", "point_ids", "exact", "certify_normals", "certify_values", "direct_levels", "keep_far_outliers",
    "normals",
}


def _configure(builder, settings, names):
    for name, value in settings.items():
        if name not in names:
            known = ", ".join(sorted(names))
            of = "" if name not in _SETTINGS else " of a mesh in memory"
            raise TypeError(f"build has no setting '{name}'{of}; there are {known}")
        if isinstance(value, float) and math.isnan(value):
            raise ValueError(f"{name} is not a number")
        if value is not None:
            with Listener(builder) as listener:
                _SETTINGS[name](builder, value)
            if listener.errors:
                raise ValueError(f"{name}={value!r}: {listener.errors[0]}")


def _is_path(source):
    return isinstance(source, (str, os.PathLike))


def _get_paths(source):
    if _is_path(source):
        return [os.fspath(source)]
    if isinstance(source, (list, tuple)) and source and all(_is_path(each) for each in source):
        return [os.fspath(each) for each in source]
    return None


def _make_mesh(points, triangles):
    """A polydata of numpy arrays: points (n, 3), triangles (m, 3); the points' memory is shared."""
    points = numpy.ascontiguousarray(points)
    triangles = numpy.ascontiguousarray(triangles, numpy.int64)
    if points.ndim != 2 or points.shape[1] != 3 or triangles.ndim != 2 or triangles.shape[1] != 3:
        raise ValueError(f"points {points.shape} and triangles {triangles.shape} are not of the shapes (n, 3) and (m, 3)")
    if triangles.size and not (0 <= triangles.min() and triangles.max() < len(points)):
        raise ValueError(f"triangles name points outside 0 to {len(points) - 1}")
    if points.dtype not in (numpy.float32, numpy.float64):
        points = points.astype(numpy.float64)
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points))
    cells = vtkCellArray()
    offsets = numpy.arange(0, 3 * len(triangles) + 1, 3, dtype=numpy.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True))
    mesh = vtkPolyData()
    mesh.SetPoints(places)
    mesh.SetPolys(cells)
    mesh._points = points  # what VTK's array looks at
    return mesh


def _get_mesh(source):
    if hasattr(source, "GetOutputDataObject"):
        source.Update()
        source = source.GetOutputDataObject(0)
    if isinstance(source, vtkPolyData):
        return source
    if hasattr(source, "vertices") and hasattr(source, "faces"):
        source = (source.vertices, source.faces)
    if isinstance(source, (list, tuple)) and len(source) == 2:
        return _make_mesh(*source)
    raise TypeError(
        "neither the name of a file, nor a vtkPolyData, nor a filter that makes one, nor a pair of arrays of points (n, 3) "
        f"and triangles (m, 3): {type(source).__name__}")


def _build_files(paths, out, progress, settings):
    builder = toolkit.vtkMultiTriangulationFileBuilder()
    for path in paths:
        builder.AddFileName(path)
    builder.SetOutputFileName(out)
    _configure(builder, settings, _SETTINGS)
    with Listener(builder) as listener, Progress(builder, progress, f"build {os.path.basename(out)}"):
        done = builder.Write()
    if builder.GetErrorCode() == builder.AbortError:
        raise KeyboardInterrupt
    if not done:
        fail(builder.GetErrorCode(), builder.GetErrorMessage() or "; ".join(listener.errors[:1]), ", ".join(paths))


def _build_mesh(mesh, progress, settings):
    builder = toolkit.vtkMultiTriangulationBuilder()
    builder.SetInputDataObject(mesh)
    _configure(builder, settings, _OF_MESHES)
    with Listener(builder) as listener, Progress(builder, progress, "build"):
        builder.Update()
    if builder.GetErrorCode():
        fail(builder.GetErrorCode(), "; ".join(listener.errors[:1]))
    if listener.errors:
        raise MultiTriangulationError(listener.errors[0])
    if builder.GetAbortExecute():
        raise KeyboardInterrupt
    return builder.GetOutput()


def _write(model, out):
    writer = toolkit.vtkMultiTriangulationWriter()
    writer.SetInputDataObject(model)
    writer.SetFileName(out)
    with Listener(writer) as listener:
        done = writer.Write()
    if not done or writer.GetErrorCode() or listener.errors:
        fail(writer.GetErrorCode(), "; ".join(listener.errors[:1]), out)


def build(
    source: Any,
    out: str | os.PathLike | None = None,
    *,
    progress: bool | Callable[[float, str], None] | None = None,
    **settings: Any,
) -> Model:
    """
    Builds a Multi-Triangulation and opens it.

    source: the name of a file, or several, of a format of 'bmt build' (PLY, STL, OBJ, glTF, VTP, volumes with iso=...,
    terrain ...), which are read out of core; or a mesh in memory: a vtkPolyData (PyVista's too), a filter that makes one,
    (points, triangles) as numpy arrays of the shapes (n, 3) and (m, 3), or an object with vertices and faces (trimesh).
    out: the file to write, as a rule with the ending .bmt. None: the model is kept in memory, or in a file without a name
    when it is built from files; it is gone with the last object that uses it.
    progress: None shows a bar where tqdm is installed and standard error is a terminal; True or False; or a function that
    is called with the fraction that is done (0 to 1) and a text.
    settings: those of 'bmt build', with underscores, for example patch_triangles=1000, feature_angle="auto" (degrees),
    exact=True, memory="2GiB", labels=["material"], iso=70.0, simplifier="best", threads=0. Meshes in memory take those
    that do not concern files.

    Other Python threads run meanwhile. Ctrl-C raises KeyboardInterrupt; out is then as it was before. FileNotFoundError
    where an input is missing, OSError where a disk is full, ValueError and TypeError for settings, and
    MultiTriangulationError for everything else say what is wrong.
    """
    paths = _get_paths(source)
    if paths is None:
        model = _build_mesh(_get_mesh(source), progress, settings)
        if out is None:
            return wrap(model)
        _write(model, os.fspath(out))
        return read(out)
    if out is not None:
        _build_files(paths, os.fspath(out), progress, settings)
        return read(out)
    with tempfile.TemporaryDirectory(prefix="multitriangulation-") as folder:
        # The file stays open when its name is gone.
        name = os.path.join(folder, "model.bmt")
        _build_files(paths, name, progress, settings)
        model = read(name)
        model.path = None
        return model
