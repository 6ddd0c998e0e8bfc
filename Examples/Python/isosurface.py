#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""isosurface.py VOLUME VALUE PICTURE.png: the isosurface of a volume (.vti, .mhd, .nrrd, .nii.gz), out of core."""
import sys

import multitriangulation as mt

if __name__ == "__main__":
    volume, value, picture = sys.argv[1:]
    mt.screenshot(mt.build(volume, iso=float(value), progress=True), path=picture)
