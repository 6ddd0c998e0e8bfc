# SPDX-License-Identifier: BSD-3-Clause
"""build_from_mesh.py MESH MODEL.bmt PICTURE.png: a model from a mesh in a pipeline, saved and drawn with its patches. MT_PLUGIN
names the plugin; run by pvpython."""
import os
import sys

from paraview.simple import *

LoadPlugin(os.environ["MT_PLUGIN"], ns=globals())
mesh, model, picture = sys.argv[1:]
surface = ExtractSurface(Input=OpenDataFile(mesh))
builder = MultiTriangulationBuilder(Input=surface, PatchTriangles=500)
SaveData(model, proxy=builder)
view = CreateView("RenderView")
view.ViewSize = [800, 600]
shown = Show(builder, view)
shown.CutColoring = "Patch"
ResetCamera(view)
SaveScreenshot(picture, view)
