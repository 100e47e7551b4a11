# SPDX-License-Identifier: GPL-3.0-or-later
"""A result as NAME.c1.json defines it, evaluated without the program: what every reader of another
format must reproduce. Plain Python, doubles.

Reference coordinates are (r, s): corner a at (0, 0), b at (1, 0), c at (0, 1)."""

import fractions
import functools
import json
import math
import pathlib
import random


def binomial(n, i):
    return math.comb(n, i)


def triangle_lattice(n):
    """(i, j) of p_ij as the result file has them: for j: for i."""
    return [(i, j) for j in range(n + 1) for i in range(n + 1 - j)]


def recursive_order(n):
    """(i, j) in the order of Gmsh and VTK, written down from their manuals: vertices, edges, then a
    triangle of order n - 3 inside."""
    if n < 0:
        return []
    if n == 0:
        return [(0, 0)]
    out = [(0, 0), (n, 0), (0, n)]
    out += [(k, 0) for k in range(1, n)]
    out += [(n - k, k) for k in range(1, n)]
    out += [(0, n - k) for k in range(1, n)]
    return out + [(i + 1, j + 1) for i, j in recursive_order(n - 3)]


@functools.lru_cache(maxsize=None)
def bernstein_triangle(n, r, s):
    """Values of the Bernstein polynomials at (r, s), in lattice order."""
    q = 1 - r - s
    return tuple(binomial(n, j) * binomial(n - j, i) * r**i * s**j * q**(n - i - j)
                 for i, j in triangle_lattice(n))


@functools.lru_cache(maxsize=None)
def bernstein(n, t):
    return tuple(binomial(n, i) * t**i * (1 - t)**(n - i) for i in range(n + 1))


def combine(weights, points):
    return (sum(w * p[0] for w, p in zip(weights, points)),
            sum(w * p[1] for w, p in zip(weights, points)))


def triangle_point(net, n, r, s):
    return combine(bernstein_triangle(n, r, s), net)


@functools.lru_cache(maxsize=None)
def _neighbours(n):
    """Where p_ij, p_(i+1)j and p_i(j+1) stand in the net, for i + j < n."""
    at = {ij: k for k, ij in enumerate(triangle_lattice(n))}
    return tuple((at[i, j], at[i + 1, j], at[i, j + 1]) for i, j in triangle_lattice(n - 1))


def triangle_frame(net, n, r, s):
    """The derivatives by r and by s."""
    first, second = [], []
    for p, a, b in _neighbours(n):
        first.append((n * (net[a][0] - net[p][0]), n * (net[a][1] - net[p][1])))
        second.append((n * (net[b][0] - net[p][0]), n * (net[b][1] - net[p][1])))
    weights = bernstein_triangle(n - 1, r, s)
    return combine(weights, first), combine(weights, second)


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def curve_point(poles, t):
    return combine(bernstein(len(poles) - 1, t), poles)


def curve_derivative(poles, t):
    n = len(poles) - 1
    return curve_point([(n * (b[0] - a[0]), n * (b[1] - a[1])) for a, b in zip(poles, poles[1:])], t)


@functools.lru_cache(maxsize=None)
def gauss(count):
    """Gauss-Legendre points and weights on [0, 1]: exact up to degree 2 count - 1."""
    out = []
    for k in range(count):
        x = math.cos(math.pi * (k + 0.75) / (count + 0.5))
        for _ in range(100):
            p, before = x, 1.0
            for m in range(2, count + 1):
                p, before = ((2 * m - 1) * x * p - (m - 1) * before) / m, p
            slope = count * (x * p - before) / (x * x - 1)
            x -= p / slope
            if abs(p / slope) < 1e-16:
                break
        out.append((0.5 + 0.5 * x, 1 / ((1 - x * x) * slope * slope)))
    return tuple(out)


LENGTH_POINTS = 12  # the same in every length that is compared: the integrand is no polynomial


def curve_length(poles, start=0.0, end=1.0):
    return sum(w * abs(end - start) * math.hypot(*curve_derivative(poles, start + t * (end - start)))
               for t, w in gauss(LENGTH_POINTS))


