# SPDX-License-Identifier: GPL-3.0-or-later
"""The four .vtu files of a result read back and evaluated by VTK, Bezier and Lagrange cells; the .obj
read back by VTK."""

import unittest

import comparison
import native
import obj_test

vtk_core = comparison.need("vtkmodules.vtkCommonCore", "python3-vtk9")
vtk_data = comparison.need("vtkmodules.vtkCommonDataModel", "python3-vtk9")
vtk_xml = comparison.need("vtkmodules.vtkIOXML", "python3-vtk9")
vtk_geometry = comparison.need("vtkmodules.vtkIOGeometry", "python3-vtk9")
vtk_surface = comparison.need("vtkmodules.vtkFiltersGeometry", "python3-vtk9")

POLY_LINE, LAGRANGE_TRIANGLE, BEZIER_CURVE, BEZIER_TRIANGLE = 4, 69, 75, 76
BEZIER, LAGRANGE = (BEZIER_TRIANGLE, BEZIER_CURVE), (LAGRANGE_TRIANGLE, POLY_LINE)
BOUNDARY, FEATURE = 1, 2  # edge_kind


class Grid:
    """A file as VTK has read it."""

    def __init__(self, path):
        reader = vtk_xml.vtkXMLUnstructuredGridReader()
        reader.SetFileName(path)
        reader.Update()
        self.grid = reader.GetOutput()
        self.cell = vtk_data.vtkGenericCell()
        self.current, self.points = -1, []
        self.domain = self.grid.GetPointData().GetArray("domain")
        kinds = self.grid.GetCellData().GetArray("edge_kind")
        self.types = [self.grid.GetCellType(k) for k in range(self.grid.GetNumberOfCells())]
        self.kinds = [int(kinds.GetTuple1(k)) for k in range(len(self.types))]

    def ids(self, k):
        """The cell's points; from here on it is the one that is evaluated."""
        if k != self.current:
            self.grid.GetCell(k, self.cell)
            self.current = k
            self.points = [self.cell.GetPointId(m) for m in range(self.cell.GetNumberOfPoints())]
        return self.points

    def evaluate(self, k, r, s):
        """The place of (r, s) in cell k, and the domain coordinates interpolated there."""
        ids = self.ids(k)
        place, weights = [0.0, 0.0, 0.0], [0.0] * len(ids)
        self.cell.EvaluateLocation(vtk_core.reference(0), (r, s, 0.0), place, weights)
        return tuple(place[:2]), native.combine(weights, [self.domain.GetTuple2(m) for m in ids])

    def inverse_jacobian(self, k, r, s):
        """Derivatives of u, v by x, y as VTK computes them."""
        values = [x for m in self.ids(k) for x in self.domain.GetTuple2(m)]
        out = [0.0] * 6
        self.cell.Derivatives(0, (r, s, 0.0), values, 2, out)
        return (out[0], out[1]), (out[3], out[4])


