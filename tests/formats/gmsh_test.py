# SPDX-License-Identifier: GPL-3.0-or-later
"""NAME.msh and NAME.domain.msh read back and evaluated by Gmsh."""

import unittest

import comparison
import native

gmsh = comparison.need("gmsh", "python3-gmsh")
HIGHEST_DEGREE = 10


class Mesh:
    """What Gmsh says of the open model."""

    def __init__(self, path, degree):
        gmsh.clear()
        gmsh.open(path)
        mesh = gmsh.model.mesh
        self.line = mesh.getElementType("Line", degree)
        self.triangle = mesh.getElementType("Triangle", degree)
        tags, coordinates, _ = mesh.getNodes()
        self.nodes = {int(tag): tuple(coordinates[3 * k:3 * k + 2]) for k, tag in enumerate(tags)}

    def elements(self, kind, tag=-1):
        """Lists of node tags."""
        size = gmsh.model.mesh.getElementProperties(kind)[3]
        _, nodes = gmsh.model.mesh.getElementsByType(kind, tag)
        nodes = [int(k) for k in nodes]
        return [nodes[k:k + size] for k in range(0, len(nodes), size)]

    def evaluate(self, kind, local, tag=-1):
        """Per element: (dets, points) at the local coordinates."""
        flat = [x for r, s in local for x in (r, s, 0)]
        _, dets, points = gmsh.model.mesh.getJacobians(kind, flat, tag)
        count = len(local)
        return [(list(dets[k:k + count]), [tuple(points[3 * m:3 * m + 2]) for m in range(k, k + count)])
                for k in range(0, len(dets), count)]

    def integral(self, kind, rule, tag=-1):
        points, weights = rule
        return sum(w * d for dets, _ in self.evaluate(kind, points, tag) for w, d in zip(weights, dets))

    def groups(self):
        """(dimension, name) -> entities."""
        return {(d, gmsh.model.getPhysicalName(d, tag)): list(gmsh.model.getEntitiesForPhysicalGroup(d, tag))
                for d, tag in gmsh.model.getPhysicalGroups()}


def triangle_rule(degree):
    """Gmsh's rule, as reference points and weights."""
    flat, weights = gmsh.model.mesh.getIntegrationPoints(2, f"Gauss{max(1, degree)}")
    return [(flat[k], flat[k + 1]) for k in range(0, len(flat), 3)], weights


def line_rule():
    """The rule that the lengths of native.py are computed with, on Gmsh's line from -1 to 1."""
    rule = native.gauss(native.LENGTH_POINTS)
    return [(2 * t - 1, 0) for t, _ in rule], [2 * w for _, w in rule]


