#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""several_models.py PICTURE.png MODEL...: models beside each other in one scene; each keeps within a pixel."""
import sys

import multitriangulation as mt

if __name__ == "__main__":
    picture, names = sys.argv[1], sys.argv[2:]
    actors, left = [], 0.0
    for name in names:
        actor = mt.actor(name)
        bounds = actor.GetBounds()
        actor.SetPosition(left - bounds[0], -bounds[2], -bounds[4])
        left += 1.1 * (bounds[1] - bounds[0])
        actors.append(actor)
    mt.screenshot(*actors, path=picture)
