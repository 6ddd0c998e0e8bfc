# SPDX-License-Identifier: BSD-3-Clause
"""Two ranks draw half of the cut each; pictures and selection are those of one rank."""
import json
import os
import subprocess

from mtparaview import OUTPUT, check, count_pixels, finish

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "draw_on_ranks.py")
# This program has set up MPI for itself alone, which those that mpirun starts must not see.
environment = {name: value for name, value in os.environ.items() if not name.startswith(("OMPI_", "PMIX_"))}
environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
results = {}
for count in (1, 2):
    subprocess.run(["mpirun", "--oversubscribe", "-np", str(count), "pvbatch", SCRIPT], check=True, timeout=300,
                   env=environment)
    with open(os.path.join(OUTPUT, f"ranks{count}.json"), encoding="utf-8") as file:
        results[count] = json.load(file)
one, two = results[1], results[2]
for name in ("Plain", "Level", "Elevation", "Translucent"):
    pixels = count_pixels(os.path.join(OUTPUT, f"Ranks1{name}.png"), os.path.join(OUTPUT, f"Ranks2{name}.png"), 3)
    check(f"The picture {name} is the same", pixels == 0, f"{pixels} pixels differ")
check("The first rank draws about half of the triangles", 0.3 < two["triangles"] / one["triangles"] < 0.7,
      two["triangles"], one["triangles"])
check("The selection is the same", one["selection"] == two["selection"] and len(one["selection"][2]) > 10)
check("The mesh is there once", one["cells"] == two["cells"] and one["finest"] == two["finest"] == 81920,
      two["cells"], two["finest"])
finish()
