#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of kinds that invite quadratic time, of n, 2n, 4n and 8n triangles: what it takes to build, to verify against the
input and to read a model of each.

usage: stiff_input.py BMT WORK [--kinds KIND ...] [--steps STEP ...] [--triangles N] [--limit CPU_SECONDS]

BMT is the command; WORK takes meshes and models, which are deleted. N is the largest size, 8n (default: what each kind's
table says). CPU seconds are user and system, the least of --repeat runs, which are spread over the sizes so that other
work on the machine meets all of them alike. Exponents are log2 of the ratio of neighbouring times: 1 is linear, 2
quadratic, and n log n is 1.06 to 1.1 at these sizes; the last one is the mean of the three. 'too long' is more than
--limit.

Steps: build (--simplifier fast), best (--simplifier best), verify (--input), read (extract --level 0).
"""
import argparse
import array
import math
import os
import pathlib
import resource
import signal
import subprocess
import sys


class Mesh:
    def __init__(self):
        self.points = array.array("d")
        self.triangles = array.array("i")

    def point(self, x, y, z):
        self.points.extend((x, y, z))
        return len(self.points) // 3 - 1

    def triangle(self, a, b, c):
        self.triangles.extend((a, b, c))

    def write(self, path):
        points = len(self.points) // 3
        count = len(self.triangles) // 3
        with open(path, "wb") as out:
            out.write((f"ply\nformat binary_little_endian 1.0\nelement vertex {points}\n"
                       "property double x\nproperty double y\nproperty double z\n"
                       f"element face {count}\nproperty list uchar int vertex_indices\nend_header\n").encode())
            out.write(self.points.tobytes())
            faces = bytearray(13 * count)
            for t in range(count):
                faces[13 * t] = 3
                faces[13 * t + 1:13 * t + 13] = self.triangles[3 * t:3 * t + 3].tobytes()
            out.write(faces)


def add_ring(mesh, n, z, wobble):
    return [mesh.point(math.cos(a) * r, math.sin(a) * r, z + 0.02 * math.sin(9.0 * a))
            for a, r in ((2.0 * math.pi * i / n, 1.0 + wobble * math.sin(7.0 * 2.0 * math.pi * i / n)) for i in range(n))]


def add_fan(mesh, apex, ring):
    for i, p in enumerate(ring):
        mesh.triangle(apex, p, ring[(i + 1) % len(ring)])


def fan(n):
    mesh = Mesh()
    add_fan(mesh, mesh.point(0.0, 0.0, 0.5), add_ring(mesh, n, 0.0, 0.1))
    return mesh


def two_fans(n):
    mesh = Mesh()
    apex = mesh.point(0.0, 0.0, 0.0)
    add_fan(mesh, apex, add_ring(mesh, n // 2, -0.5, 0.1))
    add_fan(mesh, apex, add_ring(mesh, n // 2, 0.5, 0.1)[::-1])
    return mesh


def spindle(n):
    """Two apexes over one ring, closed."""
    mesh = Mesh()
    ring = add_ring(mesh, n // 2, 0.0, 0.1)
    add_fan(mesh, mesh.point(0.0, 0.0, 0.5), ring)
    add_fan(mesh, mesh.point(0.0, 0.0, -0.5), ring[::-1])
    return mesh


def barycentres(n):
    """Triangles around one barycentre, which no rounding moves."""
    mesh = Mesh()
    for i in range(1, n + 1):
        u, v = (i, i * 7919 % (n + 1))
        mesh.triangle(mesh.point(u, v, 0.0), mesh.point(-v, u - v, 1.0), mesh.point(v - u, -u, -1.0))
    return mesh


def components(n):
    mesh = Mesh()
    side = math.ceil(n ** (1.0 / 3.0))
    for i in range(n):
        x, y, z = i % side, i // side % side, i // side // side
        mesh.triangle(mesh.point(x, y, z), mesh.point(x + 0.5, y, z), mesh.point(x, y + 0.5, z + 0.1))
    return mesh


def boxes(n):
    """Closed components of twelve triangles, all in one row: no region is without some of other ones'."""
    mesh = Mesh()
    corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    faces = ((0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2),
             (1, 3, 7), (1, 7, 5))
    for i in range(n // 12):
        base = [mesh.point(2.0 * i + x, y, z) for x, y, z in corners]
        for face in faces:
            mesh.triangle(*(base[k] for k in face))
    return mesh


def needles(n):
    """A ruled strip: triangles as long as the mesh."""
    mesh = Mesh()
    low = [mesh.point(0.0, 1e-4 * i, 0.01 * math.sin(0.01 * i)) for i in range(n // 2 + 1)]
    high = [mesh.point(1000.0, 1e-4 * i, 0.01 * math.cos(0.013 * i)) for i in range(n // 2 + 1)]
    for i in range(n // 2):
        mesh.triangle(low[i], high[i], low[i + 1])
        mesh.triangle(high[i], high[i + 1], low[i + 1])
    return mesh


def pages(n):
    """Triangles at one edge, as a book's."""
    mesh = Mesh()
    a, b = mesh.point(0.0, 0.0, 0.0), mesh.point(0.0, 0.0, 1.0)
    for i in range(n):
        t = 2.0 * math.pi * i / n
        mesh.triangle(a, b, mesh.point(math.cos(t), math.sin(t), 0.5))
    return mesh


def sheets(n):
    """One square again and again at the same place, with points of its own each time."""
    mesh = Mesh()
    for _ in range(n // 2):
        a, b, c, d = (mesh.point(x, y, 0.0) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)))
        mesh.triangle(a, b, c)
        mesh.triangle(a, c, d)
    return mesh


def touching(n):
    """Tetrahedra with one corner in common."""
    mesh = Mesh()
    o = mesh.point(0.0, 0.0, 0.0)
    for i in range(n // 4):
        z = 1.0 - 2.0 * (i + 0.5) / (n // 4)
        t, r = 2.399963 * i, math.sqrt(1.0 - z * z)
        d = 0.5 / math.sqrt(n)
        a, b, c = (mesh.point(r * math.cos(t) + x, r * math.sin(t) + y, z + w) for x, y, w in ((d, 0, 0), (0, d, 0), (0, 0, d)))
        for face in ((o, a, b), (o, b, c), (o, c, a), (a, c, b)):
            mesh.triangle(*face)
    return mesh


KINDS = {"fan": (fan, 100000), "two_fans": (two_fans, 100000), "spindle": (spindle, 100000),
         "barycentres": (barycentres, 80000), "components": (components, 300000), "boxes": (boxes, 300000),
         "needles": (needles, 100000), "pages": (pages, 100000), "sheets": (sheets, 100000), "touching": (touching, 100000)}


def run(command, limit):
    """CPU seconds; infinite where they are more than the limit."""
    def set_limit():
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1))

    child = subprocess.Popen([str(c) for c in command], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                             preexec_fn=set_limit)
    message = child.stderr.read().decode()
    _, status, usage = os.wait4(child.pid, 0)
    if os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGXCPU, signal.SIGKILL):
        return math.inf
    if status != 0:
        print(message[-1000:], f"failed: {[str(c) for c in command]}", file=sys.stderr)
        return math.nan
    return usage.ru_utime + usage.ru_stime


def run_step(arguments, step, mesh, model):
    bmt = arguments.bmt
    scratch = mesh.with_suffix(".out.ply")
    commands = {"build": [bmt, "build", mesh, "-o", model],
                "best": [bmt, "build", mesh, "-o", model, "--simplifier", "best"],
                "verify": [bmt, "verify", model, "--input", mesh],
                "read": [bmt, "extract", model, "--level", "0", "-o", scratch]}
    seconds = run(commands[step], arguments.limit)
    scratch.unlink(missing_ok=True)
    return seconds


def measure(arguments, kind, triangles):
    """[step][size] the least CPU seconds."""
    seconds = {step: [math.inf] * 4 for step in arguments.steps}
    for _ in range(arguments.repeat):
        for size, divisor in enumerate((8, 4, 2, 1)):
            mesh = arguments.work / f"{kind}.ply"
            model = arguments.work / f"{kind}.bmt"
            KINDS[kind][0](triangles // divisor).write(mesh)
            if "build" not in arguments.steps:
                run([arguments.bmt, "build", mesh, "-o", model], arguments.limit)
            for step in sorted(arguments.steps, key=STEPS.index):
                if step in ("verify", "read") and not model.exists():
                    continue
                seconds[step][size] = min(seconds[step][size], run_step(arguments, step, mesh, model))
            mesh.unlink()
            model.unlink(missing_ok=True)
    return seconds


def print_row(kind, step, triangles, seconds):
    def write(number):
        return f"{number:.2f}" if math.isfinite(number) else "too long" if number == math.inf else "failed"

    exponents = [math.log2(b / a) if math.isfinite(a) and math.isfinite(b) else math.nan
                 for a, b in zip(seconds, seconds[1:])]
    exponents.append(sum(exponents) / 3.0)
    cells = [kind, step, str(triangles)] + [write(s) for s in seconds]
    cells += [f"{e:.2f}" if math.isfinite(e) else "-" for e in exponents]
    print("| " + " | ".join(cells) + " |", flush=True)


STEPS = ["best", "build", "verify", "read"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bmt", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=list(KINDS))
    parser.add_argument("--steps", nargs="+", choices=STEPS, default=STEPS)
    parser.add_argument("--triangles", type=int)
    parser.add_argument("--repeat", type=int, default=1)
    parser.add_argument("--limit", type=int, default=600)
    arguments = parser.parse_args()
    print("| kind | step | 8n | n, CPU s | 2n | 4n | 8n | exponents | | | mean |\n|" + "---|" * 11)
    for kind in arguments.kinds:
        triangles = arguments.triangles or KINDS[kind][1]
        for step, seconds in measure(arguments, kind, triangles).items():
            print_row(kind, step, triangles, seconds)


if __name__ == "__main__":
    main()
