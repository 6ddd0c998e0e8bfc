# SPDX-License-Identifier: BSD-3-Clause
"""Cuts: meshes of the resolution that is asked for."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from vtkmodules.vtkCommonDataModel import vtkBox, vtkImplicitFunction
from vtkmodules.vtkRenderingCore import vtkCamera

from . import vtkMultiTriangulationCutFilter
from ._errors import Listener, fail
from ._model import Cut, open_model


def _make_region(region):
    if isinstance(region, vtkImplicitFunction):
        return region
    bounds = [float(each) for each in region]
    if len(bounds) != 6:
        raise ValueError("a region is an implicit function, or the six bounds of a box: xmin, xmax, ymin, ymax, zmin, zmax")
    box = vtkBox()
    box.SetBounds(bounds)
    return box


def _choose(cutter, choices):
    given = [name for name, value in choices.items() if value is not None]
    if len(given) > 1:
        raise TypeError(f"{' and '.join(given)} are given: a cut goes by one of {', '.join(choices)}")
    if choices["triangles"] is not None:
        cutter.SetTriangleLimit(int(choices["triangles"]))
    elif choices["level"] is not None:
        cutter.SetLevel(int(choices["level"]))
    elif choices["error"] is not None:
        if not choices["error"] >= 0.0:
            raise ValueError(f"error={choices['error']} is no distance")
        cutter.SetError(float(choices["error"]))
    elif choices["camera"] is not None:
        return True
    return False


def _select(cutter, model, names):
    """Has the output the arrays of these names alone."""
    for selection, data in ((cutter.GetPointArraySelection(), model.GetPointData()),
                            (cutter.GetCellArraySelection(), model.GetCellData())):
        for i in range(data.GetNumberOfArrays()):
            selection.AddArray(data.GetArrayName(i), data.GetArrayName(i) in names)


def cut(
    model: Any,
    *,
    triangles: int | None = None,
    error: float | None = None,
    level: int | None = None,
    camera: vtkCamera | None = None,
    size: Sequence[int] = (1024, 768),
    pixel_error: float = 1.0,
    region: vtkImplicitFunction | Sequence[float] | None = None,
    outside_error: float | None = None,
    arrays: Iterable[str] | None = None,
    distances: bool = False,
    input_ids: bool = False,
) -> Cut:
    """
    A cut of a model as one conforming, welded triangle mesh: a vtkPolyData with numpy arrays (see Cut).

    model: what `read` or `build` gave, or the name of a file. At most one of these says which cut; without, it is the
    coarsest one:
    triangles: the most precise cut of at most so many triangles.
    error: the coarsest cut that is certified to be within this distance of the input, in its units.
    level: one level; 0 is the finest.
    camera: a vtkCamera: the coarsest cut that a picture of size=(width, height) pixels shows within pixel_error pixels.

    region: where the cut is to be that fine: an implicit function (inside: negative), or the six bounds of a box; outside
    of it the cut is as coarse as it can be, or within outside_error (input's units).
    arrays: the names of the arrays to have; None: all.
    distances: whether to have two cell arrays more, "DistanceToInput" and "DistanceFromInput": what is certified of the
    patch that a triangle is of (input's units).
    input_ids: whether the input's ids, which coarse triangles and points do not have (-1), are looked for: those of the
    nearest cell and point.

    MultiTriangulationError where there is no such cut, with the reason.
    """
    cutter = vtkMultiTriangulationCutFilter()
    model = open_model(model)
    cutter.SetInputDataObject(model)
    if _choose(cutter, {"triangles": triangles, "error": error, "level": level, "camera": camera}):
        cutter.SetView(camera, int(size[0]), int(size[1]))
        cutter.SetPixelError(float(pixel_error))
    if region is not None:
        cutter.SetRegion(_make_region(region))
    if outside_error is not None:
        cutter.SetOutsideError(float(outside_error))
    if arrays is not None:
        _select(cutter, model, {arrays} if isinstance(arrays, str) else set(arrays))
    cutter.SetGenerateDistances(bool(distances))
    cutter.SetFindInputIds(bool(input_ids))
    with Listener(cutter) as listener:
        cutter.Update()
    if cutter.GetErrorMessage():
        fail(cutter.GetErrorCode(), cutter.GetErrorMessage() or "; ".join(listener.errors[:1]))
    result = Cut()
    result.ShallowCopy(cutter.GetOutput())
    result.error = cutter.GetCutError()
    result.distance_to_input = cutter.GetDistanceToInput()
    result.distance_from_input = cutter.GetDistanceFromInput()
    result.exact = cutter.GetExact()
    result.finest_level = cutter.GetFinestLevel()
    result.coarsest_level = cutter.GetCoarsestLevel()
    result.patches = cutter.GetNumberOfPatches()
    return result
