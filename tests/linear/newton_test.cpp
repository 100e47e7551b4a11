// SPDX-License-Identifier: GPL-3.0-or-later
#include "linear/newton.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace c1mesh {
namespace {

// sum over i of a_i x_i - log x_i on x > 0: minimum at x_i = 1 / a_i.
class Barrier : public Objective {
 public:
  explicit Barrier(Eigen::VectorXd a) : a_(std::move(a)) {}
  double value(const Eigen::VectorXd& x) const override {
    if (!(x.minCoeff() > 0)) return std::numeric_limits<double>::infinity();
    return a_.dot(x) - x.array().log().sum();
  }
  double derivatives(const Eigen::VectorXd& x, Eigen::VectorXd& gradient,
                     SparseMatrix& hessian) const override {
    gradient = a_ - x.cwiseInverse();
    assembler_.start(static_cast<int>(x.size()));
    for (int i = 0; i < x.size(); ++i) assembler_.add(i, i, 1 / (x[i] * x[i]));
    hessian = assembler_.finish();
    return value(x);
  }

 private:
  Eigen::VectorXd a_;
  mutable Assembler assembler_;
};

TEST(Newton, FindsTheMinimumOfABarrierFromFarAway) {
  const Eigen::Vector3d a(2, 0.1, 50);
  const Barrier barrier(a);
  Eigen::VectorXd x = Eigen::Vector3d(100, 1e-3, 7);
  const NewtonReport report = newton(barrier, x, {100, 1e-15}, {});
  EXPECT_TRUE(report.converged);
  EXPECT_LT((x - Eigen::VectorXd(a.cwiseInverse())).norm(), 1e-6);
}

TEST(Newton, CheckpointStopsIt) {
  const Barrier barrier(Eigen::Vector3d(1, 2, 3));
  Eigen::VectorXd x = Eigen::Vector3d(9, 9, 9);
  EXPECT_THROW(newton(barrier, x, {100, 0}, [] { throw 1; }), int);
}

// The second pass reuses the pattern; entries above the diagonal are dropped, repeats add up.
TEST(Assembler, RepeatsAddUpAndPassesAgree) {
  Assembler assembler;
  for (int pass = 1; pass <= 3; ++pass) {
    assembler.start(3);
    assembler.add(2, 0, pass);
    assembler.add(0, 2, 100);
    assembler.add(1, 1, 4);
    assembler.add(2, 0, 0.5);
    const Eigen::MatrixXd dense(assembler.finish());
    Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
    expected(2, 0) = pass + 0.5;
    expected(1, 1) = 4;
    EXPECT_EQ(dense, Eigen::MatrixXd(expected));
  }
}

TEST(SparseSolver, SolvesAndSaysWhenItCannot) {
  Eigen::MatrixXd dense(3, 3);
  dense << 4, 1, 0, 1, 3, 1, 0, 1, 2;
  const SparseMatrix matrix = SparseMatrix(dense.sparseView()).triangularView<Eigen::Lower>();
  SparseSolver solver;
  ASSERT_TRUE(solver.factorise(matrix, 0));
  const Eigen::Vector3d right(1, 2, 3);
  EXPECT_LT((dense * solver.solve(right) - right).norm(), 1e-14);
  const SparseMatrix negative = -matrix;
  EXPECT_FALSE(solver.factorise(negative, 0));
  EXPECT_TRUE(factorise_shifted(solver, negative, 1e-6));
}

}  // namespace
}  // namespace c1mesh
