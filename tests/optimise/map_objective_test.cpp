// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimise/map_objective.h"

#include <random>

#include "finite_differences.h"
#include "optimise/random_mesh.h"
#include "optimise/stages.h"

namespace c1mesh {
namespace {

struct Fixture {
  CurvedMesh mesh;
  Joints joints;
  Roles roles;
  DomainLayout layout;
  MapState state;
};

// The square with its sides in chains between the true corners, inner points moved at random.
Fixture square(int degree, unsigned seed) {
  Fixture f;
  f.mesh = testing_tools::jittered_square(degree, 3, seed);
  f.joints = find_joints(f.mesh, 8);
  f.roles = natural_roles(f.joints);
  f.layout = make_layout(f.mesh, f.joints, f.roles);
  f.state.unknowns = start_positions(f.mesh, f.joints, f.roles, f.layout, Start::shape);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.004, 0.004);
  f.state.control = f.mesh.control;
  for (Point& p : f.state.control) p += Point(shift(random), shift(random));
  for (Eigen::Index k = 0; k < f.state.unknowns.rows(); ++k)
    f.state.unknowns.row(k) += Eigen::RowVector2d(shift(random), shift(random));
  return f;
}

class Map : public testing::TestWithParam<int> {};

TEST_P(Map, GradientMatchesDifferencesWithDomainFreeAndFrozen) {
  const Fixture f = square(GetParam(), 2);
  const auto elements = domain_elements(f.mesh, f.joints, f.roles, f.layout, {});
  for (const bool free : {true, false}) {
    MapObjective objective(f.mesh, f.layout, asked_edges(f.mesh, f.joints, f.roles), elements.all,
                           f.state, free);
    objective.rho = 30;
    objective.exponent = free ? 1 : 2;
    Eigen::VectorXd x = objective.pack(f.state);
    objective.update_multipliers(x);
    Eigen::VectorXd gradient;
    SparseMatrix hessian;
    const double value = objective.derivatives(x, gradient, hessian);
    EXPECT_NEAR(value, objective.value(x), 1e-12 * std::abs(value));
    const auto at = [&](const Eigen::VectorXd& y) { return objective.value(y); };
    EXPECT_LT(testing_tools::gradient_error(at, gradient, x, 1e-7), 1e-6);
    EXPECT_EQ(hessian.rows(), x.size());
  }
}

// At zero residue Gauss-Newton is the exact Hessian of the penalty. The identity map of the square
// has none, and its distortion energy is at its minimum with positive curvature in the interior.
TEST_P(Map, HessianIsExactAtTheIdentityMap) {
  Fixture f = square(GetParam(), 4);
  f.state.control = f.mesh.control;
  f.state.unknowns = start_positions(f.mesh, f.joints, f.roles, f.layout, Start::shape);
  MapObjective objective(f.mesh, f.layout, asked_edges(f.mesh, f.joints, f.roles), {}, f.state,
                         true);
  objective.rho = 1e4;
  const Eigen::VectorXd x = objective.pack(f.state);
  Eigen::VectorXd gradient;
  SparseMatrix hessian;
  objective.derivatives(x, gradient, hessian);
  const Eigen::MatrixXd lower(hessian);
  const Eigen::MatrixXd full = lower.selfadjointView<Eigen::Lower>();
  const auto slope = [&](const Eigen::VectorXd& y) {
    Eigen::VectorXd g;
    SparseMatrix H;
    objective.derivatives(y, g, H);
    return g;
  };
  // The element Hessians are projected; they differ from the exact ones by their small negative
  // parts only, against a penalty of 1e4.
  EXPECT_LT(testing_tools::hessian_error(slope, full, x, 1e-6), 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Degrees, Map, testing::Values(3, 4, 5));

// Two states of the same run must agree to the bit, whatever order threads finish in.
TEST(Map, ValuesRepeatBitForBit) {
  const Fixture f = square(3, 7);
  MapObjective objective(f.mesh, f.layout, asked_edges(f.mesh, f.joints, f.roles), {}, f.state,
                         true);
  objective.rho = 10;
  const Eigen::VectorXd x = objective.pack(f.state);
  const double first = objective.value(x);
  for (int k = 0; k < 20; ++k) EXPECT_EQ(objective.value(x), first);
}

}  // namespace
}  // namespace c1mesh
