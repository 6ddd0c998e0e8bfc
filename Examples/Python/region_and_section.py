#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""
region_and_section.py MODEL PICTURE.png: a cut that is fine in a ball and coarse elsewhere, with its edges, and the line in
which a plane meets the surface.
"""
import sys

import multitriangulation as mt
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkSphere
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

if __name__ == "__main__":
    name, picture = sys.argv[1:]
    model = mt.read(name)
    bounds = model.bounds
    center = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    size = max(bounds[2 * i + 1] - bounds[2 * i] for i in range(3))

    ball = vtkSphere()
    ball.SetCenter(center[0], center[1], bounds[5])
    ball.SetRadius(0.08 * size)
    mapper, mesh = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(mt.cut(model, error=3e-5 * size, region=ball))
    mapper.ScalarVisibilityOff()
    mesh.SetMapper(mapper)
    mesh.GetProperty().EdgeVisibilityOn()

    plane = vtkPlane()
    plane.SetOrigin(center)
    plane.SetNormal(1, 0, 0)
    section = mt.vtkMultiTriangulationSection()
    section.SetInputDataObject(model)
    section.SetImplicitFunction(plane)
    tubes, lines, outline = vtkTubeFilter(), vtkPolyDataMapper(), vtkActor()
    tubes.SetInputConnection(section.GetOutputPort())
    tubes.SetRadius(0.004 * size)
    lines.SetInputConnection(tubes.GetOutputPort())
    lines.ScalarVisibilityOff()
    outline.SetMapper(lines)
    outline.GetProperty().SetColor(1, 0.2, 0.1)
    mt.screenshot(mesh, outline, path=picture)
