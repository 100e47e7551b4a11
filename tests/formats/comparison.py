# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of this folder share: the results to read, tolerances, spoiled files, skipping."""

import importlib
import math
import os
import pathlib
import sys
import tempfile
import unittest

import native

SKIPPED = 77  # SKIP_RETURN_CODE in CMakeLists.txt
ROUNDING = 64 * 2.0**-52


def need(module, package):
    """The reader's module; without it the whole test is skipped, and says so."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        print(f"skipped: no Python module {module} ({error}); Debian has it in {package} "
              f"(cmake/packages-tests.txt)")
        sys.exit(SKIPPED)


def folder():
    return pathlib.Path(os.environ["C1MESH_RESULTS"])


class Comparison(unittest.TestCase):
    # How many times more than by its own arithmetic a reader may be off at this degree.
    def allowance(self, degree):
        return 1

    def each_result(self, check, highest_degree=99):
        """check(result) for every result, each a subtest."""
        found = [r for r in native.all_results(folder()) if r.degree <= highest_degree]
        self.assertGreaterEqual(len(found), 36)  # make_results.py makes 37, one above Gmsh's degree
        for result in found:
            with self.subTest(result.name):
                check(result)

    def same_point(self, found, expected, extent, message, allowance=1):
        distance = math.dist(found[:2], expected)
        self.assertLessEqual(distance, allowance * ROUNDING * extent,
                             f"{message}: {found} is not {expected}")

    def same_det(self, found, result, t, r, s):
        expected = result.det(t, r, s)
        tolerance = self.allowance(result.degree) * result.det_tolerance(t, r, s)
        self.assertLessEqual(abs(found - expected), tolerance,
                             f"det J in triangle {t}: {found} is not {expected}")

    def same_measure(self, found, expected, scale, message):
        self.assertLessEqual(abs(found - expected), 16 * ROUNDING * scale,
                             f"{message}: {found} is not {expected}")

    def same_area(self, found, result):
        # A sum over the sides of triangles: each is rounded by its place in the plane.
        self.same_measure(found, result.area, self.allowance(result.degree) * result.extent**2, "area")

    def same_boundary_length(self, found, result):
        self.same_measure(found, result.boundary_length(),
                          4 * self.allowance(result.degree) * result.extent, "length of the boundary")

    def spoiled(self, path, change):
        """A copy of the file with its lines changed by `change`."""
        lines = pathlib.Path(path).read_text(encoding="utf-8").split("\n")
        change(lines)
        spoiled = tempfile.NamedTemporaryFile("w", suffix=pathlib.Path(path).suffix, delete=False)
        self.addCleanup(os.unlink, spoiled.name)
        with spoiled:
            spoiled.write("\n".join(lines))
        return spoiled.name


def swap(words, a, b):
    words[a], words[b] = words[b], words[a]
