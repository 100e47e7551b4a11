// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/straighten.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mesh/shapes.h"
#include "paper/meshes.h"

namespace c1mesh {
namespace {

using namespace testing_tools;

std::set<int> corners_of(const Straightened& s) {
  std::set<int> out;
  for (std::size_t v = 0; v < s.corner.size(); ++v)
    if (s.corner[v]) out.insert(static_cast<int>(v));
  return out;
}

Point row(const PointMatrix& points, int v) {
  return points.row(v).transpose();
}

double turn(const PointMatrix& domain, const Joint& j) {
  const Point in = row(domain, j.vertex) - row(domain, j.previous);
  const Point out = row(domain, j.next) - row(domain, j.vertex);
  return std::atan2(cross(in, out), in.dot(out));
}

// Every vertex of a closed path that is no corner lies on the line, and three or more are corners.
void expect_straight(const Straightened& s, const std::vector<Joint>& path) {
  int corners = 0;
  for (const Joint& j : path) {
    corners += s.corner[j.vertex];
    if (!s.corner[j.vertex]) {
      EXPECT_LT(std::abs(turn(s.domain, j)), 1e-13) << j.vertex;
    }
  }
  EXPECT_GE(corners, 3);
}

// A fan around w = (2, 1) of a rectangle whose lower side has vertices at `at` (0 first, 4 last).
struct Fan {
  CurvedMesh mesh;
  Joints joints;
  Pair state;
  int w;
};

Fan fan(const std::vector<double>& at) {
  Fan out;
  std::vector<Point> points;
  std::vector<int> loop;
  for (const double x : at) points.emplace_back(x, 0);
  points.emplace_back(4, 3);
  points.emplace_back(0, 3);
  for (std::size_t k = 0; k < points.size(); ++k) loop.push_back(static_cast<int>(k));
  out.w = static_cast<int>(points.size());
  points.emplace_back(2, 1);
  std::vector<std::array<int, 3>> triangles;
  for (std::size_t k = 0; k < loop.size(); ++k)
    triangles.push_back({loop[k], loop[(k + 1) % loop.size()], out.w});
  out.mesh = straight_mesh(3, points, triangles, {loop});
  out.joints = find_joints(out.mesh, 8);
  out.state = initial_pair(out.mesh);
  return out;
}

constexpr double kFar = 1e6;  // a bound that no triangle of these tests meets while it is positive

// The corners of the shape stay where they are; vertices between them go to their foot points.
TEST(Straighten, OrthogonallyKeepsTheFootPoints) {
  Fan f = fan({0, 1, 2, 3, 4});
  f.state.domain.row(0) << 0.1, -0.2;
  f.state.domain.row(1) << 1, 0.25;
  f.state.domain.row(2) << 2.125, -0.25;
  f.state.domain.row(3) << 3.25, 0.125;
  f.state.domain.row(4) << 4.1, -0.2;
  const Straightened s =
      straighten(f.mesh, f.joints, f.state, {kFar, Straightening::orthogonal, false});
  EXPECT_EQ(corners_of(s), (std::set<int>{0, 4, 5, 6}));
  EXPECT_EQ(s.restored, 0);
  for (const int v : {0, 4, 5, 6, 7}) EXPECT_EQ(row(s.domain, v), row(f.state.domain, v));
  for (const int v : {1, 2, 3}) {
    EXPECT_NEAR(s.domain(v, 0), f.state.domain(v, 0), 1e-15);
    EXPECT_NEAR(s.domain(v, 1), -0.2, 1e-15);
  }
  // Vertex 1 went furthest, by 0.45; the domain is 4.1 wide.
  EXPECT_NEAR(s.largest_move, 0.45 / 4.1, 1e-14);
  expect_straight(s, f.joints[0]);
}

// Along a line in any direction, the move is perpendicular to it.
TEST(Straighten, MovesAreOrthogonalToTheLine) {
  Fan f = fan({0, 1, 2, 3, 4});
  Eigen::Matrix2d turned;
  turned << 0.6, -0.8, 0.8, 0.6;
  for (const int v : {1, 2, 3}) f.state.domain(v, 1) += 0.05 * v;
  f.state.domain = mapped(f.state.domain, turned, {1, 2});
  const Straightened s =
      straighten(f.mesh, f.joints, f.state, {kFar, Straightening::orthogonal, false});
  const Point line = row(s.domain, 4) - row(s.domain, 0);
  for (const int v : {1, 2, 3}) {
    const Point move = row(s.domain, v) - row(f.state.domain, v);
    EXPECT_NEAR(move.norm(), 0.05 * v, 1e-14);
    EXPECT_NEAR(move.dot(line), 0, 1e-14);
  }
  expect_straight(s, f.joints[0]);
}

// Edges of the shape of length 1/2, 1/4, 9/4, 1: derivatives in the same ratios, and so the parts
// of the line from (0, 0) to (8, 2), whatever the vertices' places were.
TEST(Straighten, FractionsFollowTheBoundarysDerivatives) {
  Fan f = fan({0, 0.5, 0.75, 3, 4});
  f.state.domain.row(1) << 2, 0.6;
  f.state.domain.row(2) << 4, 1.1;
  f.state.domain.row(3) << 6, 1.4;
  f.state.domain.row(4) << 8, 2;
  f.state.domain.row(5) << 8, 7;
  f.state.domain.row(6) << 0, 7;
  f.state.domain.row(7) << 4, 4;
  const Straightened s =
      straighten(f.mesh, f.joints, f.state, {kFar, Straightening::fractions, false});
  EXPECT_EQ(s.restored, 0);
  const double part[5] = {0, 0.125, 0.1875, 0.75, 1};
  for (int v = 0; v < 5; ++v)
    EXPECT_LT((row(s.domain, v) - part[v] * Point(8, 2)).norm(), 1e-14) << v;
  // Orthogonally they would have kept their places along the line.
  const Straightened other =
      straighten(f.mesh, f.joints, f.state, {kFar, Straightening::orthogonal, false});
  EXPECT_GT((row(other.domain, 1) - row(s.domain, 1)).norm(), 0.5);
}

// The paper's figure 11: the lower side sags below w, and straightened as a whole it would pass it.
// Its lowest vertex is the sharpest; with that a corner, both halves can be straightened.
TEST(Straighten, WhereATriangleWouldBeInvertedTheSharpestVertexIsACornerToo) {
  Fan f = fan({0, 1, 2, 3, 4});
  f.state.domain.row(1) << 1, -0.55;
  f.state.domain.row(2) << 2, -1;
  f.state.domain.row(3) << 3, -0.45;
  f.state.domain.row(f.w) << 2, -0.3;
  for (const bool no_overlap : {false, true}) {
    const Straightened s =
        straighten(f.mesh, f.joints, f.state, {kFar, Straightening::orthogonal, no_overlap});
    EXPECT_EQ(corners_of(s), (std::set<int>{0, 2, 4, 5, 6}));
    EXPECT_EQ(s.restored, 1);
    EXPECT_EQ(row(s.domain, 2), Point(2, -1));
    // Feet on the lines from (0, 0) and (4, 0) to (2, -1): at (2 + 0.55) / 5, (2 + 0.45) / 5.
    EXPECT_LT((row(s.domain, 1) - 0.51 * Point(2, -1)).norm(), 1e-14);
    EXPECT_LT((row(s.domain, 3) - Point(4, 0) - 0.49 * Point(-2, -1)).norm(), 1e-14);
    for (const double g : distortion_bounds(f.mesh, s.domain, f.state.control))
      EXPECT_TRUE(std::isfinite(g));
    // It was to be straight there, and the shape is: exceptional.
    const std::vector<char> exceptional = exceptional_corners(f.mesh, f.joints, s);
    EXPECT_EQ(std::count(exceptional.begin(), exceptional.end(), 1), 1);
    EXPECT_EQ(exceptional[2], 1);
  }
}

// The same sag without a vertex in the way: what undoes the straightening is then the bound on g.
TEST(Straighten, TheBoundOnDistortionIsKept) {
  Fan f = fan({0, 1, 2, 3, 4});
  f.state.domain.row(2) << 2, -1;
  f.state.domain.row(f.w) << 2, 0.05;  // a nearly flat triangle once straightened
  const auto run = [&](double bound) {
    return straighten(f.mesh, f.joints, f.state, {bound, Straightening::orthogonal, false});
  };
  const Straightened loose = run(1e4), tight = run(15);
  EXPECT_EQ(loose.restored, 0);
  EXPECT_EQ(corners_of(loose).size(), 4u);
  EXPECT_GT(tight.restored, 0);
  EXPECT_TRUE(tight.corner[2]);
  const auto largest = [&](const Straightened& s) {
    const auto g = distortion_bounds(f.mesh, s.domain, f.state.control);
    return *std::max_element(g.begin(), g.end());
  };
  EXPECT_LT(largest(tight), 15);
  EXPECT_GT(largest(loose), 15);
}

// Without a corner in the shape the three sharpest vertices of the domain are kept, or more; which
// they are does not depend on where the loop starts.
TEST(Straighten, SmoothLoopsKeepThreeCornersWhereverTheyStart) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    MeshReport report;
    const CurvedMesh mesh = initial_mesh(test::input_of({test::blob(6, 0.2, seed)}), {}, report);
    const auto run = [&](const CurvedMesh& m) {
      const Joints joints = find_joints(m, 8);
      const Straightened s =
          straighten(m, joints, initial_pair(m), {kFar, Straightening::orthogonal, false});
      expect_straight(s, joints[0]);
      for (const double g : distortion_bounds(m, s.domain, m.control)) EXPECT_LT(g, kFar);
      return s;
    };
    const std::set<int> corners = corners_of(run(mesh));
    const int edges = static_cast<int>(mesh.loops[0].size());
    ASSERT_GE(edges, 6);
    for (int start = 1; start < edges; ++start) {
      CurvedMesh other = mesh;
      std::rotate(other.loops[0].begin(), other.loops[0].begin() + start, other.loops[0].end());
      EXPECT_EQ(corners_of(run(other)), corners) << "seed " << seed << ", start " << start;
    }
  }
}

