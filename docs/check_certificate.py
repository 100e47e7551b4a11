#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks a certificate against its result in exact rational arithmetic (docs/certificate.md).

usage: docs/check_certificate.py RESULT.c1.json CERTIFICATE.json

A second implementation on purpose: it shares nothing with the program, not even the arithmetic, and is
written for reading. Every double is taken as the fraction it is; no bound is compared in floating point.
It checks the mesh, the orientation of the domain and every entry of the certificate. Exit status: 0 if all
holds, 1 if anything does not, with a line for each fault; 2 if a file cannot be used.
"""

import json
import math
import sys
from fractions import Fraction
from math import factorial

DEEPER = 6  # splits beyond the certificate's where other directions than the program's are tried


def net_index(n, i, j):
    """Position of p_ij in a net of degree n (docs/format.md)."""
    return j * (n + 1) - j * (j - 1) // 2 + i


def indices(n):
    return [(i, j) for j in range(n + 1) for i in range(n + 1 - j)]


def multinomial(n, i, j):
    return factorial(n) // (factorial(i) * factorial(j) * factorial(n - i - j))


def exact(point):
    return (Fraction(point[0]), Fraction(point[1]))


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1])


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def product_form(m, value):
    """Bernstein coefficients of degree 2m of the sum of value(a, b) B_a B_b, a and b of degree m."""
    out = [Fraction(0)] * len(indices(2 * m))
    for a, (i, j) in enumerate(indices(m)):
        for b, (k, l) in enumerate(indices(m)):
            out[net_index(2 * m, i + k, j + l)] += (
                multinomial(m, i, j) * multinomial(m, k, l) * value(a, b))
    return [c / multinomial(2 * m, i, j) for c, (i, j) in zip(out, indices(2 * m))]


def halves(n, form):
    """The form over (2, 0, m) and (1, 2, m), m the middle of edge 01."""
    first, second = list(form), list(form)
    for j in range(n + 1):
        row = [form[net_index(n, i, j)] for i in range(n - j + 1)]
        for level in range(n - j + 1):
            rest = n - j - level
            first[net_index(n, rest, level)] = row[0]
            second[net_index(n, j, level)] = row[rest]
            row = [(row[i] + row[i + 1]) / 2 for i in range(rest)]
    return first, second


class Checker:
    def __init__(self, result, certificate):
        self.result, self.certificate = result, certificate
        self.n = result["degree"]
        self.control = [exact(p) for p in result["control_points"]]
        self.domain = [exact(p) for p in result["domain_vertices"]]
        self.faults = []

    def want(self, holds, message):
        if not holds:
            self.faults.append(message)

    def check(self):
        self.header()
        self.mesh()
        if not self.faults:
            self.triangles()
            self.edges()
            self.curve_edges()
            self.boundary()
        return self.faults

    def header(self):
        poles = [p for curve in self.result["curves"] for p in curve["poles"]]
        sides = [max(p[k] for p in poles) - min(p[k] for p in poles) for k in range(2)]
        c = self.certificate
        self.want(c["format"] == "c1mesh-certificate" and c["version"] == 1, "unknown format")
        self.want(c["degree"] == self.n, "another degree")
        self.want(c["extent"] == max(sides), f"the extent is {max(sides)!r}, not {c['extent']!r}")
        self.want(len(c["triangles"]) == len(self.result["triangles"]), "another number of triangles")
        self.want(all(item[1] == "valid" for item in c["items"]), "an item is not valid")
        self.extent = Fraction(c["extent"])
        bounds = c["bounds"]
        self.want(all(bounds["det"] <= t[1] for t in c["triangles"]), "bounds.det is no bound")
        self.want(all(t[2] is not None and bounds["g"] >= t[2] for t in c["triangles"]),
                  "bounds.g is no bound")
        self.want(all(bounds["c1"] >= e[2] for e in c["edges"]), "bounds.c1 is no bound")
        self.want(all(bounds["conformance"] >= e[2] for e in c["curve_edges"]),
                  "bounds.conformance is no bound")

    # -- the mesh ------------------------------------------------------------------------------

    def row(self, t, corner, depth):
        """Control point ids of triangle t along the edge from `corner`, `depth` rows away from it."""
        out = []
        for s in range(self.n + 1 - depth):
            exponent = [0, 0, 0]
            exponent[corner] = self.n - s - depth
            exponent[(corner + 1) % 3] = s
            exponent[(corner + 2) % 3] = depth
            net = self.result["triangle_control_points"][t]
            out.append(net[net_index(self.n, exponent[1], exponent[2])])
        return out

    def mesh(self):
        self.side = {}  # directed edge -> (triangle, corner)
        for t, corners in enumerate(self.result["triangles"]):
            a, b, c = (self.domain[v] for v in corners)
            self.want(cross(minus(b, a), minus(c, a)) > 0, f"domain triangle {t} is not counter-clockwise")
            for k in range(3):
                edge = (corners[k], corners[(k + 1) % 3])
                self.want(edge not in self.side, f"the edge {edge} has two triangles on one side")
                self.side[edge] = (t, k)
        for (a, b), (t, k) in self.side.items():
            if (b, a) in self.side:
                other = self.row(*self.side[(b, a)], 0)
                self.want(self.row(t, k, 0) == other[::-1], f"the edge {(a, b)} is not shared")
        self.loop_edges = {edge for edge in self.side if edge[::-1] not in self.side}
        listed = {(e[0], e[1]) for e in self.result["boundary_edges"]}
        self.want(listed == self.loop_edges, "the boundary edges are not those of the mesh")
        self.winding()

    def winding(self):
        on_boundary = {v for edge in self.loop_edges for v in edge}
        turns = {}
        for corners in self.result["triangles"]:
            for k in range(3):
                v, a, b = corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]
                up = self.domain[a][1] <= self.domain[v][1] < self.domain[b][1]
                turns[v] = turns.get(v, 0) + up
        for v, count in turns.items():
            self.want(v in on_boundary or count == 1, f"vertex {v} is wound {count} times")

    # -- triangles -----------------------------------------------------------------------------

    def forms(self, t):
        n, net = self.n, [self.control[id] for id in self.result["triangle_control_points"][t]]
        p0, p1, p2 = (self.domain[v] for v in self.result["triangles"][t])
        u, v = minus(p1, p0), minus(p2, p0)
        columns = []
        for i, j in indices(n - 1):
            start = net[net_index(n, i, j)]
            du = minus(net[net_index(n, i + 1, j)], start)
            dv = minus(net[net_index(n, i, j + 1)], start)
            columns.append(((n * du[0], n * du[1]), (n * dv[0], n * dv[1])))
        det = product_form(n - 1, lambda a, b: cross(columns[a][0], columns[b][1]))
        rows = [[(c[0][k] * v[1] - c[1][k] * u[1], c[1][k] * u[0] - c[0][k] * v[0]) for k in range(2)]
                for c in columns]
        norm = product_form(n - 1, lambda a, b: sum(
            rows[a][k][s] * rows[b][k][s] for k in range(2) for s in range(2)))
        return det, norm, cross(u, v)

    def triangles(self):
        for t, entry in enumerate(self.certificate["triangles"]):
            marks = iter(entry[3] if len(entry) > 3 and entry[3] else "0")
            det, norm, frame = self.forms(t)
            reached = self.pieces(entry, marks, det, norm, frame, 0)
            self.want(reached == entry[0] and next(marks, None) is None,
                      f"triangle {t}: its proof does not show det J >= {entry[1]!r}, g <= {entry[2]!r}")

    def pieces(self, entry, marks, det, norm, frame, depth):
        """The deepest piece, None if the proof fails."""
        mark = next(marks, None)
        if mark == "1":
            deepest = depth
            for pair in zip(halves(2 * self.n - 2, det), halves(2 * self.n - 2, norm)):
                reached = self.pieces(entry, marks, *pair, frame, depth + 1)
                if reached is None:
                    return None
                deepest = max(deepest, reached)
            return deepest
        least, most = min(det), max(norm)
        holds = (mark == "0" and least > 0 and least >= Fraction(entry[1]) * frame
                 and entry[2] is not None and most <= Fraction(entry[2]) * frame * least)
        return depth if holds else None

    # -- edges ---------------------------------------------------------------------------------

    def edges(self):
        left_out = {tuple(sorted(e[:2])) for e in self.result["relaxed_edges"]}
        left_out |= {tuple(sorted(e[:2])) for e in self.result["feature_edges"]}
        asked = sorted(e for e in self.side if e[0] < e[1] and e[::-1] in self.side
                       and e not in left_out)
        listed = [(e[0], e[1]) for e in self.certificate["edges"]]
        self.want(listed == asked, "the edges are not those where C1 is asked")
        for a, b, bound in self.certificate["edges"]:
            if (a, b) in asked and bound is not None:
                for edge in ((a, b), (b, a)):
                    square = self.defect_squared(edge)
                    self.want(square <= (Fraction(bound) * self.extent) ** 2,
                              f"edge {edge} deviates by more than {bound!r}")

    def defect_squared(self, edge):
        """The largest |p'_1i - (g0 p_0i + g1 p_0(i+1) + g2 p_1i)|^2 of the edge in this orientation."""
        (t, k), (r, l) = self.side[edge], self.side[edge[::-1]]
        v0, v1 = (self.domain[v] for v in edge)
        v2 = self.domain[self.result["triangles"][t][(k + 2) % 3]]
        v3 = self.domain[self.result["triangles"][r][(l + 2) % 3]]
        area = lambda a, b, c: cross(minus(b, a), minus(c, a))
        whole = area(v0, v1, v2)
        gamma = [area(v3, v1, v2) / whole, area(v0, v3, v2) / whole, area(v0, v1, v3) / whole]
        on = [self.control[id] for id in self.row(t, k, 0)]
        near = [self.control[id] for id in self.row(t, k, 1)]
        far = [self.control[id] for id in self.row(r, l, 1)][::-1]
        squares = []
        for i in range(self.n):
            residual = [far[i][s] - gamma[0] * on[i][s] - gamma[1] * on[i + 1][s] - gamma[2] * near[i][s]
                        for s in range(2)]
            squares.append(residual[0] ** 2 + residual[1] ** 2)
        return max(squares)

    def restricted(self, curve, t0, t1):
        """Control points of the curve over [t0, t1] raised to degree n: its blossom at t0 and t1."""
        poles = [exact(p) for p in self.result["curves"][curve]["poles"]]
        d = len(poles) - 1

        def blossom(arguments):
            row = poles
            for t in arguments:
                row = [tuple((1 - t) * a[k] + t * b[k] for k in range(2)) for a, b in zip(row, row[1:])]
            return row[0]

        points = [blossom([t0] * (d - i) + [t1] * i) for i in range(d + 1)]
        while len(points) <= self.n:
            m = len(points)
            points = [tuple(Fraction(i, m) * points[i - 1][k] + Fraction(m - i, m) * points[i % m][k]
                            for k in range(2)) for i in range(m + 1)]
        return points

    def curve_edges(self):
        edges = self.result["boundary_edges"] + self.result["feature_edges"]
        listed = self.certificate["curve_edges"]
        self.want([e[:2] for e in edges] == [e[:2] for e in listed], "the curve edges are not the result's")
        for (a, b, curve, t0, t1), (_, _, bound) in zip(edges, listed):
            ids = (self.row(*self.side[(a, b)], 0) if (a, b) in self.side
                   else self.row(*self.side[(b, a)], 0)[::-1])
            places = self.restricted(curve, Fraction(t0), Fraction(t1))
            for id, place in zip(ids, places):
                off = minus(self.control[id], place)
                self.want(off[0] ** 2 + off[1] ** 2 <= (Fraction(bound) * self.extent) ** 2,
                          f"control point {id} is further than {bound!r} from curve {curve}")

    # -- the boundary --------------------------------------------------------------------------

    def boundary(self):
        rows = {edge: [self.control[id] for id in self.row(*self.side[edge], 0)]
                for edge in self.loop_edges}
        given = {tuple(p[:4]): p[4] for p in self.certificate["boundary"]}
        pairs = [(e, e) for e in rows] + meeting_boxes(rows)
        for e, f in pairs:
            key = e + f if e + f in given else f + e
            if key == f + e:
                e, f = f, e
            marks = iter(given.pop(key, "0"))
            self.want(compare(e, f, rows, marks) and next(marks, None) is None,
                      f"the edges {e} and {f} are not proven to keep apart")
        for key in given:
            self.faults.append(f"the pair {key} needs no proof")


