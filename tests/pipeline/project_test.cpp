// SPDX-License-Identifier: GPL-3.0-or-later
// From nearly C1 to C1: the orthogonal projection of all control points.
#include "c1mesh/project.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/runs.h"

namespace c1mesh {
namespace {

using testing_pipeline::example;

double extent_of(const Result& result) {
  Point low = result.control_points.front(), high = low;
  for (const Point& p : result.control_points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).maxCoeff();
}

// Iterations that end while C1 still deviates by far more than rounding.
Result nearly_c1() {
  Options options;
  options.method = Method::paper;
  options.paper.iterations[0] = 100;
  options.paper.iterations[1] = 30;
  return parametrize(example("blob"), options).result;
}

double parameter(const Result& result, const std::string& name) {
  for (const auto& [key, value] : result.parameters)
    if (key == name) return std::get<double>(value);
  ADD_FAILURE() << "no parameter " << name;
  return 0;
}

std::vector<Point> moves(const Result& from, const Result& to) {
  std::vector<Point> out;
  for (std::size_t k = 0; k < from.control_points.size(); ++k)
    out.push_back(to.control_points[k] - from.control_points[k]);
  return out;
}

double largest(const std::vector<Point>& moves) {
  double out = 0;
  for (const Point& move : moves) out = std::max(out, move.norm());
  return out;
}

// Where each control point is if the map is the identity, or any polynomial map of degree one: C1
// across every edge, and so in the space that is projected onto.
std::vector<Point> identity_net(const Result& result) {
  std::vector<Point> out(result.control_points.size());
  const int n = result.degree;
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    const auto& v = result.triangles[t];
    std::size_t k = 0;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n - j; ++i, ++k)
        out[result.triangle_control_points[t][k]] =
            ((n - i - j) * result.domain_vertices[v[0]] + i * result.domain_vertices[v[1]] +
             j * result.domain_vertices[v[2]]) /
            n;
  }
  return out;
}

class ProjectedBlob : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    before = nearly_c1();
    projection = project(before);
  }
  static Result before;
  static Projection projection;
};
Result ProjectedBlob::before;
Projection ProjectedBlob::projection;

TEST_F(ProjectedBlob, IsExactlyC1OverTheSameDomain) {
  const Result& after = projection.result;
  EXPECT_GT(projection.before, 1e-9);
  EXPECT_LT(projection.after, 1e-14);
  // verify takes the larger of an equation's two orientations.
  const double deviation = verify(before).metrics.d_ei.max;
  EXPECT_LE(projection.before, deviation * (1 + 1e-9));
  EXPECT_GE(projection.before, 0.01 * deviation);
  const VerifyReport report = verify(after, claimed_bounds(after));
  EXPECT_TRUE(report.valid()) << report_text(report);
  EXPECT_LE(report.metrics.d_ei.max, 1e-13);
  EXPECT_EQ(after.domain_vertices, before.domain_vertices);
  EXPECT_EQ(after.triangles, before.triangles);
  EXPECT_EQ(after.relaxed_edges, before.relaxed_edges);
  EXPECT_EQ(after.exceptional_vertices, before.exceptional_vertices);
  const double extent = extent_of(before), move = largest(moves(before, after)) / extent;
  EXPECT_NEAR(projection.largest_move, move, 1e-12);
  EXPECT_GT(move, 1e-9);
  // The boundary goes at most as far as the farthest control point.
  EXPECT_GT(report.metrics.conformance_max, 0);
  EXPECT_LE(report.metrics.conformance_max, move * (1 + 1e-9));
}

TEST_F(ProjectedBlob, ProjectingAgainMovesByRoundingOnly) {
  const Projection again = project(projection.result);
  EXPECT_LT(again.largest_move, 1e-13);
  EXPECT_LT(again.before, 1e-14);
  EXPECT_EQ(again.result.parameters, projection.result.parameters);
}