// A polygon needs three corners that turn its way. Two of the shape's do, a reflex one does not:
// one more is kept, so that nothing collapses.
TEST(Straighten, ReflexCornersAreNotAmongTheThree) {
  Fan f = fan({0, 1, 2, 3, 4});
  for (Joint& j : f.joints[0])
    j.kind = j.vertex % 2 == 0 && j.vertex < 5 ? JointKind::corner : JointKind::smooth;
  f.state.domain.row(2) << 2, 0.3;
  const Straightened s =
      straighten(f.mesh, f.joints, f.state, {kFar, Straightening::orthogonal, false});
  EXPECT_EQ(s.restored, 0);
  EXPECT_TRUE(s.corner[0] && s.corner[2] && s.corner[4]);
  EXPECT_EQ(s.corner[5] + s.corner[6], 1);
  EXPECT_EQ(corners_of(s).size(), 4u);
  expect_straight(s, f.joints[0]);
}

// Holes are run through the other way; their corners count where they turn that way.
TEST(Straighten, HolesKeepThreeCornersToo) {
  MeshReport report;
  const CurvedMesh mesh =
      initial_mesh(test::input_of({test::circle({0.5, 0.5}, 0.4),
                                   test::backwards(test::circle({0.5, 0.5}, 0.15))}),
                   {}, report);
  const Joints joints = find_joints(mesh, 8);
  const Straightened s =
      straighten(mesh, joints, initial_pair(mesh), {kFar, Straightening::fractions, false});
  for (const auto& path : joints) expect_straight(s, path);
  const std::vector<char> exceptional = exceptional_corners(mesh, joints, s);
  EXPECT_EQ(std::vector<char>(s.corner), exceptional) << "no smooth vertex may be a corner";
}

