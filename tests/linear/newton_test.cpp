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

// Each iteration is told once, with where it led: the same places that single steps lead to.
TEST(Newton, TellsEveryIterationToAnObserver) {
  const Barrier barrier(Eigen::Vector3d(2, 0.1, 50));
  Eigen::VectorXd x = Eigen::Vector3d(100, 1e-3, 7), single = x;
  double value = 0, step = 0;
  SparseSolver solver;
  int told = 0;
  const Checkpoint watched =
      Checkpoint([] {}).observed_by([&](const Eigen::VectorXd& at, double s) {
        newton_step(barrier, solver, single, value, step);
        EXPECT_EQ(at, single);
        EXPECT_EQ(s, step);
        ++told;
      });
  const NewtonReport report = newton(barrier, x, {100, 1e-15}, watched);
  EXPECT_EQ(told, report.iterations);
  EXPECT_EQ(x, single);
}

TEST(Checkpoint, TranslatesAndMarksOnTheWay) {
  std::vector<double> seen;
  std::vector<std::string> stages;
  const Checkpoint watched(
      [] {}, [&](const TraceRecord& r) { stages.push_back(r.stage + std::to_string(r.pass)); });
  const Checkpoint marked = watched.marked([](TraceRecord& r) { r.pass = 7; })
                                .marked([](TraceRecord& r) { r.stage += "!"; })
                                .observed_by([&](const Eigen::VectorXd& x, double step) {
                                  seen = {x[0], step};
                                });
  marked.over([](const Eigen::VectorXd& x) { return Eigen::VectorXd(2 * x); })
      .observe(Eigen::VectorXd::Constant(1, 5), 0.5);
  EXPECT_EQ(seen, (std::vector<double>{10, 0.5}));
  TraceRecord record;
  record.stage = "a";
  marked.trace(record);
  EXPECT_EQ(stages, std::vector<std::string>{"a!7"});
  EXPECT_FALSE(watched.over([](const Eigen::VectorXd& x) { return x; }).observe);
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
