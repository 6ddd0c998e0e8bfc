# SPDX-License-Identifier: BSD-3-Clause
"""Interactive renders: from the DAG, by ParaView's settings of levels of detail."""
from mtparaview import MODEL, check, figure, finish, load_plugin, make_view, plain, simple

load_plugin()
reader = simple.OpenDataFile(MODEL)
view = make_view()
representation = plain(simple.Show(reader, view))
representation.PixelError = 0.25
representation.DrawingRate = 1e15  # so that no clock has a say
view.LODThreshold = 1000.0
simple.Render(view)
full = figure(representation, "NumberOfTriangles")
view.SMProxy.InteractiveRender()
check("Below the threshold an interactive render has the same cut", figure(representation, "NumberOfTriangles") == full)
view.LODThreshold = 0.0
counts = []
for resolution in (0.0, 0.5, 1.0):
    view.LODResolution = resolution
    view.SMProxy.InteractiveRender()
    counts.append(figure(representation, "NumberOfTriangles"))
check("A coarser resolution draws fewer triangles", counts[0] < counts[1] < counts[2] == full, counts, full)
simple.Render(view)
check("A still render is full again", figure(representation, "NumberOfTriangles") == full)
representation.DrawingRate = 50000.0
view.LODThreshold = 1000.0
view.SMProxy.InteractiveRender()
check("An interactive render keeps ParaView's frame rate of 5 a second", figure(representation, "NumberOfTriangles") <= 10000,
      figure(representation, "NumberOfTriangles"))
simple.Render(view)
check("and a still one has all the time it needs", figure(representation, "NumberOfTriangles") == full)
view.LODThreshold = 0.0
view.UseOutlineForLODRendering = 1
before = figure(representation, "FrameTime")
view.SMProxy.InteractiveRender()
check("Where ParaView's outline is wanted the mapper draws nothing", figure(representation, "FrameTime") == before)
view.UseOutlineForLODRendering = 0
view.SMProxy.InteractiveRender()
check("and where not, it does", figure(representation, "FrameTime") != before)
finish()
