#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""test_readme.py README.md: runs the README's Python pipeline, word for word, on a mesh.ply made here, and looks at its picture.png."""
import os
import re
import sys
import tempfile

import vtk


def write_mesh(name):
    sphere = vtk.vtkSphereSource()
    sphere.SetThetaResolution(200)
    sphere.SetPhiResolution(200)
    writer = vtk.vtkPLYWriter()
    writer.SetInputConnection(sphere.GetOutputPort())
    writer.SetFileName(name)
    writer.Write()


def count_lit_pixels(name):
    """Pixels that are not the renderer's black background, and all pixels."""
    reader = vtk.vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    pixels = reader.GetOutput().GetPointData().GetScalars()
    number = pixels.GetNumberOfTuples()
    return sum(1 for i in range(number) if any(pixels.GetTuple(i))), number


def main(readme):
    with open(readme, encoding="utf-8") as file:
        blocks = re.findall(r"^```python\n(.*?)^```", file.read(), re.MULTILINE | re.DOTALL)
    if len(blocks) != 1:
        print(f"{readme}: one Python block expected, {len(blocks)} found")
        return 1
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        write_mesh("mesh.ply")
        scope = {}
        exec(compile(blocks[0], readme, "exec"), scope)
        lit, number = count_lit_pixels("picture.png")
        os.chdir("/")
    model = scope["builder"].GetOutput()
    print(f"{model.GetNumberOfFinestTriangles()} triangles, {model.GetNumberOfPatches()} patches, {lit} of {number} pixels lit")
    # The default camera shows the whole sphere, which covers between a tenth and nine tenths of the window.
    return 0 if model.GetNumberOfPatches() > 1 and 0.1 * number < lit < 0.9 * number else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
