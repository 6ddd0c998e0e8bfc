# SPDX-License-Identifier: BSD-3-Clause
"""Ranks draw a share of the cut each; pictures, figures and selection are those of one rank."""
import json
import os
import subprocess

from mtparaview import OUTPUT, check, count_pixels, finish

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "draw_on_ranks.py")
# This program has set up MPI for itself alone, which those that mpirun starts must not see.
environment = {name: value for name, value in os.environ.items() if not name.startswith(("OMPI_", "PMIX_"))}
environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
results = {}
for count in (1, 2, 3):
    subprocess.run(["mpirun", "--oversubscribe", "-np", str(count), "pvbatch", SCRIPT], check=True, timeout=300,
                   env=environment)
    with open(os.path.join(OUTPUT, f"ranks{count}.json"), encoding="utf-8") as file:
        results[count] = json.load(file)


def compare(count, name, slight):
    """How many pixels differ by more from those of one rank."""
    return count_pixels(os.path.join(OUTPUT, f"Ranks1{name}.png"), os.path.join(OUTPUT, f"Ranks{count}{name}.png"), slight)


one = results[1]
for count in (2, 3):
    ranks = results[count]
    for name in ("Plain", "Level", "Elevation", "Opaque"):
        pixels = compare(count, name, 3)
        check(f"On {count} ranks the picture {name} is the same", pixels == 0, f"{pixels} pixels differ")
        check("and the figures are those of all ranks together",
              all(ranks[name][each] == one[name][each] for each in ("NumberOfTriangles", "AchievedPixelError", "Converged")),
              ranks[name], one[name]["NumberOfTriangles"])
        check("and each draws its share", ranks[name]["LargestShare"] < 1.4 * one[name]["NumberOfTriangles"] / count)
    # Ranks blend in another order of rounding, and sort nothing where a triangle crosses from one's box into another's:
    # ParaView's own surface of this mesh differs in 283 pixels on 4 ranks.
    for name in ("Translucent", "Clipped", "Moved"):
        pixels, clearly = compare(count, name, 3), compare(count, name, 25)
        check(f"On {count} ranks the picture {name} is the same", pixels < 100 and clearly == 0, pixels, clearly)
        most, all_of_it = ranks[name]["LargestShare"], one[name]["NumberOfTriangles"]
        # The boxes are those of the data, wherever a representation moves it to.
        share = 1.0 if name == "Moved" else 0.85
        check("and no rank draws all of it", all_of_it / count < most < share * all_of_it, most, all_of_it)
    # Where few pixels of a rank have a second translucent layer, it is missing; either layer alone is right.
    pixels = compare(count, "Beside", 3)
    check(f"On {count} ranks a translucent object beside the model is, but for the last layer", pixels < 200, pixels)
    check("The selection is the same", one["selection"] == ranks["selection"] and len(one["selection"][2]) > 10)
    check("The mesh is there once", one["cells"] == ranks["cells"] and one["finest"] == ranks["finest"] == 81920,
          ranks["cells"], ranks["finest"])
finish()
