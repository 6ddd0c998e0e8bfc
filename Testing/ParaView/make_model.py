# SPDX-License-Identifier: BSD-3-Clause
"""Makes the mesh and the model of the other tests: source, builder, writer, reader, file builder."""
import os

from mtparaview import MESH, MODEL, OUTPUT, check, figure, finish, load_plugin, simple

load_plugin()
sphere = simple.FractalSphere(NumberOfTriangles=81920)
height = simple.Elevation(Input=sphere)
height.LowPoint = [0.0, 0.0, -1.0]
height.HighPoint = [0.0, 0.0, 1.0]
height.ScalarRange = [-1.0, 1.0]
simple.SaveData(MESH, proxy=height)
builder = simple.MultiTriangulationBuilder(Input=height)
builder.UpdatePipeline()
check("The builder's output is the coarsest mesh of 81920 triangles",
      0 < builder.GetDataInformation().GetNumberOfCells() < 10000, builder.GetDataInformation().GetNumberOfCells())
simple.SaveData(MODEL, proxy=builder)
reader = simple.OpenDataFile(MODEL)
check("A .bmt file is opened by the reader", reader.SMProxy.GetXMLName() == "MultiTriangulationReader")
reader.UpdatePipeline()
whole = height.PointData["Elevation"].GetRange()
coarse = reader.PointData["Elevation"].GetRange()
check("Ranges are those of the whole model", max(abs(a - b) for a, b in zip(whole, coarse)) < 1e-6, whole, coarse)

finest = simple.MultiTriangulationCut(Input=reader, Mode="Level", Level=0)
finest.UpdatePipeline()
check("Level 0 has all triangles", finest.GetDataInformation().GetNumberOfCells() == 81920)
limited = simple.MultiTriangulationCut(Input=reader, Mode="Triangles", TriangleLimit=20000)
limited.UpdatePipeline()
cells = limited.GetDataInformation().GetNumberOfCells()
check("A limit of triangles is kept and used", 17000 <= cells <= 20000, cells)
precise = simple.MultiTriangulationCut(Input=reader, Mode="Error", Error=0.005)
precise.UpdatePipeline()
error = figure(precise, "CutError")
check("An error is kept", 0.0 < error <= 0.005, error)
section = simple.MultiTriangulationSection(Input=reader, SectionType="Plane")
section.SectionType.Normal = [0.0, 0.0, 1.0]
section.SectionType.Origin = [0.0, 0.0, 0.0]
section.UpdatePipeline()
bounds = section.GetDataInformation().GetBounds()
check("A section lies in its plane", abs(bounds[4]) + abs(bounds[5]) < 1e-5 and bounds[1] - bounds[0] > 1.0, bounds)
moved = simple.MultiTriangulationTransform(Input=reader, Transform="Transform")
moved.Transform.Translate = [5.0, 0.0, 0.0]
moved.UpdatePipeline()
check("A transform moves the mesh", abs(moved.GetDataInformation().GetBounds()[0] -
                                        reader.GetDataInformation().GetBounds()[0] - 5.0) < 1e-5)

sequence = simple.MultiTriangulationPartitionSequence(Input=sphere, FirstTarget=2000.0)
crossing = simple.MultiTriangulationCrossing(Input=sequence)
crossing.UpdatePipeline()
elements = figure(crossing, "NumberOfPatches")
check("Elements of the crossing are numbered", crossing.CellData["Patch"].GetRange()[1] + 1 == elements, elements)
partition = simple.MultiTriangulationPartition(Input=sphere, PartitionStrategy="Regular Partition")
partition.UpdatePipeline()
regions = figure(partition, "NumberOfRegions")
check("Regions are numbered", partition.CellData["Region"].GetRange()[1] + 1 == regions, regions)
simpler = simple.MultiTriangulationSimplification(Input=sphere, TargetTriangles=10000)
simpler.UpdatePipeline()
check("A mesh is simplified", abs(simpler.GetDataInformation().GetNumberOfCells() - 10000) < 100)

other = os.path.join(OUTPUT, "other.bmt")
files = simple.MultiTriangulationFileBuilder(FileNames=[MESH], OutputFileName=other, PatchTriangles=500)
files.UpdatePipeline()
check("The file builder writes and reads", os.path.getsize(other) > 100000 and
      files.GetDataInformation().GetNumberOfCells() > 0, files.GetDataInformation().GetNumberOfCells())
finish()
