# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and windows."""
from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

import numpy
import vtkmodules.vtkInteractionStyle  # noqa: F401  registers the styles
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkScalarsToColors
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCamera,
    vtkRenderer,
    vtkRenderWindow,
    vtkRenderWindowInteractor,
    vtkWindowToImageFilter,
)

from . import vtkMultiTriangulationMapper
from ._errors import Listener, MultiTriangulationError
from ._model import Model, open_model, wrap

BACKGROUND = (0.32, 0.34, 0.43)

_METRICS = {"distance": "DISTANCE", "edges": "EDGE_LENGTH", "normals": "NORMAL_DEVIATION", "value": "VALUE"}
_OF_CUT = {"level": "LEVEL", "patch": "PATCH", "error": "ERROR_IN_PIXELS"}


def _color(mapper, model, color_by, component, clim, lut):
    if color_by is None:
        if not mapper.SelectColors():
            mapper.ScalarVisibilityOff()
        return
    if color_by in _OF_CUT and color_by not in model.point_arrays + model.cell_arrays:
        mapper.SetColorBy(getattr(mapper, _OF_CUT[color_by]))
        return
    association = model.find_array(color_by)
    mapper.ScalarVisibilityOn()
    mapper.SelectColorArray(color_by)
    if association == "point":
        mapper.SetScalarModeToUsePointFieldData()
    else:
        mapper.SetScalarModeToUseCellFieldData()
    data = model.GetAttributes(vtkDataObject.POINT if association == "point" else vtkDataObject.CELL)
    if data.GetAbstractArray(color_by).GetLookupTable():
        lut = lut or data.GetAbstractArray(color_by).GetLookupTable()
    if lut is None:
        lut = vtkLookupTable()
        lut.SetHueRange(0.667, 0.0)  # blue to red
        lut.Build()
    if component is None or component < 0:
        lut.SetVectorModeToMagnitude()
    else:
        lut.SetVectorModeToComponent()
        lut.SetVectorComponent(component)
    mapper.SetLookupTable(lut)
    mapper.SetScalarRange(clim or model.array_range(color_by, _get_component(data, color_by, component), association))


def _get_component(data, name, component):
    single = data.GetAbstractArray(name).GetNumberOfComponents() == 1
    return 0 if single else -1 if component is None else component


def configure(mapper, pixel_error, metric, triangles, color_by=None, value=None, value_error=0.0):
    """What a mapper draws of a model; color_by is "level", "patch" or "error", or None."""
    if value is None and metric == "value":
        raise ValueError("metric='value' needs the name of an array: value='thickness'")
    if value is not None and metric not in ("distance", "value"):
        raise ValueError(f"value='{value}' goes with metric='value' and not with metric='{metric}'")
    metric = metric if value is None else "value"
    if metric not in _METRICS or not hasattr(vtkMultiTriangulationMapper, _METRICS[metric]):
        raise ValueError(f"metric='{metric}' is none of {', '.join(_METRICS)}")
    if color_by is not None and color_by not in _OF_CUT:
        raise ValueError(f"color_by='{color_by}' is none of {', '.join(_OF_CUT)}")
    mapper.SetErrorMetric(getattr(mapper, _METRICS[metric]))
    mapper.SetTriangleLimit(int(triangles))
    mapper.SetErrorMetricArray(value)
    for name, number, setter in (
        ("pixel_error", pixel_error, mapper.SetPixelError),
        ("value_error", value_error, mapper.SetValueError),
    ):
        with Listener(mapper) as listener:
            setter(float(number))
        if listener.errors:
            raise ValueError(f"{name}={number}: {listener.errors[0]}")
    if color_by is not None:
        mapper.SetColorBy(getattr(mapper, _OF_CUT[color_by]))


