# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/battery.sh and docs/tables.py on a stand-in for the program."""

import csv
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from xml.etree import ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "docs"))
import histograms  # noqa: E402  (found only now)

# Fails with status 3 on inputs called bad*, does not end on those called slow*, else writes a result
# whose surplus is the input's text; generates such inputs.
PROGRAM = r"""#!/bin/bash
[[ $1 == --version ]] && { echo "c1mesh 9.9.9"; exit 0; }
if [[ $1 == generate ]]; then
  [[ $2 == --set && $4 == --count && "$6 $7 $8" == "--seed 1 -o" ]] || exit 2
  mkdir -p "$9"
  for k in $(seq "$5"); do echo $((k - 1)) >"$9/$3-000$k.json"; done
  exit 0
fi
[[ $1 == run && $3 == -o ]] || exit 2
name=$(basename "$2")
name=${name%.*}
echo "$name" >>"$(dirname "$0")/calls"
[[ $name == slow* ]] && { echo "thinking | hard"; exec sleep 30; }
[[ $name == bad* ]] && { echo "crossing" >&2; exit 3; }
surplus=$(cat "$2")
echo "  remedies              none" >&2
cat >"$4/$name.c1.json" <<TEXT
{"parameters":{"alpha":100,"mips_bound":10,"degree":3},"metrics":{"triangles":12,"exceptional":$((3 + surplus)),
"exceptional_minimum":3,"surplus":$surplus,"d_ei":{"max":2e-15},"conformance_max":0,
"mips_bound_max":$((10 + surplus)),"domain_overlaps":false}}
TEXT
"""


