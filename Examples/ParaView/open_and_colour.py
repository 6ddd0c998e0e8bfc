# SPDX-License-Identifier: BSD-3-Clause
"""open_and_colour.py MODEL.bmt ARRAY PICTURE.png: opens a model and colours it by an array of points, over the range of the
whole model. MT_PLUGIN names the plugin; run by pvpython."""
import os
import sys

from paraview.simple import *

LoadPlugin(os.environ["MT_PLUGIN"], ns=globals())
model, array, picture = sys.argv[1:]
reader = OpenDataFile(model)
view = CreateView("RenderView")
view.ViewSize = [800, 600]
shown = Show(reader, view)
shown.PixelError = 1.0
ColorBy(shown, ("POINTS", array))
shown.SetScalarBarVisibility(view, True)
ResetCamera(view)
SaveScreenshot(picture, view)
