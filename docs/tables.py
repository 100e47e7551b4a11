#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Markdown tables of what docs/battery.sh left in a folder.

usage: docs/tables.py examples FOLDER > docs/examples.md
       docs/tables.py corpus FOLDER [INPUTS [SVG_FOLDER]] > docs/corpus.md
       docs/tables.py families FOLDER > docs/hard.md
       docs/tables.py sets FOLDER [DOCS]

A folder holds NAME.log (all that was printed, then "STATUS n" and "WALL seconds") and, where a
result was written, NAME.c1.json; and machine.txt. Fails if a log has no STATUS or WALL line: a run
that did not end must not pass for one that was never made. INPUTS is how the table's command names
the input files (shapes/*.json); SVG_FOLDER holds the runs of the same shapes, of the same names, read
from SVG. The FOLDER of `sets` is what docs/sets.sh made; sets.md, sets.csv and pictures/sets-*.svg
are written into DOCS (the folder of this script).
"""

import pathlib
import re
import sys

import experiments
from runs import (LEGEND, conditions, counts, full_table, markdown_table, page, quantile,
                  run_options, runs_in)

def summary_rows(runs):
    """(what, value) pairs, one way for every table."""
    done = [run for run in runs if run.metrics is not None]
    seconds = [run.seconds for run in runs]
    rows = [["inputs", str(len(runs))]]
    for status, count in counts([run.status for run in runs]).items():
        rows.append([f"status {status}", str(count)])
    rows.append(["results written", str(len(done))])
    if done:
        surplus = [run.metrics["surplus"] for run in done]
        rows += [["surplus 0", str(sum(value <= 0 for value in surplus))],
                 ["surplus, mean", f"{sum(surplus) / len(done):.2f}"],
                 ["surplus, largest", str(max(surplus))],
                 ["max d_ei, median", f"{quantile([r.metrics['d_ei']['max'] for r in done], .5):.1e}"],
                 ["max d_ei, worst", f"{max(r.metrics['d_ei']['max'] for r in done):.1e}"],
                 ["conformance, worst", f"{max(r.metrics['conformance_max'] for r in done):.1e}"],
                 ["g, median", f"{quantile([r.g for r in done], .5):.4g}"],
                 ["g at most 20", str(sum(r.g <= 20 for r in done))],
                 ["g at most 100", str(sum(r.g <= 100 for r in done))],
                 ["g, worst", f"{max(r.g for r in done):.4g}"],
                 ["triangles, median", str(quantile([r.metrics["triangles"] for r in done], .5))],
                 ["domain overlaps itself", str(sum(r.metrics["domain_overlaps"] for r in done))]]
    return rows + [["seconds, median", f"{quantile(seconds, .5):.2f}"],
                   ["seconds, 90 %", f"{quantile(seconds, .9):.2f}"],
                   ["seconds, worst", f"{max(seconds):.2f}"],
                   ["seconds, all together", f"{sum(seconds):.0f}"]]


def histogram(runs):
    """How many results have which surplus; and which remedies were taken."""
    done = [run for run in runs if run.metrics is not None]
    parts = []
    if done:
        rows = [[str(value), str(count)]
                for value, count in counts([run.metrics["surplus"] for run in done]).items()]
        parts.append(markdown_table(["surplus", "results"], rows, 0))
    # What a remedy says in brackets is about that shape alone.
    taken = counts([re.sub(r" \([^)]*\)", "", run.remedies) for run in runs if run.remedies])
    if taken:
        rows = sorted(taken.items(), key=lambda item: (-item[1], item[0]))
        parts.append(markdown_table(["remedies", "results"],
                                    [[remedy, str(count)] for remedy, count in rows]))
    return "\n\n".join(parts)


def examples_page(folder):
    runs = runs_in(folder)
    examples = pathlib.Path(__file__).resolve().parent.parent / "examples"
    files = {path.stem: path.name for path in sorted(examples.iterdir())}
    pictures = [f"## {run.name}\n\n"
                f"`c1mesh run examples/{files.get(run.name, run.name)} -o out` writes\n\n"
                f"![The shape {run.name} and its domain](pictures/{run.name}.svg)" for run in runs]
    return page("The examples", ["docs/pictures.sh"],
                [conditions(folder, runs), LEGEND, full_table(runs)] + pictures)


def differences(run, other):
    """Names of the metrics that are not the same to the last bit; times are no metric here."""
    if run.metrics is None or other.metrics is None:
        return [] if run.metrics is other.metrics else ["result"]
    return [key for key in run.metrics
            if key != "seconds" and run.metrics[key] != other.metrics.get(key)]


COUNTED = ["triangles", "exceptional", "exceptional_minimum", "surplus", "domain_overlaps"]


def same_g(run, other):
    """Within 1 %."""
    return (run.metrics is not None and other.metrics is not None and
            (run.g == other.g or abs(run.g - other.g) <= 0.01 * run.g))


def svg_parts(runs, others):
    """The same shapes read from SVG, compared with the JSON runs by name."""
    known = {run.name: run for run in runs}
    pairs = [(known[other.name], other) for other in others if other.name in known]
    different = {run.name: differences(run, other) for run, other in pairs}
    rows = [["shapes read both ways", str(len(pairs))],
            ["read from JSON only", str(len(runs) - len(pairs))],
            ["read from SVG only", str(len(others) - len(pairs))],
            ["same status", str(sum(run.status == other.status for run, other in pairs))],
            ["all metrics equal to the last bit", str(sum(not keys for keys in different.values()))]]
    for key in COUNTED:
        same = sum(key not in keys and "result" not in keys for keys in different.values())
        rows.append([f"same {key.replace('_', ' ')}", str(same)])
    rows.append(["g within 1 %", str(sum(same_g(*pair) for pair in pairs))])
    parts = ["## The same shapes read from SVG", markdown_table(["", "all"], summary_rows(others)),
             "Compared with the runs from JSON, shape by shape:", markdown_table(["", "shapes"], rows)]
    listed = [[run.name, f"{run.status}, {other.status}"] + both_ways(run, other)
              for run, other in pairs
              if run.status != other.status or
              not (different[run.name] == [] or same_g(run, other)) or
              set(different[run.name]) & set(COUNTED)]
    if listed:
        head = ["name", "status", "triangles", "exceptional", "minimum", "surplus", "g"]
        parts += ["Where status, a count or g (by more than 1 %) differs (from JSON, from SVG):",
                  markdown_table(head, listed)]
    return parts


def both_ways(run, other):
    """Triangles to surplus, and g, of both, one cell each."""
    columns = [run.cells(), other.cells()]
    return [", ".join(cells[k] for cells in columns) for k in (2, 3, 4, 5, 8)]


def corpus_page(folder, inputs="shapes/*.json", svg_folder=None):
    runs = runs_in(folder)
    others = runs_in(svg_folder) if svg_folder else []
    commands = [f"docs/battery.sh build/release/bin/c1mesh out/corpus {inputs}"]
    if others:
        svg_inputs = re.sub(r"\bjson\b", "svg", inputs)
        commands += [f"docs/battery.sh build/release/bin/c1mesh out/corpus-svg {svg_inputs}",
                     f"docs/tables.py corpus out/corpus '{inputs}' out/corpus-svg > docs/corpus.md"]
    else:
        commands.append("docs/tables.py corpus out/corpus > docs/corpus.md")
    corpus = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data" / "corpus"
    here = {file.stem for file in corpus.glob("*.json")}
    count = sum(run.name in here for run in runs)
    about = (f"The inputs are {len(runs)} real shapes: icons, clip art, glyphs of fonts, each named after "
             f"its source; {count} of them are in `tests/data/corpus`, with their licences.")
    parts = [about, conditions(folder, runs), LEGEND, "## Summary",
             markdown_table(["", "all"], summary_rows(runs)), histogram(runs)]
    if others:
        parts += svg_parts(runs, others)
    return page("Real shapes", commands, parts + ["## Every shape", full_table(runs)])


def family_cells(family, runs):
    """One line for a family; the runs without a result count in status and seconds only."""
    done = [run for run in runs if run.metrics is not None]
    statuses = [run.status for run in runs]
    other = counts([status for status in statuses if status not in (0, 4)])
    cells = [family, str(len(runs)), str(statuses.count(0)), str(statuses.count(4)),
             ", ".join(f"{count} of status {status}" for status, count in other.items()) or "-"]
    if done:
        surplus = [run.metrics["surplus"] for run in done]
        g = [run.g for run in done]
        cells += [f"{sum(surplus) / len(done):.1f}", str(max(surplus)), f"{quantile(g, .5):.4g}",
                  f"{max(g):.4g}", f"{max(run.metrics['d_ei']['max'] for run in done):.1e}",
                  f"{max(run.metrics['conformance_max'] for run in done):.1e}"]
    else:
        cells += ["-"] * 6
    seconds = [run.seconds for run in runs]
    return cells + [f"{quantile(seconds, .5):.2f}", f"{max(seconds):.2f}"]


def families_page(folder):
    """The inputs are called FAMILY-0001 and so on."""
    runs = runs_in(folder)
    families = {}
    for run in runs:
        families.setdefault(run.name.rsplit("-", 1)[0], []).append(run)
    most = max(len(members) for members in families.values())
    commands = [f"for f in {' '.join(families)}; do",
                f"  c1mesh generate --family $f --count {most} --seed 1 -o out/hard-in", "done",
                f"{run_options(folder)}docs/battery.sh build/release/bin/c1mesh out/hard out/hard-in/*.json",
                "docs/tables.py families out/hard > docs/hard.md"]
    head = ["family", "shapes", "status 0", "status 4", "other", "surplus, mean", "surplus, worst",
            "g, median", "g, worst", "max d_ei", "conformance", "seconds, median", "seconds, worst"]
    about = ("Shapes made by formulas, each family with a parameter that runs from pleasant to nasty "
             "(`c1mesh generate --help` says which and how far).")
    missed = [run for run in runs if run.status != 0]
    parts = [about, conditions(folder, runs), LEGEND, "## Families",
             markdown_table(head, [family_cells(*item) for item in sorted(families.items())]),
             "## All together", markdown_table(["", "all"], summary_rows(runs)), histogram(runs)]
    if missed:
        parts += ["## What is not of status 0", full_table(missed)]
    return page("Hard shapes", commands, parts + ["## Every shape", full_table(runs)])


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "examples":
        text = examples_page(arguments[1])
    elif len(arguments) in (2, 3, 4) and arguments[0] == "corpus":
        text = corpus_page(*arguments[1:])
    elif len(arguments) == 2 and arguments[0] == "families":
        text = families_page(arguments[1])
    elif len(arguments) in (2, 3) and arguments[0] == "sets":
        docs = pathlib.Path(__file__).resolve().parent
        experiments.write_page(arguments[1], arguments[2] if len(arguments) == 3 else docs)
        text = ""
    else:
        print(__doc__, file=sys.stderr)
        return 2
    sys.stdout.write(text)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
