# SPDX-License-Identifier: GPL-3.0-or-later
"""What meshio reads of NAME.msh and of NAME.lagrange.vtu: points, cells, groups, fields. meshio does
not evaluate elements; its cells are in the order of VTK, and are evaluated so here."""

import unittest
import warnings

import comparison
import native

meshio = comparison.need("meshio", "python3-meshio")
LINE = {1: "line", 2: "line3", **{n: f"line{n + 1}" for n in range(3, 11)}}
TRIANGLE = {1: "triangle", **{n: f"triangle{(n + 1) * (n + 2) // 2}" for n in range(2, 11)}}


def cells(mesh, kind):
    return [[int(k) for k in cell] for block in mesh.cells if block.type == kind for cell in block.data]


class Meshio(comparison.Comparison):
    def allowance(self, degree):  # of the way back from values to control points
        return 4.0**max(0, degree - 3)

    def check_triangles(self, mesh, found, result):
        n = result.degree
        back = {ij: k for k, ij in enumerate(native.recursive_order(n))}
        area = 0.0
        self.assertEqual(len(found), len(result.triangles))
        for t, nodes in enumerate(found):
            values = [tuple(map(float, mesh.points[nodes[back[ij]]][:2])) for ij in native.triangle_lattice(n)]
            net = native.net_from_values(values, n)
            area += native.net_area(net, n)
            for r, s in result.references(1):
                self.same_point(native.triangle_point(net, n, r, s), result.point(t, r, s), result.extent,
                                f"triangle {t}", self.allowance(n))
                det = native.cross(*native.triangle_frame(net, n, r, s))
                self.same_det(det / result.domain_det(t), result, t, r, s)
        self.same_area(area, result)

    def check_msh(self, result):
        mesh = meshio.read(result.file(".msh"))
        # meshio numbers the points anew, in the file's order; corners are known by their coordinates.
        number = {tuple(map(float, p[:2])): k for k, p in enumerate(mesh.points)}
        by_corners = {tuple(nodes[:3]): nodes for nodes in cells(mesh, TRIANGLE[result.degree])}
        corners = [[number[tuple(map(float, result.control_points[k]))] for k in result.corner_ids(t)]
                   for t in range(len(result.triangles))]
        self.check_triangles(mesh, [by_corners[tuple(c)] for c in corners], result)
        curves = result.curve_lengths()
        names = {name for name in mesh.field_data if name.startswith("curve")}
        self.assertEqual(names, {f"curve {k}" for k in curves})
        for curve, expected in curves.items():
            length = 0.0
            for block, group in zip(mesh.cells, mesh.cell_data["gmsh:physical"]):
                if block.type == LINE[result.degree] and group[0] == mesh.field_data[f"curve {curve}"][0]:
                    for nodes in block.data:
                        start, end, *inside = [tuple(map(float, mesh.points[k][:2])) for k in nodes]
                        poles = native.poles_from_values([start, *inside, end])
                        length += native.curve_length(poles)
            self.same_measure(length, expected, self.allowance(result.degree) * result.extent, f"curve {curve}")
        self.assertEqual(mesh.point_data["domain"].shape, (len(mesh.points), 3))

    def test_msh(self):
        self.each_result(self.check_msh, 10)

    def test_lagrange_vtu(self):
        def check(result):
            mesh = meshio.read(result.file(".lagrange.vtu"))
            self.check_triangles(mesh, cells(mesh, "VTK_LAGRANGE_TRIANGLE"), result)

        self.each_result(check)


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    unittest.main()
