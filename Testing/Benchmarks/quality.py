#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""RMS and largest distance of cuts of a fractal sphere, beside meshopt_simplify of the whole mesh at the same count.

usage: quality.py BIN WORK [--triangles N] [--shares S ...]

BIN holds bmt and meshopt_yardstick; WORK takes the meshes. Prints a table in percent of the bounding box's diagonal.
"""
import argparse
import json
import pathlib
import subprocess


def run(*command):
    return subprocess.run([str(c) for c in command], check=True, capture_output=True, text=True).stdout


def compare(bmt, a, b, samples):
    figures = json.loads(run(bmt, "compare", a, b, "--samples", samples, "--json"))
    return 100 * figures["rms"] / figures["diagonal"], 100 * figures["max"] / figures["diagonal"]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--triangles", type=int, default=1310720)
    parser.add_argument("--shares", type=float, nargs="*", default=[0.125, 0.015625, 0.0078125])
    parser.add_argument("--samples", type=int, default=500000)
    parser.add_argument("--simplifier", default="fast")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    bmt = arguments.bin / "bmt"
    mesh = arguments.work / "sphere.ply"
    model = arguments.work / f"sphere-{arguments.simplifier}.bmt"
    if not mesh.exists():
        run(bmt, "generate", "fractal-sphere", "--triangles", arguments.triangles, "-o", mesh)
    if not model.exists():
        run(bmt, "build", mesh, "-o", model, "--simplifier", arguments.simplifier)
    print("| share | triangles | cut: RMS / max % | meshopt_simplify: RMS / max % | ratio of RMS |")
    print("|---|---|---|---|---|")
    for share in arguments.shares:
        cut = arguments.work / "cut.ply"
        other = arguments.work / "meshopt.ply"
        run(bmt, "extract", model, "-o", cut, "--triangles", round(arguments.triangles * share))
        # The yardstick gets the count that the cut has, not the one that was asked for.
        triangles = json.loads(run(bmt, "compare", cut, cut, "--samples", 1, "--json"))["triangles_a"]
        run(arguments.bin / "meshopt_yardstick", mesh, other, triangles)
        ours, peer = compare(bmt, cut, mesh, arguments.samples), compare(bmt, other, mesh, arguments.samples)
        print(f"| {100 * share:.2f} % | {triangles} | {ours[0]:.4f} / {ours[1]:.3f} | {peer[0]:.4f} / {peer[1]:.3f} "
              f"| {ours[0] / peer[0]:.3f} |", flush=True)


if __name__ == "__main__":
    main()