class Tables(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.program = self.root / "c1mesh"
        self.program.write_text(PROGRAM, encoding="utf-8")
        self.program.chmod(0o755)

    def battery(self, out, inputs, ending="json", check=True, **environment):
        files = []
        for name, text in inputs.items():
            files.append(self.root / f"{name}.{ending}")
            files[-1].write_text(text, encoding="utf-8")
        return subprocess.run(
            [str(ROOT / "docs" / "battery.sh"), str(self.program), str(self.root / out),
             *map(str, files)], env={**os.environ, **environment}, capture_output=True, text=True,
            check=check)

    def calls(self):
        file = self.root / "calls"
        text = file.read_text(encoding="utf-8") if file.exists() else ""
        file.write_text("", encoding="utf-8")
        return sorted(text.split())

    def table(self, *arguments):
        return subprocess.run([sys.executable, "-B", str(ROOT / "docs" / "tables.py"), *arguments],
                              capture_output=True, text=True, check=False)

    def test_corpus(self):
        self.battery("out", {"one": "0", "two words": "0", "three": "4", "bad": ""})
        self.assertRegex((self.root / "out" / "bad.log").read_text(encoding="utf-8"),
                         r"^crossing\nSTATUS 3\nWALL \d+\.\d\d\n$")
        done = self.table("corpus", str(self.root / "out"))
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stdout.split("\n")
        for line in ("| inputs | 4 |", "| status 0 | 3 |", "| status 3 | 1 |",
                     "| results written | 3 |", "| surplus, mean | 1.33 |", "| g, median | 10 |",
                     "| g, worst | 14 |", "| surplus 0 | 2 |", "| g at most 20 | 3 |", "| 0 | 2 |", "| 4 | 1 |", "| none | 3 |"):
            self.assertIn(line, lines)
        self.assertIn("| three | 0 | 12 | 7 | 3 | 4 | 2.0e-15 | 0.0e+00 | 14 |", done.stdout)
        self.assertIn("| bad | 3 | - |", done.stdout)
        self.assertIn("docs/battery.sh build/release/bin/c1mesh", done.stdout)

    def test_corpus_read_from_svg_too(self):
        inputs = {"one": "0", "two": "1", "three": "4", "bad": ""}
        self.battery("out", {**inputs, "four": "2"})
        self.battery("svg", {**inputs, "three": "5", "five": "2"}, ending="svg")
        file = self.root / "svg" / "two.c1.json"
        result = json.loads(file.read_text(encoding="utf-8"))
        result["metrics"]["d_ei"]["max"] = 3e-15  # rounding: not equal, and not worth a row
        file.write_text(json.dumps(result), encoding="utf-8")
        done = self.table("corpus", str(self.root / "out"), "in/*.json", str(self.root / "svg"))
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stdout.split("\n")
        for line in ("| shapes read both ways | 4 |", "| read from JSON only | 1 |",
                     "| read from SVG only | 1 |", "| same status | 4 |",
                     "| all metrics equal to the last bit | 2 |", "| same triangles | 4 |",
                     "| same surplus | 3 |", "| g within 1 % | 2 |",
                     "| three | 0, 0 | 12, 12 | 7, 8 | 3, 3 | 4, 5 | 14, 15 |"):
            self.assertIn(line, lines)
        self.assertNotIn("| two | 0, 0 |", done.stdout)
        self.assertIn("c1mesh out/corpus-svg in/*.svg", done.stdout)

    def test_a_battery_goes_on(self):
        self.battery("out", {"one": "0", "two": "0"})
        self.assertEqual(self.calls(), ["one", "two"])
        (self.root / "out" / "two.log").write_text("still at it\n", encoding="utf-8")
        inputs = {"one": "0", "two": "0", "three": "0"}
        self.battery("out", inputs, RESUME="1")
        self.assertEqual(self.calls(), ["three", "two"])
        self.assertIn("STATUS 0\n", (self.root / "out" / "two.log").read_text(encoding="utf-8"))
        self.battery("out", inputs, RESUME="1")
        self.assertEqual(self.calls(), [])
        done = self.battery("out", inputs, check=False, RESUME="1", RUN_OPTIONS="--alpha 10")
        self.assertEqual(done.returncode, 2)
        self.assertIn("another program", done.stderr)
        self.program.write_text(PROGRAM + "# newer\n", encoding="utf-8")
        done = self.battery("out", inputs, check=False, RESUME="1")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(self.calls(), [])
        self.battery("out", inputs)
        self.assertEqual(len(self.calls()), 3)

    def test_a_battery_with_a_limit(self):
        self.battery("out", {"slow": "0", "one": "0"}, TIMEOUT="1")
        log = (self.root / "out" / "slow.log").read_text(encoding="utf-8")
        self.assertRegex(log, r"^thinking \| hard\nSTATUS 124\nWALL [1-9]\.\d\d\n$")
        self.assertIn("STATUS 0", (self.root / "out" / "one.log").read_text(encoding="utf-8"))

    def test_a_battery_that_is_ended_leaves_no_status(self):
        """The stand-in ends well at a signal, as the program does: that is no status of the input."""
        self.program.write_text(PROGRAM.replace(
            "exec sleep 30", "trap 'exit 5' TERM INT; for k in {1..300}; do sleep 0.1; done"),
            encoding="utf-8")
        (self.root / "slow.json").write_text("0", encoding="utf-8")
        log = self.root / "out" / "slow.log"
        for limit, number in (("", signal.SIGINT), ("20", signal.SIGINT), ("", signal.SIGTERM),
                              ("20", signal.SIGTERM)):
            log.unlink(missing_ok=True)
            with subprocess.Popen(
                    [str(ROOT / "docs" / "battery.sh"), str(self.program), str(self.root / "out"),
                     str(self.root / "slow.json")], env={**os.environ, "TIMEOUT": limit},
                    stderr=subprocess.DEVNULL, start_new_session=True) as battery:
                while not (log.exists() and log.read_text(encoding="utf-8")):
                    time.sleep(0.02)
                time.sleep(0.2)
                os.killpg(battery.pid, number)
            time.sleep(0.5)
            self.assertNotEqual(battery.returncode, 0)
            self.assertNotIn("STATUS", log.read_text(encoding="utf-8"))

    def sets(self, count, **environment):
        subprocess.run([str(ROOT / "docs" / "sets.sh"), str(self.program), str(self.root / "sets"),
                        str(count)], env={**os.environ, **environment}, capture_output=True, check=True)

    def test_sets(self):
        self.sets(2)
        self.assertEqual(self.calls(), sorted(["A-0001", "A-0002", "B-0001", "B-0002", "C-0001",
                                               "C-0002"] * 3))
        self.sets(2)
        self.assertEqual(self.calls(), [])
        for experiment, options in (("100", "--alpha 100"), ("10", "--alpha 10"),
                                    ("min", "--exceptional min --alpha 1e9")):
            text = (self.root / "sets" / f"B-{experiment}" / "machine.txt").read_text(encoding="utf-8")
            self.assertTrue(text.endswith(f"--formats json {options}\n"), text)
            self.assertIn("at most 300 s each", text)
        ended = self.root / "sets" / "C-min" / "C-0001"  # as if stopped by the limit
        ended.with_suffix(".log").write_text("thinking | hard\nSTATUS 124\nWALL 300.01\n",
                                             encoding="utf-8")
        ended.with_suffix(".c1.json").unlink()
        docs = self.root / "docs"
        done = self.table("sets", str(self.root / "sets"), str(docs))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, "")
        text = (docs / "sets.md").read_text(encoding="utf-8")
        rows = {line.split(" | ")[0]: line[:-2].split(" | ")[1:] for line in text.split("\n")}
        for key, cells in {
                "inputs": ["2"] * 9, "status 0": ["2"] * 8 + ["1"], "other status": ["0"] * 8 + ["1"],
                "surplus 0": ["1"] * 8 + ["0"], "surplus, mean": ["0.50"] * 8 + ["1.00"],
                "target, on surplus 0 and status 0": ["≥ 99 %: missed", "", "", "≥ 95 %: missed", "", "",
                                                      "≥ 90 %: missed", "", ""],
                "target, surplus, mean": ["", "≤ 0.3: missed", "", "", "≤ 1: met", "", "", "≤ 2: met",
                                          ""],
                "g, worst": ["11"] * 9, "g, median": ["10"] * 8 + ["11"]}.items():
            self.assertEqual(rows[f"| {key}"], cells)
        self.assertIn("docs/sets.sh build/release/bin/c1mesh out/sets 2", text)
        self.assertIn("| A-0002 | 0 | 12 | 4 | 3 | 1 | 2.0e-15 | 0.0e+00 | 11 |", text)
        self.assertNotIn("| A-0001 |", text)
        self.assertIn("| 300.01 | (thinking \\| hard) |", text)
        self.assertIn("| seconds | remedies |\n| --- |" + " ---: |" * 9 + " --- |\n", text)
        self.assertNotIn("Not run", text)
        with open(docs / "sets.csv", encoding="utf-8", newline="") as stream:
            table = list(csv.DictReader(stream))
        self.assertEqual(len(table), 18)
        self.assertEqual([row["surplus"] for row in table], ["0", "1"] * 8 + ["", "1"])
        self.assertEqual([table[-2][key] for key in ("set", "experiment", "name", "status", "g")],
                         ["C", "min", "C-0001", "124", ""])
        for name in ("surplus", "g", "seconds"):
            self.assertIn(f"](pictures/sets-{name}.svg)", text)
            ElementTree.parse(docs / "pictures" / f"sets-{name}.svg")

    def test_sets_in_part(self):
        for letter in "AB":
            self.battery(f"sets/{letter}-10", {f"{letter}-{k}": "0" for k in range(ord(letter) - 64)})
        self.table("sets", str(self.root / "sets"), str(self.root))
        text = (self.root / "sets.md").read_text(encoding="utf-8")
        self.assertIn("| inputs | 1 | 2 |", text)
        self.assertIn("Not run: A-100, A-min, B-100, B-min, C-100, C-10, C-min.", text)
        self.assertIn("Not every experiment is complete", text)
        self.assertIn("| target, surplus, mean | ≤ 0.3: met | ≤ 1: met |", text)

    def test_bins(self):
        surplus = histograms.ClassBins(histograms.SURPLUS_BINS)
        self.assertEqual([surplus.index(v) for v in (-1, 0, 1, 3, 4, 7, 8, 31, 32, 1000)],
                         [0, 0, 1, 3, 4, 4, 5, 6, 7, 7])
        bins = histograms.LogBins([0.02, 300])  # from 0.01 to 1000
        self.assertEqual((bins.count, bins.ticks[0], bins.ticks[-1]), (20, (0, "0.01"), (20, "1000")))
        self.assertEqual([bins.index(v) for v in (0, 0.0101, 0.99, 1.01, 999, 1000)],
                         [0, 0, 7, 8, 19, 19])
        self.assertEqual(histograms.bins_of([1.5, None, float("inf")], bins, "none"),
                         [0] * 8 + [1] + [0] * 12 + [2])
        drawn = histograms.sheet("t", "a", [[("p", [0.02, 300, 300])]], bins)
        heights = [float(h) for h in re.findall(r'height="([0-9.]+)" fill="#4477aa"', drawn)]
        self.assertEqual(heights, [histograms.HEIGHT / 2, histograms.HEIGHT])

    def test_families(self):
        self.battery("out", {"comb-0001": "0", "comb-0002": "3", "bad-comb-0001": "",
                             "maze-0001": "1"})
        done = self.table("families", str(self.root / "out"))
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = {line.split(" | ")[0]: line.split(" | ")[1:-2] for line in done.stdout.split("\n")}
        self.assertEqual(rows["| comb"], ["2", "2", "0", "-", "1.5", "3", "10", "13", "2.0e-15",
                                          "0.0e+00"])
        self.assertEqual(rows["| bad-comb"], ["1", "0", "0", "1 of status 3"] + ["-"] * 6)
        self.assertEqual(rows["| maze"][:5], ["1", "1", "0", "-", "1.0"])
        self.assertIn("## What is not of status 0", done.stdout)
        self.assertIn("for f in bad-comb comb maze; do", done.stdout)
        self.assertIn("--family $f --count 2 --seed 1", done.stdout)
        self.assertIn("\ndocs/battery.sh build", done.stdout)
        machine = self.root / "out" / "machine.txt"
        machine.write_text(machine.read_text(encoding="utf-8").replace(
            "--formats json ", "--formats json --time-limit 60"), encoding="utf-8")
        self.assertIn('\nRUN_OPTIONS="--time-limit 60" docs/battery.sh build',
                      self.table("families", str(self.root / "out")).stdout)

    def test_a_run_that_did_not_end_is_refused(self):
        self.battery("out", {"one": "0"})
        (self.root / "out" / "two.log").write_text("still at it\n", encoding="utf-8")
        done = self.table("corpus", str(self.root / "out"))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("two.log", done.stderr)

    def test_an_infinite_bound(self):
        self.battery("out", {"one": "0"})
        file = self.root / "out" / "one.c1.json"
        result = json.loads(file.read_text(encoding="utf-8"))
        result["metrics"]["mips_bound_max"] = None
        file.write_text(json.dumps(result), encoding="utf-8")
        self.assertIn("| g, worst | inf |", self.table("corpus", str(self.root / "out")).stdout)


if __name__ == "__main__":
    unittest.main()
