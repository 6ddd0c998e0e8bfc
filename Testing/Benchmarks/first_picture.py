# SPDX-License-Identifier: BSD-3-Clause
"""first_picture.py MODEL.bmt: time and bytes until a model's first picture, and until the picture is what the view asks for.

With the build tree's package on PYTHONPATH, under CMake/with-display where there is no display. A window without the model is drawn
first, so that what OpenGL costs is not counted. Bytes are those that the process read from the file (rchar of /proc/self/io).
"""
import sys
import time

import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from multitriangulation.vtkMTIO import vtkMultiTriangulationReader
from multitriangulation.vtkMTRenderingOpenGL2 import vtkMultiTriangulationMapper
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow


def bytes_read():
    with open("/proc/self/io", encoding="ascii") as lines:
        return int(next(lines).split()[1])


def main(path):
    window = vtkRenderWindow()
    window.SetSize(1024, 768)
    renderer = vtkRenderer()
    window.AddRenderer(renderer)
    window.Render()
    start, before = time.monotonic(), bytes_read()

    def report(what, mapper):
        print(f"{what:34} {1000 * (time.monotonic() - start):9.1f} ms {bytes_read() - before:12} bytes read,"
              f" {mapper.GetNumberOfTriangles():8} triangles drawn", flush=True)

    reader = vtkMultiTriangulationReader()
    reader.SetFileName(path)
    mapper = vtkMultiTriangulationMapper()
    mapper.SetWaitForConvergence(vtkMultiTriangulationMapper.WAIT_NEVER)
    mapper.SetInputConnection(reader.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)
    reader.Update()
    report("opened", mapper)
    renderer.ResetCamera()
    window.Render()
    report("first picture", mapper)
    while mapper.GetLoading():
        window.Render()
    report("picture within one pixel", mapper)


if __name__ == "__main__":
    main(sys.argv[1])
