// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "check/drawings.h"

namespace c1mesh {
namespace {

const Defect* find(const std::vector<Defect>& defects, DefectKind kind) {
  for (const Defect& defect : defects)
    if (defect.kind == kind) return &defect;
  return nullptr;
}

TEST(Screen, NumbersThatCannotBeWorkedWith) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {inf, -inf, std::nan(""), 1e300, 1e200}) {
    auto curves = square(0, 0, 1);
    curves[2][1] = {bad, 0};
    EXPECT_EQ(fault_kinds(drawing_of(curves)), Kinds{DefectKind::non_finite}) << bad;
    EXPECT_THROW(make_shape(drawing_of(curves)), InputError);
  }
  EXPECT_EQ(fault_kinds(drawing_of(square(1e12, 0, 1e-6))), Kinds{DefectKind::non_finite});
  EXPECT_EQ(fault_kinds(drawing_of({{{2, 3}, {2, 3}}})), Kinds{DefectKind::zero_length});
  EXPECT_EQ(fault_kinds(drawing_of({})), Kinds{DefectKind::empty});
  EXPECT_EQ(fault_kinds(drawing_of({{{2, 3}}})), Kinds{DefectKind::malformed});
  EXPECT_EQ(fault_kinds(drawing_of({std::vector<Point>(1000, Point(1, 2))})),
            Kinds{DefectKind::limit});
}

TEST(Screen, FrameIsAPowerOfTwoAroundTheControlPoints) {
  const Shape shape = make_shape(drawing_of(square(-3, 5, 10)));
  EXPECT_EQ(shape.frame.origin, Point(-3, 5));
  EXPECT_EQ(shape.frame.exponent, 4);
  EXPECT_EQ(make_shape(drawing_of(square(0, 0, 8))).frame.exponent, 3);
  EXPECT_EQ(make_shape(drawing_of(square(0, 0, 0.25))).frame.exponent, -2);
}

// Scaling by a power of two changes nothing but the numbers.
TEST(Screen, WorksAlikeAtEveryScaleAndFarAway) {
  for (const double scale : {0x1p-150, 1.0, 0x1p150})
    EXPECT_TRUE(check(drawing_of(square(0, 0, 3 * scale) + square(scale, scale, scale))).usable());
  EXPECT_TRUE(check(drawing_of(square(1e9, -1e9, 3))).usable());
}

TEST(Repairs, ZeroLengthCurvesAreLeftOut) {
  auto curves = square(0, 0, 1);
  curves.insert(curves.begin() + 1, {{1, 0}, {1, 0}, {1, 0}, {1, 0}});
  const Shape shape = make_shape(drawing_of(curves));
  EXPECT_EQ(shape.curves.size(), 4u);
  EXPECT_EQ(shape.curve_ids, (std::vector<std::string>{"0", "2", "3", "4"}));
  const Defect* said = find(shape.notes, DefectKind::zero_length);
  ASSERT_TRUE(said);
  EXPECT_TRUE(said->repaired);
  EXPECT_EQ(said->curves, std::vector<std::string>{"1"});
  EXPECT_EQ(broken_promise(shape), "");
}

// A closing segment made of rounding goes, and the joint it bridged becomes exact.
TEST(Repairs, CurvesBelowTheResolutionAreLeftOutAndTheJointClosed) {
  auto curves = polygon({{0, 0}, {1, 0}, {1, 1}, {1e-15, 1e-15}});
  const Shape shape = make_shape(drawing_of(curves));
  EXPECT_EQ(shape.curves.size(), 3u);
  EXPECT_EQ(broken_promise(shape), "");
}

TEST(Repairs, SmallGapsAreClosedAtTheirMiddle) {
  auto curves = square(0, 0, 1);
  curves[0][1] = {1, -1e-3};
  curves[1][0] = {1, 1e-3};
  const Shape shape = make_shape(drawing_of(curves));
  EXPECT_EQ(shape.curves[0].end(), Point(1, 0));
  EXPECT_EQ(shape.curves[1].start(), Point(1, 0));
  const Defect* said = find(shape.notes, DefectKind::gap);
  ASSERT_TRUE(said);
  EXPECT_TRUE(said->repaired);
  EXPECT_EQ(said->curves, (std::vector<std::string>{"0", "1"}));
  EXPECT_EQ(said->where.size(), 2u);
}

TEST(Repairs, HandlesMoveWithTheirEnds) {
  const Drawing drawing = drawing_of(
      {{{0, 0}, {0.25, -0.5}, {0.75, -0.5}, {1, 1e-3}}, {{1, -1e-3}, {1, 0.5}, {0.5, 1}, {0, 0}}});
  const Shape shape = make_shape(drawing);
  EXPECT_EQ(shape.curves[0].end(), Point(1, 0));
  EXPECT_EQ(shape.curves[0].poles[1], Point(0.25, -0.5));
  EXPECT_LT((shape.curves[0].poles[2] - Point(0.75, -0.501)).norm(), 1e-15);
  EXPECT_LT((shape.curves[1].poles[1] - Point(1, 0.501)).norm(), 1e-15);
}

