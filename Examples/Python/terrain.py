#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""terrain.py PICTURE.png TILE...: joins tiles (.hgt, .dem, GeoTIFF) into one terrain in metres and colours it by height."""
import sys

import multitriangulation as mt
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingCore import vtkCamera


def make_colours():
    """Green to brown to white."""
    colours = vtkLookupTable()
    for i in range(256):
        t = i / 255
        colours.SetTableValue(i, 0.2 + 0.8 * t, 0.45 + 0.1 * t + 0.4 * t * t, 0.2 + 0.75 * t * t)
    return colours


def look_from_south(bounds):
    """A camera that sees all of it, from half a diagonal above."""
    center = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    width = max(bounds[1] - bounds[0], bounds[3] - bounds[2])
    camera = vtkCamera()
    camera.SetFocalPoint(center)
    camera.SetPosition(center[0], center[1] - 1.6 * width, center[2] + width)
    camera.SetViewUp(0, 0, 1)
    return camera


if __name__ == "__main__":
    picture, tiles = sys.argv[1], sys.argv[2:]
    model = mt.build(tiles, vertical_scale=2)
    low, high = model.bounds[4:]
    actor = mt.actor(model)
    mapper = actor.GetMapper()
    mapper.SetLookupTable(make_colours())
    mapper.SetColorByElevation((0, 0, low), (0, 0, high), (low, high))
    mt.screenshot(actor, path=picture, camera=look_from_south(model.bounds))