def meeting_boxes(rows):
    """Pairs of different edges whose boxes meet."""
    boxes = sorted((min(p[0] for p in row), max(p[0] for p in row), min(p[1] for p in row),
                    max(p[1] for p in row), edge) for edge, row in rows.items())
    out, open_boxes = [], []
    for box in boxes:
        open_boxes = [o for o in open_boxes if o[1] >= box[0]]
        out += [(o[4], box[4]) for o in open_boxes if o[2] <= box[3] and o[3] >= box[2]]
        open_boxes.append(box)
    return out


def compare(e, f, rows, marks):
    a, b = rows[e], rows[f]
    if e == f:
        return by_itself(a, marks)
    if e == f[::-1]:
        return next(marks, None) == "1" and both_ends(a, b[::-1], marks)
    if e[1] == f[0]:
        return common_start(a[::-1], b, marks)
    if e[0] == f[1]:
        return common_start(a, b[::-1], marks)
    return no_common_end(a, b, marks)


def split(curve):
    first, second, row = [], [], list(curve)
    while row:
        first.append(row[0])
        second.append(row[-1])
        row = [tuple((a[k] + b[k]) / 2 for k in range(2)) for a, b in zip(row, row[1:])]
    return first, second[::-1]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def unit(v):
    """A direction near that of v; any will do, for what is shown with it is shown exactly."""
    x, y = float(v[0]), float(v[1])
    length = math.hypot(x, y)
    return (Fraction(x / length), Fraction(y / length)) if length > 0 else (Fraction(0), Fraction(0))


