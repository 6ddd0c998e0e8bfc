#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Builds, verifies and renders every mesh of a folder, and prints the table of what came out.

usage: data_table.py BIN WORK MESH [MESH ...] [--cuts N] [--keep]

BIN holds bmt. A mesh that bmt refuses is listed with its message: whether that is right is for the reader to judge.
Run it under CMake/with-display where there is no display.
"""
import argparse
import json
import os
import pathlib
import subprocess


def run(*command):
    """The command's exit code, its JSON, the last line of its messages, and the CPU seconds that it took."""
    before = os.times()
    done = subprocess.run([str(c) for c in command] + ["--json"], capture_output=True, text=True)
    after = os.times()
    cpu = after.children_user + after.children_system - before.children_user - before.children_system
    try:
        figures = json.loads(done.stdout)
    except ValueError:
        figures = {}
    messages = done.stderr.strip().splitlines()
    return done.returncode, figures, messages[-1] if messages else "", cpu


def worst_ratio(figures):
    """Median and worst ratio of certified to sampled error: up to level 3, and beyond."""
    levels = figures.get("certified_over_sampled", {})
    fine = [v["median"] for k, v in levels.items() if 0 < int(k) <= 3 and v["median"] is not None]
    coarse = [v["median"] for k, v in levels.items() if int(k) > 3 and v["median"] is not None]
    worst = [v["worst"] for k, v in levels.items() if int(k) > 0 and v["worst"] is not None]
    return [f"{max(values):.2f}" if values else "-" for values in (fine, coarse, worst)]


def table_row(arguments, mesh):
    name = f"{mesh.parent.name}/{mesh.name}"
    model = arguments.work / (mesh.name + ".bmt")
    picture = arguments.work / (mesh.name + ".png")
    bmt = arguments.bin / "bmt"
    code, built, message, cpu = run(bmt, "build", mesh, "-o", model)
    if code != 0:
        return f"| `{name}` | refused: {message} |"
    _, info, _, _ = run(bmt, "info", model)
    verified, report, problem, verify_cpu = run(bmt, "verify", model, "--cuts", arguments.cuts, "--input", mesh)
    rendered, picture_figures, trouble, _ = run(bmt, "render", model, "-o", picture)
    fine, coarse, worst = worst_ratio(report)
    verdict = "ok" if verified == 0 else f"**failed**: {problem}"
    drawn = f"{picture_figures.get('triangles', '-')}" if rendered == 0 else f"**failed**: {trouble}"
    blocked = ", ".join(f"{k} {v}" for k, v in info["blocked"].items()) or "-"
    if not arguments.keep:
        model.unlink()
    return (f"| `{name}` | {info['triangles']} | {info['stored_triangles']} | {info['levels']} | {info['patches']} "
            f"| {info['root_triangles']} | {cpu:.1f} | {info['conditioning']['largest_region_over_target']:.2f} "
            f"| {fine} | {coarse} | {worst} | {verdict} ({verify_cpu:.0f} s) | {drawn} | {blocked} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("meshes", type=pathlib.Path, nargs="+")
    parser.add_argument("--cuts", type=int, default=1000)
    parser.add_argument("--keep", action="store_true", help="leave the models in WORK")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    print("| mesh | triangles in | stored | levels | patches | root | build CPU s | largest region over target "
          "| certified over sampled: median up to level 3 | beyond | worst | verify | drawn triangles | blocked edges |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|")
    for mesh in arguments.meshes:
        print(table_row(arguments, mesh), flush=True)


if __name__ == "__main__":
    main()
