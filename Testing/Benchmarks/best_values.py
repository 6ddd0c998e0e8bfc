#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What values at the points of a cut could be at best: those that are nearest to the input's in the mean of squares.

usage: best_values.py BMT WORK MESH ARRAY [--share S] [--samples N]

Builds a model of MESH with BMT, takes a cut of a share of its triangles and prints the root of the mean of squares of
the difference of the ARRAY's values (the first three components) at places of the input and at the places of the cut
that are nearest to them: of the cut as it is, and of the values that make it least, all points at once (conjugate
gradients). Those are found by one half of the places; both rows are of the other half.
"""
import argparse
import pathlib
import subprocess

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkCellLocator, vtkGenericCell
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


class Surface:
    def __init__(self, path, array):
        reader = vtkPLYReader() if path.suffix == ".ply" else vtkXMLPolyDataReader()
        reader.SetFileName(str(path))
        triangles = vtkTriangleFilter()
        triangles.SetInputConnection(reader.GetOutputPort())
        triangles.Update()
        self.data = triangles.GetOutput()
        self.points = vtk_to_numpy(self.data.GetPoints().GetData()).astype(float)
        self.triangles = vtk_to_numpy(self.data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        values = vtk_to_numpy(self.data.GetPointData().GetArray(array)).astype(float)
        self.values = values.reshape(len(self.points), -1)[:, :3]

    def sample(self, count):
        """Places spread evenly over the surface, and the values there."""
        random = numpy.random.default_rng(1)
        corners = self.points[self.triangles]
        areas = numpy.linalg.norm(
            numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
        chosen = random.choice(len(areas), count, p=areas / areas.sum())
        u = random.random((count, 2))
        u[u.sum(1) > 1] = 1 - u[u.sum(1) > 1]
        weights = numpy.stack([1 - u.sum(1), u[:, 0], u[:, 1]], 1)[:, :, None]
        return (corners[chosen] * weights).sum(1), (self.values[self.triangles[chosen]] * weights).sum(1)

    def find(self, places):
        """The corners of the nearest triangles, and their weights at the nearest places."""
        locator = vtkCellLocator()
        locator.SetDataSet(self.data)
        locator.BuildLocator()
        nearest, cell, index, part, distance2 = [0.0] * 3, vtkGenericCell(), reference(0), reference(0), reference(0.0)
        triangles = numpy.empty(len(places), int)
        found = numpy.empty((len(places), 3))
        for i, place in enumerate(places):
            locator.FindClosestPoint(place, nearest, cell, index, part, distance2)
            triangles[i], found[i] = index.get(), nearest
        corners = self.points[self.triangles[triangles]]
        a, b, x = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0], found - corners[:, 0]
        aa, ab, bb, xa, xb = ((p * q).sum(1) for p, q in ((a, a), (a, b), (b, b), (x, a), (x, b)))
        area = numpy.where(aa * bb - ab * ab > 0, aa * bb - ab * ab, 1)
        second, third = (bb * xa - ab * xb) / area, (aa * xb - ab * xa) / area
        weights = numpy.clip(numpy.stack([1 - second - third, second, third], 1), 0, 1)
        return self.triangles[triangles], weights


def fit(corners, weights, wanted, values):
    """The values with the least squares, from those that there are."""
    def apply(x):
        return (x[corners] * weights[:, :, None]).sum(1)

    def spread(y):
        out = numpy.zeros_like(values)
        for k in range(3):
            for j in range(out.shape[1]):
                out[:, j] += numpy.bincount(corners[:, k], weights[:, k] * y[:, j], len(values))
        return out

    change = numpy.zeros_like(values)
    rest = spread(wanted - apply(values))
    way, before = rest, (rest * rest).sum()
    least = 1e-12 * before
    for _ in range(300):
        if before <= least:
            break
        image = spread(apply(way)) + 1e-3 * way  # points without a place near them stay
        step = before / (way * image).sum()
        change = change + step * way
        rest = rest - step * image
        now = (rest * rest).sum()
        way, before = rest + now / before * way, now
    return values + change


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bmt", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("mesh", type=pathlib.Path)
    parser.add_argument("array")
    parser.add_argument("--share", type=float, default=0.125)
    parser.add_argument("--samples", type=int, default=400000)
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    mesh = Surface(arguments.mesh, arguments.array)
    model, cut = arguments.work / "model.bmt", arguments.work / "cut.vtp"
    wanted = int(arguments.share * len(mesh.triangles))
    for command in ([arguments.bmt, "build", arguments.mesh, "-o", model],
                    [arguments.bmt, "extract", model, "--triangles", wanted, "-o", cut]):
        subprocess.run([str(part) for part in command], check=True, stdout=subprocess.DEVNULL)
    surface = Surface(cut, arguments.array)
    places, values = mesh.sample(arguments.samples)
    corners, weights = surface.find(places)
    best = fit(corners[::2], weights[::2], values[::2], surface.values)
    print(f"{len(surface.triangles)} of {len(mesh.triangles)} triangles, {arguments.array}")
    for name, own in (("of the cut", surface.values), ("at best", best)):
        difference = (own[corners[1::2]] * weights[1::2, :, None]).sum(1) - values[1::2]
        print(f"{name:>10}: RMS {numpy.sqrt((difference * difference).mean()):.4g}")


if __name__ == "__main__":
    main()
