#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Bytes against precision: builds each mesh on lattices of 2^14 to 2^31 steps and prints tables of what came out.

usage: precision_table.py BMT WORK MESH [MESH ...] [--bits N,N,...] [--compression fast] [--exact]

A row for each mesh and lattice: bytes of geometry (positions, topology and identities of all levels) per triangle of the
input, the lattice's step and the largest shift of a point over the longest side, and the certified error of level 1 over
the longest side, to see what a finer lattice still improves. With --exact also what the residuals of level 0 take.
"""
import argparse
import json
import math
import pathlib
import subprocess


def bmt(arguments, *command):
    done = subprocess.run([str(arguments.bmt), *map(str, command), "--json"], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"precision_table.py: {' '.join(map(str, command))}: {done.stderr.strip()}")
    return json.loads(done.stdout)


def get_row(arguments, mesh, bits):
    model = arguments.work / f"{mesh.stem}_{bits}.bmt"
    options = ["--lattice-bits", bits, "--compression", arguments.compression]
    built = bmt(arguments, "build", mesh, "-o", model, *options, *(["--exact"] if arguments.exact else []))
    info = bmt(arguments, "info", model)
    side = max(info["bounds"][2 * i + 1] - info["bounds"][2 * i] for i in range(3))
    error = math.nan
    if info["levels"] > 1:
        error = bmt(arguments, "extract", model, "--level", 1, "-o", arguments.work / "level1.ply")["error"]
    residuals = info["bytes_of"].get("vtkMTExactPoints", 0) / info["triangles"]
    model.unlink()
    return {"bits": bits, "bytes": info["bytes_of"]["geometry"] / info["triangles"], "residuals": residuals,
            "step": info["lattice_step"] / side, "shift": info["largest_shift"] / side, "error": error / side,
            "dropped": built["input_report"].get("dropped_degenerate", 0), "triangles": info["triangles"]}


def power(x):
    return f"2^{math.log2(x):.1f}" if x > 0 else "0"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bmt", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("mesh", type=pathlib.Path, nargs="+")
    parser.add_argument("--bits", default="14,16,18,20,22,24,26,28,31")
    parser.add_argument("--compression", default="fast")
    parser.add_argument("--exact", action="store_true")
    arguments = parser.parse_args()
    print("| mesh | triangles | bits | bytes per triangle |" + (" residuals |" if arguments.exact else "") +
          " step | largest shift | error of level 1 | dropped |")
    print("|---|---|---|---|" + ("---|" if arguments.exact else "") + "---|---|---|---|")
    for mesh in arguments.mesh:
        for bits in map(int, arguments.bits.split(",")):
            row = get_row(arguments, mesh, bits)
            print(f"| `{mesh.name}` | {row['triangles']} | {bits} | {row['bytes']:.2f} |" +
                  (f" {row['residuals']:.2f} |" if arguments.exact else "") +
                  f" {power(row['step'])} | {power(row['shift'])} | {power(row['error'])} | {row['dropped']} |", flush=True)


if __name__ == "__main__":
    main()
