# SPDX-License-Identifier: BSD-3-Clause
"""State files, as XML and as Python, and the Python trace: each makes the same picture again."""
import os

from mtparaview import MODEL, OUTPUT, check, count_pixels, figure, finish, load_plugin, make_view, plain, save, simple

from paraview import smstate, smtrace

load_plugin()


def begin():
    simple.ResetSession()
    load_plugin()


def compare(claim, name):
    view = simple.GetActiveView()
    path = save(view, name)
    pixels = count_pixels(os.path.join(OUTPUT, "StateBefore.png"), path, 3)
    representation = simple.GetDisplayProperties(simple.FindSource("sphere.bmt"), view)
    check(claim, pixels == 0 and representation.PixelError == 3.0 and representation.CutColoring == "Level",
          f"{pixels} pixels differ")


smtrace.start_trace()
simple.LoadPlugin(os.environ["MT_PLUGIN"], remote=False, ns=vars(simple))
reader = simple.OpenDataFile(MODEL)
simple.RenameSource("sphere.bmt", reader)
view = make_view()
representation = plain(simple.Show(reader, view))
representation.PixelError = 3.0
representation.CutColoring = "Level"
simple.Render(view)
trace = smtrace.stop_trace()
save(view, "StateBefore")
check("The trace names reader and representation",
      "MultiTriangulationReader(" in trace and "Representation = 'Multi-Triangulation'" in trace)

simple.SaveState(os.path.join(OUTPUT, "state.pvsm"))
with open(os.path.join(OUTPUT, "state.py"), "w", encoding="utf-8") as file:
    file.write(smstate.get_state())

begin()
simple.LoadState(os.path.join(OUTPUT, "state.pvsm"))
compare("A state file makes the same picture", "StateXml")
begin()
exec(compile(open(os.path.join(OUTPUT, "state.py"), encoding="utf-8").read(), "state.py", "exec"), {})
compare("A Python state makes the same picture", "StatePython")
begin()
exec(compile(trace, "trace.py", "exec"), {"LoadPlugin": simple.LoadPlugin})
representation = simple.GetDisplayProperties(simple.FindSource("sphere.bmt"), simple.GetActiveView())
simple.Render()
check("The trace draws the model again", figure(representation, "NumberOfTriangles") > 1000)
finish()
