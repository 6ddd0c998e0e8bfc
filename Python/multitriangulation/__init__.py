# SPDX-License-Identifier: BSD-3-Clause
"""Multi-Triangulations of large triangle meshes for VTK.

The toolkit's classes, for use beside vtkmodules:

    from multitriangulation import vtkMultiTriangulationBuilder, vtkMultiTriangulationMapper

Importing the package loads the VTK modules that the classes build on, and registers VTK's OpenGL back end when the mapper is there.
"""
import importlib
import pkgutil
import threading

from vtkmodules.vtkCommonCore import vtkObjectBase

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
