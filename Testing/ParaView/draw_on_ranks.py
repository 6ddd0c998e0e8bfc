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
save(view, f"Ranks{count}Plain")
result = {"triangles": figure(representation, "NumberOfTriangles"), "cells": reader.GetDataInformation().GetNumberOfCells()}
simple.SelectSurfaceCells(Rectangle=[150, 100, 190, 140], View=view)
result["selection"] = selected(reader)
simple.ClearSelection(reader)
representation.CutColoring = "Level"
representation.PixelError = 0.5
save(view, f"Ranks{count}Level")
representation.CutColoring = "None"
simple.ColorBy(representation, ("POINTS", "Elevation"))
save(view, f"Ranks{count}Elevation")
plain(representation).Opacity = 0.4
save(view, f"Ranks{count}Translucent")
finest = simple.MultiTriangulationCut(Input=reader, Mode="Level", Level=0)
finest.UpdatePipeline()
result["finest"] = finest.GetDataInformation().GetNumberOfCells()
if ranks.GetLocalProcessId() == 0:
    with open(os.path.join(OUTPUT, f"ranks{count}.json"), "w", encoding="utf-8") as file:
        json.dump(result, file)
