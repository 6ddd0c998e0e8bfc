#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pipeline.py MESH PICTURE.png

Builds a Multi-Triangulation of a mesh in memory and draws it through an ordinary actor. PYTHONPATH must name the
toolkit's site-packages (build/lib/python3.11/site-packages); without a screen run it under xvfb-run.
"""
import sys

import vtk
from multitriangulation import vtkMultiTriangulationBuilder, vtkMultiTriangulationMapper

READERS = {
    "ply": vtk.vtkPLYReader,
    "stl": vtk.vtkSTLReader,
    "obj": vtk.vtkOBJReader,
    "vtp": vtk.vtkXMLPolyDataReader,
    "vtk": vtk.vtkPolyDataReader,
}


def main(mesh, picture):
    reader = READERS[mesh.rsplit(".", 1)[-1].lower()]()
    reader.SetFileName(mesh)
    builder = vtkMultiTriangulationBuilder()
    builder.SetInputConnection(reader.GetOutputPort())
    mapper = vtkMultiTriangulationMapper()
    mapper.SetInputConnection(builder.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    renderer = vtk.vtkRenderer()
    renderer.AddActor(actor)
    window = vtk.vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetSize(800, 600)
    window.AddRenderer(renderer)
    window.Render()
    grabber = vtk.vtkWindowToImageFilter()
    grabber.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(grabber.GetOutputPort())
    writer.SetFileName(picture)
    writer.Write()
    model = builder.GetOutput()
    print(f"{model.GetNumberOfFinestTriangles()} triangles in {model.GetNumberOfPatches()} patches of "
          f"{model.GetNumberOfLevels()} levels; drawn into {picture}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
