#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""usage: docs/figures.py RUNS OUT TEMPLATE

Prints the page of figures: TEMPLATE with, in braces, RUN.KEY replaced by a number of that run in
RUNS, `picture NAME` by the link to OUT/NAME.svg or .png, `commands` by what was run and drawn.
Anything else in braces is an error."""
import json
import math
import pathlib
import re
import sys


def chains(edges):
    """For each boundary vertex of the result: the one before and the one after."""
    after = {edge[0]: edge[1] for edge in edges}
    before = {b: a for a, b in after.items()}
    return [(before[v], v, after[v]) for v in after]


def corners(result):
    """Boundary vertices where the domain turns by more than a tenth of a degree."""
    points, out = result["domain_vertices"], 0
    for p, q, r in chains(result["boundary_edges"]):
        (ax, ay), (bx, by) = (
            [points[j][k] - points[i][k] for k in (0, 1)] for i, j in ((p, q), (q, r)))
        out += abs(math.degrees(math.atan2(ax * by - ay * bx, ax * bx + ay * by))) > 0.1
    return out


def last_trace(folder):
    return json.loads((folder / "trace.jsonl").read_text().splitlines()[-1])


def straightened(folder):
    return re.search(r"moved a domain vertex by (\S+)", (folder / "log").read_text()).group(1)


def number(folder, key):
    result = json.loads(next(folder.glob("*.c1.json")).read_text())
    metrics = result["metrics"]
    return {
        "exceptional": lambda: str(metrics["exceptional"]),
        "minimum": lambda: str(metrics["exceptional_minimum"]),
        "triangles": lambda: str(metrics["triangles"]),
        "g": lambda: f"{metrics['mips_bound_max']:.3g}",
        "d": lambda: f"{metrics['d_ei']['max']:.1e}",
        "corners": lambda: str(corners(result)),
        "straightened": lambda: straightened(folder),
        "e_s": lambda: f"{last_trace(folder)['e_s']:.1e}",
        "iterations": lambda: str(len((folder / "trace.jsonl").read_text().splitlines())),
    }[key]()


def commands(runs):
    out = [(folder / "log").read_text().splitlines()[0]
           for folder in sorted(runs.iterdir()) if (folder / "log").exists()]
    return "\n".join(out + [""] + (runs / "pictures").read_text().splitlines())


def main():
    runs, out, template = map(pathlib.Path, sys.argv[1:])

    def replace(match):
        words = match.group(1)
        if words == "commands":
            return commands(runs)
        if words.startswith("picture "):
            name = words.split()[1]
            file = next(f for f in (out / (name + e) for e in (".svg", ".png")) if f.exists())
            return f"![{name}]({out.name}/{file.name})"
        run, key = words.rsplit(".", 1)
        return number(runs / run, key)

    print(re.sub(r"\{([^{}]+)\}", replace, template.read_text()), end="")


if __name__ == "__main__":
    main()