def tangent(curve):
    return next((unit(minus(p, curve[0])) for p in curve if p != curve[0]), (Fraction(0), Fraction(0)))


def chord(curve):
    return unit(minus(curve[-1], curve[0]))


def walk(marks, holds, parts, depth=0):
    """A proof by its marks; beyond them `holds` may need up to DEEPER splits more."""
    mark = next(marks, None)
    if mark == "1":
        return all(part(marks) for part in parts())
    return mark == "0" and (holds() or (depth < DEEPER and all(
        part(iter("0"), depth + 1) for part in parts())))


def no_common_end(a, b, marks, depth=0):
    def holds():
        turned = [(-chord(c)[1], chord(c)[0]) for c in (a, b)]
        ends = [unit(minus(b[0], a[0])), unit(minus(b[-1], a[-1]))]
        for d in [(Fraction(1), Fraction(0)), (Fraction(0), Fraction(1))] + turned + ends:
            x, y = [dot(p, d) for p in a], [dot(p, d) for p in b]
            if max(x) < min(y) or max(y) < min(x):
                return True
        return False

    def parts():
        pa, pb = split(a), split(b)
        return [lambda m, k=0, i=i, j=j: no_common_end(pa[i], pb[j], m, k) for i in (0, 1) for j in (0, 1)]
    return walk(marks, holds, parts, depth)


