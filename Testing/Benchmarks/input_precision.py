#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How finely meshes say where their points are, beside the default lattice.

usage: input_precision.py MESH [MESH ...]    (VTP, VTK, PLY, STL, OBJ)

For each mesh, as powers of two: the default lattice's step, the spacing of the coordinates' type (single precision
where all coordinates fit in it) at the coordinate that is farthest from 0, and the largest step of which all
coordinates are multiples.
"""
import math
import pathlib
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

READERS = {".vtp": vtkXMLPolyDataReader, ".vtk": vtkPolyDataReader, ".ply": vtkPLYReader, ".stl": vtkSTLReader,
           ".obj": vtkOBJReader}


def spacing(x, single):
    return math.frexp(x)[1] - (24 if single else 53)


def largest_step(coordinates):
    values = numpy.unique(coordinates)
    mantissas, exponents = numpy.frexp(values[values != 0])
    whole = (mantissas * 2.0**53).astype(numpy.int64)
    zeros = numpy.log2(whole & -whole).astype(int)
    return int((exponents - 53 + zeros).min())


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    for path in map(pathlib.Path, sys.argv[1:]):
        reader = READERS[path.suffix]()
        reader.SetFileName(str(path))
        reader.Update()
        points = vtk_to_numpy(reader.GetOutput().GetPoints().GetData()).astype(float)
        points = points[numpy.isfinite(points).all(1)]
        single = bool((points.astype(numpy.float32) == points).all())
        step = math.ceil(math.log2((points.max(0) - points.min(0)).max())) - 24
        print(f"{path.name:32} lattice 2^{step:<4} {'float' if single else 'double'} 2^"
              f"{spacing(abs(points).max(), single):<4} multiples of 2^{largest_step(points)}")


if __name__ == "__main__":
    main()
