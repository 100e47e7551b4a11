// SPDX-License-Identifier: GPL-3.0-or-later
// The verification's own exact arithmetic and Bernstein forms against closed forms.
#include <gtest/gtest.h>

#include <random>

#include "verify/bernstein_forms.h"
#include "verify/boxes.h"
#include "verify/exact.h"

namespace c1mesh::verification {
namespace {

// The form of degree n evaluated at barycentric (u, v), by its definition, in rationals.
Rational value(int n, const std::vector<Rational>& form, const Rational& u, const Rational& v) {
  const auto power = [](const Rational& x, int k) {
    Rational out = 1;
    for (int i = 0; i < k; ++i) out *= x;
    return out;
  };
  Rational sum = 0;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n - j; ++i)
      sum += form[net_index(n, i, j)] * Rational(multinomial(n, i, j)) * power(u, i) * power(v, j) *
             power(1 - u - v, n - i - j);
  return sum;
}

class Forms : public testing::TestWithParam<int> {};

TEST_P(Forms, HalvesAreTheSameFunctionOverTheTwoHalfTriangles) {
  const int n = GetParam();
  std::mt19937 random(n);
  std::vector<Rational> form;
  for (int k = 0; k < (n + 1) * (n + 2) / 2; ++k)
    form.push_back(Rational(int(random() % 200) - 100));
  const auto half = halves(n, form);
  const Rational u(1, 3), v(2, 7);
  const Rational w = 1 - u - v;
  // Over (2, 0, m) the barycentric (w, u, v) means w*c2 + u*c0 + v*(c0 + c1)/2.
  EXPECT_EQ(value(n, half[0], u, v), value(n, form, v / 2, w));
  // Over (1, 2, m): w*c1 + u*c2 + v*(c0 + c1)/2.
  EXPECT_EQ(value(n, half[1], u, v), value(n, form, w + v / 2, u));
}

TEST_P(Forms, DetFormIsTheDeterminantOfTheDerivativeEverywhere) {
  const int n = GetParam();
  std::mt19937 random(n);
  std::vector<Vec<Rational>> net;
  for (int k = 0; k < (n + 1) * (n + 2) / 2; ++k)
    net.push_back({Rational(int(random() % 100)), Rational(int(random() % 100))});
  const auto d = derivative_forms(n, net);
  const auto component = [&](int column, int row) {
    std::vector<Rational> out;
    for (const auto& p : d[column]) out.push_back(p[row]);
    return out;
  };
  const Rational u(2, 5), v(1, 7);
  const auto at = [&](int column, int row) { return value(n - 1, component(column, row), u, v); };
  EXPECT_EQ(value(2 * n - 2, det_form(ProductRule(n - 1), net), u, v),
            Rational(at(0, 0) * at(1, 1) - at(0, 1) * at(1, 0)));
}

INSTANTIATE_TEST_SUITE_P(Degrees, Forms, testing::Values(1, 2, 3, 4, 5, 7));

TEST(Exact, OrientationDecidesWhereDoublesCannot) {
  // Points on y = x / 3 up to one ulp; the sign is that of the last bit.
  const Point a(0, 0), b(3, 1);
  const double third = 1.0 / 3;  // below 1/3
  EXPECT_EQ(orientation(a, b, Point(1, third)), -1);
  EXPECT_EQ(orientation(a, b, Point(1, std::nextafter(third, 1.0))), 1);
  EXPECT_EQ(orientation(a, b, Point(6, 2)), 0);
  // The difference of huge products, and products that underflow.
  EXPECT_EQ(orientation(Point(1e200, 0), Point(0, 1e200), Point(-1e200, 2e200)), 0);
  EXPECT_EQ(orientation(Point(0, 0), Point(1e-200, 0), Point(0, 1e-200)), 1);
  EXPECT_EQ(orientation(Point(0.1, 0.1), Point(0.2, 0.2), Point(0.3, 0.3)), 0);
}

TEST(Exact, SegmentsMeet) {
  const Point o(0, 0), x(1, 0), y(0, 1), d(1, 1);
  EXPECT_TRUE(segments_meet(o, d, x, y));
  EXPECT_FALSE(segments_meet(o, x, y, d));
  EXPECT_TRUE(segments_meet(o, x, Point(0.5, 0), Point(0.5, 1)));
  EXPECT_FALSE(segments_meet(o, x, Point(0.5, 5e-324), Point(0.5, 1)));
  EXPECT_TRUE(segments_meet(o, x, Point(0.5, 0), Point(2, 0)));
  EXPECT_FALSE(segments_meet(o, x, Point(1.5, 0), Point(2, 0)));
  EXPECT_TRUE(spokes_overlap(o, x, Point(2, 0)));
  EXPECT_FALSE(spokes_overlap(o, x, Point(-2, 0)));
  EXPECT_FALSE(spokes_overlap(o, x, Point(2, 1e-300)));
}

// x(t) = t^2, y(t) = t restricted to 1/4 -> 3/4, and back again, by exact fractions.
TEST(Exact, RestrictionOfAParabola) {
  const BezierCurve parabola{{Point(0, 0), Point(0, 0.5), Point(1, 1)}};
  const auto part = exact_restriction(parabola, 0.25, 0.75, 2);
  EXPECT_EQ(part[0], (Vec<Rational>{Rational(1, 16), Rational(1, 4)}));
  EXPECT_EQ(part[1], (Vec<Rational>{Rational(3, 16), Rational(1, 2)}));  // blossom t1 t2
  EXPECT_EQ(part[2], (Vec<Rational>{Rational(9, 16), Rational(3, 4)}));
  const auto back = exact_restriction(parabola, 0.75, 0.25, 3);
  EXPECT_EQ(back[0], part[2]);
  EXPECT_EQ(back[3], part[0]);
  // Degree raised: (p0 + 2 p1) / 3.
  EXPECT_EQ(back[1], (Vec<Rational>{Rational(5, 16), Rational(7, 12)}));
  const auto whole = exact_restriction(parabola, 0, 1, 2);
  EXPECT_EQ(whole[1], (Vec<Rational>{Rational(0), Rational(1, 2)}));
}

TEST(Boxes, PairsAreThoseOfTheQuadraticSearch) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 10), size(0, 1);
  std::vector<Box> boxes;
  for (int i = 0; i < 300; ++i) {
    const double x = place(random), y = place(random);
    boxes.push_back({{x, y}, {x + size(random), y + size(random)}});
  }
  boxes.push_back(boxes[0]);  // identical, and one that only touches
  boxes.push_back({{boxes[0].high[0], boxes[0].low[1]}, {boxes[0].high[0] + 1, boxes[0].high[1]}});
  std::vector<std::pair<int, int>> expected;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
    for (int j = i + 1; j < static_cast<int>(boxes.size()); ++j)
      if (boxes[i].low[0] <= boxes[j].high[0] && boxes[j].low[0] <= boxes[i].high[0] &&
          boxes[i].low[1] <= boxes[j].high[1] && boxes[j].low[1] <= boxes[i].high[1])
        expected.emplace_back(i, j);
  EXPECT_EQ(meeting_pairs(boxes), expected);
}

TEST(Boxes, PointsAreFoundInAllBoxesThatHoldThem) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(0, 10), size(0, 3);
  std::vector<Box> boxes;
  std::vector<Point> points;
  for (int i = 0; i < 100; ++i) {
    const double x = place(random), y = place(random);
    boxes.push_back({{x, y}, {x + size(random), y + size(random)}});
    points.emplace_back(place(random), place(random));
  }
  points.emplace_back(boxes[0].high[0], boxes[0].low[1]);  // on a corner
  std::vector<std::pair<int, int>> expected;
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    for (int j = 0; j < static_cast<int>(boxes.size()); ++j)
      if (boxes[j].low[0] <= points[i].x() && points[i].x() <= boxes[j].high[0] &&
          boxes[j].low[1] <= points[i].y() && points[i].y() <= boxes[j].high[1])
        expected.emplace_back(i, j);
  EXPECT_EQ(containing_pairs(points, boxes), expected);
}

}  // namespace
}  // namespace c1mesh::verification
