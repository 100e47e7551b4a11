// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "result/example_results.h"

namespace c1mesh {
namespace {

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

void expect_same(const Point& a, const Point& b) {
  EXPECT_TRUE(same_bits(a.x(), b.x())) << a.x() << " " << b.x();
  EXPECT_TRUE(same_bits(a.y(), b.y())) << a.y() << " " << b.y();
}

// Random bit patterns: every exponent is as likely, subnormals and both zeros included.
TEST(RoundTrip, RandomDoublesReadBackBitForBit) {
  Result result = example::square();
  std::mt19937_64 random(5);
  std::vector<double> values{-0.0,
                             0.0,
                             1e308,
                             -1e308,
                             5e-324,
                             -5e-324,
                             0.1,
                             1e22,
                             1e23,
                             123456789012345678.0,
                             1e19,
                             18446744073709551616.0,
                             9007199254740993.0,
                             std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::min(),
                             std::numeric_limits<double>::min() / 3,
                             1.0 / 3};
  while (values.size() < 4000) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) values.push_back(value);
  }
  for (std::size_t i = 0; i + 1 < values.size(); i += 2)
    result.control_points.emplace_back(values[i], values[i + 1]);
  result.domain_vertices.assign(result.control_points.begin(), result.control_points.end());
  result.curves[0].poles = result.control_points;
  result.boundary_edges[0].t0 = 5e-324;
  result.boundary_edges[0].t1 = 1.0 / 3;
  const Result back = parse_result(format_result(result), "example");
  ASSERT_EQ(back.control_points.size(), result.control_points.size());
  for (std::size_t i = 0; i < result.control_points.size(); ++i) {
    expect_same(back.control_points[i], result.control_points[i]);
    expect_same(back.domain_vertices[i], result.domain_vertices[i]);
    expect_same(back.curves[0].poles[i], result.control_points[i]);
  }
  EXPECT_TRUE(same_bits(back.boundary_edges[0].t0, 5e-324));
  EXPECT_TRUE(same_bits(back.boundary_edges[0].t1, 1.0 / 3));
}

Result full_example() {
  Result result = example::grid(2, 4, example::cubic_map());
  result.exceptional_vertices = {4};
  result.relaxed_edges = {{4, 5}};
  result.feature_edges = {{4, 1, 0, 0.5, 0.25}};
  result.parameters = {{"version", std::string("0.1 \"x\"\n\xc3\xa9")},
                       {"alpha", 10.0},
                       {"seed", 7LL},
                       {"project", true},
                       {"corner_angle", 0.25},
                       {"tiny", -0.0}};
  result.metrics.d_ei = {1e-17, 2e-16, 3e-16};
  result.metrics.gradient_angle_deg = {1, 2, 3};
  result.metrics.gradient_magnitude = {4, 5, 6};
  result.metrics.mips_bound_max = std::numeric_limits<double>::infinity();
  result.metrics.min_det_coefficient = -0.25;
  result.metrics.conformance_max = 1e-16;
  result.metrics.exceptional = 1;
  result.metrics.exceptional_minimum = 2;
  result.metrics.exceptional_minimum_paper = 3;
  result.metrics.surplus = -1;
  result.metrics.flatness_ratio = 0.5;
  result.metrics.domain_overlaps = true;
  result.metrics.triangles = 8;
  result.metrics.seconds = {{"zebra", 0.5}, {"apple", 0.25}};
  return result;
}

TEST(RoundTrip, EveryFieldSurvivesAndTheTextIsAFixedPoint) {
  const Result result = full_example();
  const std::string text = format_result(result);
  const Result back = parse_result(text, "example");
  EXPECT_EQ(format_result(back), text);
  EXPECT_EQ(back.parameters, result.parameters);
  EXPECT_EQ(back.triangles, result.triangles);
  EXPECT_EQ(back.triangle_control_points, result.triangle_control_points);
  EXPECT_EQ(back.exceptional_vertices, result.exceptional_vertices);
  EXPECT_EQ(back.relaxed_edges, result.relaxed_edges);
  EXPECT_EQ(back.metrics.seconds, result.metrics.seconds);
  EXPECT_EQ(back.metrics.surplus, -1);
  EXPECT_EQ(back.metrics.gradient_magnitude.p99, 5);
  EXPECT_TRUE(std::isinf(back.metrics.mips_bound_max));
  EXPECT_TRUE(back.metrics.domain_overlaps);
  ASSERT_EQ(back.feature_edges.size(), 1u);
  EXPECT_EQ(back.feature_edges[0].t1, 0.25);
  ASSERT_EQ(back.boundary_vertices.size(), result.boundary_vertices.size());
  for (std::size_t i = 0; i < back.boundary_vertices.size(); ++i)
    EXPECT_EQ(back.boundary_vertices[i].corner, result.boundary_vertices[i].corner);
}

TEST(RoundTrip, KeysComeInTheDocumentsOrder) {
  const auto root = nlohmann::ordered_json::parse(format_result(full_example()));
  std::vector<std::string> keys;
  for (const auto& [key, value] : root.items()) keys.push_back(key);
  const std::vector<std::string> expected{"format",
                                          "version",
                                          "degree",
                                          "domain_vertices",
                                          "triangles",
                                          "control_points",
                                          "triangle_control_points",
                                          "curves",
                                          "boundary_edges",
                                          "feature_edges",
                                          "boundary_vertices",
                                          "exceptional_vertices",
                                          "relaxed_edges",
                                          "parameters",
                                          "metrics"};
  EXPECT_EQ(keys, expected);
}

}  // namespace
}  // namespace c1mesh
