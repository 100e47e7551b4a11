// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bernstein/curve.h"
#include "check/drawings.h"

namespace c1mesh {

double sampled_area(const Shape& shape, const Loop& loop, int samples) {
  std::vector<Point> points;
  for (const CurveUse& use : loop)
    for (int k = 0; k < samples; ++k) {
      const double t = double(k) / samples;
      points.push_back(evaluate(shape.curves[use.curve], use.reversed ? 1 - t : t));
    }
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += cross(points[i] - points[0], points[(i + 1) % points.size()] - points[0]);
  return sum;
}

std::string broken_promise(const Shape& shape) {
  std::set<int> used;
  const auto broken = [&](const Loop& loop, int sign) -> std::string {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const CurveUse a = loop[i], b = loop[(i + 1) % loop.size()];
      if (!used.insert(a.curve).second) return "a curve is used twice";
      const BezierCurve &c = shape.curves[a.curve], &d = shape.curves[b.curve];
      if ((a.reversed ? c.start() : c.end()) != (b.reversed ? d.end() : d.start()))
        return "a loop does not close bit for bit";
    }
    return sign * sampled_area(shape, loop) > 0 ? "" : "a loop turns the wrong way";
  };
  if (shape.regions.empty()) return "no region";
  for (const Region& region : shape.regions) {
    if (const std::string said = broken(region.outer, 1); !said.empty()) return said;
    for (const Loop& hole : region.holes)
      if (const std::string said = broken(hole, -1); !said.empty()) return said;
  }
  return "";
}

namespace {

// A loop as the multiset of its curves by id with the direction in which the points run.
std::set<std::string> described(const Shape& shape, const Loop& loop) {
  std::set<std::string> out;
  for (const CurveUse& use : loop) {
    const BezierCurve& curve = shape.curves[use.curve];
    const Point from = use.reversed ? curve.end() : curve.start();
    out.insert(shape.curve_ids[use.curve] + " from " + std::to_string(from.x()) + " " +
               std::to_string(from.y()));
  }
  return out;
}

std::set<std::set<std::string>> described(const Shape& shape) {
  std::set<std::set<std::string>> out;
  for (const Region& region : shape.regions) {
    out.insert(described(shape, region.outer));
    for (const Loop& hole : region.holes) out.insert(described(shape, hole));
  }
  return out;
}

Drawing target() {
  return drawing_of(square(0, 0, 10) + square(1, 1, 3) + backward(square(5, 5, 4)) +
                    square(6, 6, 1) + square(20, 0, 2));
}

TEST(Joining, OrderAndDirectionOfCurvesDoNotMatter) {
  const auto expected = described(make_shape(target()));
  EXPECT_EQ(expected.size(), 5u);
  std::mt19937 random(5);
  for (int round = 0; round < 50; ++round) {
    Drawing drawing = target();
    for (std::size_t i = drawing.curves.size() - 1; i > 0; --i)
      std::swap(drawing.curves[i], drawing.curves[random() % (i + 1)]);
    for (InputCurve& input : drawing.curves)
      if (random() % 2) std::reverse(input.curve.poles.begin(), input.curve.poles.end());
    const Shape shape = make_shape(drawing);
    EXPECT_EQ(broken_promise(shape), "");
    EXPECT_EQ(described(shape), expected);
  }
}

TEST(Joining, BackwardCurvesAreNoted) {
  auto curves = square(0, 0, 1);
  std::swap(curves[2][0], curves[2][1]);
  const Shape shape = make_shape(drawing_of(curves));
  ASSERT_EQ(shape.notes.size(), 1u);
  EXPECT_EQ(shape.notes[0].kind, DefectKind::note);
  EXPECT_EQ(shape.notes[0].curves, std::vector<std::string>{"2"});
  EXPECT_EQ(shape.curves[2].poles, curves[2]);
  // A clockwise outer loop is no fault and nothing to tell.
  EXPECT_TRUE(make_shape(drawing_of(backward(square(0, 0, 1)))).notes.empty());
}

TEST(Joining, OpenChainsNameTheirCurvesAndEnds) {
  auto curves = square(0, 0, 1) + square(5, 5, 1);
  curves.pop_back();
  const auto found = faults(drawing_of(curves));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, DefectKind::open_loop);
  EXPECT_EQ(std::set<std::string>(found[0].curves.begin(), found[0].curves.end()),
            (std::set<std::string>{"4", "5", "6"}));
  ASSERT_EQ(found[0].where.size(), 2u);
  EXPECT_FALSE(found[0].remedy.empty());
}

TEST(Joining, BranchingsAndTouchingLoops) {
  EXPECT_EQ(
      fault_kinds(drawing_of(square(0, 0, 1) + std::vector<std::vector<Point>>{{{1, 1}, {2, 2}}})),
      (Kinds{DefectKind::branching, DefectKind::open_loop}));
  // Two squares share a corner.
  const auto found = faults(drawing_of(square(0, 0, 1) + square(1, 1, 1)));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, DefectKind::touching);
  EXPECT_EQ(found[0].where.at(0), Point(1, 1));
  EXPECT_EQ(found[0].curves.size(), 4u);
}

TEST(Joining, OneCurveCanBeALoop) {
  const Shape drop = make_shape(drawing_of({{{0, 0}, {3, 3}, {-3, 3}, {0, 0}}}));
  EXPECT_EQ(broken_promise(drop), "");
  const Shape turned = make_shape(drawing_of({{{0, 0}, {-3, 3}, {3, 3}, {0, 0}}}));
  EXPECT_EQ(broken_promise(turned), "");
  EXPECT_NE(drop.regions[0].outer[0].reversed, turned.regions[0].outer[0].reversed);
}

TEST(Joining, NegativeZeroIsZero) {
  const Shape shape =
      make_shape(drawing_of({{{0.0, -0.0}, {1, 0}}, {{1, 0}, {0, 1}}, {{0, 1}, {-0.0, 0.0}}}));
  EXPECT_FALSE(std::signbit(shape.curves[2].end().x()));
  EXPECT_TRUE(shape.notes.empty());
}

}  // namespace
}  // namespace c1mesh
