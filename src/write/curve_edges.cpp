// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/curve_edges.h"

#include <map>
#include <utility>

namespace c1mesh {

std::vector<EdgeOnCurve> edges_on_curves(const Result& result) {
  std::map<std::pair<int, int>, std::pair<int, int>> sides;  // a, b -> triangle, corner
  for (int t = 0; t < static_cast<int>(result.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k)
      sides.emplace(std::pair(result.triangles[t][k], result.triangles[t][(k + 1) % 3]),
                    std::pair(t, k));
  std::vector<EdgeOnCurve> out;
  const auto add = [&](const CurveEdge& edge, bool feature) {
    auto found = sides.find({edge.a, edge.b});
    const bool against = found == sides.end();
    if (against) found = sides.find({edge.b, edge.a});
    if (found == sides.end()) return;
    out.push_back({edge, feature, found->second.first, found->second.second, against});
  };
  for (const CurveEdge& edge : result.boundary_edges) add(edge, false);
  for (const CurveEdge& edge : result.feature_edges) add(edge, true);
  return out;
}

}  // namespace c1mesh
