// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/path_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "read/scanner.h"

namespace c1mesh::detail {
namespace {

using PoleLists = std::vector<std::vector<Point>>;

PoleLists poles_of(const std::string& path) {
  PoleLists out;
  for (const auto& subpath : parse_path(path).subpaths)
    for (const BezierCurve& curve : subpath) out.push_back(curve.poles);
  return out;
}

TEST(PathData, EveryCommandAbsolute) {
  EXPECT_EQ(poles_of("M 1 2 L 3 4 H 5 V 6 C 7 8 9 10 11 12 S 13 14 15 16 Q 17 18 19 20 T 21 22 Z"),
            (PoleLists{{{1, 2}, {3, 4}},
                       {{3, 4}, {5, 4}},
                       {{5, 4}, {5, 6}},
                       {{5, 6}, {7, 8}, {9, 10}, {11, 12}},
                       {{11, 12}, {13, 14}, {13, 14}, {15, 16}},
                       {{15, 16}, {17, 18}, {19, 20}},
                       {{19, 20}, {21, 22}, {21, 22}},
                       {{21, 22}, {1, 2}}}));
}

TEST(PathData, RelativeIsAbsoluteFromTheCurrentPoint) {
  EXPECT_EQ(poles_of("m1 2l2 2h2v2c2 2 4 4 6 6s2 2 4 4q2 2 4 4t2 2z"),
            poles_of("M1 2L3 4H5V6C7 8 9 10 11 12S13 14 15 16Q17 18 19 20T21 22Z"));
}

TEST(PathData, CompactNumbersAndRepeatedCommands) {
  const PoleLists expected = {{{10, -0.5}, {0.5, -1.5}},
                              {{0.5, -1.5}, {3.5, 0.25}},
                              {{3.5, 0.25}, {0.5, 9}},
                              {{0.5, 9}, {10, -0.5}}};
  EXPECT_EQ(poles_of("M1e1-.5.5-1.5L3.5.25.5 9.Z"), expected);
  EXPECT_EQ(poles_of(" M+1E+1,-0.5 , 0.5 -15e-1\n\tL 3.5,.25 L.5 9 z "), expected);
}

TEST(PathData, SmoothHandlesReflectOnlyAfterTheirOwnKind) {
  // After a line the reflected handle is the current point itself.
  EXPECT_EQ(poles_of("M0 0L1 0S2 2 3 0Z")[1], (std::vector<Point>{{1, 0}, {1, 0}, {2, 2}, {3, 0}}));
  EXPECT_EQ(poles_of("M0 0Q1 1 2 0S3 3 4 0Z")[1][1], Point(2, 0));
  EXPECT_EQ(poles_of("M0 0C0 1 2 1 2 0T4 0Z")[1][1], Point(2, 0));
  EXPECT_EQ(poles_of("M0 0Q1 1 2 0T4 0T6 0Z")[2], (std::vector<Point>{{4, 0}, {5, 1}, {6, 0}}));
}

TEST(PathData, ClosingAtTheStartAddsNoCurve) {
  EXPECT_EQ(poles_of("M0 0L1 0L0 1L0 0Z").size(), 3u);
  EXPECT_EQ(poles_of("M0 0L1 0L0 1L0 0ZZZ").size(), 3u);
  EXPECT_EQ(parse_path("M0 0L1 0L0 1Z").closed_by_line, 0);
}

TEST(PathData, OpenSubpathsAreClosedAndCounted) {
  const Outline outline = parse_path("M0 0L1 0L0 1M5 5L6 5L5 6ZM9 9");
  ASSERT_EQ(outline.subpaths.size(), 2u);
  EXPECT_EQ(outline.subpaths[0].size(), 3u);
  EXPECT_EQ(outline.closed_by_line, 1);
}

TEST(PathData, AfterZTheNextSubpathBeginsAtTheStart) {
  EXPECT_EQ(poles_of("M1 1l1 0l0 1zl0 -1l-1 0z")[3], (std::vector<Point>{{1, 1}, {1, 0}}));
  EXPECT_EQ(poles_of("M1 1l1 0l0 1zm1 1l1 0l0 1z")[3], (std::vector<Point>{{2, 2}, {3, 2}}));
}

TEST(PathData, ErrorsAreRefused) {
  for (const char* bad : {"L0 0", "M0", "M0 0L1", "M0 0L1 1 2", "M0 0X1 1", "M0 0C1 1 2 2 3Z",
                          "M0 0L1,,1", "M0 0L1 1,", "M 0 0 L 1e999 0", "M0 0L--1 0", "M0 0L. 0",
                          "M0 0A1 1 0 2 0 1 1", "M0 0A1 1 0 1", "0 0", "M0 0 # L1 1", "M&i;"})
    EXPECT_THROW(parse_path(bad), SyntaxError) << bad;
  try {
    parse_path("M0 0L1 1L2 ?");
    FAIL();
  } catch (const SyntaxError& error) {
    EXPECT_EQ(error.position, 11u);
  }
}

TEST(PathData, EmptyPathsDrawNothing) {
  for (const char* empty : {"", "  ", "none", "M0 0", "M0 0Z", "M1 1M2 2"})
    EXPECT_TRUE(parse_path(empty).subpaths.empty()) << empty;
}

Point at(const BezierCurve& curve, double t) {
  std::vector<Point> p = curve.poles;
  for (std::size_t last = p.size() - 1; last > 0; --last)
    for (std::size_t i = 0; i < last; ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
  return p[0];
}

// The distance from the unit circle over a fine sample is the stated error, and not more.
TEST(Arc, StatedErrorIsTheTrueOneOnTheCircle) {
  const Outline outline = parse_path("M1 0A1 1 0 0 1 0 1L0 0Z");
  const BezierCurve arc = outline.subpaths[0][0];
  double worst = 0;
  for (int k = 0; k <= 6000; ++k) worst = std::max(worst, std::abs(at(arc, k / 6000.0).norm() - 1));
  EXPECT_NEAR(outline.arc_error, worst, 1e-9);
  EXPECT_LE(worst, outline.arc_error + 1e-15);
  EXPECT_NEAR(outline.arc_error, 2.7253e-4, 1e-8);
}

TEST(Arc, FlagsChooseAmongFourArcs) {
  // From (1,0) to (0,1) with radius 1: centres (0,0) and (1,1). The middle of the arc tells which.
  const double r = std::sqrt(0.5);
  const auto middle = [](const std::string& flags) {
    const auto arc = parse_path("M1 0A1 1 0 " + flags + " 0 1L5 5Z").subpaths[0];
    const std::size_t pieces = arc.size() - 2;
    return pieces % 2 ? at(arc[pieces / 2], 0.5) : Point(arc[pieces / 2].start());
  };
  // y points down, sweep 1 is towards growing angles.
  EXPECT_LT((middle("0 1") - Point(r, r)).norm(), 1e-12);
  EXPECT_LT((middle("0 0") - Point(1 - r, 1 - r)).norm(), 1e-12);
  EXPECT_LT((middle("1 0") - Point(-r, -r)).norm(), 1e-3);
  EXPECT_LT((middle("1 1") - Point(1 + r, 1 + r)).norm(), 1e-3);
}

TEST(Arc, GluedFlagsReadAsSeparateOnes) {
  EXPECT_EQ(poles_of("M10 50a40 20 15 1090 0a40 20 15 00-90 0z"),
            poles_of("M10 50a40 20 15 1 0 90 0a40 20 15 0 0 -90 0z"));
}

TEST(Arc, RotatedEllipseLiesOnItsEquation) {
  // Ellipse with radii 3 and 1 turned by 30 degrees about (2, -1); a quarter of it.
  const double phi = std::numbers::pi / 6;
  const auto on = [&](double angle) {
    const double x = 3 * std::cos(angle), y = std::sin(angle);
    return Point(2 + std::cos(phi) * x - std::sin(phi) * y,
                 -1 + std::sin(phi) * x + std::cos(phi) * y);
  };
  Pen pen;
  pen.move_to(on(0.2));
  pen.arc_to({3, 1}, 30, false, true, on(1.7));
  const Outline outline = pen.finish();
  const BezierCurve& arc = outline.subpaths[0][0];
  for (int k = 0; k <= 100; ++k) {
    const Point d = at(arc, k / 100.0) - Point(2, -1);
    const double x = std::cos(phi) * d.x() + std::sin(phi) * d.y();
    const double y = -std::sin(phi) * d.x() + std::cos(phi) * d.y();
    EXPECT_NEAR(std::hypot(x / 3, y), 1, unit_arc_error(1.5) + 1e-12);
  }
}

TEST(Arc, SmallRadiiAreScaledUpAndZeroRadiiAreLines) {
  // Half circle over a chord of length 4 although radius 1 was asked: radius 2.
  const auto arc = parse_path("M-2 0A1 1 0 0 1 2 0Z").subpaths[0];
  ASSERT_EQ(arc.size(), 3u);
  EXPECT_LT((arc[0].end() - Point(0, -2)).norm(), 1e-12);
  EXPECT_EQ(poles_of("M0 0A0 1 0 0 1 2 0L1 1Z")[0], (std::vector<Point>{{0, 0}, {2, 0}}));
  EXPECT_EQ(poles_of("M0 0A5 5 0 0 1 0 0L1 1L1 0Z").size(), 3u);
}

}  // namespace
}  // namespace c1mesh::detail
