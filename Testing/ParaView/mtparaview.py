# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the ParaView plugin share. MT_PLUGIN is the plugin, MT_OUTPUT a folder for what tests write,
MT_BASELINE the folder of the pictures that must come out."""
import os
import sys

import paraview
from paraview import servermanager, simple
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader

OUTPUT = os.environ["MT_OUTPUT"]
MODEL = os.path.join(OUTPUT, "sphere.bmt")
MESH = os.path.join(OUTPUT, "sphere.vtp")
failures = []


def load_plugin(remote=False):
    """The plugin, in this process and, where it is connected, in the server."""
    simple.LoadPlugin(os.environ["MT_PLUGIN"], remote=False, ns=vars(simple))
    if remote:
        simple.LoadPlugin(os.environ["MT_PLUGIN"], remote=True, ns=vars(simple))
    simple._DisableFirstRenderCameraReset()


def check(claim, holds, *figures):
    """Prints the claim with its figures, and remembers that it is false."""
    print("ok    " if holds else "FALSE ", claim, *figures, flush=True)
    if not holds:
        failures.append(claim)


def finish():
    """Ends the script, badly where a claim was false. Not by sys.exit: ParaView 5.11 crashes after it."""
    print(f"{len(failures)} claims are false")
    sys.stdout.flush()
    os._exit(1 if failures else 0)


def make_view(size=(400, 300)):
    """A render view without decorations, which would depend on fonts."""
    view = simple.CreateView("RenderView")
    view.ViewSize = list(size)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.2, 0.25, 0.3]
    view.CameraPosition = [2.2, -3.2, 2.0]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    return view


def plain(representation):
    """No colours of data."""
    representation.ColorArrayName = ["POINTS", ""]
    return representation


def figure(proxy, name):
    """A property that only informs: of a representation's last frame, of what a filter has made."""
    proxy.SMProxy.UpdatePropertyInformation()
    return proxy.GetProperty(name).GetData()


def count_pixels(a, b, slight=0):
    """How many pixels of two pictures differ by more than that in a channel; all of them where the sizes differ."""
    pictures = []
    for name in (a, b):
        reader = vtkPNGReader()
        reader.SetFileName(name)
        reader.Update()
        pictures.append(reader.GetOutput())
    if pictures[0].GetDimensions() != pictures[1].GetDimensions():
        return pictures[0].GetNumberOfPoints()
    from vtkmodules.util.numpy_support import vtk_to_numpy
    first, second = (vtk_to_numpy(p.GetPointData().GetScalars())[:, :3].astype(int) for p in pictures)
    return int((abs(first - second).max(axis=1) > slight).sum())


def save(view, name):
    """The view's picture as a file of the output folder."""
    path = os.path.join(OUTPUT, name + ".png")
    simple.SaveScreenshot(path, view)
    return path


def check_baseline(view, name, slight=3):
    """The view's picture must be the one in the repository, but for the last bits of a channel: that of this version of
    ParaView, where it draws something in its own way."""
    path = save(view, name)
    version = simple.GetParaViewVersion()
    folder = os.path.join(os.environ["MT_BASELINE"], "ParaView")
    baseline = os.path.join(folder, f"{name}-{version.major}.{version.minor}.png")
    if not os.path.exists(baseline):
        baseline = os.path.join(folder, name + ".png")
    if not os.path.exists(baseline):
        check(f"{name} has a baseline", False, path)
        return
    pixels = count_pixels(path, baseline, slight)
    check(f"{name} is as in the repository", pixels == 0, f"{pixels} pixels differ")


def selected(source):
    """Kind, array and sorted values of what is selected in a source's output."""
    selection = source.GetSelectionInput(0)
    if not selection:
        return None, None, []
    if selection.GetXMLName() == "AppendSelections":
        selection = selection.Input[0]
    values = list(selection.Values if selection.GetXMLName() == "ValueSelectionSource" else selection.IDs)
    array = selection.ArrayName if selection.GetXMLName() == "ValueSelectionSource" else None
    return selection.GetXMLName(), array, sorted(set(values[1::2]))
