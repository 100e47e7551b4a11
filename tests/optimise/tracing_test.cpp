// SPDX-License-Identifier: GPL-3.0-or-later
// What is recorded of a state: values known in closed form, and what every stage must do.
#include "optimise/tracing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "optimise/exact_map.h"
#include "optimise/random_mesh.h"

namespace c1mesh {
namespace {

using testing_tools::exact_map;
using testing_tools::ExactMap;
using testing_tools::ExactState;

// The unit square cut along a diagonal; the map is the identity.
CurvedMesh square(int n) {
  return testing_tools::straight_mesh(n, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}},
                                      {{0, 1, 2, 3}});
}

PointMatrix domain_of(const CurvedMesh& mesh) {
  return domain_points(mesh);
}

// An identity is C1 and a similarity: E_s = 0, and f = g = 2.
TEST(TraceRecord, OfTheIdentity) {
  for (const int n : {3, 4, 5}) {
    const CurvedMesh mesh = square(n);
    const TraceRecord record = trace_record(mesh, c1_edges(mesh), domain_of(mesh), mesh.control);
    EXPECT_LT(record.e_s, 1e-15);
    EXPECT_NEAR(record.e_reg, 2, 1e-13);
    EXPECT_NEAR(record.g, 2, 1e-13);
  }
}

// v3 is the mirror image of v2, so that g2 = -1: a control point next to the edge, moved by s,
// makes one d_ei of length s; E_s is their sum, not the root of their squares' sum.
TEST(TraceRecord, SumsTheDeviationsNotTheirSquares) {
  const int n = 4;
  CurvedMesh mesh = square(n);
  const std::vector<C1Edge> asked = c1_edges(mesh);
  ASSERT_EQ(asked.size(), 1u);
  mesh.control[asked[0].inner[1]] += Point(0.003, 0.004);
  mesh.control[asked[0].inner[2]] += Point(-0.012, 0.005);
  const TraceRecord record = trace_record(mesh, asked, domain_of(mesh), mesh.control);
  EXPECT_NEAR(record.e_s, 0.005 + 0.013, 1e-15);
  EXPECT_GT(record.g, 2);
  EXPECT_EQ(trace_record(mesh, {}, domain_of(mesh), mesh.control).e_s, 0);
}

// Stretched by s in one direction |J|^2 / det J = s + 1/s everywhere.
TEST(TraceRecord, OfAStretch) {
  const CurvedMesh mesh = square(3);
  PointMatrix domain = domain_of(mesh);
  domain.col(0) *= 4;
  const TraceRecord record = trace_record(mesh, c1_edges(mesh), domain, mesh.control);
  EXPECT_LT(record.e_s, 1e-15);
  EXPECT_NEAR(record.e_reg, 4.25, 1e-12);
  EXPECT_NEAR(record.g, 4.25, 1e-12);
}

TEST(TraceRecord, OfAnInvertedOrFlatDomainIsInfinite) {
  const CurvedMesh mesh = square(3);
  for (const Point& place : {Point(0.5, 0.5), Point(2, -1)}) {
    PointMatrix domain = domain_of(mesh);
    domain.row(3) = place.transpose();
    // Vertex 3 beyond the diagonal, or on it.
    const TraceRecord record = trace_record(mesh, c1_edges(mesh), domain, mesh.control);
    EXPECT_EQ(record.e_reg, std::numeric_limits<double>::infinity());
    EXPECT_EQ(record.g, std::numeric_limits<double>::infinity());
    EXPECT_FALSE(std::isnan(record.e_s));
  }
}

// With the penalty fixed every step lowers the objective, or is none. Only the objective: E_s, g
// and the mean energy may each rise on the way.
TEST(TracedMap, EveryStepOfNewtonLowersTheObjective) {
  const ExactMap map = exact_map({test::blob(8, 0.5, 5)});
  ASSERT_TRUE(map.attempt.success);
  const ExactState exact(map);
  MapObjective objective(map.mesh, exact.layout, exact.asked, {}, exact.state, false);
  MapState start = exact.state;
  start.control = map.mesh.control;
  start.control.resize(exact.state.control.size());
  std::copy(exact.state.control.begin() + static_cast<std::ptrdiff_t>(map.mesh.control.size()),
            exact.state.control.end(),
            start.control.begin() + static_cast<std::ptrdiff_t>(map.mesh.control.size()));
  int records = 0, falls = 0;
  for (const double rho : {1.0, 1e4}) {
    objective.rho = rho;
    Eigen::VectorXd x = objective.pack(start);
    double last = objective.value(x);
    const Checkpoint watched = Checkpoint([] {},
                                          [&](const TraceRecord& record) {
                                            EXPECT_EQ(record.stage, "test");
                                            EXPECT_GE(record.step, 0);
                                            EXPECT_LE(record.step, 1);
                                            ++records;
                                          });
    const Checkpoint traced = traced_map(watched, "test", map.mesh, objective);
    const auto both = traced.observed_by([&](const Eigen::VectorXd& there, double step) {
      traced.observe(there, step);
      const double value = objective.value(there);
      EXPECT_LE(value, last);
      EXPECT_EQ(value<last, step> 0);
      falls += value < last;
      last = value;
    });
    const int before = records;
    const int iterations = newton(objective, x, {8, 0}, both).iterations;
    EXPECT_EQ(iterations, records - before);
  }
  EXPECT_GT(falls, 8);
}