TEST(ShapeCorner, TurnsThatC1SurvivesAreNone) {
  Joint joint;
  for (const JointKind kind : {JointKind::inside, JointKind::smooth}) {
    joint.kind = kind;
    EXPECT_FALSE(is_shape_corner(joint));
  }
  for (const JointKind kind : {JointKind::corner, JointKind::end}) {
    joint.kind = kind;
    EXPECT_TRUE(is_shape_corner(joint));
  }
  joint.kind = JointKind::mild;
  for (const double sign : {1, -1}) {
    joint.turn = sign * 0.99 * kNegligibleTurn;
    EXPECT_FALSE(is_shape_corner(joint));
    joint.turn = sign * 1.01 * kNegligibleTurn;
    EXPECT_TRUE(is_shape_corner(joint));
  }
  joint.kind = JointKind::inside;
  joint.branch = true;
  EXPECT_TRUE(is_shape_corner(joint));
}

// Corners of the rectangle are convex; a domain that is reflex or flat in one of them gives up C1.
TEST(ExceptionalCorners, AreThoseThatDoNotTurnAsTheShapeDoes) {
  const Fan f = fan({0, 1, 2, 3, 4});
  Straightened s;
  s.domain = f.state.domain;
  s.corner.assign(f.mesh.vertex_count(), 0);
  for (const int v : {0, 4, 5, 6}) s.corner[v] = 1;
  const auto found = [&] {
    const std::vector<char> marked = exceptional_corners(f.mesh, f.joints, s);
    std::set<int> out;
    for (std::size_t v = 0; v < marked.size(); ++v)
      if (marked[v]) out.insert(static_cast<int>(v));
    return out;
  };
  EXPECT_EQ(found(), std::set<int>{});
  s.corner[2] = 1;  // smooth in the shape
  EXPECT_EQ(found(), std::set<int>{2});
  s.domain.row(5) << 2, 1.5;  // between its neighbours (4, 0) and (0, 3): flat
  EXPECT_EQ(found(), (std::set<int>{2, 5}));
  s.domain.row(5) << 1.9, 1.4;  // reflex
  EXPECT_EQ(found(), (std::set<int>{2, 5}));
  s.domain.row(5) << 2.1, 1.6;  // convex again
  EXPECT_EQ(found(), std::set<int>{2});
}