def common_start(a, b, marks, depth=0):
    def holds():
        ta, tb, ca, cb = tangent(a), tangent(b), chord(a), chord(b)
        for d in (minus(tb, ta), minus(cb, ca)):
            x = [dot(minus(p, a[0]), d) for p in a[1:] if p != a[0]]
            y = [dot(minus(p, b[0]), d) for p in b[1:] if p != b[0]]
            if x and y and max(x) < 0 < min(y):
                return True
        return False

    def parts():
        pa, pb = split(a), split(b)
        return [lambda m, k=0: common_start(pa[0], pb[0], m, k)] + [
            lambda m, k=0, i=i, j=j: no_common_end(pa[i], pb[j], m, k) for i, j in ((0, 1), (1, 0), (1, 1))]
    return walk(marks, holds, parts, depth)


def both_ends(a, b, marks):
    pa, pb = split(a), split(b)
    return (common_start(pa[0], pb[0], marks) and no_common_end(pa[0], pb[1], marks)
            and no_common_end(pa[1], pb[0], marks)
            and common_start(pa[1][::-1], pb[1][::-1], marks))


def by_itself(curve, marks, depth=0):
    def holds():
        for d in (chord(curve), minus(tangent(curve), tangent(curve[::-1]))):
            steps = [dot(minus(q, p), d) for p, q in zip(curve, curve[1:]) if p != q]
            if steps and min(steps) > 0:
                return True
        return False

    def parts():
        first, second = split(curve)
        return [lambda m, k=0: by_itself(first, m, k), lambda m, k=0: by_itself(second, m, k),
                lambda m, k=0: common_start(first[::-1], second, m, k)]
    return walk(marks, holds, parts, depth)


def main(arguments):
    if len(arguments) != 2:
        print(__doc__.split("\n\n")[1], file=sys.stderr)
        return 2
    try:
        result, certificate = (json.load(open(path, encoding="utf-8")) for path in arguments)
        faults = Checker(result, certificate).check()
    except (OSError, ValueError, KeyError, IndexError, TypeError) as error:
        print(f"cannot be checked: {error!r}", file=sys.stderr)
        return 2
    for fault in faults[:20]:
        print(fault, file=sys.stderr)
    if not faults:
        bounds = certificate["bounds"]
        print(f"{len(certificate['triangles'])} triangles, det J >= {bounds['det']:.6g}, "
              f"g <= {bounds['g']:.6g}, C1 to {bounds['c1']:.3g}, conformance {bounds['conformance']:.3g}: "
              "all proofs hold")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
