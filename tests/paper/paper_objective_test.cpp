// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/paper_objective.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "domain/apart.h"
#include "finite_differences.h"
#include "paper/meshes.h"

namespace c1mesh {
namespace {

using namespace testing_tools;

// Weights that let every term be seen in a test of all.
PaperWeights balanced() {
  return {
      .regularisation = 0.01, .hard_penalty = 3, .barrier = 0.5, .bound = 40, .smoothing = 1e-2};
}

Eigen::MatrixXd full_hessian(const PaperObjective& objective, const Eigen::VectorXd& x,
                             Eigen::VectorXd& gradient) {
  SparseMatrix hessian;
  objective.derivatives(x, gradient, hessian);
  const Eigen::MatrixXd lower(hessian);
  EXPECT_TRUE(lower.isLowerTriangular(0)) << "only the lower half is promised";
  return lower.selfadjointView<Eigen::Lower>();
}

class ObjectiveOf : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    mesh = half_warped_square(GetParam(), 3, 2);
    asked = all_edges(mesh);
    ASSERT_GT(asked.soft.size(), 3u);
    ASSERT_GT(asked.hard.size(), 3u);
    // With a dent below, where a scaffold has triangles. They are at their optimum in `before`.
    Pair before = shaken(mesh, 5, 0.02, 0.01);
    for (const int v : {1, 2}) before.domain(v, 1) += 0.1;
    scaffold = scaffold_elements(mesh, before.domain, Flats::kept, 0.1);
    ASSERT_FALSE(scaffold.empty());
    state = before;
    state.domain += 0.2 * (shaken(mesh, 6, 0.02, 0).domain - domain_points(mesh));
  }
  PaperObjective objective(bool domain_free, const PaperWeights& weights,
                           std::vector<DomainElement> around = {}) const {
    PaperObjective out(mesh, asked, state, domain_free, std::move(around));
    out.weights = weights;
    return out;
  }
  CurvedMesh mesh;
  AskedEdges asked;
  std::vector<DomainElement> scaffold;
  Pair state;
};

TEST_P(ObjectiveOf, GradientMatchesDifferencesWithDomainFreeAndFixedAndAScaffold) {
  Eigen::VectorXd x, gradient[3];
  for (int k = 0; k < 3; ++k) {
    const bool free = k > 0;
    const PaperObjective f = objective(free, balanced(), k == 2 ? scaffold : decltype(scaffold)());
    x = f.pack(state);
    SparseMatrix hessian;
    const double value = f.derivatives(x, gradient[k], hessian);
    EXPECT_NEAR(value, f.value(x), 1e-12 * std::abs(value));
    const auto at = [&](const Eigen::VectorXd& y) { return f.value(y); };
    EXPECT_LT(gradient_error(at, gradient[k], x, 2e-7), 1e-6);
    EXPECT_EQ(hessian.rows(), x.size());
  }
  // The domain's variables come first, and the scaffold is felt by them only.
  const Eigen::Index points = 2 * mesh.vertex_count();
  EXPECT_EQ(gradient[1].size(), gradient[0].size() + points);
  EXPECT_LT((gradient[1].tail(gradient[0].size()) - gradient[0]).norm(), 1e-12);
  EXPECT_EQ(gradient[2].tail(gradient[0].size()), gradient[1].tail(gradient[0].size()));
  EXPECT_GT((gradient[2] - gradient[1]).norm(), 1e-6);
  // A fixed domain has no scaffold.
  EXPECT_EQ(objective(false, balanced(), scaffold).value(objective(false, balanced()).pack(state)),
            objective(false, balanced()).value(objective(false, balanced()).pack(state)));
}

TEST_P(ObjectiveOf, HessianIsPositiveSemidefinite) {
  for (const bool free : {false, true}) {
    const PaperObjective f = objective(free, balanced(), scaffold);
    Eigen::VectorXd gradient;
    const Eigen::MatrixXd H = full_hessian(f, f.pack(state), gradient);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(H, Eigen::EigenvaluesOnly);
    EXPECT_GT(solver.eigenvalues()[0], -1e-12 * H.norm());
  }
}

// With the domain fixed d is linear in the variables, so that value, gradient and Hessian are a
// quadratic that is nowhere below E_s + lambda_h E_h.
TEST_P(ObjectiveOf, HessianOfTheNormsIsAMajoriserWithTheDomainFixed) {
  PaperWeights weights = balanced();
  weights.regularisation = weights.barrier = 0;
  weights.bound = 1e12;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (const double smoothing : {1e-2, 1e-6}) {
    weights.smoothing = smoothing;
    const PaperObjective f = objective(false, weights);
    const Eigen::VectorXd x = f.pack(state);
    Eigen::VectorXd gradient;
    const Eigen::MatrixXd H = full_hessian(f, x, gradient);
    for (const double length : {1e-6, 1e-4, 1e-3})
      for (int k = 0; k < 5; ++k) {
        Eigen::VectorXd step(x.size());
        for (double& s : step) s = length * normal(random);
        const double there = f.value(x + step);
        ASSERT_TRUE(std::isfinite(there));
        EXPECT_GE(f.value(x) + gradient.dot(step) + 0.5 * step.dot(H * step), there - 1e-12);
      }
    // So a part t of the Newton step gains at least t - t^2 / 2 of its slope.
    const Eigen::VectorXd step = -H.completeOrthogonalDecomposition().solve(gradient);
    double t = 1;
    while (!std::isfinite(f.value(x + t * step))) t *= 0.5;
    EXPECT_GT(t, 0.01);
    EXPECT_LE(f.value(x + t * step), f.value(x) + (t - 0.5 * t * t) * gradient.dot(step) + 1e-12);
    EXPECT_LT(gradient.dot(step), -1e-3);
  }
}

