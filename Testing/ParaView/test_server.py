# SPDX-License-Identifier: BSD-3-Clause
"""Client and server, also with the server calling the client: picture and selection are those without a server."""
import os
import subprocess
import sys
import time

from mtparaview import MODEL, check, count_pixels, figure, finish, load_plugin, make_view, plain, save, selected
from mtparaview import simple

RECTANGLE = [150, 100, 190, 140]
FIGURES = ("NumberOfTriangles", "NumberOfPatches", "AchievedPixelError", "Converged", "Loading", "GraphicsMemory")


def draw(name):
    """Pictures of the model without and with a selection, the selection, and the figures of the first."""
    reader = simple.OpenDataFile(MODEL)
    view = make_view()
    representation = plain(simple.Show(reader, view))
    path = save(view, name)
    figures = [figure(representation, each) for each in FIGURES]
    simple.SelectSurfaceCells(Rectangle=RECTANGLE, View=view)
    return path, save(view, name + "Selected"), selected(reader), figures, representation


def serve(reverse):
    """A pvserver, and this process connected to it."""
    port = 20000 + os.getpid() % 10000 + (1 if reverse else 0)
    options = ["--reverse-connection", "--client-host=localhost"] if reverse else []
    server = subprocess.Popen(["pvserver", f"--server-port={port}", *options])
    if reverse:
        simple.ReverseConnect(str(port))
        return server
    for _ in range(60):
        time.sleep(1)
        try:
            simple.Connect("localhost", port)
            return server
        except RuntimeError:
            pass
    sys.exit("the server cannot be reached")


reverse = sys.argv[1:] == ["reverse"]
load_plugin()
alone = draw("ServerAlone")
server = serve(reverse)
load_plugin(remote=True)
remote = draw("ServerRemote")
pixels = count_pixels(alone[0], remote[0], 3)
check("The picture is the same", pixels == 0, f"{pixels} pixels differ")
# A server draws its lines a little thinner or thicker.
seen = [count_pixels(picture, selection, 20) for picture, selection, *_ in (alone, remote)]
check("The selection is highlighted in both", min(seen) > 500 and max(seen) < 1.5 * min(seen), seen)
check("The selection is the same", remote[2] == alone[2] and len(alone[2][2]) > 10, len(alone[2][2]))
check("The figures are those of the server", alone[3] == remote[3] and alone[3][0] > 10000 and alone[3][5] > 0, *remote[3])
shown = remote[4]
shown.PixelError = 4.0
simple.Render()
shown.UpdatePropertyInformation()
check("and follow it, as attributes in Python, too", 0 < shown.NumberOfTriangles < remote[3][0] / 2 and
      1.0 < shown.AchievedPixelError <= 4.0 and shown.FrameTime > 0.0 and shown.PatchMemory > 0,
      shown.NumberOfTriangles, shown.AchievedPixelError, shown.FrameTime)
server.terminate()
finish()
