// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/unbend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "domain/apart.h"
#include "domain/hard_shapes.h"
#include "domain/minimise.h"
#include "domain/solve.h"
#include "domain/unbend_objective.h"
#include "finite_differences.h"
#include "mesh/scaffold.h"

namespace c1mesh {
namespace {

using test::Stage;
using testing_tools::gradient_error;
using testing_tools::hessian_error;

Eigen::VectorXd initial_positions(const CurvedMesh& mesh) {
  Eigen::VectorXd x(2 * mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) x.segment<2>(2 * v) = mesh.domain[v];
  return x;
}

double least_determinant(const CurvedMesh& mesh, const Eigen::VectorXd& x) {
  double least = 1e300;
  for (const auto& t : mesh.triangles) {
    const Point a = x.segment<2>(2 * t[0]);
    least = std::min(least, cross(x.segment<2>(2 * t[1]) - a, x.segment<2>(2 * t[2]) - a));
  }
  return least;
}

// Three consecutive boundary vertices each, random factors and multipliers.
std::vector<Spring> random_springs(const CurvedMesh& mesh, std::mt19937& random) {
  std::normal_distribution<double> number;
  std::vector<Spring> springs;
  const auto& loop = mesh.loops[0];
  for (std::size_t k = 0; k < loop.size(); ++k) {
    Spring spring;
    const std::complex<double> ratio(1 + 0.3 * number(random), number(random));
    spring.points = {loop[k].a, loop[k].b, loop[(k + 1) % loop.size()].b};
    spring.factor = {ratio, -1.0 - ratio, 1};
    spring.length2 = (mesh.domain[loop[k].b] - mesh.domain[loop[k].a]).squaredNorm();
    spring.stiffness = std::abs(number(random));
    spring.multiplier = 0.01 * Point(number(random), number(random));
    springs.push_back(spring);
  }
  return springs;
}

UnbendObjective random_objective(const Stage& stage, unsigned seed) {
  std::mt19937 random(seed);
  UnbendObjective objective(stage.mesh);
  objective.elements.assign(stage.elements.all.begin(),
                            stage.elements.all.begin() + stage.elements.triangles);
  objective.springs = random_springs(stage.mesh, random);
  return objective;
}

TEST(UnbendObjective, GradientIsThatOfItsValue) {
  const Stage stage = test::stage_of({test::polygon(test::comb(3))});
  UnbendObjective objective = random_objective(stage, 1);
  const Eigen::VectorXd x = initial_positions(stage.mesh);
  objective.scaffold = scaffold_elements(stage.mesh, unflatten(x), Flats::left_out, 0.1);
  ASSERT_FALSE(objective.scaffold.empty());
  Eigen::VectorXd gradient;
  SparseMatrix hessian;
  EXPECT_NEAR(objective.derivatives(x, gradient, hessian), objective.value(x),
              1e-12 * objective.value(x));
  EXPECT_LT(gradient_error([&](const auto& y) { return objective.value(y); }, gradient, x, 1e-7),
            1e-5);
}

// Elements' Hessians are projected; those of springs are exact.
TEST(UnbendObjective, HessianOfSpringsIsThatOfTheirGradient) {
  const Stage stage = test::stage_of({test::blob(4, 0.2, 5)});
  UnbendObjective objective = random_objective(stage, 2);
  objective.elements.clear();
  const Eigen::VectorXd x = initial_positions(stage.mesh);
  const auto gradient_at = [&](const Eigen::VectorXd& y) {
    Eigen::VectorXd gradient;
    SparseMatrix hessian;
    objective.derivatives(y, gradient, hessian);
    return gradient;
  };
  Eigen::VectorXd gradient;
  SparseMatrix lower;
  objective.derivatives(x, gradient, lower);
  const Eigen::MatrixXd half = lower;
  const Eigen::MatrixXd hessian = half.selfadjointView<Eigen::Lower>();
  EXPECT_LT(hessian_error(gradient_at, hessian, x, 1e-3), 1e-9);
}

TEST(UnbendObjective, NoTriangleTurnsOverOnTheWayOfAnyStep) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Stage stage = test::stage_of({test::blob(5, 0.4, seed)});
    UnbendObjective objective = random_objective(stage, seed);
    objective.stiffness = 100;
    SparseSolver solver;
    Eigen::VectorXd x = initial_positions(stage.mesh);
    for (int step = 0; step < 12; ++step) {
      const Eigen::VectorXd before = x;
      double value = 0, length = 0;
      newton_step(objective, solver, x, value, length);
      for (double t = 0.05; t <= 1; t += 0.05)
        ASSERT_GT(least_determinant(stage.mesh, before + t * (x - before)), 0) << seed;
      ASSERT_TRUE(winding_faults(stage.mesh, unflatten(x)).empty()) << seed;
    }
  }
}

TEST(UnbendObjective, StepLimitIsJustBeforeTheFirstTriangleVanishes) {
  const Stage stage = test::stage_of({test::blob(4, 0.2, 7)});
  UnbendObjective objective = random_objective(stage, 3);
  const Eigen::VectorXd x = initial_positions(stage.mesh);
  std::mt19937 random(4);
  std::normal_distribution<double> number;
  for (int k = 0; k < 10; ++k) {
    const Eigen::VectorXd direction =
        Eigen::VectorXd::NullaryExpr(x.size(), [&] { return number(random); });
    const double limit = objective.step_limit(x, direction);
    ASSERT_LT(limit, 1);
    EXPECT_GT(least_determinant(stage.mesh, x + limit * direction), 0);
    EXPECT_NEAR(least_determinant(stage.mesh, x + limit / 0.9 * direction), 0, 1e-12);
  }
}