// The move is perpendicular to every solution of A p = 0: to the constants and the linear functions
// of the domain, and to what is projected itself.
TEST_F(ProjectedBlob, TheMoveIsOrthogonalToTheC1Space) {
  const std::vector<Point> move = moves(before, projection.result);
  const std::vector<Point> identity = identity_net(before);
  double size = 0;
  for (const Point& m : move) size += m.norm();
  ASSERT_GT(size, 0);
  const double extent = extent_of(before);
  Eigen::Matrix2d linear = Eigen::Matrix2d::Zero(), itself = Eigen::Matrix2d::Zero();
  Point constant = Point::Zero();
  double reach = 0;
  for (std::size_t k = 0; k < move.size(); ++k) {
    constant += move[k];
    linear += move[k] * identity[k].transpose();
    itself += move[k] * projection.result.control_points[k].transpose();
    reach = std::max(reach, identity[k].norm());
  }
  EXPECT_LT(constant.norm(), 1e-10 * size);
  EXPECT_LT(linear.norm(), 1e-10 * size * reach);
  EXPECT_LT(itself.norm(), 1e-10 * size * extent);
}

// A random vector of the space, had by projecting a shaken identity, is perpendicular too; and the
// projected point is nearer than any other point of the space.
TEST_F(ProjectedBlob, NoOtherPointOfTheSpaceIsNearer) {
  Result other = projection.result;
  unsigned long long state = 1;
  const double extent = extent_of(before);
  for (Point& p : other.control_points)
    for (int c = 0; c < 2; ++c) {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      p[c] += 1e-3 * extent * (static_cast<double>(state >> 40) / (1 << 24) - 0.5);
    }
  const Result inside = project(other).result;  // in the space, elsewhere
  const std::vector<Point> direction = moves(projection.result, inside);
  const std::vector<Point> move = moves(before, projection.result);
  double dot = 0, length = 0, size = 0;
  for (std::size_t k = 0; k < move.size(); ++k) {
    dot += move[k].dot(direction[k]);
    length += direction[k].squaredNorm();
    size += move[k].squaredNorm();
  }
  EXPECT_GT(std::sqrt(length), 1e-3 * extent);
  EXPECT_LT(std::abs(dot), 1e-9 * std::sqrt(length * size));
}

// What is C1 already stays, to rounding: the exact method's result.
TEST(Project, AC1ResultMovesByRoundingOnly) {
  for (const char* name : {"blob", "annulus"}) {
    const Result exact = parametrize(example(name)).result;
    const Projection projection = project(exact);
    EXPECT_LT(projection.before, 1e-12) << name;
    EXPECT_LT(projection.largest_move, 1e-11) << name;
    EXPECT_LE(projection.after, std::max(projection.before, 1e-15)) << name;
  }
}

TEST(Project, ClaimsItsBounds) {
  const Result exact = parametrize(example("blob")).result;
  EXPECT_EQ(claimed_bounds(exact).c1_bound, VerifyOptions().c1_bound);
  EXPECT_EQ(claimed_bounds(exact).conformance_tolerance, VerifyOptions().conformance_tolerance);
  const Result projected = project(exact, 3e-5).result;
  EXPECT_EQ(parameter(projected, "c1_bound"), 1e-11);
  EXPECT_EQ(parameter(projected, "conformance_bound"), 3e-5);
  EXPECT_EQ(claimed_bounds(projected).c1_bound, 1e-11);
  EXPECT_EQ(claimed_bounds(projected).conformance_tolerance, 3e-5);
  // Through the file, too; and a second projection replaces the claim.
  const Result read = parse_result(format_result(projected), projected.name);
  EXPECT_EQ(claimed_bounds(read).conformance_tolerance, 3e-5);
  const Result again = project(read, 1e-6).result;
  EXPECT_EQ(parameter(again, "conformance_bound"), 1e-6);
  EXPECT_EQ(again.parameters.size(), projected.parameters.size());
}

TEST(Project, AFlatOrInvertedDomainTriangleIsATypedError) {
  const Result exact = parametrize(example("blob")).result;
  const auto& t = exact.triangles.front();
  for (const bool flat : {true, false}) {
    Result bad = exact;
    if (flat)
      bad.domain_vertices[t[2]] = 0.5 * (bad.domain_vertices[t[0]] + bad.domain_vertices[t[1]]);
    else
      std::swap(bad.triangles.front()[0], bad.triangles.front()[1]);
    try {
      project(bad);
      ADD_FAILURE() << "not refused";
    } catch (const InputError& error) {
      ASSERT_EQ(error.defects().size(), 1u);
      EXPECT_EQ(error.defects()[0].kind, DefectKind::unsupported);
    }
  }
}

}  // namespace
}  // namespace c1mesh
