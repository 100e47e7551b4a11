// SPDX-License-Identifier: GPL-3.0-or-later
// What makes the maps worth having: first derivatives agree across edges where C1 is claimed.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "map/results.h"

namespace c1mesh {
namespace {

struct Gaps {
  double smooth = 0;  ///< largest relative difference of Jacobians across edges where C1 is claimed
  double relaxed = 0;  ///< across relaxed edges
  int edges = 0;
};

Gaps gaps_of(const Result& result) {
  const Map map(result);
  std::set<std::pair<int, int>> relaxed;
  for (const auto& [a, b] : result.relaxed_edges) relaxed.insert(std::minmax(a, b));
  std::map<std::pair<int, int>, int> first;
  Gaps gaps;
  for (int t = 0; t < map.triangles(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = result.triangles[t][k], b = result.triangles[t][(k + 1) % 3];
      const auto [entry, fresh] = first.emplace(std::minmax(a, b), t);
      if (fresh) continue;
      double& gap = relaxed.count(std::minmax(a, b)) ? gaps.relaxed : gaps.smooth;
      if (&gap == &gaps.smooth) ++gaps.edges;
      for (const double s : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        const Point p = (1 - s) * result.domain_vertices[a] + s * result.domain_vertices[b];
        const Eigen::Matrix2d J = map.jacobian(map.at(t, p));
        const Eigen::Matrix2d other = map.jacobian(map.at(entry->second, p));
        gap = std::max(gap, (J - other).norm() / J.norm());
      }
    }
  return gaps;
}

TEST(MapIsSmooth, AcrossEveryEdgeButThoseRelaxed) {
  for (const char* example : {"puzzle.svg", "interfaces.json"}) {
    const Gaps gaps = gaps_of(testing_map::result_of(example));
    EXPECT_GT(gaps.edges, 50) << example;
    EXPECT_LT(gaps.smooth, 1e-9) << example;
  }
}

// The test above can fail: a control point moved by a thousandth shows, and so do relaxed edges.
TEST(MapIsSmooth, AKinkShows) {
  Result result = testing_map::result_of("annulus.svg");
  EXPECT_GT(gaps_of(result).relaxed, 1e-3);
  const Point size = Map(result).shape_box().high - Map(result).shape_box().low;
  for (std::size_t t = 0; t < result.triangles.size(); ++t)
    result.control_points[result.triangle_control_points[t][5]] += 1e-3 * size;
  EXPECT_GT(gaps_of(result).smooth, 1e-4);
}

}  // namespace
}  // namespace c1mesh
