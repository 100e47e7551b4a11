// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "read/scanner.h"

namespace c1mesh::detail {
namespace {

void expect_maps(const std::string& transform, const Point& from, const Point& to) {
  EXPECT_LT((parse_transform(transform)(from) - to).norm(), 1e-14 * (1 + to.norm())) << transform;
}

TEST(Transform, EveryFunctionInClosedForm) {
  const double s = std::sqrt(3.0) / 2, t = std::tan(std::numbers::pi / 18);
  expect_maps("matrix(1 2 3 4 5 6)", {10, 20}, {10 + 60 + 5, 20 + 80 + 6});
  expect_maps("translate(3)", {1, 2}, {4, 2});
  expect_maps("translate(3,-4)", {1, 2}, {4, -2});
  expect_maps("scale(2)", {1, 2}, {2, 4});
  expect_maps("scale(2 -1)", {1, 2}, {2, -2});
  expect_maps("rotate(30)", {2, 0}, {2 * s, 1});
  expect_maps("rotate(90 1 1)", {2, 1}, {1, 2});
  expect_maps("skewX(10)", {1, 2}, {1 + 2 * t, 2});
  expect_maps("skewY(10)", {1, 2}, {1, 2 + t});
  expect_maps("", {1, 2}, {1, 2});
  expect_maps("none", {1, 2}, {1, 2});
}

TEST(Transform, TheRightmostFunctionActsFirst) {
  expect_maps("translate(10,20) rotate(90)", {1, 0}, {10, 21});
  expect_maps("rotate(90),translate(10 20)", {1, 0}, {-20, 11});
}

TEST(Transform, QuarterTurnsAreExact) {
  EXPECT_EQ(parse_transform("rotate(90)")(Point(3, 5)), Point(-5, 3));
  EXPECT_EQ(parse_transform("rotate(-450)")(Point(3, 5)), Point(5, -3));
  EXPECT_EQ(parse_transform("rotate(180)")(Point(3, 5)), Point(-3, -5));
}

TEST(Transform, StretchIsTheLargerSingularValue) {
  EXPECT_NEAR(parse_transform("rotate(33) scale(2 -7) rotate(12)").stretch(), 7, 1e-13);
  // [[1, 1], [0, 1]] has the golden ratio.
  EXPECT_NEAR(parse_transform("matrix(1 0 1 1 0 0)").stretch(), (1 + std::sqrt(5.0)) / 2, 1e-14);
}

TEST(Transform, ErrorsAreRefused) {
  for (const char* bad : {"rotate", "rotate(", "rotate(1", "rotate(1,2)", "turn(1)", "scale()",
                          "matrix(1 2 3)", "translate(1px)", "3"})
    EXPECT_THROW(parse_transform(bad), SyntaxError) << bad;
}

}  // namespace
}  // namespace c1mesh::detail
