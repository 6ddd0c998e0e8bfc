# SPDX-License-Identifier: BSD-3-Clause
"""Hovering over a model that keeps no ids: nothing is told, nothing is highlighted, nothing breaks."""
import os

from mtparaview import MESH, OUTPUT, check, count_pixels, figure, finish, load_plugin, make_view, plain, save, selected
from mtparaview import simple

from paraview.modules.vtkRemotingMisc import vtkSMTooltipSelectionPipeline
from vtkmodules.vtkCommonCore import reference, vtkCollection
from vtkmodules.vtkCommonDataModel import vtkDataObject

PLACES = [(170, 120), (200, 150), (230, 180), (5, 5), (399, 299)]


def hover(view, place, points):
    """What ParaView's hovering does with the cursor there: the tooltip, or None where nothing is found to tell of."""
    shown, selections = vtkCollection(), vtkCollection()
    select = view.SMProxy.SelectSurfacePoints if points else view.SMProxy.SelectSurfaceCells
    found = select([*place, *place], shown, selections, 0, False)
    if not found or shown.GetNumberOfItems() == 0:
        return None
    pipeline = vtkSMTooltipSelectionPipeline.GetInstance()
    pipeline.Show(shown.GetItemAsObject(0), selections.GetItemAsObject(0), view.SMProxy)
    html, text = reference(""), reference("")
    told = pipeline.GetTooltipInfo(vtkDataObject.POINT if points else vtkDataObject.CELL, html, text)
    pipeline.Hide(view.SMProxy)
    return str(text) if told else None


load_plugin()
mesh = simple.OpenDataFile(MESH)
model = os.path.join(OUTPUT, "without_ids.bmt")
built = simple.MultiTriangulationFileBuilder(FileNames=[MESH], OutputFileName=model, InputIds=0, PatchTriangles=500)
built.UpdatePipeline()
view = make_view()
representation = plain(simple.Show(built, view))
simple.Render(view)
check("A model without ids is shown", representation.Representation == "Multi-Triangulation" and
      figure(representation, "NumberOfTriangles") > 10000, figure(representation, "NumberOfTriangles"))
before = save(view, "HoverBefore")
for points in (False, True):
    told = [hover(view, place, points) for place in PLACES]
    check(f"Hovering over {'points' if points else 'cells'} tells nothing", told == [None] * len(PLACES), told)
simple.SelectSurfaceCells(Rectangle=[150, 100, 190, 140], View=view)
check("A selection of cells selects nothing", not selected(built)[2], selected(built))
pixels = count_pixels(before, save(view, "HoverAfter"))
check("and the picture stays as it was", pixels == 0, f"{pixels} pixels differ")

# The same places on ParaView's own representation of the input, so that they are known to lie on something.
simple.Hide(built, view)
plain(simple.Show(mesh, view)).Representation = "Surface"
simple.Render(view)
told = [hover(view, place, False) for place in PLACES]
check("Where the input is shown there is something to tell at the first three places",
      all(told[:3]) and not any(told[3:]), [bool(each) for each in told])
finish()