// A line across the rectangle: where it meets the boundary C1 is given up, whatever the domain. An
// open line is straightened between its ends.
TEST(ExceptionalCorners, AreBranchPointsAndFeaturesAreStraightened) {
  Fan f = fan({0, 1, 2, 3, 4});
  f.mesh.features.push_back({{{2, f.w, 20, 0, 1}, {f.w, 5, 20, 1, 2}}, false});
  f.mesh.control[f.w] = f.mesh.domain[f.w];
  f.joints = find_joints(f.mesh, 8);
  ASSERT_EQ(f.joints.size(), 2u);
  ASSERT_EQ(f.joints[1].size(), 3u);
  EXPECT_EQ(f.joints[1][1].kind, JointKind::inside);
  const Straightened s =
      straighten(f.mesh, f.joints, f.state, {kFar, Straightening::orthogonal, false});
  EXPECT_TRUE(s.corner[2]);
  EXPECT_TRUE(s.corner[5]);
  EXPECT_FALSE(s.corner[f.w]);
  const Point a = row(s.domain, 2), b = row(s.domain, 5), c = row(s.domain, f.w);
  EXPECT_LT(std::abs(cross(b - a, c - a)), 1e-14);
  EXPECT_GT(std::abs(cross(Point(4, 3) - Point(2, 0), f.mesh.domain[f.w] - Point(2, 0))), 1);
  const std::vector<char> exceptional = exceptional_corners(f.mesh, f.joints, s);
  EXPECT_EQ(exceptional[2], 1);
  EXPECT_EQ(exceptional[5], 1);
  EXPECT_EQ(std::count(exceptional.begin(), exceptional.end(), 1), 2);
}

}  // namespace
}  // namespace c1mesh
