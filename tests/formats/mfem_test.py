# SPDX-License-Identifier: GPL-3.0-or-later
"""NAME.mesh and NAME.domain.mesh against the layout that MFEM documents.

Debian 12 has no MFEM, so the reader is a small one of our own, after https://mfem.org/mesh-format
(MFEM mesh v1.0) and MFEM's L2Pos_TriangleElement: degree of freedom (i, j) of a triangle of order p, j
in the outer loop and i in the inner one, belongs to
    p! / (i! j! (p-i-j)!) x^i y^j (1-x-y)^(p-i-j)."""

import math
import pathlib
import re
import unittest

import comparison
import native

SEGMENT, TRIANGLE = 1, 2


class Mesh:
    """What MFEM would hold after reading the file. Sections come in a fixed order."""

    def __init__(self, path):
        self.words = pathlib.Path(path).read_text(encoding="utf-8").split()
        self.at = 0
        self.expect("MFEM", "mesh", "v1.0", "dimension", "2", "elements")
        self.elements = self.read_elements(TRIANGLE, 3)
        self.expect("boundary")
        self.boundary = self.read_elements(SEGMENT, 2)
        self.expect("vertices")
        self.vertex_count = int(self.word())
        self.vertices = self.values = None
        if self.words[self.at] == "nodes":
            self.read_nodes()
        else:
            self.expect("2")
            self.vertices = [self.pair() for _ in range(self.vertex_count)]
        assert self.at == len(self.words), "words are left over"

    def word(self):
        self.at += 1
        return self.words[self.at - 1]

    def pair(self):
        return float(self.word()), float(self.word())

    def expect(self, *words):
        for word in words:
            found = self.word()
            assert found == word, f"'{found}' instead of '{word}'"

    def read_elements(self, geometry, corners):
        """[(attribute, vertices)]"""
        out = []
        for _ in range(int(self.word())):
            attribute = int(self.word())
            assert attribute > 0
            self.expect(str(geometry))
            out.append((attribute, tuple(int(self.word()) for _ in range(corners))))
        return out

    def read_nodes(self):
        self.expect("nodes", "FiniteElementSpace", "FiniteElementCollection:")
        # L2_T<basis>_<dimension>D_P<order>; basis 2 is BasisType::Positive.
        self.order = int(re.fullmatch(r"L2_T2_2D_P(\d+)", self.word()).group(1))
        self.expect("VDim:", "2", "Ordering:", "1")  # 1: byVDIM, x and y side by side
        self.per_element = (self.order + 1) * (self.order + 2) // 2
        self.values = [self.pair() for _ in range(len(self.elements) * self.per_element)]

    def shape_functions(self, x, y):
        p, out = self.order, []
        for j in range(p + 1):
            for i in range(p + 1 - j):
                count = math.comb(p, j) * math.comb(p - j, i)
                out.append(count * x**i * y**j * (1 - x - y)**(p - i - j))
        return out

    def point(self, element, x, y):
        first = element * self.per_element
        return native.combine(self.shape_functions(x, y), self.values[first:first + self.per_element])


class Mfem(comparison.Comparison):
    def allowance(self, degree):  # of the way back from values to control points
        return 4.0**max(0, degree - 3)

    def check(self, path, result):
        mesh = Mesh(path)
        self.assertEqual(mesh.order, result.degree)
        self.assertEqual(mesh.vertex_count, len(result.domain_vertices))
        self.assertEqual([list(v) for _, v in mesh.elements], result.triangles)
        area, n = 0.0, result.degree
        for t in range(len(result.triangles)):
            for r, s in result.references():
                self.same_point(mesh.point(t, r, s), result.point(t, r, s), result.extent, f"triangle {t}")
            values = [mesh.point(t, i / n, j / n) for i, j in native.triangle_lattice(n)]
            net = native.net_from_values(values, n)
            area += native.net_area(net, n)
            for r, s in result.references():
                det = native.cross(*native.triangle_frame(net, n, r, s))
                self.same_det(det / result.domain_det(t), result, t, r, s)
        self.same_area(area, result)
        self.check_boundary(mesh, result)

    def check_boundary(self, mesh, result):
        """Boundary elements by attribute: the lengths of the input's curves, on the elements' sides."""
        n = result.degree
        side = {}
        for t, (_, v) in enumerate(mesh.elements):
            for k in range(3):
                side[v[k], v[(k + 1) % 3]] = (t, k)
        places = [(i / n) for i in range(n + 1)]
        lengths = {}
        for attribute, (a, b) in mesh.boundary:
            t, k = side.get((a, b)) or side[b, a]
            values = [mesh.point(t, *[(x, 0), (1 - x, x), (0, 1 - x)][k]) for x in places]
            length = native.curve_length(native.poles_from_values(values))
            lengths[attribute - 1] = lengths.get(attribute - 1, 0.0) + length
        expected = result.curve_lengths()
        self.assertEqual(set(lengths), set(expected))
        for curve, length in expected.items():
            self.same_measure(lengths[curve], length, self.allowance(n) * result.extent,
                              f"length of curve {curve}")
        self.same_boundary_length(sum(lengths[c] for c in {e[2] for e in result.boundary}), result)
        # Where there is one triangle alone, its side runs as the boundary element does.
        outer = {tuple(e[:2]) for e in result.boundary}
        for _, edge in mesh.boundary:
            self.assertTrue(edge in outer or edge[::-1] not in outer)

    def test_geometry(self):
        self.each_result(lambda r: self.check(r.file(".mesh"), r))

    def test_control_points_bit_for_bit(self):
        def check(result):
            values = Mesh(result.file(".mesh")).values
            expected = [tuple(map(float, p)) for t in range(len(result.triangles)) for p in result.net(t)]
            self.assertEqual(values, expected)

        self.each_result(check)

    def test_domain_files(self):
        def check(result):
            shape, domain = Mesh(result.file(".mesh")), Mesh(result.file(".domain.mesh"))
            self.assertEqual(domain.elements, shape.elements)
            self.assertEqual(domain.boundary, shape.boundary)
            self.assertEqual(domain.vertices, [tuple(map(float, p)) for p in result.domain_vertices])

        self.each_result(check)

    def test_regions_are_what_shared_sides_connect(self):
        def check(result):
            mesh = Mesh(result.file(".mesh"))
            attribute = {}
            for number, (a, b, c) in mesh.elements:
                for edge in ((a, b), (b, c), (c, a)):
                    attribute.setdefault(tuple(sorted(edge)), set()).add(number)
            self.assertTrue(all(len(found) == 1 for found in attribute.values()))
            numbers = {number for number, _ in mesh.elements}
            self.assertEqual(numbers, set(range(1, len(numbers) + 1)))

        self.each_result(check)

    def test_swapped_control_points_are_noticed(self):
        """The comparison fails if two values of one element trade places."""
        result = native.Native(comparison.folder() / "annulus.c1.json")
        self.check(result.file(".mesh"), result)
        for a, b in ((1, 2), (3, 9), (4, 5), (6, 7)):
            def swap_values(lines, a=a, b=b):
                first = lines.index("Ordering: 1") + 2
                comparison.swap(lines, first + a, first + b)
            with self.assertRaises(AssertionError):
                self.check(self.spoiled(result.file(".mesh"), swap_values), result)


if __name__ == "__main__":
    unittest.main()
