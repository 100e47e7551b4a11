// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "domain/exceptional.h"
#include "domain/solve.h"
#include "mesh/initial_mesh.h"
#include "mesh/topology.h"

namespace c1mesh {
namespace {

LoopCurve cubic(int id, Point a, Point b, Point c, Point d) {
  return {BezierCurve{{a, b, c, d}}, id, false};
}

// A closed loop of four cubics through the corners of a square; handles are the joints' tangents
// times per-joint lengths in and out, turned by `turn` radians at joint 0.
MeshInput loop_with_ratio(double in, double out, double turn) {
  const Point p[4] = {{0.9, 0.5}, {0.5, 0.9}, {0.1, 0.5}, {0.5, 0.1}};
  const Point t[4] = {{0, 1}, {-1, 0}, {0, -1}, {1, 0}};
  const Point bent(-std::sin(turn), std::cos(turn));
  MeshInput input;
  input.loops.emplace_back();
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    const Point start = k == 0 ? Point(out * bent) : Point(0.2 * t[k]);
    const Point end = next == 0 ? Point(in * t[0]) : Point(0.2 * t[next]);
    input.loops[0].push_back(cubic(k, p[k], p[k] + start, p[next] - end, p[next]));
  }
  return input;
}

struct Case {
  CurvedMesh mesh;
  Joints joints;
  Roles roles;
  DomainLayout layout;
};

Case make_case(double in, double out, double turn) {
  Case c;
  MeshReport report;
  c.mesh = initial_mesh(loop_with_ratio(in, out, turn), {}, report);
  c.joints = find_joints(c.mesh, 8);
  c.roles = place_exceptional(c.mesh, c.joints, natural_roles(c.joints), Placement::spread);
  c.layout = make_layout(c.mesh, c.joints, c.roles);
  return c;
}

PointMatrix random_points(const DomainLayout& layout, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  PointMatrix unknowns(layout.unknowns(), 2);
  for (Eigen::Index k = 0; k < unknowns.rows(); ++k)
    unknowns.row(k) << number(random), number(random);
  return layout.exact * unknowns;
}

const Joint& joint_of_kind(const Case& c, JointKind kind) {
  for (const Joint& joint : c.joints[0])
    if (joint.kind == kind) return joint;
  throw std::logic_error("no such joint");
}

// For any values of the unknowns flat vertices are flat and divide their edges as the derivatives.
TEST(Layout, FlatVerticesDivideTheirEdgesAsTheDerivativesDo) {
  const Case c = make_case(0.25, 0.11, 0);
  const PointMatrix points = random_points(c.layout, 3);
  const int m = static_cast<int>(c.joints[0].size());
  int flat = 0;
  for (int k = 0; k < m; ++k) {
    if (c.roles[0][k] != Role::flat) continue;
    ++flat;
    const Joint& joint = c.joints[0][k];
    const Point in = points.row(joint.vertex) - points.row(c.joints[0][(k + m - 1) % m].vertex);
    const Point out = points.row(c.joints[0][(k + 1) % m].vertex) - points.row(joint.vertex);
    EXPECT_LT((out - joint.d1.norm() / joint.d0.norm() * in).norm(), 1e-13 * (1 + out.norm()));
  }
  EXPECT_EQ(flat, m - 3);
}

// e1 = r e0 + kappa w, with the tips at v + e0 and v + w, over decades of the turn.
TEST(Layout, BentJointsTurnByKappaW) {
  for (double turn : {1e-2, 1e-4, 1e-6, 1e-8, -1e-3, -1e-7}) {
    Case c = make_case(0.2, 0.2, turn);
    const Joint& joint = joint_of_kind(c, JointKind::mild);
    EXPECT_NEAR(joint.turn, turn, 1e-12);
    if (gives_up_c1(c.roles[0][joint.position])) {
      c.roles = natural_roles(c.joints, 1);
      const int m = static_cast<int>(c.joints[0].size());
      for (int k = 1; k < 4; ++k) c.roles[0][(joint.position + k * m / 4) % m] = Role::exceptional;
    } else {
      c.roles[0][joint.position] = Role::bent;
    }
    c.layout = make_layout(c.mesh, c.joints, c.roles);
    const PointMatrix points = random_points(c.layout, 5);
    const int m = static_cast<int>(c.joints[0].size()), k = joint.position;
    const Tips tips = c.layout.tips[0][k];
    ASSERT_GE(tips.along, 0);
    const Point v = points.row(joint.vertex);
    const Point e0 = v - Point(points.row(c.joints[0][(k + m - 1) % m].vertex));
    const Point e1 = Point(points.row(c.joints[0][(k + 1) % m].vertex)) - v;
    const Point w = Point(points.row(tips.across)) - v;
    EXPECT_LT((Point(points.row(tips.along)) - v - e0).norm(), 1e-14);
    EXPECT_LT((e1 - joint.ratio * e0 - joint.kappa * w).norm(), 2e-14);
  }
}

// A smooth loop needs three exceptional vertices; the domain is then a triangle with the area of
// the shape, valid, wound once, and optimal up to the tolerance.
TEST(Domain, SmoothLoopBecomesATriangle) {
  const Case c = make_case(0.2, 0.2, 0);
  EXPECT_EQ(minimum_exceptional(c.mesh, c.joints), 3);
  EXPECT_EQ(count_exceptional(c.roles), 3);
  DomainReport report;
  const DomainState state = solve_domain(c.mesh, c.joints, c.roles, {}, report, {});
  ASSERT_TRUE(report.valid);
  EXPECT_EQ(report.crossings, 0);
  const PointMatrix points = state.layout.exact * state.unknowns;
  EXPECT_TRUE(winding_faults(c.mesh, points.topRows(c.mesh.vertex_count())).empty());
  double turning = 0;
  const int m = static_cast<int>(c.joints[0].size());
  for (int k = 0; k < m; ++k) {
    const Point v = points.row(c.joints[0][k].vertex);
    const Point in = v - Point(points.row(c.joints[0][(k + m - 1) % m].vertex));
    const Point out = Point(points.row(c.joints[0][(k + 1) % m].vertex)) - v;
    const double turn = std::atan2(cross(in, out), in.dot(out));
    turning += turn;
    if (c.roles[0][k] == Role::flat) {
      EXPECT_NEAR(turn, 0, 1e-12);
    } else {
      EXPECT_GT(turn, 0.1);
    }
  }
  EXPECT_NEAR(turning, 2 * std::numbers::pi, 1e-9);
}

// Untangling from a start with a vertex thrown far outside ends valid.
TEST(Domain, UntanglesAThrownVertex) {
  const Case c = make_case(0.2, 0.2, 0);
  const DomainElements elements = domain_elements(c.mesh, c.joints, c.roles, c.layout, {});
  DomainObjective objective(c.layout, elements.all);
  Eigen::VectorXd x = flatten(start_positions(c.mesh, c.joints, c.roles, c.layout, Start::convex));
  const MeshTopology topology(c.mesh);
  for (int v = 0; v < c.mesh.vertex_count(); ++v)
    if (!topology.on_boundary[v]) {
      x.segment<2>(2 * c.layout.unknown_of_row[v]) += Point(3, -2);
      break;
    }
  ASSERT_LT(objective.least_determinant(x), 0);
  EXPECT_TRUE(untangle_domain(objective, x, 200, {}).converged);
  EXPECT_GT(objective.least_determinant(x), 0);
}

}  // namespace
}  // namespace c1mesh
