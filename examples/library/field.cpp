// SPDX-License-Identifier: GPL-3.0-or-later
// field RESULT.c1.json: values, derivatives and the inverse of a map; its area by quadrature over
// the domain and by Green's formula along the boundary.
#include <c1mesh/c1mesh.h>

#include <Eigen/LU>
#include <cmath>
#include <iostream>

#include "quadrature.h"

namespace {

/// The integral of det J over the domain. det J is a polynomial of degree 2n - 2 on each triangle,
/// so n points a side are exact.
double area_by_quadrature(const c1mesh::Result& result, const c1mesh::Map& map) {
  double area = 0;
  for (int t = 0; t < map.triangles(); ++t) {
    const auto corner = [&](int k) { return result.domain_vertices[result.triangles[t][k]]; };
    const double twice = c1mesh::cross(corner(1) - corner(0), corner(2) - corner(0));
    for (const TrianglePoint& p : gauss_triangle(map.degree()))
      area += p.weight * twice * map.jacobian(map.at(t, p.at)).determinant();
  }
  return area;
}

/// Green: the area is the integral of x dy along the boundary, interior on the left.
double area_by_green(const c1mesh::Result& result) {
  double area = 0;
  for (const c1mesh::CurveEdge& edge : result.boundary_edges) {
    const std::vector<c1mesh::Point>& poles = result.curves[edge.curve].poles;
    const int n = static_cast<int>(poles.size()) - 1;
    for (const LinePoint& p : gauss_line(n)) {
      const double t = edge.t0 + (edge.t1 - edge.t0) * p.at;
      std::vector<c1mesh::Point> level = poles;  // de Casteljau
      c1mesh::Point slope = c1mesh::Point::Zero();
      for (; level.size() > 1; level.pop_back()) {
        if (level.size() == 2) slope = n * (level[1] - level[0]);
        for (std::size_t i = 0; i + 1 < level.size(); ++i)
          level[i] = (1 - t) * level[i] + t * level[i + 1];
      }
      area += p.weight * (edge.t1 - edge.t0) * level[0].x() * slope.y();
    }
  }
  return area;
}

/// A grid over the shape's box: '#' inside, by the inverse.
void draw(const c1mesh::Map& map, int columns) {
  const c1mesh::Box& box = map.shape_box();
  const c1mesh::Point size = box.high - box.low;
  const double step = size.x() / columns;
  for (double y = box.high.y() - step; y > box.low.y(); y -= 2 * step) {
    for (double x = box.low.x() + step / 2; x < box.high.x(); x += step)
      std::cout << (map.locate(x, y) ? '#' : '.');
    std::cout << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: field RESULT.c1.json\n";
    return 2;
  }
  const c1mesh::Result result = c1mesh::read_result(argv[1]);
  const c1mesh::Map map(result);
  draw(map, 60);

  // The middle of a triangle: its image, the derivatives there, and back again.
  const c1mesh::DomainPoint place =
      map.at(map.triangles() / 2, c1mesh::Barycentric(1.0 / 3, 1.0 / 3, 1.0 / 3));
  const c1mesh::Jet jet = map.jet(place);
  std::cout << "(u, v) = " << place.uv.transpose() << "\n(x, y) = " << jet.value.transpose()
            << "\nJ =\n"
            << jet.jacobian << "\nsecond derivatives of x =\n"
            << jet.hessian[0] << "\nof y =\n"
            << jet.hessian[1] << '\n';
  const std::optional<c1mesh::DomainPoint> back = map.locate(jet.value.x(), jet.value.y());
  if (!back) return 1;
  const double missed = (back->uv - place.uv).norm();
  std::cout << "back again: triangle " << back->triangle << ", missed by " << missed << '\n';

  const double quadrature = area_by_quadrature(result, map), green = area_by_green(result);
  const double difference = std::abs(quadrature - green) / green;
  std::cout << "area by quadrature " << quadrature << ", by Green's formula " << green
            << ", relative difference " << difference << '\n';
  return back->triangle == place.triangle && difference < 1e-10 ? 0 : 1;
}