using Outlines = std::map<std::string, std::vector<std::vector<BezierCurve>>>;

Outlines hard_outlines() {
  return {{"comb", {test::rounded(test::comb(5), 0.3)}},
          {"tree", {test::rounded(test::tree(2), 0.3)}},
          {"spiral", {test::spiral(5)}},
          {"comb with corners", {test::polygon(test::comb(6))}},
          {"plate",
           {test::circle({0.5, 0.5}, 0.5), test::backwards(test::circle({0.3, 0.5}, 0.1)),
            test::backwards(test::circle({0.7, 0.4}, 0.1))}}};
}

TEST(Unbend, ReachesTheLayoutWithoutEverTurningOver) {
  for (const auto& [name, loops] : hard_outlines()) {
    const Stage stage = test::stage_of(loops);
    // A strip wound on itself has no room to unroll in the plane.
    UnbendOptions options;
    options.apart = name != "spiral";
    UnbendReport report;
    const PointMatrix unknowns = unbend_domain(stage.mesh, stage.joints, stage.roles, stage.layout,
                                               stage.elements, options, report, {});
    EXPECT_TRUE(report.reached) << name;
    const PointMatrix points = stage.layout.exact * unknowns;
    for (const DomainElement& e : stage.elements.all) ASSERT_GT(determinant_of(e, points), 0);
    EXPECT_TRUE(winding_faults(stage.mesh, points).empty()) << name;
    if (options.apart) {
      EXPECT_FALSE(boundary_meets_itself(stage.mesh, points)) << name;
    }
  }
}

TEST(SolveDomain, EndsValidAndApartOnHardOutlines) {
  for (const auto& [name, loops] : hard_outlines()) {
    const Stage stage = test::stage_of(loops);
    DomainReport report;
    const DomainState state = solve_domain(stage.mesh, stage.joints, stage.roles, {}, report, {});
    EXPECT_TRUE(report.valid) << name;
    EXPECT_EQ(report.crossings, 0) << name;
    EXPECT_FALSE(boundary_meets_itself(stage.mesh, state.layout.exact * state.unknowns)) << name;
  }
}

// An exceptional vertex at a mild joint is a corner of the polygon like any other: something must
// hold it on its side, or it may be wound more than once.
TEST(DomainElements, ExceptionalVerticesAtMildJointsHaveAWedge) {
  std::vector<BezierCurve> loop = test::circle({0.5, 0.5}, 0.5);
  loop[0].poles[1] += Point(0.01, 0);
  Stage stage = test::stage_of({loop});
  int mild = 0;
  for (std::size_t k = 0; k < stage.joints[0].size(); ++k) {
    if (stage.joints[0][k].kind != JointKind::mild) continue;
    ++mild;
    Roles roles = stage.roles;
    roles[0][k] = Role::exceptional;
    const DomainLayout layout = make_layout(stage.mesh, stage.joints, roles);
    const DomainElements elements = domain_elements(stage.mesh, stage.joints, roles, layout, {});
    bool held = false;
    for (std::size_t e = elements.triangles; e < elements.all.size(); ++e)
      held |= elements.all[e].points[0] == stage.joints[0][k].vertex;
    EXPECT_TRUE(held);
  }
  EXPECT_GT(mild, 0);
}

double area_of(const std::vector<Point>& points, const std::vector<std::array<int, 3>>& triangles) {
  double sum = 0;
  for (const auto& t : triangles)
    sum += 0.5 * cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
  return sum;
}

TEST(Scaffold, FillsTheConvexHull) {
  // A unit square with a notch and a square hole: what is missing to the hull is notch and hole.
  const std::vector<Point> outline = {{0, 0},     {1, 0},   {1, 1}, {0.6, 1},
                                      {0.5, 0.7}, {0.4, 1}, {0, 1}};
  const std::vector<Point> hole = {{0.2, 0.2}, {0.2, 0.4}, {0.4, 0.4}, {0.4, 0.2}};
  const Stage stage = test::stage_of({test::polygon(outline), test::polygon(hole)});
  const Scaffold scaffold = make_scaffold(stage.mesh, stage.mesh.domain);
  EXPECT_FALSE(scaffold.crossing);
  EXPECT_NEAR(area_of(stage.mesh.domain, scaffold.triangles), 0.5 * 0.2 * 0.3 + 0.04, 1e-12);
  for (const auto& t : scaffold.triangles) EXPECT_GT(area_of(stage.mesh.domain, {t}), 0);
}

TEST(Scaffold, FindsCrossingsAndTouches) {
  const Stage stage =
      test::stage_of({test::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}),
                      test::polygon({{0.4, 0.4}, {0.4, 0.6}, {0.6, 0.6}, {0.6, 0.4}})});
  std::vector<Point> moved = stage.mesh.domain;
  const int corner = stage.mesh.loops[1][0].a;
  moved[corner] = {0.1, 0.37};
  EXPECT_FALSE(make_scaffold(stage.mesh, moved).crossing);
  moved[corner] = {-0.1, 0.37};
  EXPECT_TRUE(make_scaffold(stage.mesh, moved).crossing);
  moved[corner] = {0, 0.37};
  EXPECT_TRUE(make_scaffold(stage.mesh, moved).crossing);
}

}  // namespace
}  // namespace c1mesh
