// SPDX-License-Identifier: GPL-3.0-or-later
// Slight joints under refinement: kinds persist, ratio and kappa scale, the vectors w are carried.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "domain/joints.h"
#include "domain/start.h"
#include "mesh/initial_mesh.h"
#include "mesh/split.h"

namespace c1mesh {
namespace {

// Four cubics; the joint of the last and the first lies at the origin, where halving control points
// has no rounding, and turns from (0, 1) by `turn` radians. Handles there are `in` and `out`.
MeshInput loop_turning_at_origin(double in, double out, double turn) {
  const Point p[4] = {{0, 0}, {-0.5, 0.5}, {-1, 0}, {-0.5, -0.5}};
  const Point t[4] = {{0, 1}, {-1, 0}, {0, -1}, {1, 0}};
  MeshInput input;
  input.loops.emplace_back();
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    const Point start =
        k == 0 ? Point(out * Point(-std::sin(turn), std::cos(turn))) : Point(0.25 * t[k]);
    const Point end = next == 0 ? Point(in * t[0]) : Point(0.25 * t[next]);
    input.loops[0].push_back({BezierCurve{{p[k], p[k] + start, p[next] - end, p[next]}}, k, false});
  }
  return input;
}

CurvedMesh mesh_of(const MeshInput& input) {
  MeshReport report;
  return initial_mesh(input, {}, report);
}

const Joint& at_origin(const CurvedMesh& mesh, const Joints& joints) {
  for (const Joint& joint : joints[0])
    if (mesh.control[joint.vertex].norm() == 0) return joint;
  throw std::logic_error("no joint at the origin");
}

enum class Halved { before, after, both };

void halve(CurvedMesh& mesh, int position, Halved which) {
  const int m = static_cast<int>(mesh.loops[0].size());
  const int in = (position + m - 1) % m;
  // The later place first: a split shifts what follows.
  for (const int edge : {std::max(in, position), std::min(in, position)}) {
    const bool wanted = edge == in ? which != Halved::after : which != Halved::before;
    if (wanted) split_boundary_edge(mesh, 0, edge);
  }
}

class Halving : public testing::TestWithParam<Halved> {};

// d0 or d1 is halved exactly, so r and kappa double, halve, or stay, to the last bit.
TEST_P(Halving, ScalesRatioAndKappaExactly) {
  for (const double turn : {5e-3, -1e-6, 4e-13}) {
    CurvedMesh mesh = mesh_of(loop_turning_at_origin(0.375, 0.25, turn));
    Joints joints = find_joints(mesh, 8);
    ASSERT_EQ(at_origin(mesh, joints).kind, JointKind::mild) << turn;
    EXPECT_NEAR(at_origin(mesh, joints).turn, turn, 1e-15);
    const double factor = GetParam() == Halved::before ? 2 : GetParam() == Halved::after ? 0.5 : 1;
    for (int round = 0; round < 8; ++round) {
      const Joint old = at_origin(mesh, joints);
      halve(mesh, old.position, GetParam());
      joints = find_joints_again(mesh, joints);
      const Joint& now = at_origin(mesh, joints);
      EXPECT_EQ(now.vertex, old.vertex);
      EXPECT_EQ(now.kind, JointKind::mild);
      EXPECT_EQ(now.d0, (GetParam() == Halved::after ? 1 : 0.5) * old.d0);
      EXPECT_EQ(now.d1, (GetParam() == Halved::before ? 1 : 0.5) * old.d1);
      EXPECT_EQ(now.ratio, factor * old.ratio);
      EXPECT_EQ(now.kappa, factor * old.kappa);
      EXPECT_EQ(now.turn, old.turn);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Halving,
                         testing::Values(Halved::before, Halved::after, Halved::both));

// What find_joints says of a slight turn depends on the edges' length; find_joints_again does not.
TEST(JointsAgain, KindsPersistWhereTheTurnWouldSeemToVanish) {
  CurvedMesh mesh = mesh_of(loop_turning_at_origin(0.375, 0.375, 2e-13));
  const Joints first = find_joints(mesh, 8);
  ASSERT_EQ(at_origin(mesh, first).kind, JointKind::mild);
  Joints joints = first;
  for (int round = 0; round < 4; ++round) {
    refine_uniform(mesh);
    joints = find_joints_again(mesh, joints);
  }
  ASSERT_EQ(at_origin(mesh, find_joints(mesh, 8)).kind, JointKind::smooth);
  EXPECT_EQ(at_origin(mesh, joints).kind, JointKind::mild);
  EXPECT_EQ(at_origin(mesh, joints).kappa, at_origin(mesh, first).kappa);
  EXPECT_EQ(joints[0].size(), 16 * first[0].size());
  std::vector<JointKind> kinds(mesh.vertex_count(), JointKind::inside);
  for (const Joint& joint : first[0]) kinds[joint.vertex] = joint.kind;
  for (const Joint& joint : joints[0]) EXPECT_EQ(joint.kind, kinds[joint.vertex]);
}

// A chain over the joint at the origin, bent there; the other joints between curves end chains.
struct Bent {
  CurvedMesh mesh;
  Joints joints;
  Roles roles;
  DomainLayout layout;
  int unknown() const { return layout.bend_unknown[0][at_origin(mesh, joints).position]; }
};

Bent bent_at_origin(double turn) {
  Bent out;
  out.mesh = mesh_of(loop_turning_at_origin(0.375, 0.375, turn));
  out.joints = find_joints(out.mesh, 8);
  out.roles.emplace_back(out.joints[0].size(), Role::flat);
  for (const Joint& joint : out.joints[0])
    if (joint.kind != JointKind::inside) out.roles[0][joint.position] = Role::exceptional;
  out.roles[0][at_origin(out.mesh, out.joints).position] = Role::bent;
  out.layout = make_layout(out.mesh, out.joints, out.roles);
  return out;
}

PointMatrix random_unknowns(const DomainLayout& layout) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1, 1);
  PointMatrix unknowns(layout.unknowns(), 2);
  for (Eigen::Index k = 0; k < unknowns.rows(); ++k)
    unknowns.row(k) << number(random), number(random);
  return unknowns;
}

class Carried : public testing::TestWithParam<double> {};

// Any unknowns give a domain, and the domain the unknowns back.
TEST_P(Carried, UnknownsComeBackFromTheDomain) {
  const Bent bent = bent_at_origin(GetParam());
  ASSERT_GE(bent.unknown(), 0);
  ASSERT_EQ(at_origin(bent.mesh, bent.joints).kind, JointKind::mild);
  const double kappa = at_origin(bent.mesh, bent.joints).kappa;
  EXPECT_NEAR(kappa / std::sin(GetParam()), 1, 1e-2);
  const PointMatrix unknowns = random_unknowns(bent.layout);
  DomainShape shape = shape_of_domain(bent.mesh.vertex_count(), bent.joints, bent.layout, unknowns);
  const PointMatrix back = unknowns_of_shape(shape, bent.joints, bent.layout);
  ASSERT_EQ(back.rows(), unknowns.rows());
  EXPECT_LT((back - unknowns).cwiseAbs().maxCoeff(), 4e-16);
  // From positions of size one, rounded, w is known to their error over kappa, and no better.
  shape.bends.clear();
  const PointMatrix recovered = unknowns_of_shape(shape, bent.joints, bent.layout);
  const double error = (recovered - unknowns).row(bent.unknown()).norm();
  EXPECT_GT(error, 0.02 * 1.1e-16 / kappa);
  EXPECT_LT(error, 20 * 1.1e-16 / kappa);
}

// Refined 1 to 4, w is halved with the edges, and the layout of the refined mesh gives the refined
// domain.
TEST_P(Carried, UnknownsFollowARefinement) {
  const Bent coarse = bent_at_origin(GetParam());
  const PointMatrix unknowns = random_unknowns(coarse.layout);
  DomainShape shape =
      shape_of_domain(coarse.mesh.vertex_count(), coarse.joints, coarse.layout, unknowns);
  CurvedMesh solved = coarse.mesh;
  for (int v = 0; v < solved.vertex_count(); ++v)
    solved.domain[v] = shape.points.row(v).transpose();
  refine_uniform(solved);
  Bent fine;
  fine.mesh = solved;
  fine.joints = find_joints_again(fine.mesh, coarse.joints);
  fine.roles = roles_on(coarse.joints, coarse.roles, fine.joints);
  fine.layout = make_layout(fine.mesh, fine.joints, fine.roles);
  shape.points.resize(solved.vertex_count(), 2);
  for (int v = 0; v < solved.vertex_count(); ++v)
    shape.points.row(v) = solved.domain[v].transpose();
  ASSERT_GE(fine.unknown(), 0);
  const PointMatrix carried = unknowns_of_shape(shape, fine.joints, fine.layout);
  EXPECT_LT((carried.row(fine.unknown()) - 0.5 * unknowns.row(coarse.unknown())).norm(), 1e-15);
  const PointMatrix points = (fine.layout.exact * carried).topRows(solved.vertex_count());
  EXPECT_LT((points - shape.points).cwiseAbs().maxCoeff(), 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Turns, Carried, testing::Values(1e-2, 1e-6, 1e-10, 1e-13));

}  // namespace
}  // namespace c1mesh
