# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/battery.sh and docs/tables.py on a stand-in for the program."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# Fails with status 3 on inputs called bad*, else writes a result whose surplus is the input's text.
PROGRAM = r"""#!/bin/bash
[[ $1 == --version ]] && { echo "c1mesh 9.9.9"; exit 0; }
[[ $1 == run && $3 == -o ]] || exit 2
name=$(basename "$2" .json)
[[ $name == bad* ]] && { echo "crossing" >&2; exit 3; }
surplus=$(cat "$2")
echo "  remedies              none" >&2
cat >"$4/$name.c1.json" <<TEXT
{"parameters":{"alpha":100,"degree":3},"metrics":{"triangles":12,"exceptional":$((3 + surplus)),
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

    def battery(self, out, inputs):
        files = []
        for name, text in inputs.items():
            files.append(self.root / f"{name}.json")
            files[-1].write_text(text, encoding="utf-8")
        subprocess.run([str(ROOT / "docs" / "battery.sh"), str(self.program), str(self.root / out),
                        *map(str, files)], check=True)

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
                     "| g, worst | 14 |", "| 0 | 2 |", "| 4 | 1 |", "| none | 3 |"):
            self.assertIn(line, lines)
        self.assertIn("| three | 0 | 12 | 7 | 3 | 4 | 2.0e-15 | 0.0e+00 | 14 |", done.stdout)
        self.assertIn("| bad | 3 | - |", done.stdout)
        self.assertIn("docs/battery.sh build/release/bin/c1mesh", done.stdout)

    def test_sets(self):
        for letter in "ABC":
            self.battery(letter, {f"{letter}-0001": "1"})
        done = self.table("sets", *(str(self.root / letter) for letter in "ABC"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("generate --set B --count 1 --seed 1", done.stdout)
        self.assertIn("| inputs | 1 | 1 | 1 |", done.stdout)

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
