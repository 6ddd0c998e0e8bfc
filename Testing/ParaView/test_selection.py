# SPDX-License-Identifier: BSD-3-Clause
"""Selections of points and cells, in rectangles and under the cursor, are those of the input."""
from mtparaview import MESH, MODEL, check, count_pixels, finish, load_plugin, make_view, plain, save, selected, simple

from paraview.modules.vtkRemotingMisc import vtkSMTooltipSelectionPipeline
from vtkmodules.vtkCommonCore import reference, vtkCollection
from vtkmodules.vtkCommonDataModel import vtkDataObject

RECTANGLE = [150, 100, 190, 140]


def find_tooltip(view, place):
    """What ParaView shows while the cursor rests there, in the mode of hovering over cells."""
    shown, selections = vtkCollection(), vtkCollection()
    view.SMProxy.SelectSurfaceCells([*place, *place], shown, selections, 0, False)
    pipeline = vtkSMTooltipSelectionPipeline.GetInstance()
    pipeline.Show(shown.GetItemAsObject(0), selections.GetItemAsObject(0), view.SMProxy)
    html, text = reference(""), reference("")
    found = pipeline.GetTooltipInfo(vtkDataObject.CELL, html, text)
    pipeline.Hide(view.SMProxy)
    return str(text) if found else ""


load_plugin()
reader = simple.OpenDataFile(MODEL)
view = make_view()
representation = plain(simple.Show(reader, view))
representation.PixelError = 0.0
simple.Render(view)
simple.SelectSurfaceCells(Rectangle=RECTANGLE, View=view)
kind, array, cells = selected(reader)
check("Cells are selected by the input's ids", kind == "ValueSelectionSource" and array == "vtkMTInputCellIds", kind, array)
before = save(view, "SelectionHighlighted")
simple.ClearSelection(reader)
after = save(view, "SelectionNone")
changed = count_pixels(before, after, 20)
inside = (RECTANGLE[2] - RECTANGLE[0]) * (RECTANGLE[3] - RECTANGLE[1])
check("What is selected is highlighted", 0.3 * inside < changed < 3 * inside, changed, inside)
simple.SelectSurfaceCells(Rectangle=[170, 120, 170, 120], View=view)
picked = selected(reader)[2]
check("A pick is one cell, of the rectangle's", len(picked) == 1 and picked[0] in cells, picked)
tooltip = find_tooltip(view, (170, 120))
check("The tooltip has the values of the cell under the cursor", f"vtkMTInputCellIds: {picked[0]}" in tooltip,
      tooltip.replace("\n", "; "))

representation.PixelError = 8.0
simple.Render(view)
simple.SelectSurfaceCells(Rectangle=RECTANGLE, View=view)
coarse = selected(reader)[2]
check("On a coarse cut they are cells of the input, too", 0 < len(coarse) < len(cells) / 2 and max(coarse) < 81920,
      len(coarse), len(cells))
before = save(view, "SelectionHighlightedCoarse")
simple.ClearSelection(reader)
changed = count_pixels(before, save(view, "SelectionNoneCoarse"), 20)
check("On a coarse cut what is selected is highlighted, too", 0.1 * inside < changed < 5 * inside, changed, inside)
simple.SelectSurfacePoints(Rectangle=RECTANGLE, View=view)
check("Where no ids of points are kept nothing is selected", selected(reader)[2] == coarse or not selected(reader)[2])
simple.ClearSelection(reader)

# The cells of the input itself, in ParaView's own representation.
simple.Hide(reader, view)
mesh = simple.OpenDataFile(MESH)
plain(simple.Show(mesh, view)).Representation = "Surface"
simple.Render(view)
simple.SelectSurfaceCells(Rectangle=RECTANGLE, View=view)
expected = selected(mesh)[2]
simple.ClearSelection(mesh)
differ = set(cells) ^ set(expected)
check("They are what ParaView selects in the input", len(expected) > 100 and len(differ) <= len(expected) / 100,
      len(expected), len(differ))

# Points, by an array of ids that the model keeps.
numbered = simple.GenerateIds(Input=mesh)
built = simple.MultiTriangulationBuilder(Input=numbered, LabelArrayNames=["PointIds"], PatchTriangles=500)
simple.Hide(mesh, view)
shown = plain(simple.Show(built, view))
check("A built model is shown by the representation", shown.Representation == "Multi-Triangulation")
shown.PixelError = 0.0
shown.PointIdArray = "PointIds"
simple.Render(view)
simple.SelectSurfacePoints(Rectangle=RECTANGLE, View=view)
kind, array, points = selected(built)
check("Points are selected by the array that is named", kind == "ValueSelectionSource" and array == "PointIds", kind, array)
simple.ClearSelection(built)
simple.Hide(built, view)
plain(simple.Show(mesh, view)).Representation = "Surface"
simple.Render(view)
simple.SelectSurfacePoints(Rectangle=RECTANGLE, View=view)
expected = selected(mesh)[2]
simple.ClearSelection(mesh)
differ = set(points) ^ set(expected)
check("They are what ParaView selects in the input", len(expected) > 50 and len(differ) <= len(expected) / 20,
      len(expected), len(differ))

# By the input's point ids, which need not be named.
kept = simple.MultiTriangulationBuilder(Input=mesh, InputPointIds=1, PatchTriangles=500)
simple.Hide(mesh, view)
shown = plain(simple.Show(kept, view))
shown.PixelError = 0.0
simple.Render(view)
simple.SelectSurfacePoints(Rectangle=RECTANGLE, View=view)
kind, array, points = selected(kept)
check("Points are selected by the input's ids with no array named",
      kind == "ValueSelectionSource" and array == "vtkMTInputPointIds", kind, array)
differ = set(points) ^ set(expected)
check("They are what ParaView selects in the input, too", len(differ) <= len(expected) / 20, len(expected), len(differ))
simple.ClearSelection(kept)
simple.Hide(kept, view)

# A selection means the same in any cut that has the ids.
simple.Hide(mesh, view)
simple.Show(reader, view)
representation.PixelError = 0.0
simple.Render(view)
simple.SelectSurfaceCells(Rectangle=RECTANGLE, View=view)
finest = simple.MultiTriangulationCut(Input=reader, Mode="Level", Level=0)
extract = simple.ExtractSelection(Input=finest, Selection=reader.GetSelectionInput(0))
extract.UpdatePipeline()
check("Extracted from the finest level they are all there", extract.GetDataInformation().GetNumberOfCells() == len(cells),
      extract.GetDataInformation().GetNumberOfCells(), len(cells))
finish()
