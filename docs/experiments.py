# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of the random shapes: three sets, three experiments each, as docs/sets.sh leaves them."""

import csv
import pathlib

from histograms import SURPLUS_BINS, ClassBins, LogBins, sheet
from runs import COLUMNS, LEGEND, conditions, markdown_table, page, quantile, runs_in

SETS = "ABC"
EXPERIMENTS = {"100": "alpha 100", "10": "alpha 10", "min": "no bound"}
MEAN_TARGETS = {"A": 0.3, "B": 1, "C": 2}  # of the surplus, with alpha 10
SHARE_TARGETS = {"A": 99, "B": 95, "C": 90}  # of a hundred, with surplus 0, with alpha 100
CSV_COLUMNS = ["set", "experiment", "name", "status", "triangles", "exceptional", "minimum",
               "surplus", "max_d_ei", "conformance", "g", "seconds"]
ABOUT = """\
Three experiments on random piecewise smooth shapes of 10, 20 and 30 cubics (sets A, B and C):
with the default bound on the distortion, alpha 100; with alpha 10; and with none, where only the
number of exceptional vertices matters. A run that takes longer than its limit is ended and counts as
of status 124, with the results that it has written, if any.
"""


class Column:
    """One set in one experiment."""

    def __init__(self, folder, letter, experiment):
        self.letter, self.experiment, self.folder = letter, experiment, folder
        self.runs = runs_in(folder)
        self.done = [run for run in self.runs if run.metrics is not None]

    @property
    def title(self):
        return f"{self.letter}, {EXPERIMENTS[self.experiment]}"

    def values(self, key):
        return [run.metrics[key] for run in self.done]

    @property
    def met(self):
        """How many are of status 0 and have no surplus."""
        return sum(run.status == 0 and run.metrics["surplus"] <= 0 for run in self.done)

    @property
    def mean_surplus(self):
        return sum(self.values("surplus")) / len(self.done) if self.done else None

    @property
    def bound(self):
        """What g may be; None if no result says."""
        known = [run.parameters for run in self.runs if "mips_bound" in run.parameters]
        return known[0]["alpha"] * known[0]["mips_bound"] if known else None

    def summary(self):
        statuses = [run.status for run in self.runs]
        seconds = [run.seconds for run in self.runs]
        rows = {"inputs": str(len(self.runs)),
                "status 0": str(statuses.count(0)),
                "status 4": str(statuses.count(4)),
                "other status": str(sum(status not in (0, 4) for status in statuses)),
                "results written": str(len(self.done)),
                "surplus 0": str(sum(surplus <= 0 for surplus in self.values("surplus"))),
                "surplus 0 and status 0": str(self.met),
                "target, on surplus 0 and status 0": self.share_target()}
        if self.done:
            g = [run.g for run in self.done]
            rows.update({
                "surplus, mean": f"{self.mean_surplus:.2f}",
                "target, surplus, mean": self.mean_target(),
                "surplus, largest": str(max(self.values("surplus"))),
                "max d_ei, worst": f"{max(m['max'] for m in self.values('d_ei')):.1e}",
                "conformance, worst": f"{max(self.values('conformance_max')):.1e}",
                "g, median": f"{quantile(g, .5):.4g}",
                "g, 90 %": f"{quantile(g, .9):.4g}",
                "g, worst": f"{max(g):.4g}",
                "triangles, median": str(quantile(self.values("triangles"), .5)),
                "domain overlaps itself": str(sum(self.values("domain_overlaps")))})
        rows.update({"seconds, median": f"{quantile(seconds, .5):.2f}",
                     "seconds, worst": f"{max(seconds):.2f}"})
        return rows

    def share_target(self):
        if self.experiment != "100":
            return ""
        share = SHARE_TARGETS[self.letter]
        met = 100 * self.met >= share * len(self.runs)
        return f"≥ {share} %: {'met' if met else 'missed'}"

    def mean_target(self):
        """A mean over results says nothing of the runs without one: then the target is missed."""
        if self.experiment != "10":
            return ""
        target = MEAN_TARGETS[self.letter]
        met = self.mean_surplus <= target and len(self.done) == len(self.runs)
        return f"≤ {target:g}: {'met' if met else 'missed'}"