class Gmsh(comparison.Comparison):
    @classmethod
    def setUpClass(cls):
        gmsh.initialize()
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.logger.start()

    @classmethod
    def tearDownClass(cls):
        gmsh.finalize()

    def check_triangles(self, path, domain_path, result):
        places = result.references()
        domain = Mesh(domain_path, result.degree)
        straight = domain.evaluate(domain.triangle, places)
        domain_elements = domain.elements(domain.triangle)
        shape = Mesh(path, result.degree)
        curved = shape.evaluate(shape.triangle, places)
        elements = shape.elements(shape.triangle)
        self.assertEqual(elements, domain_elements)
        triangle_of = result.by_corners()
        allowance = self.allowance(result.degree)
        seen = set()
        for nodes, (dets, points), (domain_dets, domain_points) in zip(elements, curved, straight):
            t = triangle_of[tuple(tag - 1 for tag in nodes[:3])]
            seen.add(t)
            for k, (r, s) in enumerate(places):
                self.same_point(points[k], result.point(t, r, s), result.extent, f"triangle {t}", allowance)
                self.same_point(domain_points[k], result.domain_point(t, r, s), result.domain_extent,
                                f"domain triangle {t}", allowance)
                self.same_det(dets[k] / domain_dets[k], result, t, r, s)
        self.assertEqual(len(seen), len(result.triangles))
        self.assertEqual(len(elements), len(result.triangles))
        if result.degree <= 8:  # beyond, Gmsh has no rule of degree 2n - 2
            self.same_area(shape.integral(shape.triangle, triangle_rule(2 * result.degree - 2)), result)
        return shape, domain

    # Gmsh inverts a matrix of monomials, whose condition grows about so with the degree.
    def allowance(self, degree):
        return 8.0**max(0, degree - 3)

    def test_geometry(self):
        self.each_result(lambda r: self.check_triangles(r.file(".msh"), r.file(".domain.msh"), r),
                         HIGHEST_DEGREE)

    def test_curves_regions_and_exceptional_vertices(self):
        self.each_result(self.check_groups, HIGHEST_DEGREE)

    def check_groups(self, result):
        shape = Mesh(result.file(".msh"), result.degree)
        groups = shape.groups()
        lengths = result.curve_lengths()
        named = {name for d, name in groups if d == 1}
        self.assertEqual(named, {f"curve {k}" for k in lengths})
        for curve, length in lengths.items():
            entity, = groups[1, f"curve {curve}"]
            found = shape.integral(shape.line, line_rule(), entity)
            self.same_measure(found, length, self.allowance(result.degree) * result.extent,
                              f"length of curve {curve}")
            # Along the curve: the first element starts where the covered part does.
            elements = shape.elements(shape.line, entity)
            starts = [min(t0, t1) for _, _, k, t0, t1 in result.boundary + result.features if k == curve]
            self.same_point(shape.nodes[elements[0][0]],
                            native.curve_point(result.curves[curve], min(starts)), result.extent,
                            f"start of curve {curve}")
        edges = len(result.boundary) + len(result.features)
        self.assertEqual(len(shape.elements(shape.line)), edges)
        total = sum(shape.integral(shape.line, line_rule(), entity)
                    for (d, name), (entity, *_) in groups.items()
                    if d == 1 and int(name.split()[1]) in {e[2] for e in result.boundary})
        self.same_boundary_length(total, result)
        self.check_exceptional(groups, result)
        regions = [entities for (d, _), entities in groups.items() if d == 2]
        self.assertEqual(sorted(e for entities in regions for e in entities),
                         sorted(tag for _, tag in gmsh.model.getEntities(2)))

    def check_exceptional(self, groups, result):
        corner_node = {v: k for t in range(len(result.triangles))
                       for v, k in zip(result.triangles[t], result.corner_ids(t))}
        nodes = set()
        for entity in groups.get((0, "exceptional"), []):
            _, _, tags = gmsh.model.mesh.getElements(0, entity)
            nodes.update(int(tag) for tag in tags[0])
        self.assertEqual(nodes, {corner_node[v] + 1 for v in result.exceptional})

    def test_the_surfaces_boundary_closes(self):
        """Following the signs: each curve starts where another of the boundary ended."""
        self.each_result(self.check_surfaces, HIGHEST_DEGREE)

    def check_surfaces(self, result):
        gmsh.clear()
        gmsh.open(result.file(".msh"))
        for _, surface in gmsh.model.getEntities(2):
            curves = gmsh.model.getBoundary([(2, surface)], oriented=True)
            starts, ends = [], []
            for _, curve in curves:
                points = [tag for _, tag in gmsh.model.getBoundary([(1, abs(curve))], combined=False)]
                if curve < 0:
                    points.reverse()
                starts.append(points[0])
                ends.append(points[-1])
            self.assertEqual(sorted(starts), sorted(ends))
            self.assertGreater(len(starts), 0)

    def test_the_view_holds_the_domain(self):
        self.each_result(self.check_view, HIGHEST_DEGREE)

    def check_view(self, result):
        domain = Mesh(result.file(".domain.msh"), result.degree)
        shape = Mesh(result.file(".msh"), result.degree)
        view, = gmsh.view.getTags()
        kind, tags, values, _, components = gmsh.view.getModelData(view, 0)
        self.assertEqual((kind, components), ("NodeData", 3))
        self.assertEqual(sorted(shape.nodes), sorted(int(tag) for tag in tags))
        for tag, value in zip(tags, values):
            self.assertEqual(tuple(value[:2]), domain.nodes[int(tag)])
        # Interpolated with the element's own functions, as Gmsh draws it: the domain's own triangle.
        value = {int(tag): tuple(v[:2]) for tag, v in zip(tags, values)}
        places = result.references()
        flat = [x for r, s in places for x in (r, s, 0)]
        _, functions, _ = gmsh.model.mesh.getBasisFunctions(shape.triangle, flat, "Lagrange")
        triangle_of = result.by_corners()
        for nodes in shape.elements(shape.triangle):
            t = triangle_of[tuple(tag - 1 for tag in nodes[:3])]
            for k, (r, s) in enumerate(places):
                weights = functions[k * len(nodes):(k + 1) * len(nodes)]
                self.same_point(native.combine(weights, [value[tag] for tag in nodes]),
                                result.domain_point(t, r, s), result.domain_extent,
                                f"view in triangle {t}", self.allowance(result.degree))

    def test_nothing_was_warned_of(self):
        def check(result):
            gmsh.logger.stop()
            gmsh.logger.start()
            for ending in (".msh", ".domain.msh"):
                gmsh.clear()
                gmsh.open(result.file(ending))
            self.assertEqual([line for line in gmsh.logger.get() if not line.startswith("Info")], [])

        self.each_result(check, HIGHEST_DEGREE)

    def test_swapped_nodes_are_noticed(self):
        """The comparison fails if two nodes of one element trade places."""
        result = native.Native(comparison.folder() / "annulus.c1.json")

        def swap_nodes(a, b):
            def change(lines):
                start = lines.index("$Elements")
                size = (result.degree + 1) * (result.degree + 2) // 2
                at = next(k for k in range(start, len(lines)) if len(lines[k].split()) == size + 1)
                words = lines[at].split()
                comparison.swap(words, a, b)
                lines[at] = " ".join(words)
            return self.spoiled(result.file(".msh"), change)

        for a, b in ((4, 5), (5, 6), (8, 9), (4, 10)):
            spoiled = swap_nodes(a, b)
            self.check_triangles(result.file(".msh"), result.file(".domain.msh"), result)
            with self.assertRaises(AssertionError):
                self.check_triangles(spoiled, result.file(".domain.msh"), result)
            # Alike in both files, the map is still another one.
            with self.assertRaises(AssertionError):
                self.check_triangles(spoiled, spoiled, result)


if __name__ == "__main__":
    unittest.main()