// Where all d vanish, Gauss-Newton and majoriser are the exact Hessian; the identity is also the
// minimum of E_reg, where there is nothing to project.
TEST_P(ObjectiveOf, HessianIsExactAtTheIdentity) {
  PaperWeights weights = balanced();
  weights.barrier = 0;
  weights.regularisation = 1;
  state = initial_pair(mesh);
  for (const bool free : {false, true}) {
    const PaperObjective f = objective(free, weights);
    const Eigen::VectorXd x = f.pack(state);
    Eigen::VectorXd gradient;
    const Eigen::MatrixXd H = full_hessian(f, x, gradient);
    EXPECT_LT(gradient.norm(), 1e-11);
    const auto slope = [&](const Eigen::VectorXd& y) {
      Eigen::VectorXd g;
      SparseMatrix unused;
      f.derivatives(y, g, unused);
      return g;
    };
    EXPECT_LT(hessian_error(slope, H, x, 1e-6), 1e-6);
  }
}

TEST_P(ObjectiveOf, TermsAreThoseOfTheValueAsTheSmoothingVanishes) {
  PaperWeights weights = balanced();
  const PaperObjective terms_only = objective(true, weights);
  const Eigen::VectorXd x = terms_only.pack(state);
  const PaperTerms terms = terms_only.terms(x);
  EXPECT_GT(terms.soft, 1e-2);
  EXPECT_GT(terms.hard, 1e-2);
  const double equations =
      GetParam() * (asked.soft.size() + weights.hard_penalty * asked.hard.size());
  weights.barrier = 0;
  for (const double smoothing : {1e-3, 1e-6, 1e-9}) {
    weights.smoothing = smoothing;
    const double value = objective(true, weights).value(x);
    const double exact =
        terms.soft + weights.hard_penalty * terms.hard + weights.regularisation * terms.regulariser;
    EXPECT_LE(value, exact * (1 + 1e-14));
    EXPECT_GE(value, exact - equations * smoothing - 1e-12);
  }
  // E_reg is that of the definition: 4 A n (n + 1) / 2 at the start, the areas sum to one.
  const PaperTerms start = terms_only.terms(terms_only.pack(initial_pair(mesh)));
  EXPECT_NEAR(start.regulariser, 2 * GetParam() * (GetParam() + 1), 1e-10);
  EXPECT_NEAR(start.g, 2, 1e-12);
  EXPECT_LT(start.soft + start.hard, 1e-12);
  EXPECT_GT(terms_only.largest_distortion(x), terms.g);
}

// The barrier is rho times the sum of -log(bound - g_p): a limit that few triangles feel changes
// little, and beyond the bound there is nothing.
TEST_P(ObjectiveOf, IsInfiniteFromTheBoundOn) {
  PaperWeights weights = balanced();
  const double g =
      objective(true, weights).largest_distortion(objective(true, weights).pack(state));
  weights.bound = g * (1 + 1e-9);
  EXPECT_TRUE(std::isfinite(objective(true, weights).value(objective(true, weights).pack(state))));
  weights.bound = g * (1 - 1e-9);
  EXPECT_TRUE(std::isinf(objective(true, weights).value(objective(true, weights).pack(state))));
}

// d are barycentric: no affine map of the domain changes E_s. g sees all but similarities, E_reg
// does not see the domain's variables at all.
TEST_P(ObjectiveOf, InvariancesUnderMapsOfTheDomain) {
  const PaperObjective f = objective(true, balanced());
  const Eigen::VectorXd x = f.pack(state);
  const PaperTerms terms = f.terms(x);
  Eigen::Matrix2d shear, similarity;
  shear << 2, 0.7, -0.3, 0.5;
  similarity << 1.2, -1.6, 1.6, 1.2;
  Pair other = state;
  other.domain = mapped(state.domain, shear, {3, -1});
  const PaperTerms sheared = f.terms(f.pack(other));
  EXPECT_NEAR(sheared.soft, terms.soft, 1e-12 * terms.soft);
  EXPECT_NEAR(sheared.hard, terms.hard, 1e-12 * terms.hard);
  EXPECT_EQ(sheared.regulariser, terms.regulariser);
  EXPECT_GT(std::abs(sheared.g - terms.g), 1e-3);
  other.domain = mapped(state.domain, similarity, {3, -1});
  EXPECT_NEAR(f.value(f.pack(other)), f.value(x), 1e-11 * std::abs(f.value(x)));
}

TEST_P(ObjectiveOf, PackAndUnpackAreInverse) {
  for (const bool free : {true, false}) {
    const PaperObjective f = objective(free, balanced());
    const Pair other = shaken(mesh, 9, 0.01, 0.02), back = f.unpack(f.pack(other));
    EXPECT_EQ(back.domain, free ? other.domain : state.domain);
    EXPECT_EQ(back.control, other.control);  // the boundary's are the same in both
    Eigen::VectorXd x = f.pack(state);
    EXPECT_EQ(f.pack(f.unpack(x)), x);
    // The boundary's control points are no variables: nothing in x moves them.
    x.setConstant(7);
    const Pair moved = f.unpack(x);
    const std::vector<char> fixed = fixed_control(mesh, mesh.control.size());
    int variables = free ? mesh.vertex_count() : 0;
    for (std::size_t k = 0; k < fixed.size(); ++k) {
      EXPECT_EQ(moved.control[k], fixed[k] ? state.control[k] : Point(7, 7));
      variables += !fixed[k];
    }
    EXPECT_EQ(x.size(), 2 * variables);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, ObjectiveOf, testing::Values(3, 4, 5));

}  // namespace
}  // namespace c1mesh
