# SPDX-License-Identifier: BSD-3-Clause
"""Runs the scripts of Examples/ParaView as their users do, and looks at what they draw and print.

usage: test_examples.py FOLDER"""
import os
import re
import shutil
import subprocess
import sys

from mtparaview import MESH, MODEL, OUTPUT, check, count_pixels, finish
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

FOLDER = sys.argv[1]
ran = set()


def run(name, *arguments):
    """What the script prints; it must end well."""
    done = subprocess.run(["pvpython", os.path.join(FOLDER, name), *map(str, arguments)], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False, timeout=300)
    check(f"{name} ends well", done.returncode == 0 and not re.search(r"Error|ERR|Warn", done.stdout), done.stdout)
    ran.add(name)
    return done.stdout


def path(name):
    """A file of this test that is not there yet."""
    result = os.path.join(OUTPUT, "Example" + name)
    if os.path.exists(result):
        os.remove(result)
    return result


def read(name):
    """The colours of the pixels, one a row."""
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)


def share(pixels, *limits):
    """Of the pixels, how many are within limits (least and most of red, green and blue)."""
    inside = True
    for channel, (least, most) in enumerate(limits):
        inside = inside & (pixels[:, channel] >= least) & (pixels[:, channel] <= most)
    return inside.mean()


picture = path("Open.png")
run("open_and_colour.py", MODEL, "Elevation", picture)
colours = read(picture)
reds, blues = share(colours, (150, 255), (0, 60), (0, 80)), share(colours, (0, 80), (0, 110), (150, 255))
check("Elevation is coloured from blue to red, and has a scalar bar", reds > 0.01 and blues > 0.0001, reds, blues)

picture, model = path("Build.png"), path("Build.bmt")
run("build_from_mesh.py", MESH, model, picture)
check("A model is saved", os.path.getsize(model) > 100000, os.path.getsize(model))
hues = [share(read(picture), *((110, 255) if i == channel else (0, 100) for i in range(3))) for channel in (0, 1)]
check("Patches have hues of their own, red and green among them", min(hues) > 0.001, hues)

picture = path("Cut.png")
run("cut_and_section.py", MODEL, 5000, picture)
red = share(read(picture), (120, 255), (0, 90), (0, 90))
edges = share(read(picture), (0, 60), (0, 60), (90, 200))
check("The section and edges are drawn", red > 0.001 and edges > 0.02, red, edges)

picture = path("Clip.png")
said = run("clip_and_select.py", MODEL, picture)
found = re.fullmatch(r"(\d+) cells of the input are selected\n", said)
check("Cells of the input are selected", found is not None and 100 < int(found[1]) < 20000, said)
highlighted = share(read(picture), (180, 255), (0, 60), (180, 255))
check("They are highlighted", highlighted > 0.003, highlighted)

film = os.path.join(OUTPUT, "ExampleFilm")
shutil.rmtree(film, ignore_errors=True)
run("turntable.py", MODEL, film, 3)
frames = sorted(os.listdir(film))
check("There are three frames", frames == ["frame-000.png", "frame-001.png", "frame-002.png"], frames)
differ = count_pixels(os.path.join(film, frames[0]), os.path.join(film, frames[1]), 20)
check("They differ", differ > 5000, differ)

scripts = {name for name in os.listdir(FOLDER) if name.endswith(".py")}
check("No example is left out", scripts == ran, scripts - ran)
finish()
