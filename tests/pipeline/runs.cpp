// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/runs.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace c1mesh::testing_pipeline {
namespace {

Shape shape_of(const std::vector<BezierCurve>& curves) {
  Drawing drawing;
  drawing.name = "drawing";
  for (const BezierCurve& curve : curves)
    drawing.curves.push_back({std::to_string(drawing.curves.size()), curve});
  return make_shape(drawing);
}

}  // namespace

Shape shape_at(const std::string& path) {
  return make_shape(read_drawings(path).at(0));
}

Shape example(const std::string& name) {
  return shape_at(C1MESH_EXAMPLES "/" + name + ".svg");
}

Shape data(const std::string& name) {
  return shape_at(C1MESH_TEST_DATA "/" + name);
}

Shape polygon(const std::vector<Point>& corners) {
  std::vector<BezierCurve> curves;
  for (std::size_t i = 0; i < corners.size(); ++i)
    curves.push_back({{corners[i], corners[(i + 1) % corners.size()]}});
  return shape_of(curves);
}

Shape concentric(const std::vector<double>& radii) {
  // A handle of 9/16 of the radius is within 0.03 % of a circle and exact in doubles.
  std::vector<BezierCurve> curves;
  for (const double r : radii) {
    Point from(r, 0);
    for (int quarter = 0; quarter < 4; ++quarter) {
      const Point to(-from.y(), from.x());
      curves.push_back({{from, from + 0.5625 * to, to + 0.5625 * from, to}});
      from = to;
    }
  }
  return shape_of(curves);
}

void expect_valid_and_c1(const Outcome& outcome) {
  EXPECT_TRUE(outcome.report.valid()) << report_text(outcome.report);
  EXPECT_LE(outcome.report.metrics.d_ei.max, kExactlyC1);
  EXPECT_LE(outcome.report.metrics.conformance_max, kConforming);
  // |J|^2 / det J >= 2 with equality for similarities only.
  EXPECT_GE(outcome.report.metrics.mips_bound_max, 2 - 1e-12);
}

int components(const Result& result) {
  std::vector<int> root(result.domain_vertices.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (const auto& t : result.triangles)
    for (int c = 1; c < 3; ++c) root[find(t[c])] = find(t[0]);
  int count = 0;
  for (int v = 0; v < static_cast<int>(root.size()); ++v) count += root[v] == v;
  return count;
}

int euler_characteristic(const Result& result) {
  std::set<std::pair<int, int>> edges;
  for (const auto& t : result.triangles)
    for (int c = 0; c < 3; ++c) edges.insert(std::minmax({t[c], t[(c + 1) % 3]}));
  return static_cast<int>(result.domain_vertices.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(result.triangles.size());
}

}  // namespace c1mesh::testing_pipeline
