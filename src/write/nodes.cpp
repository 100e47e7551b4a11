// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/nodes.h"

#include "bernstein/interpolation.h"

namespace c1mesh {
namespace {

/// Calls visit(t, i, j, id) for the first triangle in which each control point stands.
template <class Visit>
void each_node_once(const PiecewiseMap& map, const Visit& visit) {
  const Result& result = map.result();
  const int n = result.degree;
  std::vector<char> known(result.control_points.size(), 0);
  for (int t = 0; t < static_cast<int>(result.triangles.size()); ++t)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n - j; ++i) {
        const int id = map.control_id(t, 0, i, j);
        if (known[id]) continue;
        known[id] = 1;
        visit(t, i, j, id);
      }
}

}  // namespace

std::vector<std::array<int, 2>> recursive_order(int n) {
  std::vector<std::array<int, 2>> out;
  for (int shift = 0; n >= 0; ++shift, n -= 3) {
    const auto add = [&](int i, int j) { out.push_back({i + shift, j + shift}); };
    add(0, 0);
    if (n == 0) break;
    add(n, 0);
    add(0, n);
    for (int s = 1; s < n; ++s) add(s, 0);
    for (int s = 1; s < n; ++s) add(n - s, s);
    for (int s = 1; s < n; ++s) add(0, n - s);
  }
  return out;
}

std::vector<int> triangle_nodes(const PiecewiseMap& map, int t) {
  std::vector<int> out;
  for (const auto& [i, j] : recursive_order(map.result().degree))
    out.push_back(map.control_id(t, 0, i, j));
  return out;
}

std::vector<int> edge_nodes(const PiecewiseMap& map, int t, int k) {
  const int n = map.result().degree;
  std::vector<int> out = {map.control_id(t, k, 0, 0), map.control_id(t, k, n, 0)};
  for (int s = 1; s < n; ++s) out.push_back(map.control_id(t, k, s, 0));
  return out;
}

std::vector<Point> interpolation_nodes(const PiecewiseMap& map) {
  const Result& result = map.result();
  std::vector<Point> out = result.control_points;
  Net net;
  int net_of = -1;
  each_node_once(map, [&](int t, int i, int j, int id) {
    if (t != net_of) {
      net.clear();
      for (const int c : result.triangle_control_points[t]) net.push_back(result.control_points[c]);
      net_of = t;
    }
    out[id] = lattice_value_exactly(net, result.degree, i, j);
  });
  return out;
}

std::vector<Point> domain_net(const PiecewiseMap& map) {
  const Result& result = map.result();
  const int n = result.degree;
  std::vector<Point> out(result.control_points.size(), Point::Zero());
  each_node_once(map, [&](int t, int i, int j, int id) {
    const auto& v = result.triangles[t];
    const auto corner = [&](int k) -> const Point& { return result.domain_vertices[v[k]]; };
    // Corners are copied: (n a) / n may differ from a in the last bit.
    if (i == n)
      out[id] = corner(1);
    else if (j == n)
      out[id] = corner(2);
    else if (i + j == 0)
      out[id] = corner(0);
    else
      out[id] = (double(n - i - j) * corner(0) + double(i) * corner(1) + double(j) * corner(2)) / n;
  });
  return out;
}

std::vector<char> used_nodes(const Result& result) {
  std::vector<char> used(result.control_points.size(), 0);
  for (const auto& net : result.triangle_control_points)
    for (const int id : net) used[id] = 1;
  return used;
}

}  // namespace c1mesh