def columns_in(out):
    """Those whose folders exist, set by set."""
    found = [Column(pathlib.Path(out) / f"{letter}-{experiment}", letter, experiment)
             for letter in SETS for experiment in EXPERIMENTS
             if (pathlib.Path(out) / f"{letter}-{experiment}").is_dir()]
    if not found:
        raise SystemExit(f"tables: no experiment in {out}")
    return found


def summary_table(columns):
    summaries = [column.summary() for column in columns]
    keys = max((list(rows) for rows in summaries), key=len)
    return markdown_table([""] + [column.title for column in columns],
                          [[key] + [rows.get(key, "-") for rows in summaries] for key in keys])


def machine(columns):
    """What conditions() says of every folder, once where it is the same."""
    texts = {}
    for column in columns:
        texts.setdefault(conditions(column.folder, column.runs), []).append(column.title)
    return "\n\n".join(f"{'; '.join(titles)}:\n{words}" for words, titles in texts.items() if words)


def is_miss(run):
    return run.status != 0 or run.metrics is None or run.metrics["surplus"] > 0


def misses(column):
    missed = [run for run in column.runs if is_miss(run)]
    if not missed:
        return ""
    rows = [run.cells() + [run.remedies or f"({run.last_words})"] for run in missed]
    return f"### {column.title}\n\n{markdown_table(COLUMNS + ['remedies'], rows, 1, -1)}"


def write_csv(file, columns):
    with open(file, "w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(CSV_COLUMNS)
        for column in columns:
            for run in column.runs:
                cells = ["" if cell == "-" else cell for cell in run.cells()]
                writer.writerow([column.letter, column.experiment] + cells)


def write_pictures(folder, columns):
    """The histograms; returns (words, file name) of each."""
    folder.mkdir(parents=True, exist_ok=True)
    rows = [[column for column in columns if column.letter == letter] for letter in SETS]
    rows = [row for row in rows if row]

    def values(of):
        return [[(column.title, [of(run) for run in column.runs]) for column in row] for row in rows]

    def flat(table):
        return [value for row in table for _, panel in row for value in panel if value is not None]

    surplus = values(lambda run: run.metrics and run.metrics["surplus"])
    g = values(lambda run: run.metrics and run.g)
    seconds = values(lambda run: run.seconds)
    bounds = [[column.bound for column in row] for row in rows]
    pictures = {
        "surplus": sheet("Surplus", "shapes by exceptional vertices beyond the minimum; "
                         "none: no result", surplus, ClassBins(SURPLUS_BINS)),
        "g": sheet("Distortion bound g", "shapes, logarithmic axis; broken line: what was asked; ∞: or no result",
                   g, LogBins(flat(g)), "∞", bounds),
        "seconds": sheet("Seconds", "shapes by wall time, logarithmic axis", seconds,
                         LogBins(flat(seconds)))}
    for name, svg in pictures.items():
        (folder / f"sets-{name}.svg").write_text(svg, encoding="utf-8")
    return [f"![Histograms of {name}](pictures/sets-{name}.svg)" for name in pictures]


def write_page(out, docs):
    """Writes sets.md, sets.csv and pictures/sets-*.svg into the folder `docs`."""
    docs = pathlib.Path(docs)
    columns = columns_in(out)
    most = max(len(column.runs) for column in columns)
    absent = [f"{letter}-{experiment}" for letter in SETS for experiment in EXPERIMENTS
              if not any(column.letter == letter and column.experiment == experiment
                         for column in columns)]
    uneven = any(len(column.runs) != most for column in columns)
    notes = ([f"Not run: {', '.join(absent)}."] if absent else [])
    notes += ["Not every experiment is complete (row `inputs`)."] if uneven else []
    commands = [f"docs/sets.sh build/release/bin/c1mesh out/sets {most}", "docs/tables.py sets out/sets"]
    parts = [ABOUT, "\n".join(notes), machine(columns), LEGEND,
             "A mean, median or worst is over the results written, that of the seconds over all runs.\n"
             "Every run is a line of [sets.csv](sets.csv).",
             "## Summary", summary_table(columns), "## Histograms"]
    parts += write_pictures(docs / "pictures", columns)
    missed = [misses(column) for column in columns]
    parts += ["## Every miss", "Status not 0, or a surplus above 0; without a result, in brackets, "
              "what was said last."] + (missed if any(missed) else ["None."])
    write_csv(docs / "sets.csv", columns)
    (docs / "sets.md").write_text(page("Random shapes, sets A, B and C", commands, parts),
                                  encoding="utf-8")