class Vtk(comparison.Comparison):
    def check_grid(self, path, types, result, domain=False):
        """Every cell evaluated; the area and the boundary's length of what VTK evaluates."""
        n = result.degree
        grid, (triangle_type, curve_type) = Grid(path), types
        count = len(result.triangles)
        self.assertEqual(grid.types[:count], count * [triangle_type])
        self.assertEqual(set(grid.types[count:]), {curve_type})
        expected = result.domain_point if domain else result.point
        extent = result.domain_extent if domain else result.extent
        area = 0.0
        for t in range(count):
            for r, s in result.references():
                place, uv = grid.evaluate(t, r, s)
                self.same_point(place, expected(t, r, s), extent, f"triangle {t}")
                self.same_point(uv, result.domain_point(t, r, s), result.domain_extent,
                                f"domain of triangle {t}")
            if not domain:
                net = self.evaluated_net(grid, t, n)
                area += native.net_area(net, n)
                self.check_dets(grid, t, net, result)
        if domain:
            return
        self.same_area(area, result)
        self.check_edges(grid, result)

    def evaluated_net(self, grid, t, n):
        """The control points of the polynomial that VTK evaluates."""
        values = [grid.evaluate(t, i / n, j / n)[0] for i, j in native.triangle_lattice(n)]
        return native.net_from_values(values, n)

    def check_dets(self, grid, t, net, result):
        for r, s in result.references():
            det = native.cross(*native.triangle_frame(net, result.degree, r, s))
            self.same_det(det / result.domain_det(t), result, t, r, s)
            # VTK 9.1's derivatives of Bezier cells write past their end.
            if grid.types[t] == LAGRANGE_TRIANGLE:
                inverse = native.cross(*grid.inverse_jacobian(t, r, s))
                self.same_det(1 / inverse, result, t, r, s)

    def check_edges(self, grid, result):
        n = result.degree
        lengths = {BOUNDARY: 0.0, FEATURE: 0.0}
        for k in range(len(result.triangles), len(grid.types)):
            if grid.kinds[k] in lengths:
                poles = native.poles_from_values(self.values_on_edge(grid, k, n))
                lengths[grid.kinds[k]] += native.curve_length(poles)
        self.same_boundary_length(lengths[BOUNDARY], result)
        features = sum(native.curve_length(result.curves[c], t0, t1)
                       for _, _, c, t0, t1 in result.features)
        self.same_measure(lengths[FEATURE], features, 4 * self.allowance(n) * result.extent,
                          "length of the features")

    def values_on_edge(self, grid, k, n):
        """At n + 1 places evenly apart: a polyline's own points."""
        if grid.types[k] == POLY_LINE:
            points = [grid.grid.GetPoint(m)[:2] for m in grid.ids(k)]
            self.assertEqual(len(points), n + 1)
            return points
        return [grid.evaluate(k, i / n, 0)[0] for i in range(n + 1)]

    # Of the way back from values to control points, and of VTK's products of distances.
    def allowance(self, degree):
        return 4.0**max(0, degree - 3)

    def test_bezier_cells(self):
        self.each_result(lambda r: self.check_grid(r.file(".vtu"), BEZIER, r))

    def test_lagrange_cells(self):
        self.each_result(lambda r: self.check_grid(r.file(".lagrange.vtu"), LAGRANGE, r))

    def test_domain_files(self):
        self.each_result(lambda r: self.check_grid(r.file(".domain.vtu"), BEZIER, r, True))
        self.each_result(lambda r: self.check_grid(r.file(".lagrange.domain.vtu"), LAGRANGE, r, True))

    def test_subdivided_surfaces(self):
        """What ParaView does to draw curves; with some cells VTK crashes there."""
        def check(result):
            triangles, pieces = len(result.triangles), 4 if result.degree > 1 else 1
            for ending in (".vtu", ".lagrange.vtu", ".domain.vtu", ".lagrange.domain.vtu"):
                surface = vtk_surface.vtkDataSetSurfaceFilter()
                surface.SetInputData(Grid(result.file(ending)).grid)
                for level in (0, 1, 3):
                    surface.SetNonlinearSubdivisionLevel(level)
                    surface.Update()
                    self.assertGreaterEqual(surface.GetOutput().GetNumberOfPolys(), triangles * pieces**level)

        self.each_result(check)

    def test_regions_and_exceptional_vertices(self):
        def check(result):
            data = Grid(result.file(".vtu")).grid.GetPointData().GetArray("exceptional")
            found = {k for k in range(data.GetNumberOfTuples()) if data.GetTuple1(k)}
            corner = {v: k for t in range(len(result.triangles))
                      for v, k in zip(result.triangles[t], result.corner_ids(t))}
            self.assertEqual(found, {corner[v] for v in result.exceptional})

        self.each_result(check)

    def test_swapped_points_are_noticed(self):
        """The comparison fails if two points of one cell trade places."""
        result = native.Native(comparison.folder() / "annulus.c1.json")

        def swap_points(path, a, b):
            def change(lines):
                at = next(k for k, line in enumerate(lines) if 'Name="connectivity"' in line) + 1
                words = lines[at].split()
                comparison.swap(words, a, b)
                lines[at] = " ".join(words)
            return self.spoiled(path, change)

        for ending, types in ((".vtu", BEZIER), (".lagrange.vtu", LAGRANGE)):
            path = result.file(ending)
            self.check_grid(path, types, result)
            for a, b in ((3, 4), (4, 5), (7, 8), (3, 9)):
                with self.assertRaises(AssertionError):
                    self.check_grid(swap_points(path, a, b), types, result)

        def relabel(lines):
            at = next(k for k, line in enumerate(lines) if 'Name="types"' in line) + 1
            while "</DataArray>" not in lines[at]:
                lines[at] = lines[at].replace("76", "69").replace("75", "4")
                at += 1

        # Control points taken for interpolation nodes draw another shape.
        spoiled = self.spoiled(result.file(".vtu"), relabel)
        with self.assertRaises(AssertionError):
            self.check_grid(spoiled, LAGRANGE, result)


class Obj(comparison.Comparison):
    def check(self, result):
        reader = vtk_geometry.vtkOBJReader()
        reader.SetFileName(result.file(".obj"))
        reader.Update()
        data = reader.GetOutput()
        uv = data.GetPointData().GetTCoords()
        expected = obj_test.Obj(result.file(".obj"))
        self.assertEqual(data.GetNumberOfCells(), len(expected.faces))
        self.assertEqual(data.GetNumberOfPoints(), len(expected.points))  # one per pair of v and vt
        for k in range(0, len(expected.faces), 17):
            cell = data.GetCell(k)
            for m, number in enumerate(expected.faces[k]):
                found = cell.GetPointId(m)
                self.same_float(data.GetPoint(found)[:2], expected.points[number], result.extent)
                self.same_float(uv.GetTuple2(found), expected.uv[number], result.domain_extent)

    def same_float(self, found, expected, extent):  # the reader works in floats
        for x, y in zip(found, expected):
            self.assertLessEqual(abs(x - y), 2.0**-22 * extent)

    def test_vtk_reads_it(self):
        self.each_result(self.check)


if __name__ == "__main__":
    unittest.main()
