// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/mesh_edges.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/extent.h"

namespace c1mesh {
namespace {

using Key = std::pair<int, int>;

Key key_of(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

/// The equations of docs/format.md in doubles; good enough to colour with.
double deviation(const PiecewiseMap& map, const DrawnEdge& edge) {
  const Result& r = map.result();
  const int n = r.degree;
  const auto far = [&](int s) { return r.triangles[edge.triangle[s]][(edge.corner[s] + 2) % 3]; };
  const Point &v0 = r.domain_vertices[edge.a], &v1 = r.domain_vertices[edge.b];
  const Point &v2 = r.domain_vertices[far(0)], &v3 = r.domain_vertices[far(1)];
  const double area = cross(v1 - v0, v2 - v0);
  const double g0 = cross(v1 - v3, v2 - v3) / area, g2 = cross(v1 - v0, v3 - v0) / area;
  const auto control = [&](int s, int second, int third) -> const Point& {
    return r.control_points[map.control_id(edge.triangle[s], edge.corner[s], second, third)];
  };
  double largest = 0;
  for (int i = 0; i < n; ++i) {
    // g1 = 1 - g0 - g2: written with differences, which are small, instead of positions.
    const Point origin = control(0, i + 1, 0);
    const Point d = control(1, n - 1 - i, 1) - origin - g0 * (control(0, i, 0) - origin) -
                    g2 * (control(0, i, 1) - origin);
    largest = std::max(largest, d.norm());
  }
  return largest * std::max(1.0, 1 / std::abs(g2));
}

}  // namespace

std::vector<DrawnEdge> edges_of(const PiecewiseMap& map) {
  const Result& result = map.result();
  std::vector<DrawnEdge> edges;
  std::map<Key, std::size_t> index;
  for (int t = 0; t < static_cast<int>(result.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = result.triangles[t][k], b = result.triangles[t][(k + 1) % 3];
      const auto [entry, fresh] = index.emplace(key_of(a, b), edges.size());
      if (fresh) edges.push_back({a, b, {t, -1}, {k, -1}, EdgeKind::boundary, 0});
      DrawnEdge& edge = edges[entry->second];
      if (fresh || edge.triangle[1] >= 0) continue;
      edge.triangle[1] = t;
      edge.corner[1] = k;
      edge.kind = EdgeKind::smooth;
    }
  const auto mark = [&](int a, int b, EdgeKind kind) {
    const auto found = index.find(key_of(a, b));
    if (found != index.end() && edges[found->second].kind != EdgeKind::boundary)
      edges[found->second].kind = kind;
  };
  for (const auto& [a, b] : result.relaxed_edges) mark(a, b, EdgeKind::relaxed);
  for (const CurveEdge& e : result.feature_edges) mark(e.a, e.b, EdgeKind::feature);
  const double extent = extent_of(result);
  for (DrawnEdge& edge : edges)
    if (edge.triangle[1] >= 0) edge.c1_deviation = deviation(map, edge) / extent;
  return edges;
}

double extent_of(const Result& result) {
  if (result.control_points.empty()) return 1;
  const double side = extent_of(result.control_points);
  return side > 0 ? side : 1;
}

std::vector<int> regions_of(const Result& result, const std::vector<DrawnEdge>& edges) {
  std::vector<std::vector<int>> beside(result.triangles.size());
  for (const DrawnEdge& edge : edges)
    if (edge.triangle[1] >= 0) {
      beside[edge.triangle[0]].push_back(edge.triangle[1]);
      beside[edge.triangle[1]].push_back(edge.triangle[0]);
    }
  std::vector<int> region(result.triangles.size(), -1), pending;
  int count = 0;
  for (int start = 0; start < static_cast<int>(region.size()); ++start) {
    if (region[start] >= 0) continue;
    region[start] = count;
    pending.push_back(start);
    while (!pending.empty()) {
      const int t = pending.back();
      pending.pop_back();
      for (const int next : beside[t])
        if (region[next] < 0) {
          region[next] = count;
          pending.push_back(next);
        }
    }
    ++count;
  }
  return region;
}

}  // namespace c1mesh
