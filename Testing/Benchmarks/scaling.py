#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Builds fractal spheres of growing size, and prints the table of what each took.

usage: scaling.py BIN WORK [--triangles N ...] [--memory SIZE ...] [--threads N ...] [--mesh FILE ...] [--keep]

BIN holds bmt and meshopt_yardstick; WORK takes meshes and models, which are deleted when they are no longer needed; --keep leaves
WORK/MESH.bmt for other benchmarks.
Peak memory is the resident size as the operating system counted it for the whole process, CPU seconds are user and
system; "of it levels" is the wall time after the input has been read, sorted and stitched. The yardstick is meshopt_simplify of the whole mesh to half its triangles with locked borders, in the same run;
it needs the mesh in memory and is left out above --yardstick triangles.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time


def run(*command):
    """JSON, CPU seconds, wall seconds and peak bytes of a command."""
    with tempfile.TemporaryFile("w+") as out:
        start = time.monotonic()
        child = subprocess.Popen([str(c) for c in command], stdout=out)
        _, status, usage = os.wait4(child.pid, 0)
        wall = time.monotonic() - start
        if status != 0:
            sys.exit(f"{' '.join(str(c) for c in command)}: failed")
        out.seek(0)
        return json.load(out), usage.ru_utime + usage.ru_stime, wall, usage.ru_maxrss * 1024


def mebi(size):
    return f"{size / 2**20:.0f} MiB"


def row(arguments, mesh, threads, memory):
    model = arguments.work / (mesh.stem + ".bmt")
    options = ["--temp", arguments.work, "--threads", threads] + (["--memory", memory] if memory else [])
    built, cpu, wall, peak = run(arguments.bin / "bmt", "build", mesh, "-o", model, "--json", *options)
    triangles = built["triangles"]
    ratio = "-"
    if triangles <= arguments.yardstick:
        half = arguments.work / "half.ply"
        other, _, _, _ = run(arguments.bin / "meshopt_yardstick", mesh, half, triangles // 2, "--lock-border")
        ratio = f"{triangles / other['cpu_s'] / 1000:.0f} ({triangles / cpu / (triangles / other['cpu_s']):.2f})"
        half.unlink()
    if not arguments.keep:
        model.unlink()
    print(f"| {triangles} | {threads} | {memory or 'default'} | {cpu:.1f} | {wall:.1f} | {built['levels_seconds']:.1f} | {triangles / cpu / 1000:.0f} | {ratio} "
          f"| {mebi(peak)} | {mebi(built['temporary_bytes'])} | {built['bytes_per_triangle']:.1f} | {built['levels']} "
          f"| {built['patches']} | {built['root_triangles']} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--triangles", type=int, nargs="*", default=[1310720, 5242880])
    parser.add_argument("--memory", nargs="*", default=[""])
    parser.add_argument("--threads", type=int, nargs="*", default=[2])
    parser.add_argument("--mesh", type=pathlib.Path, nargs="*", default=[], help="meshes in place of spheres")
    parser.add_argument("--keep", action="store_true")
    parser.add_argument("--yardstick", type=int, default=6000000)
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    print("| triangles | threads | memory | CPU s | wall s | of it levels | thousand triangles per CPU s | meshopt_simplify (ratio) "
          "| peak memory | temporary disk | bytes per triangle | levels | patches | root |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|")
    sizes = [] if arguments.mesh else arguments.triangles
    for mesh in arguments.mesh + sizes:
        generated = isinstance(mesh, int)
        path = arguments.work / f"sphere{mesh}.ply" if generated else mesh
        if generated:
            run(arguments.bin / "bmt", "generate", "fractal-sphere", "--triangles", mesh, "-o", path, "--json")
        for memory in arguments.memory:
            for threads in arguments.threads:
                row(arguments, path, threads, memory)
        if generated:
            path.unlink()


if __name__ == "__main__":
    main()
