#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the feature angle does: how meshes are classed, and how pictures compare with VTK's split normals.

usage: feature_angle.py BMT WORK MESH [MESH ...] [--pictures]

BMT is the command; WORK takes models and pictures. The first table has, for every mesh without normals, the shares of
edges (percent) that vtkMTDihedralAngles goes by, and what it chooses; meshes that bmt refuses, or that have normals, are
left out and named. With --pictures there is a second one: the mesh as it is, drawn by VTK's own mapper with the normals
of vtkPolyDataNormals (splitting on, feature angle 30), beside the finest level of the model that was built from it with
the automatic feature angle, and with none. Grey-level difference: the mean over the pixels that both pictures cover, and
the 99th percentile, of 255. Pictures are WORK/NAME-{vtk,auto,none}.png. Needs Debian's python3-vtk9 (/usr/bin/python3)
and a display: CMake/with-display.
"""
import argparse
import json
import pathlib
import re
import subprocess


def run(*command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    return done.stdout if done.returncode == 0 else None


def build(arguments, mesh, angle):
    model = arguments.work / f"{mesh.name}-{angle}.bmt"
    report = run(arguments.bmt, "build", mesh, "-o", model, "--feature-angle", angle, "--simplifier", "fast")
    return model if report is not None else None


def table_row(arguments, mesh):
    name = f"{mesh.parent.name}/{mesh.name}"
    model = build(arguments, mesh, "auto")
    if model is None:
        return None
    settings = json.loads(run(arguments.bmt, "info", model, "--json"))["settings"]
    model.unlink()
    if "dihedral_angles" not in settings:
        return None
    numbers = re.findall(r"[0-9.]+", settings["dihedral_angles"])
    flat, sharp, hard, creases, longFlat, longSharp = (float(n) for n in numbers)
    product = max(flat * sharp, longFlat * longSharp) / 100.0
    among = 100.0 * creases / hard if hard else 0.0
    chosen = "CAD" if settings["feature_angle_auto"] == "30" else "smooth"
    return (f"| `{name}` | {flat:.1f} | {hard:.2f} | {sharp:.2f} | {among:.0f} | {longFlat:.1f} | {longSharp:.2f} | "
            f"{product:.2f} | {chosen} |")


def read(path):
    from vtkmodules import vtkIOXML, vtkIOGeometry, vtkIOPLY
    readers = {".vtp": vtkIOXML.vtkXMLPolyDataReader, ".stl": vtkIOGeometry.vtkSTLReader,
               ".obj": vtkIOGeometry.vtkOBJReader, ".ply": vtkIOPLY.vtkPLYReader}
    reader = readers[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def draw(mesh, picture, size=600):
    """The mesh in one grey, lit from the camera, seen from one corner of its box; the pixels' greys, 0 outside of it."""
    from vtkmodules import vtkRenderingOpenGL2  # noqa: F401: what draws
    from vtkmodules.vtkIOImage import vtkPNGWriter
    from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                             vtkWindowToImageFilter)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.1)
    actor.GetProperty().SetDiffuse(0.9)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(1.0, 0.7, 1.3)
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    renderer.ResetCamera()
    window = vtkRenderWindow()
    window.SetMultiSamples(0)
    window.SetSize(size, size)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    writer = vtkPNGWriter()
    writer.SetFileName(str(picture))
    writer.SetInputData(grab.GetOutput())
    writer.Write()
    scalars = grab.GetOutput().GetPointData().GetScalars()
    return [int(scalars.GetComponent(i, 0)) for i in range(scalars.GetNumberOfTuples())]


def compare(a, b):
    differences = sorted(abs(x - y) for x, y in zip(a, b) if x > 0 and y > 0)
    return sum(differences) / len(differences), differences[len(differences) * 99 // 100]


def picture_row(arguments, mesh):
    from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkPolyDataNormals, vtkTriangleFilter
    plain = read(mesh)
    plain.GetPointData().Initialize()
    plain.GetCellData().Initialize()
    clean = vtkCleanPolyData()
    clean.SetInputData(plain)
    clean.SetTolerance(0.0)
    clean.ConvertPolysToLinesOff()
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(clean.GetOutputPort())
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(triangles.GetOutputPort())
    normals.SplittingOn()
    normals.SetFeatureAngle(30.0)
    normals.ConsistencyOff()
    normals.Update()
    stem = arguments.work / mesh.stem
    wanted = draw(normals.GetOutput(), f"{stem}-vtk.png")
    cells = [f"`{mesh.parent.name}/{mesh.name}`"]
    for angle in ("auto", "none"):
        model = build(arguments, mesh, angle)
        level = pathlib.Path(f"{stem}-{angle}.vtp")
        run(arguments.bmt, "extract", model, "--level", "0", "-o", level)
        mean, large = compare(wanted, draw(read(level), f"{stem}-{angle}.png"))
        cells.append(f"{mean:.2f} | {large}")
        level.unlink()
        model.unlink()
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bmt", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("meshes", type=pathlib.Path, nargs="+")
    parser.add_argument("--pictures", action="store_true")
    arguments = parser.parse_args()
    if arguments.pictures:
        print("| mesh | auto: mean difference | 99 % | none: mean difference | 99 % |\n|---|---|---|---|---|")
        for mesh in arguments.meshes:
            print(picture_row(arguments, mesh), flush=True)
        return
    print("| mesh | flat | hard | sharp | creases of hard | flat by length | sharp by length | product, % | chosen |\n"
          + "|---" * 9 + "|")
    left = []
    for mesh in arguments.meshes:
        row = table_row(arguments, mesh)
        left += [] if row else [mesh.name]
        if row:
            print(row, flush=True)
    print("\nleft out:", ", ".join(left) or "none")


if __name__ == "__main__":
    main()
