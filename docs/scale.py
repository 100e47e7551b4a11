#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How the cost of each stage grows with the number of curves.

usage: docs/scale.py BIN OUT [--families a,b,…] [--sizes 100,200,…] [--timeout SECONDS] [--resume]

Makes shapes of growing numbers of curves, runs `BIN run SHAPE --threads 1 --verbose` on each, one after
the other, and writes to OUT: the shapes, what was printed (NAME.log), and table.md: processor seconds
per stage and size, and the exponent fitted to each stage (least squares of logarithms, over the sizes
at which the stage takes more than 20 ms; at least three of them, else none). Standard library only.
"""
import argparse
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import time

LEAST_SECONDS = 0.02
SUMMED = {  # the lines of the report that are parts of one stage
    "check": "check", "mesh": "mesh", "verify": "verify",
}


# Shapes: lists of curves, a curve a list of poles.

def comb(count):
    """Teeth of two cubics each, 50 high and 1 wide, with a cusp-like gap of 0.3 degrees between them."""
    teeth, curves = count // 2, []
    for i in range(teeth):
        curves.append([[i, 0], [i + .05, 20], [i + .2, 50], [i + .5, 50]])
        curves.append([[i + .5, 50], [i + .8, 50], [i + .95, 20], [i + 1, 0]])
    corners = [[teeth, 0], [teeth, -10], [0, -10], [0, 0]]
    return curves + [[corners[i], corners[i + 1]] for i in range(3)]


def coast(count):
    """One closed outline with bays and capes; every fifth joint is a corner, the others are nearly smooth."""
    rng = random.Random(1)
    points = []
    for i in range(count):
        a = 2 * math.pi * i / count
        r = count / 8 * (1 + .25 * math.cos(3 * a + 1) + .12 * math.cos(7 * a + 2)) + rng.uniform(-.22, .22)
        points.append((r * math.cos(a), r * math.sin(a)))
    tangents = []
    for i in range(count):
        p, q = points[i - 1], points[(i + 1) % count]
        length = math.dist(p, q)
        tangents.append(((q[0] - p[0]) / length, (q[1] - p[1]) / length))
    curves = []
    for i in range(count):
        j = (i + 1) % count
        p, q = points[i], points[j]
        third = math.dist(p, q) / 3
        chord = ((q[0] - p[0]) / (3 * third), (q[1] - p[1]) / (3 * third))
        s = chord if i % 5 == 0 else tangents[i]
        t = chord if j % 5 == 0 else tangents[j]
        curves.append([[*p], [p[0] + third * s[0], p[1] + third * s[1]],
                       [q[0] - third * t[0], q[1] - third * t[1]], [*q]])
    return curves


def circle(x, y, r, clockwise=False):
    k = 4 / 3 * math.tan(math.pi / 8)
    at = [(1, 0), (0, 1), (-1, 0), (0, -1)]
    ends = [[x + r * c, y + r * s] for c, s in at]
    curves = []
    for i, (c, s) in enumerate(at):
        p, q = ends[i], ends[(i + 1) % 4]
        e, f = at[(i + 1) % 4]
        curves.append([p, [p[0] - k * r * s, p[1] + k * r * c], [q[0] + k * r * f, q[1] - k * r * e], q])
    return [c[::-1] for c in curves[::-1]] if clockwise else curves


def saw(count):
    """Short teeth over one edge as long as all of them: vertices with thousands of triangles, at first."""
    points = [[i, i % 2] for i in range(count - 2)] + [[count - 3, -5], [0, -5]]
    return [[p, q] for p, q in zip(points, points[1:] + points[:1])]


def places(count):
    side = max(1, math.ceil(math.sqrt(count)))
    return side, [(i % side + .5, i // side + .5) for i in range(count)]


def holes(count):
    """A square with count / 4 round holes."""
    side, at = places(count // 4)
    corners = [[0, 0], [side, 0], [side, side], [0, side]]
    curves = [[corners[i], corners[(i + 1) % 4]] for i in range(4)]
    return curves + [c for x, y in at for c in circle(x, y, .3, True)]


def discs(count):
    """count / 4 discs side by side: regions of one drawing."""
    return [c for x, y in places(count // 4)[1] for c in circle(x, y, .3)]


def network(count):
    """A square cut into cells by bowed interfaces: a network of features."""
    side = max(2, round((math.sqrt(1 + 2 * count) - 1) / 2))
    rng = random.Random(7)

    def jitter(i):
        return 0 if i in (0, side) else rng.uniform(-.2, .2)

    points = {(i, j): [i + jitter(i), j + jitter(j)] for i in range(side + 1) for j in range(side + 1)}

    def curve(a, b, on_side):
        (x, y), (u, v) = points[a], points[b]
        if on_side:
            return [[x, y], [u, v]]
        bow = rng.uniform(-.15, .15)
        return [[x, y], [(x + u) / 2 - bow * (v - y), (y + v) / 2 + bow * (u - x)], [u, v]]

    curves = []
    for i in range(side):
        for j in range(side + 1):
            curves.append(curve((i, j), (i + 1, j), j in (0, side)))
            curves.append(curve((j, i), (j, i + 1), j in (0, side)))
    return curves


FAMILIES = {f.__name__: f for f in (comb, coast, saw, holes, discs, network)}


def write_shape(path, curves):
    entries = [{"curve_id": i, "type": "BezierCurve", "degree": len(poles) - 1, "poles": poles}
               for i, poles in enumerate(curves)]
    path.write_text("[\n" + ",\n".join(json.dumps(e) for e in entries) + "\n]\n")


# Runs.

def run(args, shape, log):
    if args.resume and log.exists() and "\nSTATUS " in log.read_text():
        return
    start = time.monotonic()
    command = [args.bin, "run", str(shape), "-o", str(args.out), "--threads", "1", "--verbose"]
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True, timeout=args.timeout)
        text, status = done.stderr, done.returncode
    except subprocess.TimeoutExpired as expired:
        text, status = (expired.stderr or b"").decode(), "timeout"
    log.write_text(f"{text}\nSTATUS {status}\nWALL {time.monotonic() - start:.2f}\n")
    for result in (".c1.json", ".svg"):
        pathlib.Path(args.out, shape.stem + result).unlink(missing_ok=True)


def parse(log):
    """Status, triangles, peak memory in MiB, {stage: processor seconds}; None if it printed no costs."""
    text = log.read_text()
    if "  cost of " not in text:
        return None
    costs = {}
    table = text[text.index("  cost of "):].splitlines()[1:]
    for line in table:
        match = re.match(r"  (\S.*?)\s+[\d.]+\s+([\d.]+)\s+[\d.]+$", line)
        if match:
            costs[match[1]] = float(match[2])
    triangles = int(re.search(r"triangles +(\d+)", text)[1])
    memory = re.search(r"peak memory +([\d.]+) MiB", text)
    status = re.search(r"^STATUS (\S+)", text, re.M)[1]
    return status, triangles, float(memory[1]) if memory else 0, costs


def with_sums(costs):
    out = dict(costs)
    for prefix in SUMMED:
        parts = [s for name, s in costs.items() if name.startswith(prefix + ": ")]
        if parts:
            out[prefix + ", all"] = sum(parts)
    return out


def exponent(sizes, seconds):
    points = [(math.log(n), math.log(s)) for n, s in zip(sizes, seconds) if s is not None and s > LEAST_SECONDS]
    if len(points) < 3:
        return None
    x = sum(p[0] for p in points) / len(points)
    y = sum(p[1] for p in points) / len(points)
    return sum((p[0] - x) * (p[1] - y) for p in points) / sum((p[0] - x) ** 2 for p in points)


def table(family, runs):
    """Markdown of one family: {size: parsed log}."""
    sizes = sorted(runs)
    done = {n: with_sums(runs[n][3]) for n in sizes}
    stages = []
    for n in sizes:
        stages += [s for s in done[n] if s not in stages]
    lines = [f"## {family}", "", (FAMILIES[family].__doc__ or "").strip(), "",
             "| curves | " + " | ".join(str(n) for n in sizes) + " | exponent |",
             "| --- |" + " ---: |" * (len(sizes) + 1),
             "| exit status | " + " | ".join(runs[n][0] for n in sizes) + " | |",
             "| triangles | " + " | ".join(str(runs[n][1]) for n in sizes) + " | |",
             "| peak memory, MiB | " + " | ".join(f"{runs[n][2]:.0f}" for n in sizes) + " | |"]
    worst = 0
    for stage in sorted(stages):
        seconds = [done[n].get(stage) for n in sizes]
        if max(s or 0 for s in seconds) <= LEAST_SECONDS:
            continue
        fitted = exponent(sizes, seconds)
        worst = max(worst, fitted or 0)
        cells = ["" if s is None else f"{s:.3f}" for s in seconds]
        lines.append(f"| {stage} | " + " | ".join(cells) + f" | {'' if fitted is None else f'{fitted:.2f}'} |")
    return "\n".join(lines) + f"\n\nLargest exponent: {worst:.2f}.\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin")
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--families", default=",".join(FAMILIES))
    parser.add_argument("--sizes", default=",".join(str(100 * 2 ** k) for k in range(8)))
    parser.add_argument("--timeout", type=float, default=None, help="seconds after which a run is ended")
    parser.add_argument("--resume", action="store_true", help="keep the logs there are")
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    sizes = [int(n) for n in args.sizes.split(",")]
    families = args.families.split(",")
    for family in families:
        if family not in FAMILIES:
            sys.exit(f"scale.py: no family '{family}'; there are {', '.join(FAMILIES)}")
    for size in sizes:
        for family in families:
            shape = args.out / f"{family}-{size}.json"
            write_shape(shape, FAMILIES[family](size))
            run(args, shape, args.out / f"{family}-{size}.log")
            pages = []
            for name in families:
                runs = {n: parse(args.out / f"{name}-{n}.log") for n in sizes
                        if (args.out / f"{name}-{n}.log").exists()}
                runs = {n: found for n, found in runs.items() if found}
                if runs:
                    pages.append(table(name, runs))
            (args.out / "table.md").write_text("\n".join(pages))


if __name__ == "__main__":
    main()
