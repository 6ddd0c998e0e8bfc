#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pick.py MODEL X Y: which triangle of the input is drawn at a pixel of a picture of 800 x 600, and where it is."""
import sys

import multitriangulation as mt
from vtkmodules.vtkRenderingCore import vtkCellPicker, vtkRenderer, vtkRenderWindow

if __name__ == "__main__":
    model, x, y = sys.argv[1], float(sys.argv[2]), float(sys.argv[3])
    actor = mt.actor(model)
    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.AddActor(actor)
    window.SetOffScreenRendering(1)
    window.SetSize(800, 600)
    window.AddRenderer(renderer)
    window.Render()

    locator = mt.vtkMultiTriangulationLocator()
    locator.SetMapper(actor.GetMapper())
    picker = vtkCellPicker()
    picker.SetTolerance(0.0)
    picker.AddLocator(locator)
    if picker.Pick(x, y, 0, renderer):
        print("triangle %d of the input at (%g, %g, %g)" % (picker.GetCellId(), *picker.GetPickPosition()))
    else:
        print("nothing there")