def actor(
    model: Any,
    *,
    pixel_error: float = 1.0,
    metric: str = "distance",
    triangles: int = 0,
    value: str | None = None,
    value_error: float = 0.0,
    color_by: str | None = None,
    component: int | None = None,
    clim: Sequence[float] | None = None,
    lut: vtkScalarsToColors | None = None,
) -> vtkActor:
    """
    An ordinary vtkActor that draws a model at the resolution that the camera needs.

    model: what `read` or `build` gave, or the name of a file.
    pixel_error: how far the picture of the surface may be from the input's, in pixels; 0: as fine as it is stored.
    metric: what that is compared with: "distance" (certified), "edges" (mean edge length), "normals" (normal
    deviation, where the model was built with certify_normals=True) or "value".
    triangles: at most so many in a frame; 0: no limit.
    value: the name of an array, where the model was built with certified values of it; it makes the metric "value".
    value_error: by how much its values may deviate from the input's, in its units, where triangles are larger than
    pixel_error.
    color_by: the name of an array, "level", "patch" or "error"; None: the model's own colours where it has some.
    component: of arrays with several, from 0; None: the magnitude.
    clim: the values that the colours span; None: the range of the whole model, whatever is drawn of it.
    lut: a vtkScalarsToColors; None: that of the array, or blue to red.

    GetMapper() is the vtkMultiTriangulationMapper with all settings and figures.
    """
    model = open_model(model)
    if not isinstance(model, Model):
        model = wrap(model)
    mapper = vtkMultiTriangulationMapper()
    configure(mapper, pixel_error, metric, triangles, value=value, value_error=value_error)
    mapper.SetInputDataObject(model)
    _color(mapper, model, color_by, component, clim, lut)
    result = vtkActor()
    result.SetMapper(mapper)
    return result


def _make_window(models, size, camera, background, settings):
    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.SetBackground(background)
    for each in models:
        renderer.AddActor(each if isinstance(each, vtkActor) else actor(each, **settings))
    window.SetSize(int(size[0]), int(size[1]))
    window.AddRenderer(renderer)
    if camera is None:
        renderer.ResetCamera()
    else:
        renderer.SetActiveCamera(camera)
        renderer.ResetCameraClippingRange()
    return window


def _check_display(window):
    # Without a display VTK 9.1 ends the process.
    if window.IsA("vtkXOpenGLRenderWindow") and not os.environ.get("DISPLAY"):
        raise MultiTriangulationError(
            "there is no display: set DISPLAY, or run under 'xvfb-run -a -s \"-screen 0 1280x1024x24 -noreset\"'")


def screenshot(
    *models: Any,
    path: str | os.PathLike | None = None,
    size: Sequence[int] = (1024, 768),
    camera: vtkCamera | None = None,
    background: Sequence[float] = BACKGROUND,
    **settings: Any,
) -> numpy.ndarray:
    """
    A picture of one or several models, converged: it does not depend on timing.

    models: as for `actor`, or actors. path: a PNG file to write; None: none. size: pixels. camera: a vtkCamera; None:
    everything is seen. background: red, green, blue from 0 to 1. settings: those of `actor`.
    Gives the pixels: uint8, shape (height, width, 3), the first row at the top.
    """
    window = _make_window(models, size, camera, background, settings)
    _check_display(window)
    window.SetOffScreenRendering(1)
    failures = []
    listeners = [Listener(each.GetMapper()) for each in _get_actors(window)]
    window.Render()
    for listener in listeners:
        failures += listener.errors
        listener.__exit__()
    if failures:
        raise MultiTriangulationError(failures[0])
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    grabber.Update()
    image = grabber.GetOutput()
    if path is not None:
        _write_image(image, os.fspath(path))
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    return numpy.flipud(pixels)


def _get_actors(window):
    actors = window.GetRenderers().GetFirstRenderer().GetActors()
    return [actors.GetItemAsObject(i) for i in range(actors.GetNumberOfItems())]


def _write_image(image, path):
    from vtkmodules.vtkIOImage import vtkPNGWriter

    writer = vtkPNGWriter()
    writer.SetInputDataObject(image)
    writer.SetFileName(path)
    with Listener(writer) as listener:
        writer.Write()
    if writer.GetErrorCode():
        raise OSError(f"{path} cannot be written: {'; '.join(listener.errors[:1])}")


def show(
    *models: Any,
    size: Sequence[int] = (1280, 720),
    camera: vtkCamera | None = None,
    background: Sequence[float] = BACKGROUND,
    title: str = "Multi-Triangulation",
    **settings: Any,
) -> None:
    """
    Opens a window with one or several models, until the user closes it (q, or the window's button).

    models, size, camera, background and settings as for `screenshot`.
    """
    from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera

    window = _make_window(models, size, camera, background, settings)
    _check_display(window)
    window.SetWindowName(title)
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
    window.Render()
    interactor.Start()
