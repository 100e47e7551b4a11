// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation, image curves and grid lines against a polynomial map in closed form.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <map>

#include "result/example_results.h"
#include "write/grid_lines.h"
#include "write/mesh_edges.h"

namespace c1mesh {
namespace {

class Map : public testing::TestWithParam<int> {};

TEST_P(Map, ValuesAndJacobiansAreThoseOfThePolynomial) {
  const Result result = example::grid(2, GetParam(), example::cubic_map());
  const PiecewiseMap map(result);
  for (const Barycentric& at :
       {Barycentric(0.2, 0.3, 0.5), Barycentric(1, 0, 0), Barycentric(0.5, 0, 0.5)})
    for (int t = 0; t < static_cast<int>(result.triangles.size()); ++t) {
      const Point p = map.domain_point(t, at);
      EXPECT_LT((map.evaluate(t, at) - example::evaluate(example::cubic_map(), p)).norm(), 1e-14);
      // d/dx, d/dy of (x + (y^2 + x^2 y) / 8, y + (x^3 - x y) / 8).
      Eigen::Matrix2d J;
      J << 1 + 2 * p.x() * p.y() / 8, (2 * p.y() + p.x() * p.x()) / 8,
          (3 * p.x() * p.x() - p.y()) / 8, 1 - p.x() / 8;
      EXPECT_LT((map.jacobian(t, at) - J).norm(), 1e-13);
      EXPECT_NEAR(map.distortion(t, at), J.squaredNorm() / J.determinant(), 1e-12);
    }
}

TEST_P(Map, SegmentsAreImagesOfStraightLines) {
  const Result result = example::grid(1, GetParam(), example::cubic_map());
  const PiecewiseMap map(result);
  const Barycentric p(0.7, 0.3, 0), q(0.1, 0.2, 0.7);
  const std::vector<Point> poles = map.segment(1, p, q);
  ASSERT_EQ(static_cast<int>(poles.size()), GetParam() + 1);
  for (const double s : {0.0, 0.25, 0.6, 1.0}) {
    std::vector<Point> level = poles;
    for (; level.size() > 1; level.pop_back())
      for (std::size_t i = 0; i + 1 < level.size(); ++i)
        level[i] = (1 - s) * level[i] + s * level[i + 1];
    EXPECT_LT((level[0] - map.evaluate(1, (1 - s) * p + s * q)).norm(), 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, Map, testing::Values(3, 4, 5));

// On a convex domain every grid line is one run from side to side, each piece where the last ended.
TEST(GridLines, AreJoinedAcrossTheWholeSquare) {
  for (const int n : {1, 4, 5}) {
    const Result result = example::grid(n, 3, example::identity());
    const PiecewiseMap map(result);
    const std::vector<IsoLine> lines = iso_lines(result, 8);
    ASSERT_EQ(lines.size(), 16u) << n;
    for (const IsoLine& line : lines) {
      double at = 0;
      for (const LinePiece& piece : line.pieces) {
        const Point from = map.domain_point(piece.triangle, piece.from);
        const Point to = map.domain_point(piece.triangle, piece.to);
        EXPECT_NEAR(from[line.axis], line.value, 1e-15);
        EXPECT_NEAR(to[line.axis], line.value, 1e-15);
        EXPECT_NEAR(from[1 - line.axis], at, 1e-15);
        at = to[1 - line.axis];
      }
      EXPECT_NEAR(at, 1, 1e-15);
    }
  }
}

// Lines that run along mesh edges (multiples of 1/4 over a 4 x 4 grid) appear once, not twice.
TEST(GridLines, AlongMeshEdgesAreNotDoubled) {
  Result result = example::grid(4, 3, example::identity());
  // Spacing 1/2, first line at 1/4.
  const std::vector<IsoLine> lines = iso_lines(result, 2);
  ASSERT_EQ(lines.size(), 4u);
  for (const IsoLine& line : lines) EXPECT_EQ(line.pieces.size(), 4u);
}

TEST(GridLines, BreakAtAHole) {
  // A square ring: lines through the hole come as two runs.
  std::vector<Point> points;
  for (const double r : {3.0, 1.0})
    for (const auto& [x, y] :
         {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
      points.emplace_back(r * x, r * y);
  std::vector<std::array<int, 3>> triangles;
  for (int k = 0; k < 4; ++k) {
    triangles.push_back({k, (k + 1) % 4, 4 + (k + 1) % 4});
    triangles.push_back({k, 4 + (k + 1) % 4, 4 + k});
  }
  const Result ring = example::polynomial_result(3, example::identity(), points, triangles);
  std::map<std::pair<int, double>, int> runs;
  for (const IsoLine& line : iso_lines(ring, 6)) ++runs[{line.axis, line.value}];
  ASSERT_EQ(runs.size(), 12u);
  for (const auto& [line, count] : runs) EXPECT_EQ(count, std::abs(line.second) < 1 ? 2 : 1);
}

TEST(MeshEdges, KindsRegionsAndDeviation) {
  Result result = example::square();
  result.relaxed_edges = {{2, 0}};
  result.control_points[result.triangle_control_points[0][5]].x() += 0x1p-10;  // p_11
  const PiecewiseMap map(result);
  const auto edges = edges_of(map);
  ASSERT_EQ(edges.size(), 5u);
  int relaxed = 0, boundary = 0;
  for (const DrawnEdge& e : edges) {
    relaxed += e.kind == EdgeKind::relaxed;
    boundary += e.kind == EdgeKind::boundary;
    EXPECT_NEAR(e.c1_deviation, e.kind == EdgeKind::relaxed ? 0x1p-10 : 0, 1e-15);
  }
  EXPECT_EQ(relaxed, 1);
  EXPECT_EQ(boundary, 4);
  EXPECT_EQ(regions_of(result, edges), (std::vector<int>{0, 0}));
}

}  // namespace
}  // namespace c1mesh
