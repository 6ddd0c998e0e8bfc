# SPDX-License-Identifier: BSD-3-Clause
"""clip_and_select.py MODEL.bmt PICTURE.png: draws what lies on one side of a plane, selects the cells in a rectangle of the
picture, and prints how many cells of the input these are. MT_PLUGIN names the plugin; run by pvpython."""
import os
import sys

from paraview.simple import *

LoadPlugin(os.environ["MT_PLUGIN"], ns=globals())
model, picture = sys.argv[1:]
reader = OpenDataFile(model)
view = CreateView("RenderView")
view.ViewSize = [800, 600]
shown = Show(reader, view)
shown.ColorArrayName = ["POINTS", ""]
bounds = reader.GetDataInformation().GetBounds()
shown.ClipModel = 1
shown.ClipOrigin = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
shown.ClipNormal = [1.0, 0.0, 0.0]
ResetCamera(view)
SelectSurfaceCells(Rectangle=[420, 250, 520, 350], View=view)
finest = MultiTriangulationCut(Input=reader, Mode="Level", Level=0)
cells = ExtractSelection(Input=finest, Selection=reader.GetSelectionInput(0))  # the input's ids mean the same in every cut
cells.UpdatePipeline()
print(cells.GetDataInformation().GetNumberOfCells(), "cells of the input are selected")
SaveScreenshot(picture, view)
