#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""colour_by_array.py MODEL ARRAY PICTURE.png: colours that span the whole model's range, with a scalar bar."""
import sys

import multitriangulation as mt
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter
from vtkmodules.vtkIOImage import vtkPNGWriter

if __name__ == "__main__":
    model, array, picture = sys.argv[1:]
    actor = mt.actor(model, color_by=array)
    bar = vtkScalarBarActor()
    bar.SetLookupTable(actor.GetMapper().GetLookupTable())
    bar.SetTitle(array)

    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.AddActor(actor)
    renderer.AddActor2D(bar)
    window.SetOffScreenRendering(1)
    window.SetSize(800, 600)
    window.AddRenderer(renderer)
    window.Render()

    grabber, writer = vtkWindowToImageFilter(), vtkPNGWriter()
    grabber.SetInput(window)
    writer.SetInputConnection(grabber.GetOutputPort())
    writer.SetFileName(picture)
    writer.Write()