TEST(TracedMap, MeasuresTheStateItIsToldOf) {
  const ExactMap map = exact_map({test::lens(60)});
  ASSERT_TRUE(map.attempt.success);
  const ExactState exact(map);
  const MapObjective objective(map.mesh, exact.layout, exact.asked, {}, exact.state, false);
  TraceRecord told;
  const Checkpoint watched = Checkpoint([] {}, [&](const TraceRecord& r) { told = r; });
  traced_map(watched, "here", map.mesh, objective).observe(objective.pack(exact.state), 0.25);
  EXPECT_EQ(told.stage, "here");
  EXPECT_EQ(told.step, 0.25);
  EXPECT_EQ(told.g, exact.g(map.mesh));
  EXPECT_LT(told.e_s, exact.asked.size() * map.mesh.degree * kExact);
}

// Whatever the variables of a part of the domain stage, what is told are places of vertices; after
// the last iteration the domain that is returned, up to a similarity, which g does not see.
TEST(TracedDomain, IsToldTheVerticesByEveryPartOfTheStage) {
  int untangled = 0;
  for (const auto& loops : std::vector<std::vector<std::vector<BezierCurve>>>{
           {test::blob(6, 0.3, 2), test::backwards(test::circle({0.5, 0.5}, 0.1))},
           {test::blob(8, 0.5, 5)},
           {test::lens(60)}}) {
    MeshReport meshing;
    const CurvedMesh mesh = initial_mesh(test::input_of(loops), {}, meshing);
    const Joints joints = find_joints(mesh, 8);
    const Roles roles =
        place_exceptional(mesh, joints, natural_roles(joints), Placement::curvature);
    std::vector<TraceRecord> told;
    const Checkpoint watched([] {}, [&](const TraceRecord& r) { told.push_back(r); });
    const Checkpoint traced = traced_domain(watched, "test", mesh, joints, roles);
    const Checkpoint sized = traced.observed_by([&](const Eigen::VectorXd& x, double step) {
      ASSERT_EQ(x.size(), 2 * mesh.vertex_count());
      traced.observe(x, step);
    });
    DomainReport report;
    const DomainState state = solve_domain(mesh, joints, roles, {}, report, sized);
    ASSERT_TRUE(report.valid);
    untangled += report.untangle_iterations;
    ASSERT_GE(static_cast<int>(told.size()), report.untangle_iterations + report.newton_iterations);
    const PointMatrix points = state.layout.exact * state.unknowns;
    const std::vector<double> g = distortion_bounds(mesh, points, mesh.control);
    const double largest = *std::max_element(g.begin(), g.end());
    EXPECT_NEAR(told.back().g, largest, 1e-9 * largest);
    EXPECT_EQ(told.back().stage, "test");
  }
  EXPECT_GT(untangled, 0);
}

// Nothing is made for nobody.
TEST(Traced, WithoutATraceIsTheCheckpointItself) {
  const ExactMap map = exact_map({test::lens(60)});
  const ExactState exact(map);
  const MapObjective objective(map.mesh, exact.layout, exact.asked, {}, exact.state, false);
  const Checkpoint plain([] {});
  EXPECT_FALSE(traced_map(plain, "here", map.mesh, objective).observe);
  EXPECT_FALSE(traced_domain(plain, "here", map.mesh, map.joints, map.attempt.roles).observe);
  EXPECT_FALSE(traced_roles(plain, map.joints, map.attempt.roles).trace);
  EXPECT_FALSE(plain.marked([](TraceRecord&) {}).trace);
}

}  // namespace
}  // namespace c1mesh
