#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""turntable.py MODEL FOLDER [FRAMES]: pictures of a model that turns once, frame-000.png and so on, off screen; a film of them:
ffmpeg -framerate 25 -i FOLDER/frame-%03d.png film.mp4"""
import os
import sys

import multitriangulation as mt
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer

if __name__ == "__main__":
    model, folder = mt.read(sys.argv[1]), sys.argv[2]
    frames = int(sys.argv[3]) if len(sys.argv) > 3 else 100
    os.makedirs(folder, exist_ok=True)
    actor, camera, renderer = mt.actor(model), vtkCamera(), vtkRenderer()
    renderer.SetActiveCamera(camera)
    renderer.ResetCamera(model.bounds)
    for frame in range(frames):
        mt.screenshot(actor, path=os.path.join(folder, f"frame-{frame:03d}.png"), size=(640, 480), camera=camera)
        camera.Azimuth(360 / frames)
