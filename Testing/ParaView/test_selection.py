# SPDX-License-Identifier: BSD-3-Clause
"""Selections of points and cells, in rectangles and under the cursor, are those of the input."""
from mtparaview import MESH, MODEL, check, finish, load_plugin, make_view, plain, selected, simple

RECTANGLE = [150, 100, 190, 140]
load_plugin()
reader = simple.OpenDataFile(MODEL)
view = make_view()
representation = plain(simple.Show(reader, view))
representation.PixelError = 0.0
simple.Render(view)
simple.SelectSurfaceCells(Rectangle=RECTANGLE, View=view)
kind, array, cells = selected(reader)
check("Cells are selected by the input's ids", kind == "ValueSelectionSource" and array == "vtkMTInputCellIds", kind, array)
simple.SelectSurfaceCells(Rectangle=[170, 120, 170, 120], View=view)
picked = selected(reader)[2]
check("A pick is one cell, of the rectangle's", len(picked) == 1 and picked[0] in cells, picked)

representation.PixelError = 8.0
simple.Render(view)
simple.SelectSurfaceCells(Rectangle=RECTANGLE, View=view)
coarse = selected(reader)[2]
check("On a coarse cut they are cells of the input, too", 0 < len(coarse) < len(cells) / 2 and max(coarse) < 81920,
      len(coarse), len(cells))
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