TEST(Repairs, WideOrAmbiguousGapsAreNotClosed) {
  auto wide = square(0, 0, 1);
  wide[0][1] = {1, -3e-3};
  EXPECT_EQ(fault_kinds(drawing_of(wide)), Kinds{DefectKind::open_loop});
  CheckOptions generous;
  generous.gap_tolerance = 0.01;
  EXPECT_TRUE(check(drawing_of(wide), generous).usable());
  // Three ends of which none is clearly nearest.
  auto three = square(0, 0, 1);
  three[0][1] = {1, -1e-3};
  three[1][0] = {1, 1e-3};
  three.push_back({{1.0005, 0}, {2, 0}});
  const auto found = faults(drawing_of(three));
  ASSERT_FALSE(found.empty());
  for (const Defect& defect : found) EXPECT_EQ(defect.kind, DefectKind::open_loop);
}

TEST(Repairs, StraightCurvesAtRestGetAnEvenSpeed) {
  for (const auto& poles : {std::vector<Point>{{0, 0}, {0, 0}, {3, 0}},
                            std::vector<Point>{{0, 0}, {0, 0}, {1, 0}, {3, 0}},
                            std::vector<Point>{{0, 0}, {0, 0}, {3, 0}, {3, 0}}}) {
    const Shape shape = make_shape(drawing_of({poles, {{3, 0}, {0, 2}}, {{0, 2}, {0, 0}}}));
    const int n = shape.curves[0].degree();
    ASSERT_EQ(n + 1, static_cast<int>(poles.size()));
    for (int i = 0; i <= n; ++i)
      EXPECT_LT((shape.curves[0].poles[i] - Point(3.0 * i / n, 0)).norm(), 1e-15);
    EXPECT_TRUE(find(shape.notes, DefectKind::handle));
  }
}

TEST(Repairs, CoincidingInnerPolesAreLegal) {
  const Shape shape = make_shape(
      drawing_of({{{0, 0}, {1, -1}, {1, -1}, {2, 0}}, {{2, 0}, {1, 2}}, {{1, 2}, {0, 0}}}));
  EXPECT_EQ(shape.curves[0].poles[1], Point(1, -1));
  EXPECT_TRUE(shape.notes.empty());
}

TEST(Repairs, ShortLinesStayAndAreNoted) {
  const Shape shape = make_shape(drawing_of(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 1e-3}})));
  EXPECT_EQ(shape.curves.size(), 5u);
  ASSERT_EQ(shape.notes.size(), 1u);
  EXPECT_EQ(shape.notes[0].curves, std::vector<std::string>{"4"});
  // Fine sampling of a curve is no such thing.
  std::vector<Point> circle;
  for (int i = 0; i < 5000; ++i)
    circle.emplace_back(std::cos(i * 2 * M_PI / 5000), std::sin(i * 2 * M_PI / 5000));
  EXPECT_TRUE(make_shape(drawing_of(polygon(circle))).notes.empty());
}

TEST(Regularity, VanishingDerivatives) {
  const auto with = [](const std::vector<Point>& poles) {
    return faults(drawing_of({poles, {poles.back(), {1, -5}}, {{1, -5}, poles.front()}}));
  };
  // At an end.
  auto found = with({{0, 0}, {0, 0}, {1, 1.5}, {3, 0}});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, DefectKind::vanishing_derivative);
  EXPECT_EQ(found[0].where.at(0), Point(0, 0));
  // Inside: the cubic with handles crossed so that it has a cusp at t = 1/2, at (0, 3/4).
  found = with({{-1, 0}, {1, 1}, {-1, 1}, {1, 0}});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, DefectKind::vanishing_derivative);
  EXPECT_LT((found[0].where.at(0) - Point(0, 0.75)).norm(), 1e-6);
  // A straight one that runs back on itself.
  found = with({{0, 0}, {2, 0}, {-1, 0}, {1, 0}});
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].kind, DefectKind::vanishing_derivative);
}

TEST(Regularity, CuspsByTheirAngle) {
  const auto wedge = [](double degrees) {
    const double a = degrees * M_PI / 180;
    return drawing_of(polygon({{0, 0}, {1, 0}, {std::cos(a), std::sin(a)}}));
  };
  EXPECT_EQ(fault_kinds(wedge(1e-5)), Kinds{DefectKind::cusp});
  EXPECT_TRUE(check(wedge(0.85)).usable());
  EXPECT_TRUE(check(wedge(1e-3)).usable());
  // Curves that leave a joint in the same direction, curving apart.
  const Drawing horn =
      drawing_of({{{0, 0}, {1, 0}, {2, 1}}, {{2, 1}, {2, -1}}, {{2, -1}, {1, 0}, {0, 0}}});
  const auto found = faults(horn);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, DefectKind::cusp);
  EXPECT_EQ(found[0].where.at(0), Point(0, 0));
}

}  // namespace
}  // namespace c1mesh
