// SPDX-License-Identifier: GPL-3.0-or-later
// Moves inside the space of exactly C1 maps: exact after, never worse, nothing fixed moved.
#include "optimise/stages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/topology.h"
#include "optimise/exact_map.h"

namespace c1mesh {
namespace {

using testing_tools::exact_map;
using testing_tools::ExactMap;
using testing_tools::ExactState;

// The square root of the smallest twofold area of the curved triangles around each control point.
std::vector<double> sizes(const CurvedMesh& mesh, const std::vector<Point>& control) {
  const JacobianTables& tables = JacobianTables::of(mesh.degree);
  std::vector<double> size(mesh.control.size(), 1e300);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    Net net;
    for (int k = 0; k < mesh.net_size(); ++k)
      net.push_back(control[mesh.nets[t * mesh.net_size() + k]]);
    const double length = std::sqrt(det_coefficients(tables, net).mean());
    for (int k = 0; k < mesh.net_size(); ++k) {
      double& s = size[mesh.nets[t * mesh.net_size() + k]];
      s = std::min(s, length);
    }
  }
  return size;
}

std::vector<std::vector<BezierCurve>> blob_with_hole() {
  return {test::blob(6, 0.3, 2), test::backwards(test::circle({0.5, 0.5}, 0.1))};
}

// The disturbance taken back is one way to an exact map, so the least move is no larger than it,
// each point measured by its size.
TEST(ProjectExactly, IsTheLeastMoveToAnExactMap) {
  const ExactMap map = exact_map(blob_with_hole());
  ASSERT_TRUE(map.attempt.success);
  const ExactState exact(map);
  ASSERT_LT(exact.residue(), kExact);
  const std::vector<char> fixed = fixed_control(map.mesh, exact.state.control.size());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  MapState disturbed = exact.state;
  for (std::size_t i = 0; i < map.mesh.control.size(); ++i)
    if (!fixed[i]) disturbed.control[i] += 1e-8 * Point(number(random), number(random));
  ASSERT_GT(largest_residue(exact.asked, exact.domain, disturbed.control), 1e-9);

  MapState projected = disturbed;
  const double left = project_exactly(map.mesh, exact.layout, exact.asked, projected);
  EXPECT_LT(left, kExact);
  EXPECT_LT(largest_residue(exact.asked, exact.domain, projected.control), kExact);
  EXPECT_EQ(projected.unknowns, exact.state.unknowns);
  const std::vector<double> size = sizes(map.mesh, disturbed.control);
  double move = 0, back = 0;
  for (std::size_t i = 0; i < projected.control.size(); ++i) {
    if (fixed[i]) {
      EXPECT_EQ(projected.control[i], exact.state.control[i]);
      continue;
    }
    move += (projected.control[i] - disturbed.control[i]).squaredNorm() / (size[i] * size[i]);
    back += (exact.state.control[i] - disturbed.control[i]).squaredNorm() / (size[i] * size[i]);
  }
  EXPECT_GT(move, 0);
  EXPECT_LT(move, back);

  MapState again = projected;
  project_exactly(map.mesh, exact.layout, exact.asked, again);
  for (std::size_t i = 0; i < again.control.size(); ++i)
    EXPECT_LT((again.control[i] - projected.control[i]).norm(), 1e-11);
}

// Lowered again and again: exact and no worse each time; where nothing better was found, nothing
// has changed.
TEST(LowerDistortion, StaysExactAndIsNeverWorse) {
  int lowered = 0;
  for (const auto& loops : {blob_with_hole(), {test::blob(8, 0.5, 5)}, {test::lens(60)}}) {
    const ExactMap map = exact_map(loops);
    ASSERT_TRUE(map.attempt.success);
    ExactState exact(map);
    const std::vector<char> fixed = fixed_control(map.mesh, exact.state.control.size());
    double g = exact.g(map.mesh);
    EXPECT_NEAR(g, map.attempt.g, 1e-9 * g);
    for (int round = 0; round < 3; ++round) {
      const MapState before = exact.state;
      const bool better =
          lower_distortion(map.mesh, exact.layout, exact.asked, {}, exact.state, {});
      EXPECT_EQ(exact.state.unknowns, before.unknowns);
      EXPECT_LT(exact.residue(), kExact);
      if (better) {
        EXPECT_LT(exact.g(map.mesh), g);
      } else {
        EXPECT_EQ(exact.state.control, before.control);
      }
      for (std::size_t i = 0; i < fixed.size(); ++i)
        if (fixed[i]) {
          EXPECT_EQ(exact.state.control[i], before.control[i]);
        }
      g = exact.g(map.mesh);
      lowered += better;
    }
  }
  EXPECT_GT(lowered, 2);
}

// The first norm is 4; with a lower end none is tried, nothing found, nothing changed.
TEST(LowerDistortion, WithoutNormsChangesNothing) {
  const ExactMap map = exact_map({test::lens(60)});
  ASSERT_TRUE(map.attempt.success);
  ExactState exact(map);
  const MapState before = exact.state;
  ExactOptions options;
  options.final_exponent = 2;
  EXPECT_FALSE(lower_distortion(map.mesh, exact.layout, exact.asked, options, exact.state, {}));
  EXPECT_EQ(exact.state.control, before.control);
}

}  // namespace
}  // namespace c1mesh
