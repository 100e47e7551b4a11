// SPDX-License-Identifier: GPL-3.0-or-later
// Hand-made results: a polynomial map over a triangulated polygon, blossomed triangle by triangle.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "c1mesh/result.h"

namespace c1mesh::example {

/// One term c x^a y^b of a map: `value` is its coefficient in the plane.
struct Term {
  int a, b;
  Point value;
};
using Polynomial = std::vector<Term>;

inline double factorial(int k) {
  return k < 2 ? 1 : k * factorial(k - 1);
}

/// The blossom of a polynomial of degree <= n at n points: that of x^a y^b is the coefficient of
/// X^a Y^b in the product of (1 + X x_i + Y y_i), over n! / (a! b! (n-a-b)!).
inline Point blossom(const Polynomial& map, const std::vector<Point>& at) {
  const int n = static_cast<int>(at.size());
  std::map<std::pair<int, int>, double> product{{{0, 0}, 1.0}};
  for (const Point& p : at) {
    std::map<std::pair<int, int>, double> next;
    for (const auto& [power, c] : product) {
      next[power] += c;
      next[{power.first + 1, power.second}] += c * p.x();
      next[{power.first, power.second + 1}] += c * p.y();
    }
    product = next;
  }
  Point sum = Point::Zero();
  for (const Term& term : map)
    sum += term.value * (product[{term.a, term.b}] * factorial(term.a) * factorial(term.b) *
                         factorial(n - term.a - term.b) / factorial(n));
  return sum;
}

inline Point evaluate(const Polynomial& map, const Point& p) {
  Point sum = Point::Zero();
  for (const Term& t : map) sum += t.value * std::pow(p.x(), t.a) * std::pow(p.y(), t.b);
  return sum;
}

inline Polynomial identity() {
  return {{1, 0, Point(1, 0)}, {0, 1, Point(0, 1)}};
}

/// Collects control points: each location (which vertices with which weights) is stored once.
class ControlPoints {
 public:
  int id(Result& result, const Polynomial& map, const std::array<int, 3>& t, int i, int j) {
    const int n = result.degree;
    std::map<int, int> weight;
    if (n - i - j) weight[t[0]] += n - i - j;
    if (i) weight[t[1]] += i;
    if (j) weight[t[2]] += j;
    const auto [entry, fresh] =
        ids_.emplace(weight, static_cast<int>(result.control_points.size()));
    if (fresh) {
      std::vector<Point> at;
      for (const auto& [v, count] : weight) at.insert(at.end(), count, result.domain_vertices[v]);
      result.control_points.push_back(blossom(map, at));
    }
    return entry->second;
  }

 private:
  std::map<std::map<int, int>, int> ids_;
};

inline void add_boundary(Result& result) {
  std::map<std::pair<int, int>, int> opposite;  // directed edge -> triangle * 3 + first corner
  for (std::size_t t = 0; t < result.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      opposite[{result.triangles[t][k], result.triangles[t][(k + 1) % 3]}] =
          static_cast<int>(3 * t) + k;
  const int n = result.degree;
  for (const auto& [edge, where] : opposite) {
    if (opposite.count({edge.second, edge.first})) continue;
    BezierCurve curve;
    for (int s = 0; s <= n; ++s) {
      // Row of corner k to k+1: (i, j) runs along an edge of the index triangle.
      const int i = where % 3 == 0 ? s : where % 3 == 1 ? n - s : 0;
      const int j = where % 3 == 0 ? 0 : where % 3 == 1 ? s : n - s;
      const int position = j * (n + 1) - j * (j - 1) / 2 + i;
      curve.poles.push_back(
          result.control_points[result.triangle_control_points[where / 3][position]]);
    }
    result.boundary_edges.push_back(
        {edge.first, edge.second, static_cast<int>(result.curves.size()), 0, 1});
    result.curves.push_back(curve);
  }
}

/// The map of `map` over the given domain mesh: C1 (even smooth) everywhere. Every boundary edge
/// gets a curve of its own; all boundary vertices are listed as corners.
inline Result polynomial_result(int degree, const Polynomial& map, std::vector<Point> vertices,
                                std::vector<std::array<int, 3>> triangles) {
  Result result;
  result.name = "example";
  result.degree = degree;
  result.domain_vertices = std::move(vertices);
  result.triangles = std::move(triangles);
  ControlPoints controls;
  for (const auto& t : result.triangles) {
    std::vector<int> net;
    for (int j = 0; j <= degree; ++j)
      for (int i = 0; i <= degree - j; ++i) net.push_back(controls.id(result, map, t, i, j));
    result.triangle_control_points.push_back(net);
  }
  add_boundary(result);
  for (const CurveEdge& e : result.boundary_edges) result.boundary_vertices.push_back({e.a, true});
  return result;
}

/// The unit square cut by its diagonal.
inline Result square(int degree = 3, const Polynomial& map = identity()) {
  return polynomial_result(degree, map, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
}

/// A square [0, 1]^2 cut into n x n squares of two triangles each, coordinates dyadic for n = 2^k.
inline Result grid(int n, int degree, const Polynomial& map) {
  std::vector<Point> vertices;
  std::vector<std::array<int, 3>> triangles;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) vertices.emplace_back(double(x) / n, double(y) / n);
  const auto at = [&](int x, int y) { return y * (n + 1) + x; };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  Result result = polynomial_result(degree, map, vertices, triangles);
  for (BoundaryVertex& v : result.boundary_vertices) {
    const Point& p = result.domain_vertices[v.vertex];
    v.corner = (p.x() == 0 || p.x() == 1) && (p.y() == 0 || p.y() == 1);
  }
  return result;
}

/// A cubic, bijective on the unit square: (x + (y^2 + x^2 y) / 8, y + (x^3 - x y) / 8).
inline Polynomial cubic_map() {
  return {{1, 0, Point(1, 0)},     {0, 1, Point(0, 1)},     {0, 2, Point(0.125, 0)},
          {2, 1, Point(0.125, 0)}, {3, 0, Point(0, 0.125)}, {1, 1, Point(0, -0.125)}};
}

}  // namespace c1mesh::example
