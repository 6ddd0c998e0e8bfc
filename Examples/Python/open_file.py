#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""open_file.py MODEL.bmt: shows a model in a window: turn with the mouse, q ends."""
import sys

import multitriangulation as mt

if __name__ == "__main__":
    mt.show(sys.argv[1], pixel_error=1)
