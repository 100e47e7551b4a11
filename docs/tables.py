#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Markdown tables of what docs/battery.sh left in a folder.

usage: docs/tables.py examples FOLDER > docs/examples.md
       docs/tables.py corpus FOLDER [INPUTS] > docs/corpus.md
       docs/tables.py sets FOLDER_A FOLDER_B FOLDER_C > docs/sets.md
       docs/tables.py families FOLDER > docs/hard.md

A folder holds NAME.log (all that was printed, then "STATUS n" and "WALL seconds") and, where a
result was written, NAME.c1.json; and machine.txt. Fails if a log has no STATUS or WALL line: a run
that did not end must not pass for one that was never made. INPUTS is how the table's command names the input files
(shapes/*.json).
"""

import json
import math
import pathlib
import re
import sys

COLUMNS = ["name", "status", "triangles", "exceptional", "minimum", "surplus", "max d_ei",
           "conformance", "g", "seconds"]
LEGEND = """\
`status` is the exit status of `c1mesh run` (README): 0 if everything asked holds and was verified.
`exceptional` vertices, their `minimum` and `surplus` as in `docs/vocabulary.md`; `max d_ei` the largest
C1 deviation and `conformance` the boundary's distance from the input, both relative to the extent;
`g` the largest distortion bound g(t); `seconds` of wall time for the whole program, one thread.
All but the seconds are read from the metrics of the result, which the verification recomputes from
the result alone.
"""


class Run:
    """One input: the log's end, and the metrics of its result if there is one."""

    def __init__(self, log):
        self.name = log.name[:-len(".log")]
        text = log.read_text(encoding="utf-8", errors="replace")
        status = re.findall(r"^STATUS (\d+)$", text, re.MULTILINE)
        wall = re.findall(r"^WALL ([0-9.]+)$", text, re.MULTILINE)
        if not status or not wall:
            raise SystemExit(f"tables: {log} has no STATUS or WALL line: did the run end?")
        self.status, self.seconds = int(status[-1]), float(wall[-1])
        remedies = re.findall(r"^  remedies\s+(.*)$", text, re.MULTILINE)
        self.remedies = remedies[-1] if remedies else ""
        file = log.with_name(self.name + ".c1.json")
        result = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
        self.metrics, self.parameters = result.get("metrics"), result.get("parameters", {})

    @property
    def g(self):
        bound = self.metrics["mips_bound_max"]
        return math.inf if bound is None else bound

    def cells(self):
        if self.metrics is None:
            return [self.name, str(self.status)] + ["-"] * 7 + [f"{self.seconds:.2f}"]
        m = self.metrics
        return [self.name, str(self.status), str(m["triangles"]), str(m["exceptional"]),
                str(m["exceptional_minimum"]), str(m["surplus"]), f"{m['d_ei']['max']:.1e}",
                f"{m['conformance_max']:.1e}", f"{self.g:.4g}", f"{self.seconds:.2f}"]


def runs_in(folder):
    runs = [Run(log) for log in sorted(pathlib.Path(folder).glob("*.log"))]
    if not runs:
        raise SystemExit(f"tables: no logs in {folder}")
    return runs


def markdown_table(head, rows, align_right_from=1):
    marks = ["---" if k < align_right_from else "---:" for k in range(len(head))]
    return "\n".join("| " + " | ".join(row) + " |" for row in [head, marks] + rows)


def quantile(values, share):
    """By nearest rank."""
    ordered = sorted(values)
    return ordered[max(0, math.ceil(share * len(ordered)) - 1)]


def counts(values):
    return {value: values.count(value) for value in sorted(set(values))}


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
        rows += [["surplus, mean", f"{sum(surplus) / len(done):.2f}"],
                 ["surplus, largest", str(max(surplus))],
                 ["max d_ei, median", f"{quantile([r.metrics['d_ei']['max'] for r in done], .5):.1e}"],
                 ["max d_ei, worst", f"{max(r.metrics['d_ei']['max'] for r in done):.1e}"],
                 ["conformance, worst", f"{max(r.metrics['conformance_max'] for r in done):.1e}"],
                 ["g, median", f"{quantile([r.g for r in done], .5):.4g}"],
                 ["g, worst", f"{max(r.g for r in done):.4g}"],
                 ["triangles, median", str(quantile([r.metrics["triangles"] for r in done], .5))],
                 ["domain overlaps itself", str(sum(r.metrics["domain_overlaps"] for r in done))]]
    return rows + [["seconds, median", f"{quantile(seconds, .5):.2f}"],
                   ["seconds, worst", f"{max(seconds):.2f}"]]


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


def conditions(folder, runs):
    """Machine and parameters, as lines of text."""
    lines = []
    machine = pathlib.Path(folder) / "machine.txt"
    if machine.exists():
        lines.append("; ".join(machine.read_text(encoding="utf-8").split("\n")).strip("; ") + ".")
    texts = {json.dumps({k: v for k, v in run.parameters.items() if k != "degree"},
                        sort_keys=True) for run in runs if run.parameters}
    if len(texts) > 1:
        raise SystemExit(f"tables: the results in {folder} were made with different parameters")
    lines += [f"Parameters: `{text}`." for text in texts]
    return "\n".join(lines)


def full_table(runs):
    return markdown_table(COLUMNS, [run.cells() for run in runs])


def page(title, commands, parts):
    text = [f"# {title}", "Made by", "```sh\n" + "\n".join(commands) + "\n```"] + parts
    return "\n\n".join(part.strip() for part in text if part.strip()) + "\n"


def examples_page(folder):
    runs = runs_in(folder)
    examples = pathlib.Path(__file__).resolve().parent.parent / "examples"
    files = {path.stem: path.name for path in sorted(examples.iterdir())}
    pictures = [f"## {run.name}\n\n"
                f"`c1mesh run examples/{files.get(run.name, run.name)} -o out` writes\n\n"
                f"![The shape {run.name} and its domain](pictures/{run.name}.svg)" for run in runs]
    return page("The examples", ["docs/pictures.sh"],
                [conditions(folder, runs), LEGEND, full_table(runs)] + pictures)


def corpus_page(folder, inputs="shapes/*.json"):
    runs = runs_in(folder)
    commands = [f"docs/battery.sh build/release/bin/c1mesh out/corpus {inputs}",
                "docs/tables.py corpus out/corpus > docs/corpus.md"]
    corpus = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data" / "corpus"
    here = {file.stem for file in corpus.glob("*.json")}
    count = sum(run.name in here for run in runs)
    about = (f"The inputs are {len(runs)} real shapes: icons, clip art, glyphs of fonts, each named after "
             f"its source; {count} of them are in `tests/data/corpus`, with their licences.")
    return page("Real shapes", commands,
                [about, conditions(folder, runs), LEGEND, "## Summary",
                 markdown_table(["", "all"], summary_rows(runs)), histogram(runs),
                 "## Every shape", full_table(runs)])


def sets_page(folders):
    sets = [(letter, runs_in(folder), folder) for letter, folder in zip("ABC", folders)]
    commands = []
    for letter, runs, _ in sets:
        commands += [f"c1mesh generate --set {letter} --count {len(runs)} --seed 1 -o out/{letter}-in",
                     f"docs/battery.sh build/release/bin/c1mesh out/{letter} out/{letter}-in/*.json"]
    commands.append("docs/tables.py sets out/A out/B out/C > docs/sets.md")
    summaries = [dict(map(tuple, summary_rows(runs))) for _, runs, _ in sets]
    keys = []
    for rows in summaries:
        keys += [key for key in rows if key not in keys]
    keys.sort(key=lambda key: (key != "inputs", not key.startswith("status")))
    parts = [conditions(sets[0][2], [run for _, runs, _ in sets for run in runs]), LEGEND,
             "## Summary",
             markdown_table([""] + [f"set {letter}" for letter, _, _ in sets],
                            [[key] + [rows.get(key, "0") for rows in summaries] for key in keys])]
    for letter, runs, _ in sets:
        parts += [f"## Set {letter}", histogram(runs), full_table(runs)]
    return page("Random shapes, sets A, B and C", commands, parts)


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


def run_options(folder):
    """What RUN_OPTIONS held, as an assignment before a command; nothing if it was empty."""
    machine = pathlib.Path(folder) / "machine.txt"
    text = machine.read_text(encoding="utf-8") if machine.exists() else ""
    options = re.search(r"^options --threads 1 --formats \S+ (\S.*)$", text, re.MULTILINE)
    return f'RUN_OPTIONS="{options.group(1).strip()}" ' if options else ""


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
    elif len(arguments) in (2, 3) and arguments[0] == "corpus":
        text = corpus_page(*arguments[1:])
    elif len(arguments) == 2 and arguments[0] == "families":
        text = families_page(arguments[1])
    elif len(arguments) == 4 and arguments[0] == "sets":
        text = sets_page(arguments[1:])
    else:
        print(__doc__, file=sys.stderr)
        return 2
    sys.stdout.write(text)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
