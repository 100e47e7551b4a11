# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/scale.py on a stand-in for the program whose costs are known powers of the curves."""

import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCRIPT = ROOT / "docs" / "scale.py"

# Costs of n, of its square, and one that is always too small to count.
PROGRAM = r"""#!%s
import json, sys
n = len(json.load(open(sys.argv[2])))
assert sys.argv[5:] == ["--threads", "1", "--verbose"], sys.argv
print(f"stand-in\n  triangles             {5 * n} of degree 3", file=sys.stderr)
print("  cost of                          seconds     CPU s   CPU us/tri.", file=sys.stderr)
for stage, cpu in (("mesh: walks", 0.001 * n), ("map: domain", 1e-5 * n * n), ("read", 0.01)):
    print(f"  {stage:<30}{9:10.3f}{cpu:10.3f}{7:14.2f}", file=sys.stderr)
print(f"  {'peak memory':<30}{12.5:7.1f} MiB{'':10}{3:10.2f} KiB", file=sys.stderr)
sys.exit(4)
""" % sys.executable


def load():
    spec = importlib.util.spec_from_file_location("scale", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Scale(unittest.TestCase):
    def test_exponents_are_fitted(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder, "program")
            program.write_text(PROGRAM)
            os.chmod(program, 0o755)
            out = pathlib.Path(folder, "out")
            subprocess.run([sys.executable, "-B", str(SCRIPT), str(program), str(out), "--families", "discs",
                            "--sizes", "100,200,400,800"], check=True, stdin=subprocess.DEVNULL)
            rows = {line.split(" | ")[0][2:]: line.strip(" |").split(" | ")
                    for line in (out / "table.md").read_text().splitlines() if line.startswith("| ")}
        self.assertEqual(rows["exit status"][1:5], ["4"] * 4)
        self.assertEqual(rows["triangles"][1:5], ["500", "1000", "2000", "4000"])
        self.assertEqual(rows["mesh: walks"][1:], ["0.100", "0.200", "0.400", "0.800", "1.00"])
        self.assertEqual(rows["mesh, all"], ["mesh, all"] + rows["mesh: walks"][1:])
        self.assertEqual(rows["map: domain"][-1], "2.00")
        self.assertNotIn("read", rows)  # below 20 ms

    def test_shapes_have_the_curves_asked_for(self):
        scale = load()
        for name, family in scale.FAMILIES.items():
            for size in (100, 400):
                curves = family(size)
                # Few more or less: a comb has a back, a network is square.
                self.assertLess(abs(len(curves) - size), 0.15 * size, name)
                ends = {}
                for poles in curves:
                    for end in (poles[0], poles[-1]):
                        ends[tuple(end)] = ends.get(tuple(end), 0) + 1
                self.assertGreaterEqual(min(ends.values()), 2, name)  # nothing dangles
                json.dumps(curves)


if __name__ == "__main__":
    unittest.main()
