// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bernstein/curve.h"
#include "check/drawings.h"

namespace c1mesh {
namespace {

double nearest(const std::vector<Defect>& found, const Point& p) {
  double best = INFINITY;
  for (const Defect& defect : found)
    for (const Point& q : defect.where) best = std::min(best, (p - q).norm());
  return best;
}

TEST(Crossings, ParabolaAndLineWhereAlgebraSays) {
  // y = x^2 over [-2, 2], closed above by y = 4; the other loop's bottom side is y = 2 from x = -5.
  const Drawing drawing = drawing_of({{{-2, 4}, {0, -4}, {2, 4}},
                                      {{2, 4}, {-2, 4}},
                                      {{-5, 2}, {5, 2}},
                                      {{5, 2}, {0, 9}},
                                      {{0, 9}, {-5, 2}}});
  const auto found = faults(drawing);
  ASSERT_EQ(found.size(), 2u);
  for (const Defect& defect : found) {
    EXPECT_EQ(defect.kind, DefectKind::crossing);
    EXPECT_EQ(defect.curves, (std::vector<std::string>{"0", "2"}));
  }
  EXPECT_LT(nearest(found, {std::sqrt(2.0), 2}), 1e-10);
  EXPECT_LT(nearest(found, {-std::sqrt(2.0), 2}), 1e-10);
}

TEST(Crossings, TwoCubicsInNinePoints) {
  // y = T(x) with T the Chebyshev polynomial 4x^3 - 3x and x = T(y) over [-1, 1] meet in 9 points:
  // with x = cos a, y = cos 3a the equation is cos 9a = cos a.
  const auto chebyshev = [](bool swap) {
    std::vector<Point> poles;
    // 4x^3 - 3x with x = 2t - 1 is 32t^3 - 48t^2 + 18t - 1; Bernstein coefficients -1, 5, -5, 1.
    const double y[] = {-1, 5, -5, 1}, x[] = {-1, -1.0 / 3, 1.0 / 3, 1};
    for (int i = 0; i < 4; ++i) poles.push_back(swap ? Point(y[i], x[i]) : Point(x[i], y[i]));
    return poles;
  };
  // Closed far outside; the corners (-1,-1) and (1,1) are common ends and touch.
  Drawing drawing = drawing_of({chebyshev(false), chebyshev(true)});
  const auto found = faults(drawing);
  int crossings = 0;
  for (const Defect& defect : found) crossings += defect.kind == DefectKind::crossing;
  EXPECT_EQ(crossings, 7);
  for (int k = 0; k < 9; ++k) {
    // cos 9a = cos a: a = k pi / 4 or k pi / 5.
    const double a = k < 5 ? k * M_PI / 4 : (k - 4) * M_PI / 5;
    if (k == 0 || k == 4) continue;
    EXPECT_LT(nearest(found, {std::cos(a), std::cos(3 * a)}), 1e-9) << k;
  }
}

TEST(Crossings, SelfIntersectionOfACubic) {
  // By symmetry on x = 1/2; poles (0,0) (3,2) (-2,2) (1,0): x(t) = 1/2 has t(1-t) = 1/16 ... and
  // y = 6 t (1-t), so y = 6/16.
  const auto found = faults(
      drawing_of({{{0, 0}, {3, 2}, {-2, 2}, {1, 0}}, {{1, 0}, {0.5, -1}}, {{0.5, -1}, {0, 0}}}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, DefectKind::self_intersection);
  EXPECT_LT((found[0].where[0] - Point(0.5, 0.375)).norm(), 1e-10);
}

TEST(Crossings, TangentialTouchingInsideBothCurves) {
  // The parabola y = x^2 from above and the line y = 0 from below.
  const auto found = faults(drawing_of({{{-1, 1}, {0, -1}, {1, 1}},
                                        {{1, 1}, {-1, 1}},
                                        {{-3, 0}, {0, -3}},
                                        {{0, -3}, {3, 0}},
                                        {{3, 0}, {-3, 0}}}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, DefectKind::touching);
  EXPECT_LT((found[0].where[0] - Point(0, 0)).norm(), 1e-5);
}

// The distance decides: apart by far more than the resolution is apart.
TEST(Crossings, NearlyTouchingIsNotTouching) {
  for (const double gap : {1e-6, 1e-9, 1e-11}) {
    const Drawing drawing = drawing_of({{{-1, 1 + gap}, {0, -1 + gap}, {1, 1 + gap}},
                                        {{1, 1 + gap}, {-1, 1 + gap}},
                                        {{-1, 0}, {0, -1}},
                                        {{0, -1}, {1, 0}},
                                        {{1, 0}, {-1, 0}}});
    EXPECT_TRUE(check(drawing).usable()) << gap;
  }
}

TEST(Crossings, VertexOnCurve) {
  // The tip of a triangle on the side of a square.
  const auto found = faults(drawing_of(square(0, 0, 4) + polygon({{0, 2}, {2, 1}, {2, 3}})));
  ASSERT_FALSE(found.empty());
  for (const Defect& defect : found) EXPECT_EQ(defect.kind, DefectKind::touching);
  EXPECT_LT(nearest(found, {0, 2}), 1e-12);
}

TEST(Crossings, OverlapsAndDuplicates) {
  auto twice = square(0, 0, 1);
  twice.push_back({{1, 0}, {0, 0}});
  EXPECT_EQ(fault_kinds(drawing_of(twice)), Kinds{DefectKind::duplicate});
  // Sides that coincide in part.
  const auto found = faults(drawing_of(square(0, 0, 2) + square(2, 0.5, 1)));
  EXPECT_EQ(std::count_if(found.begin(), found.end(),
                          [](const Defect& d) { return d.kind == DefectKind::duplicate; }),
            1);
  // A part of a curve: the parabola over [0, 1] and over [1/4, 3/4].
  const auto parts = faults(drawing_of({{{0, 0}, {0.5, 0}, {1, 1}},
                                        {{1, 1}, {0, 0}},
                                        {{0.25, 0.0625}, {0.5, 0.1875}, {0.75, 0.5625}},
                                        {{0.75, 0.5625}, {0.9, 0.1}},
                                        {{0.9, 0.1}, {0.25, 0.0625}}}));
  EXPECT_GE(std::count_if(parts.begin(), parts.end(),
                          [](const Defect& d) { return d.kind == DefectKind::duplicate; }),
            1);
}

TEST(Crossings, AdjacentCurvesThatMeetAgain) {
  // Two curves from the joint (0,0) that cross at a second point.
  const auto found =
      faults(drawing_of({{{2, 2}, {0, 2}, {0, 0}}, {{0, 0}, {4, 0.2}, {0, 3}}, {{0, 3}, {2, 2}}}));
  ASSERT_FALSE(found.empty());
  for (const Defect& defect : found) EXPECT_EQ(defect.kind, DefectKind::crossing);
}

TEST(Crossings, LensOfTwoArcsIsSimple) {
  EXPECT_TRUE(
      check(drawing_of({{{0, 0}, {1, -1e-3}, {2, 0}}, {{2, 0}, {1, 1e-3}, {0, 0}}})).usable());
}

TEST(Crossings, EverythingIsFoundAtOnce) {
  // A bow-tie, an open chain, a zero handle and a crossing pair in one drawing.
  const Drawing drawing = drawing_of(
      polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}) +
      std::vector<std::vector<Point>>{{{5, 5}, {6, 6}}} +
      std::vector<std::vector<Point>>{{{10, 0}, {10, 0}, {11, 1}, {12, 0}}, {{12, 0}, {10, 0}}} +
      square(20, 0, 2) + square(21, 1, 2));
  const Kinds kinds = fault_kinds(drawing);
  EXPECT_EQ(kinds.count(DefectKind::crossing), 3u);
  EXPECT_EQ(kinds.count(DefectKind::open_loop), 1u);
  EXPECT_EQ(kinds.count(DefectKind::vanishing_derivative), 1u);
  for (const Defect& defect : faults(drawing)) {
    EXPECT_FALSE(defect.curves.empty());
    EXPECT_FALSE(defect.where.empty());
    EXPECT_FALSE(defect.remedy.empty());
  }
}

// Dense polylines, compared segment by segment, know nothing of boxes, cones or bisection.
int polyline_crossings(const BezierCurve& a, const BezierCurve& b) {
  constexpr int n = 300;
  std::vector<Point> p, q;
  for (int k = 0; k <= n; ++k) {
    p.push_back(evaluate(a, double(k) / n));
    q.push_back(evaluate(b, double(k) / n));
  }
  const bool same = a.poles == b.poles;
  int count = 0;
  for (int i = 0; i < n; ++i)
    for (int j = same ? i + 2 : 0; j < n; ++j) {
      const Point u = p[i + 1] - p[i], v = q[j + 1] - q[j];
      if (cross(u, q[j] - p[i]) * cross(u, q[j + 1] - p[i]) < 0 &&
          cross(v, p[i] - q[j]) * cross(v, p[i + 1] - q[j]) < 0)
        ++count;
    }
  return count;
}

TEST(Crossings, RandomCurvesAgreeWithDensePolylines) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(0, 1);
  int total = 0;
  for (int round = 0; round < 100; ++round) {
    std::vector<std::vector<Point>> curves(2);
    for (auto& poles : curves)
      for (int i = 0; i <= 3 + round % 3; ++i) poles.emplace_back(place(random), place(random));
    const Drawing drawing = drawing_of(curves);
    const Kinds kinds = fault_kinds(drawing);
    const BezierCurve &a = drawing.curves[0].curve, &b = drawing.curves[1].curve;
    const int crossings = polyline_crossings(a, b);
    EXPECT_EQ(static_cast<int>(kinds.count(DefectKind::crossing)), crossings) << round;
    EXPECT_EQ(static_cast<int>(kinds.count(DefectKind::self_intersection)),
              polyline_crossings(a, a) + polyline_crossings(b, b))
        << round;
    total += crossings;
  }
  EXPECT_GT(total, 50);
}

// 5,000 teeth, lying and standing: neighbours only are compared.
TEST(Crossings, CombOfTenThousandCurves) {
  std::vector<std::vector<Point>> curves;
  const int teeth = 5000;
  for (int i = 0; i < teeth; ++i) {
    const double x = i;
    curves.push_back({{x, 0}, {x + 0.05, 20}, {x + 0.2, 50}, {x + 0.5, 50}});
    curves.push_back({{x + 0.5, 50}, {x + 0.8, 50}, {x + 0.95, 20}, {x + 1, 0}});
  }
  curves.push_back({{teeth, 0}, {teeth, -10}});
  curves.push_back({{teeth, -10}, {0, -10}});
  curves.push_back({{0, -10}, {0, 0}});
  for (int turn = 0; turn < 2; ++turn) {
    const Shape shape = make_shape(drawing_of(curves));
    EXPECT_EQ(shape.regions.size(), 1u);
    EXPECT_EQ(shape.regions[0].outer.size(), 10003u);
    for (auto& poles : curves)
      for (Point& p : poles) p = Point(-p.y(), p.x());
  }
}

// Hopeless input ends soon, with a list of bearable length.
TEST(Crossings, ThousandsOfCrossingsEndEarly) {
  std::vector<std::vector<Point>> curves;
  for (int i = 0; i < 200; ++i)
    curves = curves + polygon({{i * 1.0, 0}, {i + 0.5, 500}, {i + 0.7, 500}});
  for (int i = 0; i < 200; ++i)
    curves = curves + polygon({{-1, i + 1.0}, {300, i + 1.5}, {300, i + 1.7}});
  const auto found = faults(drawing_of(curves));
  EXPECT_GE(found.size(), 1000u);
  EXPECT_LE(found.size(), 1001u);
}

// Each pair of neighbours takes hundreds of thousands of halvings to be told apart; together they
// are refused before that takes minutes.
TEST(Crossings, ManyCurvesSideBySideEndEarly) {
  std::vector<std::vector<Point>> curves;
  for (int i = 0; i < 200; ++i) {
    const double y = 1e-11 * i;
    curves.push_back({{0, y}, {0.3, 1 + y}, {0.7, -1 + y}, {1, y}});
  }
  EXPECT_GE(fault_kinds(drawing_of(curves)).count(DefectKind::limit), 1u);
}

}  // namespace
}  // namespace c1mesh
