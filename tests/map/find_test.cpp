// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangle a point of the domain, or of the shape, belongs to.
#include <gtest/gtest.h>

#include <limits>

#include "c1mesh/map.h"
#include "result/example_results.h"

namespace c1mesh {
namespace {

/// The least triangle with all of these vertices.
int least_with(const Result& result, const std::vector<int>& vertices) {
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    bool all = true;
    for (const int v : vertices) {
      const auto& corners = result.triangles[t];
      all = all && std::find(corners.begin(), corners.end(), v) != corners.end();
    }
    if (all) return static_cast<int>(t);
  }
  return -1;
}

// Thirds are no doubles: rounding must not decide who gets a vertex or an edge.
TEST(Find, EdgesAndVerticesBelongToTheLeastTriangle) {
  const Result result = example::grid(3, 3, example::cubic_map());
  const Map map(result);
  for (std::size_t v = 0; v < result.domain_vertices.size(); ++v) {
    const Point& p = result.domain_vertices[v];
    const int least = least_with(result, {static_cast<int>(v)});
    ASSERT_TRUE(map.find(p.x(), p.y()));
    EXPECT_EQ(map.find(p.x(), p.y())->triangle, least);
    const Point image = map.evaluate(p.x(), p.y());
    ASSERT_TRUE(map.locate(image.x(), image.y()));
    EXPECT_EQ(map.locate(image.x(), image.y())->triangle, least);
  }
  for (const auto& corners : result.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = corners[k], b = corners[(k + 1) % 3];
      const Point p = 0.7 * result.domain_vertices[a] + 0.3 * result.domain_vertices[b];
      EXPECT_EQ(map.find(p.x(), p.y())->triangle, least_with(result, {a, b}));
      const Point image = map.evaluate(p.x(), p.y());
      EXPECT_EQ(map.locate(image.x(), image.y())->triangle, least_with(result, {a, b}));
    }
}

TEST(Find, NothingOutsideByMoreThanTheTolerance) {
  const Map map(example::grid(2, 3, example::identity()));
  EXPECT_EQ(map.domain_tolerance(), 0x1p-46);
  EXPECT_EQ(map.shape_tolerance(), 0x1p-46);
  const double near = 0x1p-47, far = 0x1p-43;
  EXPECT_TRUE(map.find(1 + near, 0.3));
  EXPECT_FALSE(map.find(1 + far, 0.3));
  EXPECT_FALSE(map.find(-far, 0.3));
  EXPECT_TRUE(map.locate(1 + near, 0.3));
  EXPECT_FALSE(map.locate(1 + far, 0.3));
  EXPECT_FALSE(map.locate(0.3, -far));
  EXPECT_FALSE(map.locate(2, 2));
}

TEST(Find, BarycentricCoordinatesAreNegativeByRoundingAtMost) {
  const Map map(example::grid(3, 3, example::cubic_map()));
  for (int k = 0; k <= 30; ++k) {
    const DomainPoint found = *map.find(1, k / 30.0);
    EXPECT_GE(found.barycentric.minCoeff(), -1e-13);
    EXPECT_NEAR(found.barycentric.sum(), 1, 1e-15);
    const Point image = map.evaluate(found);
    EXPECT_GE(map.locate(image.x(), image.y())->barycentric.minCoeff(), -1e-13);
  }
}

TEST(Find, NoNumberIsNowhere) {
  const Map map(example::square());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    EXPECT_FALSE(map.find(bad, 0.5));
    EXPECT_FALSE(map.find(0.5, bad));
    EXPECT_FALSE(map.locate(bad, 0.5));
    EXPECT_FALSE(map.locate(0.5, bad));
  }
}

TEST(Find, OutsideThrowsThePoint) {
  const Map map(example::square());
  try {
    map.evaluate(2, 3);
    FAIL();
  } catch (const OutsideDomain& outside) {
    EXPECT_EQ(outside.uv(), Point(2, 3));
  }
  EXPECT_THROW(map.jacobian(-1, 0), OutsideDomain);
  EXPECT_THROW(map.hessian(-1, 0), OutsideDomain);
}

// Two triangles over one place, mapped apart.
TEST(Find, WhereTheDomainOverlapsItselfTheLeastTriangleIsTaken) {
  Result result = example::polynomial_result(3, example::identity(),
                                             {{0, 0}, {1, 0}, {0, 1}, {0, 0}, {1, 0}, {0, 1}},
                                             {{0, 1, 2}, {3, 4, 5}});
  for (const int id : result.triangle_control_points[1]) result.control_points[id] += Point(10, 0);
  const Map map(result);
  EXPECT_EQ(map.find(0.25, 0.25)->triangle, 0);
  EXPECT_EQ(map.locate(0.25, 0.25)->triangle, 0);
  const DomainPoint other = *map.locate(10.25, 0.25);
  EXPECT_EQ(other.triangle, 1);
  EXPECT_LT((other.uv - Point(0.25, 0.25)).norm(), 1e-14);
  EXPECT_LT((map.evaluate(map.at(1, Point(0.25, 0.25))) - Point(10.25, 0.25)).norm(), 1e-14);
}

}  // namespace
}  // namespace c1mesh