def _inverse(rows):
    """Inverse of a matrix of fractions, as floats: Bareiss' elimination, in integers."""
    size = len(rows)
    scale = math.lcm(*(fractions.Fraction(x).denominator for row in rows for x in row))
    work = [[int(x * scale) for x in row] + [scale * int(i == k) for k in range(size)]
            for i, row in enumerate(rows)]
    before = 1
    for k in range(size):
        pivot = next(r for r in range(k, size) if work[r][k])
        work[k], work[pivot] = work[pivot], work[k]
        top, lead = work[k], work[k][k]
        for r in range(size):
            if r != k:
                factor = work[r][k]
                work[r] = [(lead * x - factor * y) // before for x, y in zip(work[r], top)]
        before = lead
    return [[x / before for x in row[size:]] for row in work]


@functools.lru_cache(maxsize=None)
def _from_lattice(n):
    parts = [fractions.Fraction(i, n) for i in range(n + 1)]
    return _inverse([bernstein_triangle(n, parts[i], parts[j]) for i, j in triangle_lattice(n)])


@functools.lru_cache(maxsize=None)
def _from_line(n):
    return _inverse([bernstein(n, fractions.Fraction(k, n)) for k in range(n + 1)])


def net_from_values(values, n):
    """The net of the polynomial with these values at the lattice points, both in lattice order."""
    return [combine(row, values) for row in _from_lattice(n)]


def poles_from_values(values):
    """The poles of the curve with these values at 0, 1/n, …, 1."""
    return [combine(row, values) for row in _from_line(len(values) - 1)]


@functools.lru_cache(maxsize=None)
def _side(n, k):
    at = {ij: m for m, ij in enumerate(triangle_lattice(n))}
    return tuple(at[[(i, 0), (n - i, i), (0, n - i)][k]] for i in range(n + 1))


def edge_of_net(net, n, k):
    """The poles of the side from corner k to k + 1."""
    return [net[m] for m in _side(n, k)]


@functools.lru_cache(maxsize=None)
def _area_weights(n):
    """Of cross(p_i, p_j), i < j, in half the integral of x dy - y dx along a curve: by B_i B_j' - B_i'
    B_j, whose degree the quadrature integrates exactly."""
    def derivative(i, t):
        lower = bernstein(n - 1, t)
        return n * ((lower[i - 1] if i > 0 else 0.0) - (lower[i] if i < n else 0.0))

    def wronskian(i, j, t):
        return bernstein(n, t)[i] * derivative(j, t) - bernstein(n, t)[j] * derivative(i, t)

    return tuple((i, j, sum(0.5 * w * wronskian(i, j, t) for t, w in gauss(n + 1)))
                 for i in range(n + 1) for j in range(i + 1, n + 1))


def net_area(net, n):
    """The integral of det: half of x dy - y dx around the triangle."""
    area = 0.0
    for k in range(3):
        poles = edge_of_net(net, n, k)
        area += sum(w * cross(poles[i], poles[j]) for i, j, w in _area_weights(n))
    return area


class Native:
    def __init__(self, path):
        self.name = pathlib.Path(path).name[:-len(".c1.json")]
        self.folder = pathlib.Path(path).parent
        data = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
        self.degree = data["degree"]
        self.triangles = data["triangles"]
        self.ids = data["triangle_control_points"]
        self.control_points = data["control_points"]
        self.domain_vertices = data["domain_vertices"]
        self.exceptional = data["exceptional_vertices"]
        self.boundary = data["boundary_edges"]
        self.features = data["feature_edges"]
        self.curves = [[tuple(p) for p in c["poles"]] for c in data["curves"]]
        xs, ys = zip(*self.control_points)
        # Coordinates far from the origin round by their size.
        self.extent = max(max(map(abs, xs)), max(map(abs, ys)))
        us, vs = zip(*self.domain_vertices)
        self.domain_extent = max(max(map(abs, us)), max(map(abs, vs)))

    def file(self, ending):
        return str(self.folder / (self.name + ending))

    def net(self, t):
        return [self.control_points[k] for k in self.ids[t]]

    def corner_ids(self, t):
        n = self.degree
        return self.ids[t][0], self.ids[t][n], self.ids[t][-1]

    def by_corners(self):
        """Corner control point ids -> triangle."""
        return {self.corner_ids(t): t for t in range(len(self.triangles))}

    def domain_corners(self, t):
        return [self.domain_vertices[v] for v in self.triangles[t]]

    def domain_point(self, t, r, s):
        return combine((1 - r - s, r, s), self.domain_corners(t))

    def domain_det(self, t):
        a, b, c = self.domain_corners(t)
        return cross((b[0] - a[0], b[1] - a[1]), (c[0] - a[0], c[1] - a[1]))

    def point(self, t, r, s):
        return triangle_point(self.net(t), self.degree, r, s)

    def frame(self, t, r, s):
        return triangle_frame(self.net(t), self.degree, r, s)

    def det(self, t, r, s):
        """det J of the map from the domain."""
        return cross(*self.frame(t, r, s)) / self.domain_det(t)

    def det_tolerance(self, t, r, s):
        """How far rounding may move det(t, r, s): coordinates are off by a few units of rounding of
        the extent, derivatives by that times n^2; the domain likewise."""
        a, b = self.frame(t, r, s)
        unit = 64 * 2.0**-52 * self.degree**2
        corners = self.domain_corners(t)
        longest = max(math.dist(p, q) for p in corners for q in corners)
        det = self.domain_det(t)
        return (unit * self.extent * (math.hypot(*a) + math.hypot(*b) + unit * self.extent)
                + abs(cross(a, b) / det) * unit * self.domain_extent * 2 * longest) / abs(det)

    @functools.cached_property
    def area(self):
        return sum(net_area(self.net(t), self.degree) for t in range(len(self.triangles)))

    def curve_lengths(self):
        """Curve -> length of what edges cover of it, from the input curve itself."""
        out = {}
        for _, _, curve, t0, t1 in self.boundary + self.features:
            out[curve] = out.get(curve, 0.0) + curve_length(self.curves[curve], t0, t1)
        return out

    def boundary_length(self):
        return sum(curve_length(self.curves[curve], t0, t1) for _, _, curve, t0, t1 in self.boundary)

    def references(self, count=3):
        """Some places in the reference triangle, other ones for each shape, the same in each run."""
        chosen = random.Random(self.name)
        out = []
        while len(out) < count:
            r, s = chosen.random(), chosen.random()
            if r + s < 1:
                out.append((r, s))
        return out


def all_results(folder):
    return [Native(path) for path in sorted(pathlib.Path(folder).glob("*.c1.json"))]
