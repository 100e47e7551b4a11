# SPDX-License-Identifier: GPL-3.0-or-later
"""NAME.obj: a watertight tessellation of the shape with the domain as texture coordinates."""

import math
import pathlib
import subprocess
import tempfile
import os
import unittest

import comparison
import native

DEFAULT_TESSELLATION = 8


class Obj:
    def __init__(self, path):
        self.points, self.uv, self.faces = [], [], []
        for line in pathlib.Path(path).read_text(encoding="utf-8").splitlines():
            key, *words = line.split()
            if key == "v":
                assert words[2] == "0"
                self.points.append((float(words[0]), float(words[1])))
            elif key == "vt":
                self.uv.append((float(words[0]), float(words[1])))
            elif key == "f":
                corners = [word.split("/") for word in words]
                assert all(a == b for a, b in corners)
                self.faces.append(tuple(int(a) - 1 for a, _ in corners))
            else:
                assert key in ("#", "g"), key


def barycentric(corners, p):
    a, b, c = corners
    ab, ac, ap = [(q[0] - a[0], q[1] - a[1]) for q in (b, c, p)]
    det = native.cross(ab, ac)
    return native.cross(ap, ac) / det, native.cross(ab, ap) / det


class Tessellation(comparison.Comparison):
    def check(self, path, result, cuts=DEFAULT_TESSELLATION):
        obj = Obj(path)
        count = len(result.triangles)
        self.assertEqual(len(obj.faces), count * cuts * cuts)
        self.assertEqual(len(obj.points), len(obj.uv))
        self.check_sharing(obj, result, cuts)
        self.check_places(obj, result, cuts)
        self.check_area(obj, result, cuts)

    def check_sharing(self, obj, result, cuts):
        """Euler's count of shared points, none unused, none twice; every inner edge has two faces that
        run against each other, and what has one is the boundary."""
        sides = [(t[k], t[(k + 1) % 3]) for t in result.triangles for k in range(3)]
        edges = {tuple(sorted(e)) for e in sides}
        inner = (cuts - 1) * (cuts - 2) // 2
        vertices = {v for t in result.triangles for v in t}
        count = len(vertices) + len(edges) * (cuts - 1) + len(result.triangles) * inner
        self.assertEqual(len(obj.points), count)
        self.assertEqual({k for face in obj.faces for k in face}, set(range(len(obj.points))))
        self.assertEqual(len(set(obj.points)), len(obj.points))
        directed = [(f[k], f[(k + 1) % 3]) for f in obj.faces for k in range(3)]
        self.assertEqual(len(set(directed)), len(directed))
        free = set(directed) - {(b, a) for a, b in directed}
        self.assertEqual(len(free), cuts * len(result.boundary))

    def check_places(self, obj, result, cuts):
        """Each point is the image of its texture coordinates."""
        first_of = {}
        for number, face in enumerate(obj.faces):
            for k in face:
                first_of.setdefault(k, number // (cuts * cuts))
        # Faces come region by region; within one, triangle by triangle.
        order = self.triangle_order(result)
        for k, group in list(first_of.items())[::7]:
            t = order[group]
            r, s = barycentric(result.domain_corners(t), obj.uv[k])
            self.same_place(obj.points[k], result, t, r, s)

    def same_place(self, found, result, t, r, s):
        # The place is known up to the rounding of barycentric coordinates in a thin triangle.
        corners = result.domain_corners(t)
        longest = max(math.dist(p, q) for p in corners for q in corners)
        error = comparison.ROUNDING * result.domain_extent * longest / abs(result.domain_det(t))
        slope = sum(math.hypot(*d) for d in result.frame(t, r, s))
        self.assertLessEqual(math.dist(found, result.point(t, r, s)),
                             comparison.ROUNDING * result.extent + error * slope, f"triangle {t}")

    def triangle_order(self, result):
        mesh = pathlib.Path(result.file(".mesh")).read_text(encoding="utf-8").split("\n")
        first = mesh.index("elements") + 2
        region = [int(line.split()[0]) for line in mesh[first:first + len(result.triangles)]]
        return sorted(range(len(region)), key=lambda t: region[t])

    def check_area(self, obj, result, cuts):
        """The faces' areas add up to that inside the polygons through the boundary's own points."""
        area = 0.0
        for f in obj.faces:
            a, b, c = (obj.points[k] for k in f)
            area += 0.5 * native.cross((b[0] - a[0], b[1] - a[1]), (c[0] - a[0], c[1] - a[1]))
        polygon = 0.0
        for _, _, curve, t0, t1 in result.boundary:
            points = [native.curve_point(result.curves[curve], t0 + (t1 - t0) * k / cuts)
                      for k in range(cuts + 1)]
            polygon += sum(0.5 * native.cross(p, q) for p, q in zip(points, points[1:]))
        self.same_measure(area, polygon, result.extent**2, "area of the faces")

    def test_geometry(self):
        self.each_result(lambda r: self.check(r.file(".obj"), r))

    def test_other_tessellations(self):
        result = native.Native(comparison.folder() / "letter.c1.json")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "letter.obj")
            for cuts in (1, 2, 5):
                subprocess.run([os.environ["C1MESH_PROGRAM"], "convert", result.file(".c1.json"), "-o", path,
                                "--tessellation", str(cuts)], check=True)
                self.check(path, result, cuts)

    def test_moved_points_are_noticed(self):
        result = native.Native(comparison.folder() / "blob.c1.json")
        self.check(result.file(".obj"), result)

        def swap_points(lines):
            first = next(k for k, line in enumerate(lines) if line.startswith("v "))
            comparison.swap(lines, first + 7, first + 14)

        def swap_places(lines):
            first = next(k for k, line in enumerate(lines) if line.startswith("vt "))
            comparison.swap(lines, first + 7, first + 14)

        for change in (swap_points, swap_places):
            with self.assertRaises(AssertionError):
                self.check(self.spoiled(result.file(".obj"), change), result)


if __name__ == "__main__":
    unittest.main()
