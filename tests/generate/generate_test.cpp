// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/generate.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>

namespace c1mesh {
namespace {

using Rational = std::array<mpq_class, 2>;

Rational difference(const Point& a, const Point& b) {
  return {mpq_class(a.x()) - mpq_class(b.x()), mpq_class(a.y()) - mpq_class(b.y())};
}

mpq_class exact_cross(const Rational& a, const Rational& b) {
  return a[0] * b[1] - a[1] * b[0];
}
mpq_class exact_dot(const Rational& a, const Rational& b) {
  return a[0] * b[0] + a[1] * b[1];
}

// Handles in and out of joint i, between curve i and the next, as exact fractions.
std::pair<Rational, Rational> handles(const Drawing& drawing, std::size_t i) {
  const auto& in = drawing.curves[i].curve.poles;
  const auto& out = drawing.curves[(i + 1) % drawing.curves.size()].curve.poles;
  return {difference(in[3], in[2]), difference(out[1], out[0])};
}

double turn_in_degrees(const Drawing& drawing, std::size_t i) {
  const auto [u, v] = handles(drawing, i);
  return std::atan2(exact_cross(u, v).get_d(), exact_dot(u, v).get_d()) * 180 / M_PI;
}

bool is_corner(const Drawing& drawing, std::size_t i) {
  const auto [u, v] = handles(drawing, i);
  return exact_cross(u, v) != 0;
}

int corners(const Drawing& drawing) {
  int count = 0;
  for (std::size_t i = 0; i < drawing.curves.size(); ++i) count += is_corner(drawing, i);
  return count;
}

std::vector<Point> flattened(const Drawing& drawing, int samples) {
  std::vector<Point> points;
  for (const InputCurve& input : drawing.curves)
    for (int k = 0; k < samples; ++k) {
      const double t = static_cast<double>(k) / samples, s = 1 - t;
      const auto& p = input.curve.poles;
      points.push_back(s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] +
                       t * t * t * p[3]);
    }
  return points;
}

bool segments_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  return (cross(b - a, c - a) > 0) != (cross(b - a, d - a) > 0) &&
         (cross(d - c, a - c) > 0) != (cross(d - c, b - c) > 0);
}

class GenerateSets : public testing::TestWithParam<std::pair<char, std::size_t>> {};

TEST_P(GenerateSets, LoopsCloseBitForBitAndHaveTheSetsNumberOfCubics) {
  const auto [set, curves] = GetParam();
  for (const Drawing& drawing : generate(set, 30, 7)) {
    ASSERT_EQ(drawing.curves.size(), curves);
    for (std::size_t i = 0; i < curves; ++i) {
      ASSERT_EQ(drawing.curves[i].curve.degree(), 3);
      EXPECT_EQ(drawing.curves[i].curve.end(), drawing.curves[(i + 1) % curves].curve.start());
    }
  }
}

// Every joint is either tangent-continuous in exact arithmetic or turns by at least 15 degrees.
TEST_P(GenerateSets, JointsAreExactlySmoothOrTrueCorners) {
  const auto [set, curves] = GetParam();
  for (const Drawing& drawing : generate(set, 100, 3)) {
    for (std::size_t i = 0; i < curves; ++i) {
      const auto [u, v] = handles(drawing, i);
      if (is_corner(drawing, i)) {
        EXPECT_GT(std::abs(turn_in_degrees(drawing, i)), 15);
        EXPECT_LT(std::abs(turn_in_degrees(drawing, i)), 130);
      } else {
        EXPECT_GT(exact_dot(u, v), 0) << drawing.name << " joint " << i;
      }
    }
    EXPECT_LE(corners(drawing), static_cast<int>(curves) / 5) << drawing.name;
  }
}

// The number of corners is uniform on 0 … curves/5. Pearson's chi-squared at 300 draws; the
// quantile 1 - 1e-4 of 6 degrees of freedom is 27.9 (of 4: 23.5; of 2: 18.4).
TEST_P(GenerateSets, NumbersOfCornersAreUniform) {
  const auto [set, curves] = GetParam();
  const int kinds = static_cast<int>(curves) / 5 + 1, draws = 300;
  std::map<int, int> seen;
  for (const Drawing& drawing : generate(set, draws, 11)) ++seen[corners(drawing)];
  const double expected = static_cast<double>(draws) / kinds;
  double chi2 = 0;
  for (int k = 0; k < kinds; ++k) chi2 += std::pow(seen[k] - expected, 2) / expected;
  EXPECT_LT(chi2, kinds == 3 ? 18.4 : kinds == 5 ? 23.5 : 27.9);
}

TEST_P(GenerateSets, LoopsAreSimpleAndCounterClockwise) {
  const auto [set, curves] = GetParam();
  for (const Drawing& drawing : generate(set, 10, 5)) {
    const std::vector<Point> p = flattened(drawing, 20);
    const std::size_t n = p.size();
    double area = 0;
    for (std::size_t i = 0; i < n; ++i) area += cross(p[i], p[(i + 1) % n]) / 2;
    EXPECT_GT(area, 0);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 2; j < n; ++j)
        ASSERT_FALSE((i > 0 || j + 1 < n) && segments_cross(p[i], p[i + 1], p[j], p[(j + 1) % n]))
            << drawing.name;
  }
}

TEST_P(GenerateSets, CoordinatesLieOnTheGrid) {
  for (const Drawing& drawing : generate(GetParam().first, 20, 2))
    for (const InputCurve& input : drawing.curves)
      for (const Point& p : input.curve.poles)
        for (const double c : {p.x() * 64, p.y() * 64}) {
          EXPECT_EQ(c, std::floor(c));
          EXPECT_LT(std::abs(c), 2048 * 64);
        }
}

INSTANTIATE_TEST_SUITE_P(Paper, GenerateSets,
                         testing::Values(std::pair<char, std::size_t>('A', 10),
                                         std::pair<char, std::size_t>('B', 20),
                                         std::pair<char, std::size_t>('C', 30)),
                         [](const auto& test) { return std::string(1, test.param.first); });

TEST(Generate, LongerSeriesStartWithShorterOnes) {
  const auto few = generate('B', 3, 9), many = generate('B', 8, 9);
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(few[i].name, many[i].name);
    EXPECT_EQ(drawing_json(few[i]), drawing_json(many[i]));
  }
}

TEST(Generate, SeedsAndShapesDiffer) {
  const auto one = generate('A', 2, 1), two = generate('A', 2, 2);
  EXPECT_NE(drawing_json(one[0]), drawing_json(two[0]));
  EXPECT_NE(drawing_json(one[0]), drawing_json(one[1]));
}

// FNV-1a of the text of 20 shapes a set: the same on every machine, or this fails there.
TEST(Generate, BytesArePinned) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char set : {'A', 'B', 'C'})
    for (const Drawing& drawing : generate(set, 20, 1))
      for (const unsigned char c : drawing_json(drawing)) hash = (hash ^ c) * 1099511628211u;
  EXPECT_EQ(hash, 7442288808219495919u);
}

TEST(Generate, RefusesUnknownSetsAndNegativeCounts) {
  EXPECT_THROW(generate('D', 1, 1), std::invalid_argument);
  EXPECT_THROW(generate('A', -1, 1), std::invalid_argument);
  EXPECT_TRUE(generate('A', 0, 1).empty());
}

}  // namespace
}  // namespace c1mesh
