// SPDX-License-Identifier: GPL-3.0-or-later
// MFEM mesh v1.0. The curved mesh is a grid function in the positive (Bernstein) basis, so that the
// file holds the control points themselves.
#include <fmt/format.h>

#include <iterator>

#include "c1mesh/write.h"
#include "write/curve_edges.h"
#include "write/mesh_edges.h"

namespace c1mesh {
namespace {

constexpr int kSegment = 1, kTriangle = 2;  // Geometry::Type

void add_points(std::string& out, const std::vector<Point>& points) {
  for (const Point& p : points) fmt::format_to(std::back_inserter(out), "{} {}\n", p.x(), p.y());
}

/// Discontinuous elements, so that the values need no order but their elements': p_ij with i
/// fastest, as MFEM's L2Pos_TriangleElement has them, x and y side by side (Ordering 1).
void add_control_points(std::string& out, const Result& result) {
  // T2 is MFEM's positive basis.
  out += fmt::format(
      "\nnodes\nFiniteElementSpace\nFiniteElementCollection: L2_T2_2D_P{}\nVDim: 2\nOrdering: "
      "1\n\n",
      result.degree);
  for (const auto& net : result.triangle_control_points) {
    std::vector<Point> points;
    points.reserve(net.size());
    for (const int id : net) points.push_back(result.control_points[id]);
    add_points(out, points);
  }
}

}  // namespace

std::string format_mfem(const Result& result, bool domain) {
  const PiecewiseMap map(result);
  const std::vector<int> region = regions_of(result, edges_of(map));
  const std::vector<EdgeOnCurve> edges = edges_on_curves(result);
  std::string out = "MFEM mesh v1.0\n\ndimension\n2\n\n";
  // Attributes start at 1, curves and regions at 0.
  fmt::format_to(std::back_inserter(out), "elements\n{}\n", result.triangles.size());
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    const auto& [a, b, c] = result.triangles[t];
    fmt::format_to(std::back_inserter(out), "{} {} {} {} {}\n", region[t] + 1, kTriangle, a, b, c);
  }
  fmt::format_to(std::back_inserter(out), "\nboundary\n{}\n", edges.size());
  for (const EdgeOnCurve& e : edges)
    fmt::format_to(std::back_inserter(out), "{} {} {} {}\n", e.edge.curve + 1, kSegment, e.edge.a,
                   e.edge.b);
  fmt::format_to(std::back_inserter(out), "\nvertices\n{}\n", result.domain_vertices.size());
  if (domain) {
    out += "2\n";
    add_points(out, result.domain_vertices);
  } else {
    add_control_points(out, result);
  }
  return out;
}

}  // namespace c1mesh
