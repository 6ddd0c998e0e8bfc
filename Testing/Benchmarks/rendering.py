#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures drawing, and prints its tables in Markdown.

usage: rendering.py BIN WORK MODEL [MODEL ...] [options]

BIN holds fly_through; WORK takes the flights' figures (CSV), paths and the film strip; the MODELs
are Multi-Triangulation files of one surface at several resolutions (bmt generate fractal-sphere --triangles N, bmt
build). Needs a display: CMake/with-display Testing/Benchmarks/rendering.py ... The tables are:

  flight      the MAIN model (default: the second but last MODEL, or the only one) along a path from afar to the surface
              and back, with patches limited to --memory megabytes, at 1 pixel: once waiting for what each frame asks
              for, once as while a user moves the camera; then the whole mesh in a vtkPolyDataMapper and in a
              vtkQuadricLODActor, which are drawn in every --stride-th frame only.
  models      one view of every MODEL: the camera of the path's frame --view (a share, 0 to 1) of the first MODEL,
              --back times as far away, moved a little from frame to frame. Ratios are of the largest to the smallest value.
  pictures    cuts of the MAIN model beside the picture of its whole mesh, at six places of the path.
  strip       WORK/strip.png: far, approach, close, turn, back.

--only takes some of them. --quick is for trying it out: few frames, small pictures. A flight of 240 frames past 21M
triangles takes 1 to 3 minutes on two cores without a GPU, a frame of the whole mesh up to 10 s, everything with models
of 1.3M, 5.2M, 21M and 84M triangles about a quarter of an hour. Nothing else should run meanwhile.
"""
import argparse
import json
import pathlib
import subprocess
import sys

WHO = {"mapper": "mapper", "moving": "mapper, moving", "full": "vtkPolyDataMapper", "lod": "vtkQuadricLODActor"}


def fly(arguments, model, name, *options):
    """The summary that fly_through writes."""
    output = arguments.work / f"{name}.json"
    command = [arguments.bin / "fly_through", model, "--json", output, "--size", *arguments.size,
               "--memory", arguments.memory, "--error", arguments.error, *options]
    subprocess.run([str(part) for part in command], check=True, stdout=subprocess.DEVNULL)
    return json.loads(output.read_text())


def table(title, head, rows):
    print(f"\n### {title}\n")
    for row in [head, ["---"] * len(head)] + rows:
        print("| " + " | ".join(str(cell) for cell in row) + " |")
    sys.stdout.flush()


def number(value, digits=1):
    return f"{value:.{digits}f}"


def million(value):
    return f"{value / 1e6:.2f}M"


def flight(arguments):
    path = ["--frames", arguments.frames]
    done = {}
    for who, options in {"mapper": [], "moving": ["--moving"]}.items():
        strip = ["--strip", arguments.work / "strip.png"] if who == "mapper" else []
        csv = arguments.work / f"{who}.csv"
        done[who] = fly(arguments, arguments.main, who, *path, "--csv", csv, *options, *strip)
    for who in arguments.beside:
        done[who] = fly(arguments, arguments.main, who, *path, "--who", who, "--stride", arguments.stride)
    rows = []
    for who, summary in done.items():
        one = summary["flights"][0]
        own = "cut_ms_median" in one
        rows.append([
            WHO[who], one["frames"], number(one["frame_ms_median"]), number(one["frame_ms_worst"]),
            number(one["cut_ms_median"], 2) if own else "-", number(one["cut_ms_worst"], 2) if own else "-",
            f"{million(one['triangles_median'])}, {million(one['triangles_most'])}" if own else
            million(one["triangles_most"]) if who == "full" else "chosen by VTK",
            number(one["patch_megabytes_with_those_under_way_most"]) if own else "-",
            number(one["gpu_megabytes_most"]) if own else "-", number(one["process_megabytes_most"], 0),
            int(one["loads"]) if own else "-", one["stalls"],
            number(one["longest_lock_ms"], 3) if own else "-"])
    size = "x".join(str(side) for side in arguments.size)
    table(f"Flight past {million(done['mapper']['triangles'])} triangles, {size}, 1 pixel ({arguments.error}), "
          f"{arguments.memory} MB",
          ["who", "frames", "frame ms, median", "worst", "cut ms, median", "worst", "triangles, median and most",
           "patches MB, peak", "GPU MB, peak", "process MB, peak", "loads", "stalls", "longest wait ms"], rows)


def steady_path(arguments):
    """A file with one view of the path, moved by a hair from frame to frame so that each looks for its cut."""
    whole = arguments.work / "path.txt"
    subprocess.run([str(part) for part in [
        arguments.bin / "fly_through", arguments.models[0], "--frames", 101, "--size", 64, 36,
        "--write-path", whole]], check=True, stdout=subprocess.DEVNULL)
    view = [float(word) for word in whole.read_text().splitlines()[round(100 * arguments.view)].split()]
    lines = []
    for frame in range(arguments.still):
        moved = [f + (arguments.back - 1e-4 * frame) * (p - f) for p, f in zip(view[:3], view[3:6])]
        lines.append(" ".join(f"{value:.17g}" for value in moved + view[3:]))
    path = arguments.work / "view.txt"
    path.write_text("\n".join(lines) + "\n")
    return path


def models(arguments):
    path = steady_path(arguments)
    rows = []
    columns = [[], [], [], []]
    for i, model in enumerate(arguments.models):
        summary = fly(arguments, model, f"model{i}", "--path", path)
        one = summary["flights"][0]
        values = [one["frame_ms_median"], one["cpu_ms_median"], one["cut_ms_median"], one["triangles_median"]]
        for column, value in zip(columns, values):
            column.append(value)
        share = one["finest_triangles_most"] / max(one["triangles_most"], 1)
        rows.append([million(summary["triangles"]), number(values[0]), number(values[1]), number(values[2], 3),
                     int(values[3]), number(100 * share) + " %"])
    ratios = [max(column) / max(min(column), 1e-9) for column in columns]
    rows.append(["largest to smallest"] + [number(ratio, 2) for ratio in ratios] + ["-"])
    farther = "" if arguments.back == 1 else f", {arguments.back:g} times as far away"
    table(f"The same view of models of several sizes, error: {arguments.error}{farther}",
          ["model", "frame ms, median", "frame CPU ms, median", "cut ms, median", "triangles", "of full resolution"],
          rows)


def pictures(arguments):
    summary = fly(arguments, arguments.main, "pictures", "--frames", arguments.frames, "--compare")
    rows = [[row["error_choice"], row["pixel_error"], row["triangles_mean"], number(row["rms_of_255"], 2),
             number(100 * row["share_off_by_more_than_8"], 2) + " %", row["largest"],
             number(row["certified_pixels_most"], 2)] for row in summary["pictures"]]
    table("Pictures of cuts beside those of the whole mesh",
          ["error", "pixels", "triangles, mean", "RMS of 255", "pixels off by more than 8", "largest difference",
           "certified distance in pixels, most"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("models", type=pathlib.Path, nargs="+")
    parser.add_argument("--main", type=pathlib.Path)
    parser.add_argument("--only", nargs="*", choices=["flight", "models", "pictures"],
                        default=["flight", "models", "pictures"])
    parser.add_argument("--beside", nargs="*", choices=["full", "lod"], default=["full", "lod"],
                        help="who draws the whole mesh; none to leave it out")
    parser.add_argument("--frames", type=int, default=240)
    parser.add_argument("--stride", type=int, default=40)
    parser.add_argument("--still", type=int, default=15, help="frames of the one view of every model")
    parser.add_argument("--view", type=float, default=0.0, help="which one: a share of the path")
    parser.add_argument("--back", type=float, default=1.0, help="that view from so many times its distance")
    parser.add_argument("--size", type=int, nargs=2, default=[1920, 1080])
    parser.add_argument("--memory", type=float, default=90, help="megabytes")
    parser.add_argument("--error", choices=["distance", "edges"], default="distance",
                        help="what flight and models bound: the certified distance or the mean edge length")
    parser.add_argument("--quick", action="store_true")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    arguments.main = arguments.main or arguments.models[-2 if len(arguments.models) > 1 else -1]
    if arguments.quick:
        arguments.frames, arguments.stride, arguments.size, arguments.still = 24, 8, [480, 270], 5
    for step in (flight, models, pictures):
        if step.__name__ in arguments.only:
            step(arguments)


if __name__ == "__main__":
    main()
