# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the representation: against those in the repository, and against ParaView's own of the input mesh."""
from mtparaview import MESH, MODEL, check, check_baseline, count_pixels, figure, finish, load_plugin, make_view, plain
from mtparaview import save, simple

load_plugin()
reader = simple.OpenDataFile(MODEL)
view = make_view()
representation = simple.Show(reader, view)
check("The representation is used by default", representation.Representation == "Multi-Triangulation")
plain(representation)
check_baseline(view, "Plain")
check("A still picture is finished", figure(representation, "Converged") == 1 and figure(representation, "Loading") == 0)
check("It is within the pixel error", figure(representation, "AchievedPixelError") <= 1.0,
      figure(representation, "AchievedPixelError"))
triangles = figure(representation, "NumberOfTriangles")
representation.PixelError = 4.0
simple.Render(view)
check("A larger pixel error takes fewer triangles", figure(representation, "NumberOfTriangles") < triangles / 2,
      triangles, figure(representation, "NumberOfTriangles"))
representation.Style = "Surface With Edges"
check_baseline(view, "Edges")
representation.Style = "Surface"
representation.PixelError = 1.0
for colors in ("Level", "Patch", "Error in Pixels"):
    representation.CutColoring = colors
    check_baseline(view, "By" + colors.split()[0])
representation.CutColoring = "None"

simple.ColorBy(representation, ("POINTS", "Elevation"))
table = simple.GetColorTransferFunction("Elevation")
check("The colour map has the whole model's range", abs(table.RGBPoints[0] - reader.PointData["Elevation"].GetRange()[0]) +
      abs(table.RGBPoints[-4] - reader.PointData["Elevation"].GetRange()[1]) < 1e-5, table.RGBPoints[0], table.RGBPoints[-4])
check_baseline(view, "ByElevation")
plain(representation)
representation.Opacity = 0.4
check_baseline(view, "Translucent")
representation.Opacity = 1.0
representation.Specular = 0.8
representation.DiffuseColor = [0.9, 0.5, 0.2]
check_baseline(view, "Shiny")
representation.Specular = 0.0
representation.DiffuseColor = [1.0, 1.0, 1.0]

representation.ClipModel = 1
representation.ClipOrigin = [0.2, 0.0, 0.0]
representation.ClipNormal = [-1.0, 0.0, 0.5]
check_baseline(view, "Clipped")
representation.ClipModel = 0

representation.FreezeCut = 1
view.CameraViewAngle = 8.0
simple.Render(view)
frozen = figure(representation, "AchievedPixelError")
representation.FreezeCut = 0
simple.Render(view)
check("A frozen cut stays as coarse as it was", frozen > 2.0 * figure(representation, "AchievedPixelError"), frozen)
view.CameraViewAngle = 30.0
representation.TriangleLimit = 5000
simple.Render(view)
check("A limit of triangles is kept", figure(representation, "NumberOfTriangles") <= 5000,
      figure(representation, "NumberOfTriangles"))
representation.TriangleLimit = 0

# Against ParaView's own picture of the input: all of the model, so but for the lattice the same triangles.
representation.PixelError = 0.0
own = save(view, "Finest")
simple.Hide(reader, view)
mesh = simple.OpenDataFile(MESH)
builder = simple.MultiTriangulationCut(Input=reader, Mode="Level", Level=0)
surface = plain(simple.Show(builder, view, "GeometryRepresentation"))
surface.Representation = "Surface"
reference = save(view, "Surface")
pixels = count_pixels(own, reference, 3)
check("At pixel error 0 the picture is ParaView's of the finest level", pixels <= 12, f"{pixels} pixels differ")
finish()
