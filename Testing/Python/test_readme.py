#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""test_readme.py DOCUMENT...: runs the Python blocks of documents, word for word and in order, on a mesh.ply made here, and
looks at the picture.png that they make."""
import importlib.util
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
    """Pixels that are not the background, which the corner shows, and all pixels."""
    reader = vtk.vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    pixels = reader.GetOutput().GetPointData().GetScalars()
    number = pixels.GetNumberOfTuples()
    background = pixels.GetTuple(0)
    return sum(1 for i in range(number) if pixels.GetTuple(i) != background), number


def run(document):
    """Whether all blocks ran, and drew a sphere as large as the default camera shows it."""
    with open(document, encoding="utf-8") as file:
        blocks = re.findall(r"^```python\n(.*?)^```", file.read(), re.MULTILINE | re.DOTALL)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        write_mesh("mesh.ply")
        scope = {}
        for block in blocks:
            if "import pyvista" in block and importlib.util.find_spec("pyvista") is None:
                print("a block is left out: there is no PyVista")
                continue
            exec(compile(block, document, "exec"), scope)
        lit, number = count_lit_pixels("picture.png") if os.path.exists("picture.png") else (0, 1)
        os.chdir("/")
    patches = (scope.get("model") or scope["builder"].GetOutput()).GetNumberOfPatches()
    print(f"{document}: {len(blocks)} blocks, {patches} patches, {lit} of {number} pixels lit")
    return patches > 1 and 0.1 * number < lit < 0.9 * number


def main(documents):
    return 0 if documents and all([run(document) for document in documents]) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
