# SPDX-License-Identifier: BSD-3-Clause
"""cut_and_section.py MODEL.bmt TRIANGLES PICTURE.png: a mesh of so many triangles for all of ParaView's filters, with its edges,
and the section by a plane. MT_PLUGIN names the plugin; run by pvpython."""
import os
import sys

from paraview.simple import *

LoadPlugin(os.environ["MT_PLUGIN"], ns=globals())
model, triangles, picture = sys.argv[1:]
reader = OpenDataFile(model)
reader.UpdatePipeline()
bounds = reader.GetDataInformation().GetBounds()
cut = MultiTriangulationCut(Input=reader, Mode="Triangles", TriangleLimit=int(triangles))
section = MultiTriangulationSection(Input=reader, SectionType="Plane")
section.SectionType.Origin = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
section.SectionType.Normal = [1.0, 0.0, 0.0]
view = CreateView("RenderView")
view.ViewSize = [800, 600]
mesh = Show(cut, view)
mesh.Representation = "Surface With Edges"
mesh.ColorArrayName = ["POINTS", ""]
tubes = Show(Tube(Input=section, Radius=0.004 * (bounds[1] - bounds[0])), view)
tubes.ColorArrayName = ["POINTS", ""]
tubes.DiffuseColor = [1.0, 0.2, 0.1]
ResetCamera(view)
SaveScreenshot(picture, view)
