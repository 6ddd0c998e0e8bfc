#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""in_pyvista.py MODEL ARRAY PICTURE.png: a model in PyVista, beside its patches. A model may be a .bmt, or a mesh that PyVista reads."""
import sys

import pyvista as pv

import multitriangulation.pyvista  # noqa: F401  has PyVista know the toolkit

if __name__ == "__main__":
    name, array, picture = sys.argv[1:]
    model = pv.read(name)
    if not name.endswith(".bmt"):
        model = model.mt.build()
    plotter = pv.Plotter(off_screen=True, shape=(1, 2), window_size=(1200, 600), border=False)
    plotter.set_background("white")
    plotter.add_mesh(model, scalars=array, cmap="viridis", pixel_error=1, scalar_bar_args={"color": "black"})
    plotter.subplot(0, 1)
    plotter.add_mesh(model, color_by="patch", pixel_error=1)
    plotter.link_views()
    plotter.screenshot(picture)
    print(f"{model.triangles:,} triangles, {plotter.mapper.GetNumberOfTriangles():,} of them drawn")
