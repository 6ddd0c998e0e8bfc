# SPDX-License-Identifier: BSD-3-Clause
"""turntable.py MODEL.bmt FOLDER [FRAMES]: pictures of a model that turns once, frame-000.png and so on; a film of them:
ffmpeg -framerate 25 -i FOLDER/frame-%03d.png film.mp4. MT_PLUGIN names the plugin; run by pvpython."""
import os
import sys

from paraview.simple import *

LoadPlugin(os.environ["MT_PLUGIN"], ns=globals())
model, folder = sys.argv[1:3]
frames = int(sys.argv[3]) if len(sys.argv) > 3 else 100
os.makedirs(folder, exist_ok=True)
view = CreateView("RenderView")
view.ViewSize = [640, 480]
Show(OpenDataFile(model), view)
ResetCamera(view)
for frame in range(frames):
    SaveScreenshot(os.path.join(folder, f"frame-{frame:03d}.png"), view)
    GetActiveCamera().Azimuth(360.0 / frames)
