# SPDX-License-Identifier: BSD-3-Clause
"""
Multi-Triangulations of large triangle meshes for VTK.

    import multitriangulation as mt

    model = mt.build("scan.ply", "scan.bmt")        # once, out of core
    model = mt.read("scan.bmt")                     # a vtkPolyData that knows its patches
    mesh = mt.cut(model, triangles=100_000)         # a mesh, its data as numpy arrays
    actor = mt.actor(model, pixel_error=1)          # an ordinary vtkActor
    mt.show(model)                                  # a window
    mt.screenshot(model, path="scan.png")
    assert mt.verify(model, "scan.ply")

These functions stand on the toolkit's VTK classes, which are here too, for use beside vtkmodules:

    from multitriangulation import vtkMultiTriangulationBuilder, vtkMultiTriangulationMapper

Importing the package loads the VTK modules that the classes build on, and registers VTK's OpenGL back end when the mapper
is there.
"""
import importlib
import pkgutil
import threading

from vtkmodules.vtkCommonCore import vtkObjectBase

from ._version import __version__

__all__ = []


def _export(module):
    """Takes the VTK classes of one wrapped module into the package."""
    for name, value in vars(module).items():
        if isinstance(value, type) and issubclass(value, vtkObjectBase):
            globals()[name] = value
            __all__.append(name)


# Every compiled module beside this file is one of the toolkit's VTK modules.
for _entry in sorted(pkgutil.iter_modules(__path__), key=lambda entry: entry.name):
    if _entry.name.startswith("vtkMT"):
        if _entry.name == "vtkMTRenderingOpenGL2":
            import vtkmodules.vtkRenderingFreeType  # noqa: F401
            import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
        _export(importlib.import_module(f"{__name__}.{_entry.name}"))

__all__.sort()

from . import _interpreter  # noqa: E402  links to the modules above

_interpreter.install(threading.main_thread().ident)

from ._errors import MultiTriangulationError  # noqa: E402
from ._model import Cut, Model, read  # noqa: E402

__all__ += ["Cut", "Model", "MultiTriangulationError", "__version__", "read"]


def _export_functions(module, names, needs):
    """Functions are there where the classes are that they stand on: the toolkit may be built without some modules."""
    if needs in globals():
        functions = importlib.import_module(f"{__name__}.{module}")
        for name in names:
            globals()[name] = getattr(functions, name)
            __all__.append(name)


_export_functions("_build", ["build"], "vtkMultiTriangulationFileBuilder")
_export_functions("_cut", ["cut"], "vtkMultiTriangulationCutFilter")
_export_functions("_draw", ["actor", "screenshot", "show"], "vtkMultiTriangulationMapper")
_export_functions("_verify", ["Check", "Verification", "verify"], "vtkMultiTriangulationVerifier")
