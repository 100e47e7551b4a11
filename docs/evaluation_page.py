#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of docs/evaluation/README.md, from what docs/evaluation.sh made.

usage: docs/evaluation_page.py OUT [DOCS]

Reads OUT/tables/VARIANT-ALPHA/evaluation.json, copies evaluation.txt and the pictures to
DOCS/VARIANT-ALPHA/ (DOCS: the folder `evaluation` beside this script), and writes the tables between
the marks <!-- tables --> and <!-- end --> of DOCS/README.md. Seconds are compared with those of the
variant `exact` of the same alpha.
"""

import json
import pathlib
import shutil
import sys

ORDER = ["printed", "paper", "repeated", "fractions", "paper-projected", "repeated-projected",
         "exact"]
BEGIN, END = "<!-- tables -->", "<!-- end -->"


def most_common(counts):
    """The value (or values) that most shapes have, and the mean; counts: [[value, shapes], …]."""
    total = sum(count for _, count in counts)
    if not total:
        return "-"
    top = max(count for _, count in counts)
    modes = ", ".join(str(value) for value, count in counts if count == top)
    return f"{modes} ({sum(value * count for value, count in counts) / total:.2f})"


def number(value, digits=1):
    if value is None:
        return "∞"
    return "0" if value == 0 else f"{value:.{digits}e}"


def row(variant, label, series, exact):
    s = series["summary"]
    ok = sum(count for status, count in s["statuses"] if status == 0)
    seconds = s["seconds"]["median"]
    ratio = "" if exact is None else f"{seconds / exact:.1f}"
    d, angle, size = s["d_ei"], s["gradient_angle_deg"], s["gradient_magnitude"]
    return [variant, label, f"{ok} of {s['shapes']}", f"{s['regular']}",
            number(d["all"]["median"]), number(d["largest_of_shape"]["median"]),
            number(d["largest_of_shape"]["max"]),
            number(angle["all"]["p99"]), number(angle["all"]["max"]),
            number(size["all"]["p99"]), number(size["all"]["max"]),
            most_common(s["exceptional"]), most_common(s["surplus_paper"]),
            most_common(s["surplus"]), f"{s['flatness_ratio']['median']:.3f}",
            f"{s['g']['median']:.3g}", number(s["conformance"]["largest_of_shape"]["median"]),
            number(s["conformance"]["largest_of_shape"]["max"]), f"{seconds:.2f}", ratio]


HEAD = ["variant", "set", "status 0", "regular", "d_ei, median", "largest d_ei of a shape, median",
        "worst", "angle °, 99 %", "worst", "magnitude, 99 %", "worst", "exceptional: most (mean)",
        "surplus, paper's minimum", "surplus, true minimum", "flatness, median", "g, median",
        "conformance, median", "worst", "seconds, median", "of exact's"]


def table(out, alpha):
    found = {}
    for variant in ORDER:
        file = out / "tables" / f"{variant}-{alpha}" / "evaluation.json"
        if file.exists():
            found[variant] = json.loads(file.read_text(encoding="utf-8"))["series"]
    exact = {s["label"]: s["summary"]["seconds"]["median"] for s in found.get("exact", [])}
    rows = []
    for label in ("A", "B", "C"):
        for variant, all_series in found.items():
            rows += [row(variant, label, s, exact.get(label))
                     for s in all_series if s["label"] == label]
    if not rows:
        return ""
    lines = ["| " + " | ".join(HEAD) + " |", "| " + " | ".join(["---"] * len(HEAD)) + " |"]
    lines += ["| " + " | ".join(cells) + " |" for cells in rows]
    return f"### α = {alpha}\n\n" + "\n".join(lines) + "\n"


def main():
    if len(sys.argv) not in (2, 3):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    out = pathlib.Path(sys.argv[1])
    docs = pathlib.Path(sys.argv[2]) if len(sys.argv) == 3 else \
        pathlib.Path(__file__).resolve().parent / "evaluation"
    for folder in sorted((out / "tables").iterdir()):
        target = docs / folder.name
        target.mkdir(parents=True, exist_ok=True)
        for name in ("evaluation.txt", "histograms.svg", "projection.svg"):
            if name != "projection.svg" or "projected" in folder.name:
                shutil.copy(folder / name, target / name)
    text = "\n".join(part for part in (table(out, alpha) for alpha in (100, 10)) if part)
    page = docs / "README.md"
    old = page.read_text(encoding="utf-8")
    begin, end = old.index(BEGIN) + len(BEGIN), old.index(END)
    page.write_text(f"{old[:begin]}\n\n{text}\n{old[end:]}", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
