# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/evaluation.sh on a stand-in for the program: what is run, made and left out."""

import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent

# Each call leaves a line in `calls`. Runs fail on A-0002; projecting copies; evaluate writes down its
# arguments.
PROGRAM = r"""#!/bin/bash
here=$(dirname "$0")
case $1 in
--version) echo "c1mesh 9.9.9"; exit ;;
--help) printf 'Subcommands:\n  run   Run\n%s' "$(cat "$here/more")"; exit ;;
generate)
  [[ $2 == --set && $4 == --count && "$6 $7 $8" == "--seed 1 -o" ]] || exit 2
  mkdir -p "$9"
  for k in $(seq "$5"); do echo "$k" >"$9/$3-000$k.json"; done
  exit ;;
evaluate) shift; echo "evaluate $*" >>"$here/calls"; exit "$(cat "$here/ending")" ;;
project)
  echo "project $(basename "$2")" >>"$here/calls"
  [[ $3 == -o ]] && sed s/map/projected/ "$2" >"$4/$(basename "$2")"; exit ;;
run)
  name=$(basename "$2" .json)
  echo "run $name ${*:9}" >>"$here/calls"
  [[ $name == A-0002 ]] && exit 5
  echo map >"$4/$name.c1.json"; exit ;;
esac
exit 2
"""


class Evaluation(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.program = self.root / "c1mesh"
        self.program.write_text(PROGRAM, encoding="utf-8")
        self.program.chmod(0o755)
        (self.root / "more").write_text("  evaluate  Measure\n  project   Make C1\n", encoding="utf-8")
        (self.root / "ending").write_text("0", encoding="utf-8")

    def evaluation(self, check=True, **environment):
        # JOBS=1: the calls come in order.
        choice = {"SETS": "A", "COUNT": "2", "ALPHAS": "100", "JOBS": "1", **environment}
        return subprocess.run([str(ROOT / "docs" / "evaluation.sh"), str(self.program),
                               str(self.root / "out")], env={**os.environ, **choice},
                              capture_output=True, text=True, check=check)

    def calls(self):
        file = self.root / "calls"
        text = file.read_text(encoding="utf-8") if file.exists() else ""
        file.write_text("", encoding="utf-8")
        return text.replace(str(self.root / "out") + "/", "").splitlines()

    def files(self, folder):
        return sorted(path.name for path in (self.root / "out" / folder).iterdir())

    def test_options_of_the_variants(self):
        self.evaluation(VARIANTS="exact paper repeated paper-printed", ALPHAS="10 100", COUNT="1",
                        TABLES="", PRINTED="--rho 1 --extent 2")
        expected = []
        for alpha in (10, 100):
            for options in ("", "--method paper ", "--method paper --repeat 2 ",
                            "--method paper --rho 1 --extent 2 "):
                expected.append(f"run A-0001 {options}--alpha {alpha}")
        self.assertEqual(self.calls(), expected)

    def test_printed_is_left_out_where_it_is_empty(self):
        done = self.evaluation(VARIANTS="paper-printed")
        self.assertIn("left out", done.stdout)
        self.assertEqual(self.calls(), [])

    def test_a_part_first_then_more_then_nothing(self):
        self.evaluation(VARIANTS="exact", TABLES="")
        self.assertEqual(self.calls(), ["run A-0001 --alpha 100", "run A-0002 --alpha 100"])
        self.evaluation(VARIANTS="exact", TABLES="", SETS="A B", COUNT="3")
        self.assertEqual(self.calls(), ["run A-0003 --alpha 100"] +
                         [f"run B-000{k} --alpha 100" for k in (1, 2, 3)])
        self.evaluation(VARIANTS="exact", TABLES="", SETS="A B", COUNT="3")
        self.assertEqual(self.calls(), [])

    def test_projected_is_made_once_of_what_there_is(self):
        self.evaluation(VARIANTS="paper", TABLES="")
        self.calls()
        self.evaluation(VARIANTS="projected", TABLES="")
        self.assertEqual(self.calls(), ["project A-0001.c1.json"])
        self.assertEqual(self.files("paper-projected-100/A"),
                         ["A-0001.c1.json", "A-0001.log", "A-0002.log", "program.sum"])
        folder = self.root / "out" / "paper-projected-100" / "A"
        self.assertEqual((folder / "A-0001.c1.json").read_text(encoding="utf-8"), "projected\n")
        self.assertIn("STATUS 0\nWALL ", (folder / "A-0001.log").read_text(encoding="utf-8"))
        self.assertIn("STATUS 5\n", (folder / "A-0002.log").read_text(encoding="utf-8"))
        self.assertFalse((self.root / "out" / "repeated-projected-100").exists())
        self.evaluation(VARIANTS="projected", TABLES="")
        self.assertEqual(self.calls(), [])
        # A new result is projected anew.
        later = (folder / "A-0001.log").stat().st_mtime + 5
        os.utime(self.root / "out" / "paper-100" / "A" / "A-0001.c1.json", (later, later))
        self.evaluation(VARIANTS="projected", TABLES="")
        self.assertEqual(self.calls(), ["project A-0001.c1.json"])

    def test_projected_without_anything_to_project_says_so(self):
        self.assertIn("no results", self.evaluation(VARIANTS="projected").stderr)

    def test_another_program_is_refused(self):
        self.evaluation(VARIANTS="paper projected", TABLES="")
        self.program.write_text(PROGRAM + "# another\n", encoding="utf-8")
        for variants in ("paper", "projected"):
            done = self.evaluation(VARIANTS=variants, TABLES="", check=False)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn("another program", done.stderr)

    def test_tables(self):
        self.evaluation(VARIANTS="exact", SETS="A B")
        self.assertEqual(self.calls()[-1], "evaluate exact-100/A exact-100/B --labels A,B "
                                           "-o tables/exact-100")
        self.evaluation(VARIANTS="paper exact projected", SETS="A B")
        tables = [line for line in self.calls() if line.startswith("evaluate")]
        self.assertEqual(tables, [
            "evaluate paper-100/A paper-100/B --labels A,B -o tables/paper-100",
            "evaluate exact-100/A exact-100/B --compare paper-100/A paper-100/B --labels A,B "
            "-o tables/exact-100",
            "evaluate paper-projected-100/A paper-projected-100/B --compare paper-100/A paper-100/B "
            "--labels A,B -o tables/paper-projected-100"])

    def test_a_table_that_fails_does_not_stop_the_others(self):
        (self.root / "ending").write_text("3", encoding="utf-8")
        done = self.evaluation(VARIANTS="exact paper")
        self.assertEqual(done.stderr.count("evaluate ended with status 3"), 2)
        self.assertEqual(sum(line.startswith("evaluate") for line in self.calls()), 2)

    def test_what_is_missing_is_found_before_anything_is_run(self):
        (self.root / "more").write_text("", encoding="utf-8")
        for variants, tables in (("exact", "1"), ("projected", ""), ("exactly", "")):
            done = self.evaluation(VARIANTS=variants, TABLES=tables, check=False)
            self.assertEqual(done.returncode, 2)
            self.assertIn("evaluation: ", done.stderr)
        self.assertEqual(self.calls(), [])
        self.assertFalse((self.root / "out").exists())
        self.evaluation(VARIANTS="exact", TABLES="", COUNT="1")
        self.assertEqual(len(self.calls()), 1)


if __name__ == "__main__":
    unittest.main()
