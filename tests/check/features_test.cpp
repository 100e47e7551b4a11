// SPDX-License-Identifier: GPL-3.0-or-later
// Which curves are features, of which region, and what is refused.
#include <gtest/gtest.h>

#include <numeric>

#include "bernstein/curve.h"
#include "check/drawings.h"

namespace c1mesh {
namespace {

using Curves = std::vector<std::vector<Point>>;

Shape shape_of(const Curves& curves) {
  return make_shape(drawing_of(curves));
}

Drawing marked(const Curves& boundary, const Curves& features) {
  Drawing drawing = drawing_of(boundary + features);
  for (std::size_t i = boundary.size(); i < drawing.curves.size(); ++i)
    drawing.curves[i].feature = true;
  return drawing;
}

// Per feature path of the only region: number of curves, negative if closed.
std::vector<int> paths(const Shape& shape) {
  EXPECT_EQ(shape.regions.size(), 1u);
  EXPECT_EQ(broken_promise(shape), "");
  std::vector<int> out;
  for (const FeaturePath& path : shape.regions.at(0).features) {
    for (std::size_t i = 0; i + 1 < path.curves.size() + path.closed; ++i) {
      const CurveUse a = path.curves[i], b = path.curves[(i + 1) % path.curves.size()];
      const BezierCurve &c = shape.curves[a.curve], &d = shape.curves[b.curve];
      EXPECT_EQ(a.reversed ? c.start() : c.end(), b.reversed ? d.end() : d.start());
    }
    const int size = static_cast<int>(path.curves.size());
    out.push_back(path.closed ? -size : size);
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::multiset<DefectKind> notes(const Shape& shape) {
  std::multiset<DefectKind> out;
  for (const Defect& defect : shape.notes) out.insert(defect.kind);
  return out;
}

TEST(Features, OpenCurvesInside) {
  // Free, two in a row, and one from a corner.
  const Shape shape = shape_of(
      square(0, 0, 10) +
      Curves{{{2, 2}, {3, 5}, {4, 2}}, {{4, 6}, {5, 6}}, {{6, 8}, {5, 6}}, {{10, 10}, {9, 8}}});
  EXPECT_EQ(paths(shape), (std::vector<int>{1, 1, 2}));
  EXPECT_TRUE(notes(shape).empty());
}

TEST(Features, WithinABlockTheOutermostLoopBounds) {
  // A diagonal; a fan of four curves from a point inside; a zigzag between two sides' ends.
  EXPECT_EQ(paths(shape_of(square(0, 0, 10) + Curves{{{0, 0}, {10, 10}}})), std::vector<int>{1});
  EXPECT_EQ(
      paths(shape_of(
          square(0, 0, 10) +
          Curves{{{0, 0}, {4, 5}}, {{10, 0}, {4, 5}}, {{4, 5}, {10, 10}}, {{4, 5}, {0, 10}}})),
      (std::vector<int>{1, 1, 1, 1}));
  EXPECT_EQ(paths(shape_of(square(0, 0, 10) +
                           Curves{{{0, 0}, {4, 5}}, {{4, 5}, {5, 3}}, {{5, 3}, {10, 10}}})),
            std::vector<int>{3});
}

TEST(Features, TheOrderAndDirectionOfCurvesDoNotMatter) {
  Curves curves = square(0, 0, 10) + Curves{{{0, 0}, {4, 5}}, {{4, 5}, {10, 10}}, {{4, 5}, {3, 8}}};
  std::vector<std::size_t> order(curves.size());
  std::iota(order.begin(), order.end(), 0);
  for (int round = 0; round < 7; ++round) {
    std::rotate(order.begin(), order.begin() + 1, order.end());
    Curves turned;
    for (const std::size_t i : order) turned.push_back(curves[i]);
    std::reverse(turned[round % turned.size()].begin(), turned[round % turned.size()].end());
    EXPECT_EQ(paths(shape_of(turned)), (std::vector<int>{1, 1, 1}));
  }
}

TEST(Features, AnInnerLoopIsAHoleUnlessMarked) {
  EXPECT_EQ(shape_of(square(0, 0, 10) + square(3, 3, 2)).regions[0].holes.size(), 1u);
  const Shape shape = make_shape(marked(square(0, 0, 10), square(3, 3, 2)));
  EXPECT_EQ(paths(shape), std::vector<int>{-4});
  EXPECT_TRUE(shape.regions[0].holes.empty());
}

TEST(Features, ABridgeFromTheHoleLeavesItAHole) {
  const Shape shape = shape_of(square(0, 0, 10) + square(4, 4, 2) + Curves{{{0, 0}, {4, 4}}});
  EXPECT_EQ(paths(shape), std::vector<int>{1});
  EXPECT_EQ(shape.regions[0].holes.size(), 1u);
  // Two bridges make one block of all: the inner loop would lie inside. Marks tell otherwise.
  const Curves two = {{{0, 0}, {4, 4}}, {{10, 10}, {6, 6}}};
  EXPECT_TRUE(shape_of(square(0, 0, 10) + square(4, 4, 2) + two).regions[0].holes.empty());
  EXPECT_EQ(make_shape(marked(square(0, 0, 10) + square(4, 4, 2), two)).regions[0].holes.size(),
            1u);
}

TEST(Features, GoToTheRegionTheyLieIn) {
  // A ring and an island in its hole; one feature in each, one given before all else.
  const Shape shape = shape_of(Curves{{{4.4, 4.5}, {5.5, 5}}} + square(0, 0, 10) + square(2, 2, 6) +
                               square(4, 4, 2) + Curves{{{1, 1}, {1, 5}}});
  ASSERT_EQ(shape.regions.size(), 2u);
  for (const Region& region : shape.regions) {
    ASSERT_EQ(region.features.size(), 1u);
    EXPECT_EQ(region.holes.empty(), region.features[0].curves[0].curve == 0);
  }
}

TEST(Features, ACurveGivenByBothPartsIsOne) {
  const Point a(5, 0), b(5, 10);
  const Curves left = polygon({{0, 0}, a, b, {0, 10}});
  const Curves right = polygon({a, {10, 0}, {10, 10}, b});
  const Shape shape = shape_of(left + right);
  EXPECT_EQ(shape.curves.size(), 7u);
  EXPECT_EQ(paths(shape), std::vector<int>{1});
  EXPECT_EQ(shape.regions[0].outer.size(), 6u);
  ASSERT_EQ(shape.notes.size(), 1u);
  EXPECT_EQ(shape.notes[0].curves, (std::vector<std::string>{"1", "7"}));
  // Given twice where it bounds, it remains a defect.
  EXPECT_EQ(fault_kinds(drawing_of(left + Curves{left[0]})), Kinds{DefectKind::duplicate});
}

TEST(Features, CopiesMayDifferByRoundingAndDegree) {
  const double h = 1e-14;
  const Point a(5, 0), b(5, 10);
  const Curves left = polygon({{0, 0}, a, b, {0, 10}});
  Curves right = {{{5 + h, h}, {10, 0}}, {{10, 0}, {10, 10}}, {{10, 10}, {5 - h, 10}}};
  right.push_back({{5 - h, 10}, {5, 5}, {5 + h, h}});
  const Shape shape = shape_of(left + right);
  EXPECT_EQ(shape.curves.size(), 7u);
  EXPECT_EQ(paths(shape), std::vector<int>{1});
}

TEST(Features, SeveralEndsThatNearlyMeetAreJoined) {
  const Curves star = {{{4, 4}, {2, 2}}, {{4.01, 4}, {7, 2}}, {{4, 4.01}, {5, 8}}};
  const Shape shape = shape_of(square(0, 0, 10) + star);
  EXPECT_EQ(paths(shape), (std::vector<int>{1, 1, 1}));
  const Point centre = shape.curves[4].start();
  EXPECT_EQ(shape.curves[5].start(), centre);
  EXPECT_EQ(shape.curves[6].start(), centre);
}

TEST(Features, CurvesTouchedInsideAreCut) {
  // The end lies on the parabola at t = 1/4 exactly, at (2.5, 0) beside the first curve's ends.
  const Curves outline = {{{0, 0}, {5, 0}, {10, 0}}, {{10, 0}, {5, 16}, {0, 0}}};
  const Point on = evaluate(BezierCurve{outline[1]}, 0.25);
  const Shape shape = shape_of(outline + Curves{{{2.5, 0}, {3, 2}, on}});
  EXPECT_EQ(paths(shape), std::vector<int>{1});
  EXPECT_EQ(shape.curves.size(), 5u);
  EXPECT_EQ(shape.regions[0].outer.size(), 4u);
  // The parts are the curve: compare at two parameters of each.
  for (const auto& [part, low, high] : {std::tuple(1, 0.0, 0.25), std::tuple(4, 0.25, 1.0)})
    for (const double t : {0.0, 0.3, 1.0}) {
      const Point p = evaluate(shape.curves[part], t);
      EXPECT_LT((p - evaluate(BezierCurve{outline[1]}, low + t * (high - low))).norm(), 1e-14);
    }
}

TEST(Features, CurvesAreCutWhereOthersMeetOnThem) {
  // Two features end in one point of a side; two more make a lens between two sides.
  const Curves fan = {{{4, 0}, {3, 3}}, {{4, 0}, {5, 3}}};
  const Curves lens = {{{0, 5}, {5, 8}, {10, 5}}, {{0, 5}, {5, 4}, {10, 5}}};
  const Shape shape = shape_of(square(0, 0, 10) + fan + lens);
  EXPECT_EQ(paths(shape), (std::vector<int>{1, 1, 1, 1}));
  EXPECT_EQ(shape.regions[0].outer.size(), 7u);
  // Loops that touch remain a defect.
  EXPECT_EQ(fault_kinds(drawing_of(square(0, 0, 10) + fan + polygon({{0, 5}, {2, 6}, {2, 7}}))),
            Kinds{DefectKind::touching});
}

TEST(Features, EndsNearlyOnACurveAreMovedThere) {
  const Shape shape = shape_of(square(0, 0, 10) + Curves{{{4, 0.01}, {6, 5}}});
  EXPECT_EQ(paths(shape), std::vector<int>{1});
  EXPECT_EQ(notes(shape), (std::multiset<DefectKind>{DefectKind::gap}));
  EXPECT_EQ(shape.curves[4].start(), Point(4, 0));
  // Nearly on a joint: to the joint, and nothing is cut.
  const Shape joint = shape_of(square(0, 0, 10) + Curves{{{0.01, 0.01}, {6, 5}}});
  EXPECT_EQ(joint.curves.size(), 5u);
  EXPECT_EQ(joint.curves[4].start(), Point(0, 0));
  // Farther than the tolerance: it stays a free end.
  EXPECT_EQ(shape_of(square(0, 0, 10) + Curves{{{4, 0.03}, {6, 5}}}).curves.size(), 5u);
}

TEST(Features, CrossingFeaturesAreCut) {
  const Shape shape =
      shape_of(square(0, 0, 8) + Curves{{{1, 1}, {7, 7}}, {{1, 7}, {7, 1}}, {{0, 0}, {4, 4.5}}});
  // The diagonals meet at (4, 4); the third crosses the second.
  EXPECT_EQ(shape.curves.size(), 4u + 2 + 3 + 2);
  EXPECT_EQ(paths(shape).size(), 7u);
  // Features may not cross what bounds.
  EXPECT_EQ(fault_kinds(drawing_of(square(0, 0, 10) + Curves{{{5, 5}, {15, 6}}}))
                .count(DefectKind::crossing),
            1u);
}

TEST(Features, OutsideTheShapeTheyAreRefused) {
  EXPECT_EQ(fault_kinds(drawing_of(square(0, 0, 1) + Curves{{{2, 2}, {3, 3}}})),
            Kinds{DefectKind::open_loop});
  EXPECT_EQ(fault_kinds(drawing_of(square(0, 0, 9) + square(3, 3, 3) + Curves{{{4, 4}, {5, 5}}})),
            Kinds{DefectKind::open_loop});
  EXPECT_EQ(fault_kinds(marked(square(0, 0, 1), square(2, 2, 1))), Kinds{DefectKind::open_loop});
}

TEST(Features, AChainThatNearlyClosesIsNoFeature) {
  Curves hole = square(3, 3, 2);
  hole[3][1] = {3.1, 3.1};
  EXPECT_EQ(fault_kinds(drawing_of(square(0, 0, 10) + hole)), Kinds{DefectKind::open_loop});
  EXPECT_TRUE(check(marked(square(0, 0, 10), hole)).usable());
}

TEST(Features, ZeroAnglesAtBranchPointsAreCusps) {
  const Curves tangent = {{{10, 0}, {5, 0}, {4, 5}}};
  EXPECT_GE(fault_kinds(drawing_of(square(0, 0, 10) + tangent)).count(DefectKind::cusp), 1u);
  EXPECT_TRUE(check(drawing_of(square(0, 0, 10) + Curves{{{10, 0}, {5, 1}, {4, 5}}})).usable());
}

TEST(Features, MarksAreReadAndWritten) {
  const Drawing drawing = marked(square(0, 0, 10), {{{1, 1}, {2, 3}}});
  EXPECT_TRUE(drawing.curves.back().feature);
  EXPECT_EQ(paths(make_shape(drawing)), std::vector<int>{1});
}

}  // namespace
}  // namespace c1mesh
