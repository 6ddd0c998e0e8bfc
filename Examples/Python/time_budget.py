#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""
time_budget.py MODEL [RATE]: on a slow machine: the window asks for frames per second (30), the cut becomes as coarse as that
needs while the camera moves, and what was drawn and how long it took is printed.
"""
import sys
import time

import multitriangulation as mt
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

if __name__ == "__main__":
    model, rate = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 30.0
    actor = mt.actor(model, pixel_error=0.5)
    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.AddActor(actor)
    window.SetOffScreenRendering(1)
    window.SetSize(640, 480)
    window.AddRenderer(renderer)
    window.SetDesiredUpdateRate(rate)
    seconds = []
    for _ in range(60):
        renderer.GetActiveCamera().Azimuth(2)
        start = time.perf_counter()
        window.Render()
        window.WaitForCompletion()
        seconds.append(time.perf_counter() - start)
    median = sorted(seconds[20:])[20]
    mapper = actor.GetMapper()
    print(f"{1 / median:.1f} frames per second of {rate:g} asked for, {mapper.GetNumberOfTriangles()} triangles in the last one, "
          f"within {mapper.GetAchievedPixelError():.2g} pixels")
