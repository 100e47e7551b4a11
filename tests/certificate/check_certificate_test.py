# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/check_certificate.py on what the program writes: true certificates hold, falsehoods are found."""

import copy
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAM = sys.argv.pop()
sys.path.insert(0, str(ROOT / "docs"))
import check_certificate  # noqa: E402


def made(folder, path, *options):
    """The result and the certificate of one shape."""
    subprocess.run([PROGRAM, "run", str(path), "-o", folder, "--formats", "json,cert", "--quiet",
                    *options], check=False, capture_output=True)
    name = path.stem
    read = lambda ending: json.loads((pathlib.Path(folder) / (name + ending)).read_text("utf-8"))
    return read(".c1.json"), read(".cert.json")


def faults(result, certificate):
    return check_certificate.Checker(result, certificate).check()


class Examples(unittest.TestCase):
    def test_certificates_hold(self):
        for name in ("blob", "puzzle", "annulus"):
            with tempfile.TemporaryDirectory() as folder, self.subTest(name):
                self.assertEqual(faults(*made(folder, ROOT / "examples" / f"{name}.svg")), [])

    def test_of_a_higher_degree(self):
        with tempfile.TemporaryDirectory() as folder:
            blob = ROOT / "examples" / "blob.svg"
            self.assertEqual(faults(*made(folder, blob, "--degree", "4")), [])


class Falsehoods(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            cls.result, cls.certificate = made(folder, ROOT / "examples" / "blob.svg")

    def expect_fault(self, change):
        result, certificate = copy.deepcopy(self.result), copy.deepcopy(self.certificate)
        change(result, certificate)
        self.assertNotEqual(faults(result, certificate), [])

    def test_bounds(self):
        def raise_det(_, c): c["triangles"][3][1] *= 1.000001
        def lower_g(_, c): c["triangles"][3][2] *= 0.999999
        def no_defect(_, c):
            worst = max(c["edges"], key=lambda e: e[2])
            worst[2] = 0
        def no_distance(r, c):
            r["control_points"][r["triangle_control_points"][0][0]][0] += 1e-9
        for change in (raise_det, lower_g, no_defect, no_distance):
            with self.subTest(change.__name__):
                self.expect_fault(change)

    def test_lists(self):
        def edge_missing(_, c): c["edges"].pop()
        def triangle_missing(_, c): c["triangles"].pop()
        def curve_edge_missing(_, c): c["curve_edges"].pop()
        def depth(_, c): c["triangles"][0][0] += 1
        def split_in_vain(_, c): c["triangles"][0] = c["triangles"][0][:3] + ["1"]
        def flipped(r, _): r["triangles"][0] = r["triangles"][0][::-1]
        for change in (edge_missing, triangle_missing, curve_edge_missing, depth, split_in_vain, flipped):
            with self.subTest(change.__name__):
                self.expect_fault(change)

    def test_pairs(self):
        for entry in range(len(self.certificate["boundary"])):
            self.expect_fault(lambda _, c: c["boundary"][entry].__setitem__(4, "1"))


if __name__ == "__main__":
    unittest.main()
