// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimise/c1_system.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <random>
#include <set>

#include "finite_differences.h"
#include "optimise/random_mesh.h"

namespace c1mesh {
namespace {

using testing_tools::jittered_square;
using testing_tools::straight_mesh;

PointMatrix domain_matrix(const CurvedMesh& mesh) {
  PointMatrix points(mesh.vertex_count(), 2);
  for (int v = 0; v < mesh.vertex_count(); ++v) points.row(v) = mesh.domain[v].transpose();
  return points;
}

TEST(Barycentric, DerivativeMatchesDifferences) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-0.2, 0.2);
  Eigen::VectorXd x(8);
  x << 0, 0, 1, 0, 0, 1, 0.4, -0.9;
  for (int i = 0; i < 8; ++i) x[i] += number(random);
  const auto at = [](const Eigen::VectorXd& y) {
    return barycentric(y.segment<2>(0), y.segment<2>(2), y.segment<2>(4), y.segment<2>(6));
  };
  const auto d =
      barycentric_derivative(x.segment<2>(0), x.segment<2>(2), x.segment<2>(4), x.segment<2>(6));
  for (int k = 0; k < 2; ++k) {
    const auto value = [&](const Eigen::VectorXd& y) { return at(y)[k + 1]; };
    EXPECT_LT(testing_tools::gradient_error(value, d.row(k).transpose(), x, 1e-6), 1e-8);
  }
  const Eigen::Vector3d g = at(x);
  const Point sum = g[0] * x.segment<2>(0) + g[1] * x.segment<2>(2) + g[2] * x.segment<2>(4);
  EXPECT_LT((sum - Point(x.segment<2>(6))).norm(), 1e-14);
}

class C1Degrees : public testing::TestWithParam<int> {};

// The identity map, and any affine map, is C1; moving one control point breaks exactly its edges.
TEST_P(C1Degrees, AffineMapsHaveNoResidue) {
  CurvedMesh mesh = jittered_square(GetParam(), 3, 1);
  const auto edges = c1_edges(mesh);
  const PointMatrix domain = domain_matrix(mesh);
  EXPECT_LT(largest_residue(edges, domain, mesh.control), 1e-15);
  for (Point& p : mesh.control) p = Point(2 * p.x() + 0.3 * p.y(), p.y() - 0.2 * p.x());
  EXPECT_LT(largest_residue(edges, domain, mesh.control), 2e-15);
  mesh.control.back() += Point(1e-3, 0);
  EXPECT_GT(largest_residue(edges, domain, mesh.control), 1e-4);
}

// Dimension per coordinate of the cubic solutions with the boundary's control points at zero, over
// the edges without an end in `exceptional`.
int solution_dimension(const CurvedMesh& mesh, const std::vector<int>& exceptional) {
  std::vector<C1Edge> edges;
  for (const C1Edge& e : c1_edges(mesh))
    if (std::none_of(exceptional.begin(), exceptional.end(),
                     [&](int v) { return e.vertex[0] == v || e.vertex[1] == v; }))
      edges.push_back(e);
  const auto A = c1_matrix(edges, domain_matrix(mesh), int(mesh.control.size()));
  std::vector<char> fixed(mesh.control.size(), 0);
  for (const auto& loop : boundary_control(mesh))
    for (const auto& edge : loop)
      for (int id : edge) fixed[id] = 1;
  Eigen::MatrixXd dense(A.rows(), 0);
  for (int k = 0; k < A.cols(); ++k)
    if (!fixed[k]) {
      dense.conservativeResize(Eigen::NoChange, dense.cols() + 1);
      dense.col(dense.cols() - 1) = A.col(k);
    }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(dense);
  int rank = 0;
  for (double s : svd.singularValues()) rank += s > 1e-9 * svd.singularValues()[0];
  return static_cast<int>(dense.cols()) - rank;
}

