# SPDX-License-Identifier: BSD-3-Clause
"""For test_ranks.py, on any number of ranks: pictures, a selection and figures, in files named for the number."""
import json
import os

from mtparaview import MODEL, OUTPUT, figure, load_plugin, make_view, plain, save, selected, simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController

ranks = vtkMultiProcessController.GetGlobalController()
count = ranks.GetNumberOfProcesses()
load_plugin()
reader = simple.OpenDataFile(MODEL)
view = make_view()
representation = plain(simple.Show(reader, view))
figures = ("NumberOfTriangles", "LargestShare", "AchievedPixelError", "Converged")
result = {"cells": reader.GetDataInformation().GetNumberOfCells()}


def draw(name):
    """A picture, and what the ranks drew of the model for it."""
    save(view, f"Ranks{count}{name}")
    result[name] = {each: figure(representation, each) for each in figures}


draw("Plain")
simple.SelectSurfaceCells(Rectangle=[150, 100, 190, 140], View=view)
result["selection"] = selected(reader)
simple.ClearSelection(reader)
representation.CutColoring = "Level"
representation.PixelError = 0.5
draw("Level")
representation.CutColoring = "None"
representation.PixelError = 1.0
simple.ColorBy(representation, ("POINTS", "Elevation"))
draw("Elevation")
plain(representation).Opacity = 0.4
draw("Translucent")
representation.ClipModel = 1
representation.ClipOrigin = [0.0, 0.0, 0.2]
representation.ClipNormal = [0.0, 0.3, -1.0]
draw("Clipped")
representation.ClipModel = 0
# What ParaView 5.13 calls Translation.
place = "Translation" if "Translation" in representation.ListProperties() else "Position"
setattr(representation, place, [0.3, 0.2, -0.1])
representation.Orientation = [10.0, 20.0, 30.0]
draw("Moved")
setattr(representation, place, [0.0, 0.0, 0.0])
representation.Orientation = [0.0, 0.0, 0.0]
representation.Opacity = 1.0
draw("Opaque")
# Something translucent beside a model that is not: ranks' pictures are put over each other in an order then, too.
sphere = plain(simple.Show(simple.Sphere(Radius=0.9, Center=[0.5, -0.4, 0.2], ThetaResolution=40, PhiResolution=40), view))
sphere.Opacity = 0.4
sphere.DiffuseColor = [1.0, 0.2, 0.1]
draw("Beside")
finest = simple.MultiTriangulationCut(Input=reader, Mode="Level", Level=0)
finest.UpdatePipeline()
result["finest"] = finest.GetDataInformation().GetNumberOfCells()
if ranks.GetLocalProcessId() == 0:
    with open(os.path.join(OUTPUT, f"ranks{count}.json"), "w", encoding="utf-8") as file:
        json.dump(result, file)
