#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""source_to_screen.py MESH PICTURE.png: from the file of a mesh to a picture, in memory and in one go."""
import sys

import multitriangulation as mt

if __name__ == "__main__":
    mesh, picture = sys.argv[1:]
    mt.screenshot(mt.build(mesh), path=picture)