// Without exceptional vertices: 2 V_interior + V_flat + 1. The m x m square has 4 true corners and
// 4 (m - 1) flat vertices.
TEST(C1System, DimensionOfTheCubicSolutionSpace) {
  for (int m : {2, 3, 4}) {
    const CurvedMesh mesh = jittered_square(3, m, 10 + m);
    EXPECT_EQ(solution_dimension(mesh, {}), 2 * (m - 1) * (m - 1) + 4 * (m - 1) + 1) << "m = " << m;
  }
}

// Each hole takes one away: the 5 x 5 square without its middle cell has four corners of its own.
TEST(C1System, DimensionWithAHole) {
  const CurvedMesh mesh = testing_tools::jittered_square_with_hole(3, 5, 4);
  const int interior = 16 - 4, flat = 16;
  EXPECT_EQ(solution_dimension(mesh, {}), 2 * interior + flat + 1 - 1);
}

// With every edge at an exceptional vertex relaxed, their middle equations fall away too: one more
// for each of those edges than the (triangles - 1) of the least relaxation, less what they imply.
TEST(C1System, RelaxingEdgesOnlyAddsSolutions) {
  const CurvedMesh mesh = jittered_square(3, 3, 8);
  const int before = solution_dimension(mesh, {});
  const int at_corner = solution_dimension(mesh, {0});
  EXPECT_GT(at_corner, before);
  EXPECT_GT(solution_dimension(mesh, {0, 15}), at_corner);
}

// A map with a kink along a line of vertices: C1 is not asked across the line if it is a feature,
// and across all other edges it holds.
TEST_P(C1Degrees, NoEquationAcrossFeatures) {
  CurvedMesh mesh = jittered_square(GetParam(), 4, 7, 0);
  const PointMatrix domain = domain_matrix(mesh);
  const std::size_t all = c1_edges(mesh).size();
  FeatureLine line;  // up the middle column of the 5 x 5 vertices
  for (int y = 0; y < 4; ++y) line.edges.push_back({5 * y + 2, 5 * y + 7, 100 + y, 0, 1});
  for (Point& p : mesh.control) p += std::max(0.0, p.x() - 0.5) * Point(0.3, 0.2);
  EXPECT_GT(largest_residue(c1_edges(mesh), domain, mesh.control), 1e-3);
  mesh.features.push_back(line);
  const auto asked = c1_edges(mesh);
  EXPECT_EQ(asked.size(), all - 4);
  EXPECT_LT(largest_residue(asked, domain, mesh.control), 1e-15);
  // Its control points are given, like the boundary's.
  std::set<int> given;
  for (const auto& path : boundary_control(mesh))
    for (const auto& edge : path) given.insert(edge.begin(), edge.end());
  EXPECT_EQ(given.size(), 16u + 3 + (16 + 4) * (GetParam() - 1));
}

TEST_P(C1Degrees, ProjectionReachesRoundingAndKeepsTheFixedPoints) {
  CurvedMesh mesh = jittered_square(GetParam(), 4, 3);
  const auto edges = c1_edges(mesh);
  const PointMatrix domain = domain_matrix(mesh);
  std::vector<char> fixed(mesh.control.size(), 0);
  for (const auto& loop : boundary_control(mesh))
    for (const auto& edge : loop)
      for (int id : edge) fixed[id] = 1;
  std::mt19937 random(9);
  std::uniform_real_distribution<double> shift(-1e-2, 1e-2);
  for (std::size_t k = 0; k < mesh.control.size(); ++k)
    if (!fixed[k]) mesh.control[k] += Point(shift(random), shift(random));
  const std::vector<Point> before = mesh.control;
  const ProjectionReport report = project_to_c1(
      edges, domain, fixed, std::vector<double>(mesh.control.size(), 0.1), mesh.control);
  EXPECT_LT(report.after, 1e-14);
  EXPECT_LT(largest_residue(edges, domain, mesh.control), 1e-14);
  EXPECT_LT(report.largest_move, 0.1);
  for (std::size_t k = 0; k < fixed.size(); ++k)
    if (fixed[k]) {
      EXPECT_EQ(mesh.control[k], before[k]);
    }
}

INSTANTIATE_TEST_SUITE_P(Degrees, C1Degrees, testing::Values(3, 4, 5));

}  // namespace
}  // namespace c1mesh
