# SPDX-License-Identifier: GPL-3.0-or-later
"""What docs/battery.sh left in a folder, read; and what every table of it needs."""

import json
import math
import pathlib
import re

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
        said = [line.strip() for line in re.sub(r"^(STATUS|WALL) .*$", "", text, flags=re.MULTILINE)
                .split("\n") if line.strip()]
        self.last_words = said[-1].replace("|", "\\|") if said else "nothing said"
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


def markdown_table(head, rows, align_right_from=1, align_right_to=None):
    """`align_right_from` and `align_right_to` bound the columns of numbers like a slice."""
    numbers = range(len(head))[align_right_from:align_right_to]
    marks = ["---:" if k in numbers else "---" for k in range(len(head))]
    return "\n".join("| " + " | ".join(row) + " |" for row in [head, marks] + rows)


def quantile(values, share):
    """By nearest rank."""
    ordered = sorted(values)
    return ordered[max(0, math.ceil(share * len(ordered)) - 1)]


def counts(values):
    return {value: values.count(value) for value in sorted(set(values))}


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


def run_options(folder):
    """What RUN_OPTIONS held, as an assignment before a command; nothing if it was empty."""
    machine = pathlib.Path(folder) / "machine.txt"
    text = machine.read_text(encoding="utf-8") if machine.exists() else ""
    options = re.search(r"^options --threads 1 --formats \S+ (\S.*)$", text, re.MULTILINE)
    return f'RUN_OPTIONS="{options.group(1).strip()}" ' if options else ""


def full_table(runs):
    return markdown_table(COLUMNS, [run.cells() for run in runs])


def page(title, commands, parts):
    text = [f"# {title}", "Made by", "```sh\n" + "\n".join(commands) + "\n```"] + parts
    return "\n\n".join(part.strip() for part in text if part.strip()) + "\n"
