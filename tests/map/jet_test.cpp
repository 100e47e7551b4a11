// SPDX-License-Identifier: GPL-3.0-or-later
// Values and derivatives against a polynomial and against differences.
#include <gtest/gtest.h>

#include "c1mesh/map.h"
#include "result/example_results.h"

namespace c1mesh {
namespace {

/// Near the identity, with terms of every total degree up to n.
example::Polynomial map_of_degree(int n) {
  example::Polynomial map = example::identity();
  for (int total = 2; total <= n; ++total)
    for (int a = 0; a <= total; ++a)
      map.push_back({a, total - a, Point(0.02 * (a + 1), 0.03 - 0.01 * a) / total});
  return map;
}

class MapJets : public testing::TestWithParam<int> {
 protected:
  const int degree = GetParam();
  const example::Polynomial polynomial = map_of_degree(degree);
  const Map map = Map(example::grid(3, degree, polynomial));
};

TEST_P(MapJets, ValuesAreThoseOfThePolynomial) {
  EXPECT_EQ(map.degree(), degree);
  EXPECT_EQ(map.triangles(), 18);
  for (const Point& p : {Point(0.1, 0.05), Point(0.5, 0.9), Point(1, 1), Point(0, 0.4)}) {
    const Point exact = example::evaluate(polynomial, p);
    EXPECT_LT((map.evaluate(p.x(), p.y()) - exact).norm(), 1e-14);
  }
}

TEST_P(MapJets, DerivativesMatchDifferencesOfThePolynomial) {
  const double h = 1e-4;
  const auto value = [&](double u, double v) { return example::evaluate(polynomial, Point(u, v)); };
  for (const Point& p : {Point(0.1, 0.05), Point(0.5, 0.9), Point(1, 1), Point(0, 0.4)}) {
    const double u = p.x(), v = p.y();
    const Eigen::Matrix2d J = map.jacobian(u, v);
    EXPECT_LT((J.col(0) - (value(u + h, v) - value(u - h, v)) / (2 * h)).norm(), 1e-7);
    EXPECT_LT((J.col(1) - (value(u, v + h) - value(u, v - h)) / (2 * h)).norm(), 1e-7);
    const Hessians H = map.hessian(u, v);
    const Point uu = (value(u + h, v) - 2 * value(u, v) + value(u - h, v)) / (h * h);
    const Point vv = (value(u, v + h) - 2 * value(u, v) + value(u, v - h)) / (h * h);
    const Point uv =
        (value(u + h, v + h) - value(u + h, v - h) - value(u - h, v + h) + value(u - h, v - h)) /
        (4 * h * h);
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_NEAR(H[axis](0, 0), uu[axis], 1e-6);
      EXPECT_NEAR(H[axis](1, 1), vv[axis], 1e-6);
      EXPECT_NEAR(H[axis](0, 1), uv[axis], 1e-6);
      EXPECT_EQ(H[axis](0, 1), H[axis](1, 0));
    }
  }
}

TEST_P(MapJets, AJetIsAllOfThem) {
  const DomainPoint place = *map.find(0.3, 0.2);
  const Jet jet = map.jet(place);
  EXPECT_LT((jet.value - map.evaluate(place)).norm(), 1e-15);
  EXPECT_EQ(jet.jacobian, map.jacobian(place));
  EXPECT_EQ(jet.hessian[1], map.hessian(place)[1]);
}

// One polynomial everywhere: that of any triangle continues it.
TEST_P(MapJets, ATrianglesPolynomialGoesOnOutsideOfIt) {
  for (int t = 0; t < map.triangles(); ++t) {
    const DomainPoint place = map.at(t, Point(0.5, 0.5));
    EXPECT_LT((map.evaluate(place) - map.evaluate(0.5, 0.5)).norm(), 1e-11);
    EXPECT_LT((map.at(t, place.barycentric).uv - Point(0.5, 0.5)).norm(), 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, MapJets, testing::Values(3, 4, 5, 6));

}  // namespace
}  // namespace c1mesh
