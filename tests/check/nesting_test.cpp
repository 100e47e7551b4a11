// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "check/drawings.h"
#include "check/winding.h"

namespace c1mesh {
namespace {

std::vector<std::size_t> holes_of(const Shape& shape) {
  std::vector<std::size_t> out;
  for (const Region& region : shape.regions) out.push_back(region.holes.size());
  return out;
}

TEST(Nesting, EvenOddAlternatesWhateverTheDirection) {
  // Squares within squares, some clockwise: ring, island with hole, and one beside.
  const Drawing drawing = drawing_of(square(3, 3, 4) + backward(square(0, 0, 10)) +
                                     square(1, 1, 8) + square(4, 4, 2) + square(20, 0, 1));
  const Shape shape = make_shape(drawing);
  EXPECT_EQ(broken_promise(shape), "");
  EXPECT_EQ(holes_of(shape), (std::vector<std::size_t>{1, 1, 0}));
  // Regions come in the order of their first curves: the island was given first.
  EXPECT_EQ(shape.regions[0].outer[0].curve, 0);
  EXPECT_EQ(shape.regions[0].holes[0][0].curve, 12);
}

TEST(Nesting, NonzeroDecidesByDirection) {
  const auto both = square(0, 0, 10) + square(2, 2, 3);
  const auto opposite = square(0, 0, 10) + backward(square(2, 2, 3));
  // The inner loop turns the same way: it bounds nothing.
  const Shape filled = make_shape(drawing_of(both, FillRule::nonzero));
  EXPECT_EQ(holes_of(filled), (std::vector<std::size_t>{0}));
  ASSERT_EQ(filled.notes.size(), 1u);
  EXPECT_EQ(filled.notes[0].curves.size(), 4u);
  EXPECT_EQ(holes_of(make_shape(drawing_of(opposite, FillRule::nonzero))),
            (std::vector<std::size_t>{1}));
  EXPECT_EQ(holes_of(make_shape(drawing_of(both, FillRule::even_odd))),
            (std::vector<std::size_t>{1}));
}

TEST(Nesting, NonzeroHoleNeedsTheWindingToReachZero) {
  // Windings inward 1, 2, 1, 0: only the outermost and the innermost loop separate.
  const Shape shape = make_shape(drawing_of(
      square(0, 0, 10) + square(1, 1, 8) + backward(square(2, 2, 6)) + backward(square(3, 3, 4)),
      FillRule::nonzero));
  EXPECT_EQ(broken_promise(shape), "");
  EXPECT_EQ(holes_of(shape), (std::vector<std::size_t>{1}));
  EXPECT_EQ(shape.regions[0].holes[0][0].curve, 12);
}

// Loops beside each other whose boxes nest: boxes do not decide.
TEST(Nesting, ALoopInTheBayOfAnotherIsOutside) {
  const Drawing drawing =
      drawing_of(polygon({{0, 0}, {10, 0}, {10, 10}, {8, 10}, {8, 2}, {2, 2}, {2, 10}, {0, 10}}) +
                 square(4, 4, 2));
  EXPECT_EQ(holes_of(make_shape(drawing)), (std::vector<std::size_t>{0, 0}));
}

// Rays through vertices and along edges, the traps of point location.
TEST(Nesting, RaysThroughVerticesCountOnce) {
  for (const double y : {0.0, 1.0, 2.0, 3.0, 4.0}) {
    const Drawing drawing = drawing_of(
        polygon({{4, -6}, {10, 0}, {9, 1}, {10, 2}, {8, 2}, {8, 3}, {10, 4}, {4, 10}, {-6, 2}}) +
        polygon({{2, y}, {2.5, y - 0.3}, {2.5, y + 0.3}}));
    EXPECT_EQ(holes_of(make_shape(drawing)), (std::vector<std::size_t>{1})) << y;
  }
}

TEST(Nesting, HoleCloseToACurvedBoundary) {
  // Just inside and just outside the bulge of a cubic: its top is at 3/4 of the handles' height.
  for (const double dy : {-1e-7, 1e-7}) {
    const double tip = 0.75 + (dy < 0 ? dy : dy);
    const double base = dy < 0 ? 0.5 : 1;
    const Drawing drawing = drawing_of({{{0, 0}, {0, 1}, {1, 1}, {1, 0}},
                                        {{1, 0}, {0, 0}},
                                        {{0.5, tip}, {0.49, base}},
                                        {{0.49, base}, {0.51, base}},
                                        {{0.51, base}, {0.5, tip}}});
    const Shape shape = make_shape(drawing);
    EXPECT_EQ(shape.regions.size(), dy < 0 ? 1u : 2u);
    EXPECT_EQ(broken_promise(shape), "");
  }
}

TEST(Nesting, ManyHoles) {
  std::vector<std::vector<Point>> curves = square(-1, -1, 202);
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 20; ++j) {
      const auto hole = square(2 * i, 10 * j, 1);
      curves.insert(curves.end(), hole.begin(), hole.end());
    }
  EXPECT_EQ(holes_of(make_shape(drawing_of(curves))), (std::vector<std::size_t>{2000}));
}

TEST(Nesting, ManyHolesFeaturesAndIslandsGoToTheirRegions) {
  // Frames with a hole each, an island in each hole, and a line on each frame and island.
  std::vector<std::vector<Point>> curves;
  constexpr int kSide = 6;
  for (int x = 0; x < kSide; ++x)
    for (int y = 0; y < kSide; ++y) {
      curves = curves + square(10 * x, 10 * y, 8) + square(10 * x + 2, 10 * y + 2, 4) +
               square(10 * x + 3, 10 * y + 3, 2);
    }
  for (int x = 0; x < kSide; ++x)
    for (int y = 0; y < kSide; ++y)
      for (const double at : {1.0, 3.5})
        curves.push_back({{10 * x + at, 10 * y + at}, {10 * x + at + .3, 10 * y + at}});
  const Shape shape = make_shape(drawing_of(curves));
  EXPECT_EQ(broken_promise(shape), "");
  ASSERT_EQ(shape.regions.size(), 2u * kSide * kSide);
  for (const Region& region : shape.regions) {
    const bool frame = region.holes.size() == 1;
    ASSERT_EQ(region.features.size(), 1u);
    const Point corner = shape.curves[region.outer[0].curve].start();
    const Point start = shape.curves[region.features[0].curves[0].curve].start();
    EXPECT_LT((start - corner).norm(), frame ? 12 : 3);
  }
}

// A piece that contains the point is halved around it: at the end of a double's digits no longer,
// or each of these would take a hundred million halvings.
TEST(Winding, APointOnALineTakesNoTime) {
  detail::Pieces pieces;
  detail::Piece line;
  line.curve = 0;
  pieces.first = {0, 1};
  for (const double slope : {0.0, 1.0, -3.0, 1e-9}) {
    line.poles = {{0, 0.25}, {1, 0.25 + slope}};
    pieces.all = {line};
    for (int k = 0; k <= 50; ++k) {
      const double x = k / 50.0;
      const int crossings = detail::winding_number(Loop{{0, false}}, pieces, {x, 0.25 + slope * x});
      EXPECT_LE(std::abs(crossings), 1);
      if (slope == 0) {
        EXPECT_EQ(crossings, 0);
      }
    }
  }
}

}  // namespace
}  // namespace c1mesh
