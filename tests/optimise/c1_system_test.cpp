// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimise/c1_system.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <random>

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

// Solution space of the homogeneous system with the boundary's control points held at zero, per
// coordinate. Cubic: 2 V_interior + V_flat + 1 - holes (no exceptional vertex). For the m x m
// square the boundary has 4 true corners and 4 (m - 1) flat vertices.
TEST(C1System, DimensionOfTheCubicSolutionSpace) {
  for (int m : {2, 3, 4}) {
    const CurvedMesh mesh = jittered_square(3, m, 10 + m);
    const auto A = c1_matrix(c1_edges(mesh), domain_matrix(mesh), int(mesh.control.size()));
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
    const int interior = (m - 1) * (m - 1), flat = 4 * (m - 1);
    EXPECT_EQ(dense.cols() - rank, 2 * interior + flat + 1) << "m = " << m;
  }
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
