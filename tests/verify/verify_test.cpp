// SPDX-License-Identifier: GPL-3.0-or-later
// Whole verdicts on hand-made results: what must hold holds, and each single fault is found.
#include "c1mesh/verify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "result/example_results.h"

namespace c1mesh {
namespace {

Verdict verdict_of(const VerifyReport& report, const std::string& name) {
  for (const VerifyItem& item : report.items)
    if (item.name == name) return item.verdict;
  ADD_FAILURE() << "no item " << name;
  return Verdict::undecided;
}

#define EXPECT_INVALID(result, name)                                                \
  do {                                                                              \
    const VerifyReport report_ = verify(result);                                    \
    EXPECT_EQ(verdict_of(report_, name), Verdict::invalid) << report_text(report_); \
    EXPECT_FALSE(report_.valid());                                                  \
  } while (false)

int control_id(const Result& r, int t, int i, int j) {
  return r.triangle_control_points[t][j * (r.degree + 1) - j * (j - 1) / 2 + i];
}

TEST(Verify, IdentityOfASquareIsValidWithKnownMetrics) {
  const VerifyReport report = verify(example::square());
  EXPECT_TRUE(report.valid()) << report_text(report);
  EXPECT_TRUE(report.regular());
  EXPECT_TRUE(report.conforming());
  EXPECT_TRUE(report.c1());
  const Metrics& m = report.metrics;
  EXPECT_EQ(m.triangles, 2);
  EXPECT_LT(m.d_ei.max, 1e-15);  // thirds are rounded
  EXPECT_NEAR(m.mips_bound_max, 2, 1e-14);
  EXPECT_NEAR(m.min_det_coefficient, 1, 1e-14);
  EXPECT_EQ(m.conformance_max, 0);
  EXPECT_EQ(m.exceptional_minimum, 0);  // four convex corners
  EXPECT_EQ(m.surplus, 0);
  EXPECT_EQ(m.flatness_ratio, 1);
  EXPECT_FALSE(m.domain_overlaps);
  EXPECT_LT(m.gradient_angle_deg.max, 1e-12);
}

TEST(Verify, ScalingShapeOrDomainChangesNoMetric) {
  const Metrics one = verify(example::grid(2, 3, example::cubic_map())).metrics;
  Result scaled = example::grid(2, 3, example::cubic_map());
  for (Point& p : scaled.control_points) p *= 1024;
  for (BezierCurve& c : scaled.curves)
    for (Point& p : c.poles) p *= 1024;
  for (Point& p : scaled.domain_vertices) p *= 0.125;
  const VerifyReport report = verify(scaled);
  EXPECT_TRUE(report.valid()) << report_text(report);
  EXPECT_EQ(report.metrics.min_det_coefficient, one.min_det_coefficient);
  EXPECT_EQ(report.metrics.mips_bound_max, one.mips_bound_max);
  EXPECT_EQ(report.metrics.d_ei.max, one.d_ei.max);
}

class PolynomialMap : public testing::TestWithParam<int> {};

// One polynomial over many triangles is smooth across every edge: all d_ei vanish.
TEST_P(PolynomialMap, IsC1RegularAndConforming) {
  const VerifyReport report = verify(example::grid(4, GetParam(), example::cubic_map()));
  EXPECT_TRUE(report.valid()) << report_text(report);
  EXPECT_LT(report.metrics.d_ei.max, 4e-16);
  EXPECT_LT(report.metrics.gradient_angle_deg.max, 1e-11);
  EXPECT_LT(report.metrics.gradient_magnitude.max, 1e-13);
  EXPECT_EQ(report.metrics.flatness_ratio,
            verify(example::grid(4, 3, example::cubic_map())).metrics.flatness_ratio);
}

TEST_P(PolynomialMap, MovingOneInnerControlPointByAMillionthIsFound) {
  Result result = example::grid(4, GetParam(), example::cubic_map());
  Point& p = result.control_points[control_id(result, 10, 1, 1)];
  p.x() += 1e-6;
  const VerifyReport report = verify(result);
  EXPECT_EQ(verdict_of(report, "C1"), Verdict::invalid);
  EXPECT_FALSE(report.c1());
  EXPECT_TRUE(report.regular());
  EXPECT_GT(report.metrics.d_ei.max, 5e-7);
  EXPECT_LT(report.metrics.d_ei.max, 2e-6);
  EXPECT_GT(report.metrics.gradient_magnitude.max, 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Degrees, PolynomialMap, testing::Values(3, 4, 5));

// d of an isolated change: p_11 of one cubic triangle moved by h changes its edge equation by h g2
// from one side and h from the other; g2 = -1 on a diagonal of a square, so both are h.
TEST(Verify, DeviationIsTheOneOfTheFormula) {
  Result result = example::square();
  result.control_points[control_id(result, 0, 1, 1)].x() += 0x1p-10;
  EXPECT_NEAR(verify(result).metrics.d_ei.max, 0x1p-10, 1e-15);
}

TEST(Verify, TheLargerOfBothOrientationsCounts) {
  // v3 is twice as far from the diagonal as v2 is: g2 = -2 one way, -1/2 the other.
  const auto make = [](int moved) {
    Result result = example::polynomial_result(
        3, example::identity(), {{0, 0}, {1, 0}, {1, 1}, {-1, 2}}, {{0, 1, 2}, {0, 2, 3}});
    result.control_points[control_id(result, moved, 1, 1)].x() += 0x1p-10;
    return verify(result).metrics.d_ei.max * 2;  // the extent is 2
  };
  EXPECT_NEAR(make(0), 3 * 0x1p-10, 1e-14);  // area ratio 3: residual h * 3, the other way h
  EXPECT_NEAR(make(1), 0x1p-10, 1e-14);
}

TEST(Verify, RelaxedEdgesAreNotAskedToBeSmoothButNeedAnExceptionalVertex) {
  Result result = example::square();
  result.control_points[control_id(result, 0, 1, 1)].x() += 1e-3;
  result.relaxed_edges = {{0, 2}};
  EXPECT_INVALID(result, "exceptional vertices");
  result.exceptional_vertices = {2};
  const VerifyReport report = verify(result);
  EXPECT_TRUE(report.valid()) << report_text(report);
  EXPECT_EQ(report.metrics.exceptional, 1);
  EXPECT_EQ(report.metrics.surplus, 1);
  result.relaxed_edges = {{0, 1}};
  EXPECT_INVALID(result, "exceptional vertices");  // not an interior edge
}

TEST(Verify, AFlippedTriangleIsFound) {
  Result result = example::grid(2, 3, example::identity());
  Result moved = result;
  moved.domain_vertices[4] = Point(1.25, 0.5);  // the middle vertex beyond the right side
  EXPECT_INVALID(moved, "domain orientation");
  std::swap(result.triangles[0][1], result.triangles[0][2]);
  EXPECT_INVALID(result, "topology");
  EXPECT_EQ(verdict_of(verify(result), "domain orientation"), Verdict::invalid);
}

TEST(Verify, AFlatDomainTriangleIsFound) {
  Result result = example::square();
  result.domain_vertices[1] = Point(0.5, 0.5);
  EXPECT_INVALID(result, "domain orientation");
}

// The middle control point is pulled outside: det is 1 at the corners and negative inside.
TEST(Verify, AFoldInsideIsFound) {
  Result result = example::square();
  result.control_points[control_id(result, 0, 1, 1)] = Point(3, 2);
  const VerifyReport report = verify(result);
  EXPECT_EQ(verdict_of(report, "regularity"), Verdict::invalid) << report_text(report);
  EXPECT_FALSE(report.regular());
}

Result one_triangle(int degree, const example::Polynomial& map) {
  return example::polynomial_result(degree, map, {{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}});
}

// x = u, y = v q(u) has det = q(u) = s + 4 (u - 1/2)^2 >= s. As a form of degree 6 its coefficient
// number 3 along the edge is s - 1/5: negative for small s though det is positive.
example::Polynomial valley(double s) {
  return {{1, 0, Point(1, 0)}, {0, 1, Point(0, 1 + s)}, {1, 1, Point(0, -4)}, {2, 1, Point(0, 4)}};
}

TEST(Verify, NegativeCoefficientsWithPositiveDetAreValid) {
  for (const double s : {0x1p-4, 0x1p-10, 0x1p-20}) {
    const VerifyReport report = verify(one_triangle(4, valley(s)));
    EXPECT_EQ(verdict_of(report, "regularity"), Verdict::valid) << s;
    EXPECT_LT(report.metrics.min_det_coefficient, 0);
    EXPECT_TRUE(std::isinf(report.metrics.mips_bound_max));
  }
}

TEST(Verify, AZeroOrNegativeValleyIsNeverValid) {
  EXPECT_EQ(verdict_of(verify(one_triangle(3, valley(0))), "regularity"), Verdict::invalid);
  EXPECT_EQ(verdict_of(verify(one_triangle(3, valley(-0x1p-12))), "regularity"), Verdict::invalid);
}

// x = u^3, y = v: det = 3 u^2 vanishes on the edge u = 0, exactly.
TEST(Verify, DetZeroOnAnEdgeIsInvalidByRationals) {
  EXPECT_EQ(
      verdict_of(verify(one_triangle(3, {{3, 0, Point(1, 0)}, {0, 1, Point(0, 1)}})), "regularity"),
      Verdict::invalid);
}

TEST(Verify, CoverageGapOverlapAndDirectionAreFound) {
  const Result good = example::grid(2, 3, example::identity());
  Result gap = good;
  gap.boundary_edges[0].t1 = 0.75;
  EXPECT_INVALID(gap, "coverage");
  // Two edges of the lower side on one curve, split at 1/2: valid; split unevenly: not conforming.
  Result joined = good;
  const auto edge = [&](Result& r, int a) -> CurveEdge& {
    return *std::find_if(r.boundary_edges.begin(), r.boundary_edges.end(),
                         [&](const CurveEdge& e) { return e.a == a; });
  };
  const int curve = edge(joined, 0).curve;
  joined.curves[curve].poles = {Point(0, 0), Point(1, 0)};
  edge(joined, 0) = {0, 1, curve, 0, 0.5};
  edge(joined, 1) = {1, 2, curve, 0.5, 1};
  VerifyReport report = verify(joined);
  EXPECT_EQ(verdict_of(report, "coverage"), Verdict::valid) << report_text(report);
  EXPECT_EQ(verdict_of(report, "conformance"), Verdict::valid) << report_text(report);
  Result overlap = joined;
  edge(overlap, 1).t0 = 0.25;
  EXPECT_INVALID(overlap, "coverage");
  Result swapped = joined;
  std::swap(edge(swapped, 0).t0, edge(swapped, 1).t0);
  std::swap(edge(swapped, 0).t1, edge(swapped, 1).t1);
  EXPECT_INVALID(swapped, "coverage");  // tiles [0, 1], but the middle vertex is not shared
  Result missing = joined;
  missing.boundary_edges.erase(missing.boundary_edges.begin());
  EXPECT_INVALID(missing, "topology");
  // Run against the curve's own direction.
  Result backward = joined;
  std::swap(backward.curves[curve].poles[0], backward.curves[curve].poles[1]);
  edge(backward, 0) = {0, 1, curve, 1, 0.5};
  edge(backward, 1) = {1, 2, curve, 0.5, 0};
  report = verify(backward);
  EXPECT_TRUE(report.conforming()) << report_text(report);
}

TEST(Verify, ABoundaryControlPointOffByABillionthIsFound) {
  Result result = example::square();
  result.control_points[control_id(result, 0, 1, 0)].y() -= 1e-9;
  const VerifyReport report = verify(result);
  EXPECT_EQ(verdict_of(report, "conformance"), Verdict::invalid);
  EXPECT_FALSE(report.conforming());
  EXPECT_NEAR(report.metrics.conformance_max, 1e-9, 1e-15);
  Result shifted = example::square();
  shifted.curves[0].poles[1].x() += 1e-9;
  EXPECT_INVALID(shifted, "conformance");
}

TEST(Verify, SharingFaultsAreFound) {
  Result result = example::square();
  // The second triangle gets its own copy of a control point on the diagonal.
  const int id = control_id(result, 1, 1, 0);
  result.control_points.push_back(result.control_points[id]);
  Result split = result;
  split.triangle_control_points[1][1] = static_cast<int>(split.control_points.size()) - 1;
  EXPECT_INVALID(split, "topology");
  EXPECT_INVALID(result, "topology");  // the copy is used by nobody
  Result swapped = example::square();  // right ids, wrong order
  std::swap(swapped.triangle_control_points[1][1], swapped.triangle_control_points[1][2]);
  EXPECT_INVALID(swapped, "topology");
}

TEST(Verify, SurfaceFaultsAreFound) {
  // A bow tie: two triangles that share a vertex only.
  const Result bow = example::polynomial_result(
      3, example::identity(), {{0, 0}, {1, 0}, {1, 1}, {-1, 0}, {-1, -1}}, {{0, 1, 2}, {0, 3, 4}});
  EXPECT_INVALID(bow, "topology");
  Result lonely = example::square();
  lonely.domain_vertices.emplace_back(5, 5);
  EXPECT_INVALID(lonely, "topology");
  Result twice = example::square();
  twice.triangles.push_back(twice.triangles[0]);
  twice.triangle_control_points.push_back(twice.triangle_control_points[0]);
  EXPECT_INVALID(twice, "topology");
}

TEST(Verify, DefectiveStructureIsReportedNotFollowed) {
  Result result = example::square();
  result.triangle_control_points[0][3] = 1000;
  EXPECT_INVALID(result, "structure");
  result = example::square();
  result.control_points[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_INVALID(result, "structure");
  EXPECT_INVALID(Result(), "structure");
}

TEST(Verify, ASurfaceWithoutBoundaryIsNoShape) {
  const Result closed =
      example::polynomial_result(3, example::identity(), {{0, 0}, {3, 0}, {0, 3}, {1, 1}},
                                 {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}});
  EXPECT_INVALID(closed, "boundary simple");
  EXPECT_EQ(verdict_of(verify(closed), "domain orientation"), Verdict::invalid);
}

TEST(Verify, ABoundaryThatCrossesItselfIsFound) {
  // The lower side bulges through the upper one.
  Result result = example::square();
  for (const int i : {1, 2}) {
    result.control_points[control_id(result, 0, i, 0)].y() = 4;
    for (BezierCurve& curve : result.curves)
      if (curve.start() == Point(0, 0) && curve.end() == Point(1, 0)) curve.poles[i].y() = 4;
  }
  EXPECT_INVALID(result, "boundary simple");
}

TEST(Verify, PiecesThatOverlapAreFoundAndPiecesApartAreNot) {
  const auto two = [](const Point& shift, double size) {
    return example::polynomial_result(
        3, example::identity(),
        {{0, 0}, {1, 0}, {1, 1}, {0, 1}, shift, shift + Point(size, 0), shift + Point(size, size)},
        {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}});
  };
  const VerifyReport apart = verify(two({2, 0}, 1));
  EXPECT_TRUE(apart.valid()) << report_text(apart);
  EXPECT_FALSE(apart.metrics.domain_overlaps);
  const VerifyReport inside = verify(two({0.25, 0.25}, 0.5));
  EXPECT_EQ(verdict_of(inside, "boundary simple"), Verdict::invalid);
  EXPECT_TRUE(inside.metrics.domain_overlaps);
}

// A strip of triangles around more than a full turn: every triangle is positive, nothing is wound
// wrongly inside, the domain overlaps; the shape is the same strip pulled apart.
TEST(Verify, DomainOverlapIsToldApartFromInvalidity) {
  std::vector<Point> domain, shape;
  std::vector<std::array<int, 3>> triangles;
  const int steps = 20;
  for (int k = 0; k <= steps; ++k) {
    const double a = k * 2 * std::numbers::pi * 1.2 / steps;
    for (const double radius : {1.0, 2.0}) {
      domain.emplace_back(radius * std::cos(a), radius * std::sin(a));
      shape.emplace_back(-k, radius);
    }
  }
  for (int k = 0; k < steps; ++k) {
    triangles.push_back({2 * k, 2 * k + 1, 2 * k + 3});
    triangles.push_back({2 * k, 2 * k + 3, 2 * k + 2});
  }
  Result result = example::polynomial_result(3, example::identity(), shape, triangles);
  result.domain_vertices = domain;
  const VerifyReport report = verify(result);
  EXPECT_TRUE(report.metrics.domain_overlaps);
  EXPECT_TRUE(report.regular()) << report_text(report);
  EXPECT_EQ(verdict_of(report, "boundary simple"), Verdict::valid);
}

// Five triangles around a vertex, wound twice in the domain (a pentagram), once in the shape.
TEST(Verify, AVertexWoundTwiceIsFound) {
  const auto star = [](int turns) {
    std::vector<Point> points{Point(0, 0)};
    for (int k = 0; k < 5; ++k) {
      const double a = 2 * std::numbers::pi * k * turns / 5;
      points.emplace_back(std::cos(a), std::sin(a));
    }
    return points;
  };
  Result result = example::polynomial_result(
      3, example::identity(), star(1), {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}});
  EXPECT_TRUE(verify(result).valid()) << report_text(verify(result));
  result.domain_vertices = star(2);
  const VerifyReport report = verify(result);
  EXPECT_EQ(verdict_of(report, "domain orientation"), Verdict::valid);
  EXPECT_EQ(verdict_of(report, "winding"), Verdict::invalid);
  EXPECT_TRUE(report.metrics.domain_overlaps);
}

TEST(Verify, ThreeThousandTrianglesAreValid) {
  const VerifyReport report = verify(example::grid(40, 3, example::cubic_map()));
  EXPECT_TRUE(report.valid()) << report_text(report);
}

TEST(Verify, InputCurvesAreComparedBitForBit) {
  const Result result = example::square();
  Shape shape;
  shape.curves = {result.curves.rbegin(), result.curves.rend()};
  Region region;
  for (int c = 0; c < 4; ++c) region.outer.push_back({c, false});
  shape.regions = {region};
  EXPECT_EQ(verdict_of(verify(result, shape), "input curves"), Verdict::valid);
  Shape other = shape;
  other.curves[0].poles[0].x() = std::nextafter(other.curves[0].poles[0].x(), 2.0);
  EXPECT_EQ(verdict_of(verify(result, other), "input curves"), Verdict::invalid);
  other = shape;
  other.curves.push_back(BezierCurve{{Point(5, 5), Point(6, 6)}});
  EXPECT_EQ(verdict_of(verify(result, other), "input curves"), Verdict::invalid);
}

}  // namespace
}  // namespace c1mesh
