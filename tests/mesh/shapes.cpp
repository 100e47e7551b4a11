// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/shapes.h"

#include <cmath>
#include <numbers>
#include <random>

#include "bernstein/curve.h"
#include "bernstein/jacobian.h"
#include "mesh/topology.h"

namespace c1mesh::test {
namespace {

constexpr double kPi = std::numbers::pi;

// Cubics through the points with the given derivatives (Hermite).
std::vector<BezierCurve> hermite(const std::vector<Point>& points, const std::vector<Point>& slopes,
                                 bool closed) {
  std::vector<BezierCurve> curves;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    const std::size_t j = (i + 1) % n;
    curves.push_back(
        {{points[i], points[i] + slopes[i] / 3, points[j] - slopes[j] / 3, points[j]}});
  }
  return curves;
}

}  // namespace

std::vector<LoopCurve> loop_of(const std::vector<BezierCurve>& curves, int degree, int first) {
  std::vector<LoopCurve> loop;
  for (const BezierCurve& c : curves) loop.push_back({elevate(c, degree), first++, false});
  return loop;
}

std::vector<BezierCurve> polygon(const std::vector<Point>& points) {
  std::vector<BezierCurve> curves;
  for (std::size_t i = 0; i < points.size(); ++i)
    curves.push_back({{points[i], points[(i + 1) % points.size()]}});
  return curves;
}

std::vector<BezierCurve> circle(const Point& centre, double radius) {
  const double speed = radius * 4 * (std::numbers::sqrt2 - 1);
  std::vector<Point> points, slopes;
  for (const Point& d : {Point(1, 0), Point(0, 1), Point(-1, 0), Point(0, -1)}) {
    points.push_back(centre + radius * d);
    slopes.push_back(speed * Point(-d.y(), d.x()));
  }
  return hermite(points, slopes, true);
}

std::vector<BezierCurve> backwards(const std::vector<BezierCurve>& loop) {
  std::vector<BezierCurve> out;
  for (auto c = loop.rbegin(); c != loop.rend(); ++c) out.push_back(reversed(*c));
  return out;
}

std::vector<BezierCurve> blob(int count, double wave, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Point> points, slopes;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / count, radius = 0.3 * (1 + wave * unit(random));
    points.emplace_back(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle));
  }
  for (int i = 0; i < count; ++i)
    slopes.push_back(0.5 * (points[(i + 1) % count] - points[(i + count - 1) % count]));
  return hermite(points, slopes, true);
}

std::vector<BezierCurve> drop() {
  return {{{Point(0.5, 0.1), Point(1.2, 1), Point(-0.2, 1), Point(0.5, 0.1)}}};
}

std::vector<BezierCurve> spiral(double turns) {
  const int count = static_cast<int>(8 * turns);
  std::vector<Point> points[2], slopes[2];
  for (int side : {0, 1})
    for (int i = 0; i <= count; ++i) {
      const double angle = 2 * kPi * turns * i / count, step = 2 * kPi * turns / count;
      const double growth = 0.35 / (2 * kPi * turns);
      const double radius = 0.1 + growth * angle + (side == 0 ? 0.02 : 0);
      const Point e(std::cos(angle), std::sin(angle)), normal(-e.y(), e.x());
      points[side].push_back(Point(0.5, 0.5) + radius * e);
      slopes[side].push_back(step * (growth * e + radius * normal));
    }
  auto loop = hermite(points[0], slopes[0], false);
  const auto inner = backwards(hermite(points[1], slopes[1], false));
  loop.push_back({{points[0].back(), points[1].back()}});
  loop.insert(loop.end(), inner.begin(), inner.end());
  loop.push_back({{points[1].front(), points[0].front()}});
  return loop;
}

std::vector<BezierCurve> lens(double degrees) {
  const double rise = std::tan(0.5 * degrees * kPi / 180) / 3;
  return {{{Point(0, 0.5), Point(1.0 / 3, 0.5 - rise), Point(2.0 / 3, 0.5 - rise), Point(1, 0.5)}},
          {{Point(1, 0.5), Point(2.0 / 3, 0.5 + rise), Point(1.0 / 3, 0.5 + rise), Point(0, 0.5)}}};
}

MeshInput input_of(const std::vector<std::vector<BezierCurve>>& loops, int degree) {
  MeshInput input;
  input.degree = degree;
  int first = 0;
  for (const auto& loop : loops) {
    input.loops.push_back(loop_of(loop, degree, first));
    first += static_cast<int>(loop.size());
  }
  return input;
}

// Half the integral of c x c' over [0, 1]: int B_i^n B_j^(n-1) = C(n,i) C(n-1,j) / (2n
// C(2n-1,i+j)).
double green_area(const std::vector<BezierCurve>& curves) {
  const auto binomial = [](int n, int k) {
    double value = 1;
    for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
    return value;
  };
  double area = 0;
  for (const BezierCurve& c : curves) {
    const int n = c.degree();
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j < n; ++j)
        area += 0.5 * n * binomial(n, i) * binomial(n - 1, j) /
                (2 * n * binomial(2 * n - 1, i + j)) *
                cross(c.poles[i], c.poles[j + 1] - c.poles[j]);
  }
  return area;
}

double mesh_area(const CurvedMesh& mesh) {
  double area = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    area += 0.5 * det_coefficients(JacobianTables::of(mesh.degree), net_of(mesh, t)).mean();
  return area;
}

Barycentric locate(const CurvedMesh& mesh, int t, const Point& p) {
  const auto& v = mesh.triangles[t];
  const Point e1 = mesh.domain[v[1]] - mesh.domain[v[0]];
  const Point e2 = mesh.domain[v[2]] - mesh.domain[v[0]];
  const Point q = p - mesh.domain[v[0]];
  const double area = cross(e1, e2), b = cross(q, e2) / area, c = cross(e1, q) / area;
  return {1 - b - c, b, c};
}

Point map_at(const CurvedMesh& mesh, const Point& p) {
  int best = 0;
  double inside = -1e300;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const double least = locate(mesh, t, p).minCoeff();
    if (least > inside) inside = least, best = t;
  }
  return evaluate(net_of(mesh, best), mesh.degree, locate(mesh, best, p));
}

}  // namespace c1mesh::test
