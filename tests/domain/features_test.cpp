// SPDX-License-Identifier: GPL-3.0-or-later
// Chains along features, and how many exceptional vertices features need.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "domain/cycles.h"
#include "domain/energy.h"
#include "domain/exceptional.h"
#include "domain/layout.h"
#include "mesh/initial_mesh.h"

namespace c1mesh {
namespace {

constexpr double kHandle = 0.5625;

std::vector<LoopCurve> circle(double r, int first) {
  std::vector<LoopCurve> out;
  const Point centre(0.5, 0.5);
  Point from(r, 0);
  for (int k = 0; k < 4; ++k) {
    const Point to(-from.y(), from.x());
    out.push_back({BezierCurve{{centre + from, centre + from + kHandle * to,
                                centre + to + kHandle * from, centre + to}},
                   first + k, false});
    from = to;
  }
  return out;
}

LoopCurve cubic(int id, Point a, Point b, Point c, Point d) {
  return {BezierCurve{{a, b, c, d}}, id, false};
}

MeshInput disc() {
  MeshInput input;
  input.loops.push_back(circle(0.375, 0));
  return input;
}

struct Case {
  CurvedMesh mesh;
  Joints joints;
  Roles roles;
};

Case case_of(const MeshInput& input) {
  Case c;
  MeshReport report;
  c.mesh = initial_mesh(input, {}, report);
  c.joints = find_joints(c.mesh, 8);
  c.roles = place_exceptional(c.mesh, c.joints, natural_roles(c.joints), Placement::curvature);
  return c;
}

int exceptional(const Case& c) {
  std::set<int> out;
  for (std::size_t l = 0; l < c.joints.size(); ++l)
    for (std::size_t k = 0; k < c.joints[l].size(); ++k)
      if (gives_up_c1(c.roles[l][k])) out.insert(c.joints[l][k].vertex);
  return static_cast<int>(out.size());
}

// Two cubics with one tangent but derivatives 3 : 1, then a mild turn, then a corner.
MeshInput path_of_joints() {
  MeshInput input = disc();
  const Point a(0.2, 0.5), b(0.4, 0.5), c(0.55, 0.5), d(0.7, 0.52), e(0.7, 0.65);
  const double turn = 3e-3;
  input.features.push_back({{cubic(10, a, a + Point(0.05, 0.05), b - Point(0.06, 0), b),
                             cubic(11, b, b + Point(0.02, 0), c - Point(0.04, 0), c),
                             cubic(12, c, c + Point(0.04, 0.04 * turn), d - Point(0.05, 0.01), d),
                             cubic(13, d, d + Point(0, 0.04), e - Point(0, 0.04), e)},
                            false});
  return input;
}

TEST(FeatureChains, DivideTheirEdgesAsTheDerivativesDo) {
  const Case c = case_of(path_of_joints());
  const DomainLayout layout = make_layout(c.mesh, c.joints, c.roles);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(-1, 1);
  PointMatrix unknowns(layout.unknowns(), 2);
  for (Eigen::Index k = 0; k < unknowns.rows(); ++k)
    unknowns.row(k) << number(random), number(random);
  const PointMatrix points = layout.exact * unknowns;
  ASSERT_EQ(c.joints.size(), 2u);
  const auto& path = c.joints[1];
  ASSERT_EQ(path.size(), c.mesh.features[0].edges.size() + 1);
  int smooth = 0, bent = 0, corners = 0;
  for (std::size_t k = 1; k + 1 < path.size(); ++k) {
    const Joint& joint = path[k];
    const Point in = points.row(joint.vertex) - points.row(joint.previous);
    const Point out = points.row(joint.next) - points.row(joint.vertex);
    switch (c.roles[1][k]) {
      case Role::flat:
        EXPECT_LT((out - joint.ratio * in).norm(), 1e-13);
        smooth += joint.kind == JointKind::smooth;
        if (joint.kind == JointKind::smooth) {
          EXPECT_NEAR(joint.ratio, joint.d1.norm() / joint.d0.norm(), 1e-15);
        }
        break;
      case Role::bent: {
        ++bent;
        const Point w = unknowns.row(layout.bend_unknown[1][k]);
        EXPECT_LT((out - joint.ratio * in - joint.kappa * w).norm(), 1e-13);
        const Tips tips = layout.tips[1][k];
        EXPECT_LT((Point(points.row(tips.along) - points.row(joint.vertex)) - in).norm(), 1e-13);
        break;
      }
      case Role::anchor:
        ++corners;
        EXPECT_EQ(joint.kind, JointKind::corner);
        EXPECT_GE(layout.unknown_of_row[joint.vertex], 0);
        break;
      default:
        FAIL() << "nothing is exceptional on an open path";
    }
  }
  EXPECT_EQ(smooth, 1);
  EXPECT_EQ(bent, 1);
  EXPECT_EQ(corners, 1);
  // Dangling ends are free and C1.
  for (const Joint& end : {path.front(), path.back()}) {
    EXPECT_EQ(end.kind, JointKind::end);
    EXPECT_FALSE(end.branch);
    EXPECT_GE(layout.unknown_of_row[end.vertex], 0);
  }
  EXPECT_EQ(exceptional(c), 3);
}

TEST(FeatureCounts, BranchPointsAreExceptionalFromTheStart) {
  MeshInput input = disc();
  const Point m(0.5, 0.5), east = input.loops[0][0].bezier.start();
  input.features.push_back({{cubic(10, m, {0.6, 0.55}, {0.7, 0.45}, east)}, false});
  input.features.push_back({{cubic(11, m, {0.45, 0.6}, {0.4, 0.6}, {0.35, 0.7})}, false});
  input.features.push_back({{cubic(12, m, {0.45, 0.4}, {0.4, 0.4}, {0.35, 0.3})}, false});
  const Case c = case_of(input);
  const Roles natural = natural_roles(c.joints);
  for (std::size_t l = 0; l < c.joints.size(); ++l)
    for (std::size_t k = 0; k < c.joints[l].size(); ++k) {
      const bool branch = (c.mesh.control[c.joints[l][k].vertex] - m).norm() < 1e-9 ||
                          (c.mesh.control[c.joints[l][k].vertex] - east).norm() < 1e-9;
      EXPECT_EQ(c.joints[l][k].branch, branch);
      EXPECT_EQ(natural[l][k] == Role::branch, branch);
    }
  // The one on the circle serves as one of the three corners that the circle needs.
  EXPECT_EQ(exceptional(c), 1 + 3);
  EXPECT_EQ(minimum_exceptional(c.mesh, c.joints), 1 + 3);
}

TEST(FeatureCounts, ASmoothClosedFeatureNeedsThreeCorners) {
  MeshInput input = disc();
  input.features.push_back({circle(0.15625, 10), true});
  const Case c = case_of(input);
  EXPECT_EQ(face_cycles(c.mesh).size(), 3u);  // the circle, and the feature from its two sides
  EXPECT_EQ(exceptional(c), 3 + 3);
  EXPECT_EQ(minimum_exceptional(c.mesh, c.joints), 3 + 3);
}

TEST(FeatureCounts, AChordMakesTwoPolygons) {
  MeshInput input = disc();
  const Point east = input.loops[0][0].bezier.start(), west = input.loops[0][2].bezier.start();
  input.features.push_back({{cubic(10, east, {0.7, 0.5}, {0.3, 0.5}, west)}, false});
  const Case c = case_of(input);
  const auto cycles = face_cycles(c.mesh);
  ASSERT_EQ(cycles.size(), 2u);
  for (const Cycle& cycle : cycles) EXPECT_TRUE(cycle.inside);
  // Each half needs a corner beside the two ends of the chord, and both lie on the circle.
  EXPECT_EQ(exceptional(c), 2 + 2);
  EXPECT_EQ(minimum_exceptional(c.mesh, c.joints), 2 + 2);
  for (const Role role : c.roles[1]) EXPECT_NE(role, Role::exceptional);
}

TEST(FeatureCounts, DanglingCurvesBoundNothing) {
  MeshInput input = disc();
  const Point east = input.loops[0][0].bezier.start();
  input.features.push_back({{cubic(10, east, {0.8, 0.6}, {0.7, 0.4}, {0.5, 0.5})}, false});
  const Case c = case_of(input);
  EXPECT_EQ(face_cycles(c.mesh).size(), 1u);
  EXPECT_EQ(exceptional(c), 3);
  EXPECT_EQ(minimum_exceptional(c.mesh, c.joints), 3);
}

}  // namespace
}  // namespace c1mesh
