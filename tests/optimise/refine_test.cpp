// SPDX-License-Identifier: GPL-3.0-or-later
// Refinement of an exactly C1 map: g falls, all that made the map exact holds on the finer mesh.
#include "optimise/refine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "bernstein/curve.h"
#include "mesh/bisect.h"
#include "mesh/topology.h"
#include "optimise/exact_map.h"

namespace c1mesh {
namespace {

using testing_tools::exact_map;
using testing_tools::ExactMap;
using testing_tools::ExactState;

struct Shape {
  const char* name;
  std::vector<std::vector<BezierCurve>> loops;
  bool gains = true;  // does the refinement find something better?
};

void PrintTo(const Shape& shape, std::ostream* out) {
  *out << shape.name;
}

// Four corners of a square, sides bent in and out: no exceptional vertex is needed.
std::vector<BezierCurve> pillow() {
  const Point p[4] = {{0.2, 0.2}, {0.8, 0.2}, {0.8, 0.8}, {0.2, 0.8}};
  std::vector<BezierCurve> out;
  for (int k = 0; k < 4; ++k) {
    const Point along = p[(k + 1) % 4] - p[k], in(-along.y(), along.x());
    const double bend = k % 2 ? 0.3 : -0.3;
    out.push_back({{p[k], p[k] + along / 3 + bend * in, p[(k + 1) % 4] - along / 3 + bend * in,
                    p[(k + 1) % 4]}});
  }
  return out;
}

std::vector<Shape> shapes() {
  return {{"blob", {test::blob(8, 0.5, 5)}},
          {"ring", {test::blob(6, 0.3, 2), test::backwards(test::circle({0.5, 0.5}, 0.1))}},
          {"lens", {test::lens(60)}},
          {"drop", {test::drop()}, false},
          {"pillow", {pillow()}}};
}

void refine(const RefineOptions& options, ExactMap& map) {
  refine_where_distorted(options, {}, map.mesh, map.joints, map.attempt, {});
}

// The map as a mesh of its own: shape over the map's domain.
CurvedMesh as_mesh(const ExactMap& map) {
  CurvedMesh out = map.mesh;
  for (int v = 0; v < out.vertex_count(); ++v)
    out.domain[v] = map.attempt.domain.points.row(v).transpose();
  out.control = map.attempt.control;
  return out;
}

// Exactly C1, regular, sound, joints and roles those of the mesh, g as claimed.
void expect_exact(const ExactMap& map) {
  const CurvedMesh mesh = as_mesh(map);
  EXPECT_EQ(check_mesh(mesh), std::vector<std::string>());
  const ExactState exact(map);
  EXPECT_LT(exact.residue(), kExact);
  // The layout gives the domain back, so chains are as straight as they were.
  EXPECT_LT(
      (exact.domain.topRows(mesh.vertex_count()) - map.attempt.domain.points).cwiseAbs().maxCoeff(),
      1e-14);
  EXPECT_LT(largest_residue(asked_edges(map.mesh, map.joints, map.attempt.roles),
                            map.attempt.domain.points, map.attempt.control),
            kExact);
  double g = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) g = std::max(g, triangle_bound(mesh, t));
  EXPECT_NEAR(g, map.attempt.g, 1e-12 * g);
}

// Every edge of every loop: the curve's own control points, curves followed without gap.
void expect_boundary(const ExactMap& map, const ExactMap& coarse) {
  const auto control = boundary_control(map.mesh);
  for (std::size_t l = 0; l < map.mesh.loops.size(); ++l) {
    const auto& edges = map.mesh.loops[l];
    double covered = 0, wanted = 0;
    for (const BoundaryEdge& e : coarse.mesh.loops[l]) wanted += std::abs(e.t1 - e.t0);
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const BoundaryEdge& e = edges[k];
      const BoundaryEdge& next = edges[(k + 1) % edges.size()];
      EXPECT_EQ(e.b, next.a);
      if (e.curve == next.curve && edges.size() > 1 && e.t1 != 1) {
        EXPECT_EQ(e.t1, next.t0);
      }
      covered += std::abs(e.t1 - e.t0);
      const BezierCurve exact =
          restrict_exactly(map.curves.at(e.curve), e.t0, e.t1, map.mesh.degree);
      for (int i = 0; i <= map.mesh.degree; ++i)
        EXPECT_LT((map.attempt.control[control[l][k][i]] - exact.poles[i]).norm(), 1e-15);
    }
    EXPECT_EQ(covered, wanted);  // dyadic: exact
  }
}

class Refine : public testing::TestWithParam<Shape> {};

TEST_P(Refine, NeverRaisesTheDistortionAndStaysExact) {
  const ExactMap coarse = exact_map(GetParam().loops);
  ASSERT_TRUE(coarse.attempt.success);
  int finer = 0;
  for (const double growth : {1.5, 3.0}) {
    ExactMap map = coarse;
    refine({0, growth, 12}, map);
    EXPECT_LE(map.mesh.triangle_count(), growth * coarse.mesh.triangle_count());
    EXPECT_LE(map.attempt.g, coarse.attempt.g);
    if (map.mesh.triangle_count() > coarse.mesh.triangle_count()) {
      ++finer;
      EXPECT_LT(map.attempt.g, 0.98 * coarse.attempt.g);
    }
    expect_exact(map);
    expect_boundary(map, coarse);
    EXPECT_EQ(count_exceptional(map.attempt.roles), count_exceptional(coarse.attempt.roles));
  }
  EXPECT_EQ(finer > 0, GetParam().gains);
}

// Where g is at the target already, or no triangle may be added, all is left to the last bit.
TEST_P(Refine, LeavesAloneWhatNeedsNothing) {
  const ExactMap coarse = exact_map(GetParam().loops);
  ASSERT_TRUE(coarse.attempt.success);
  for (const RefineOptions& options :
       {RefineOptions{coarse.attempt.g, 4, 12}, RefineOptions{0, 1, 12}, RefineOptions{0, 4, 0}}) {
    ExactMap map = coarse;
    refine(options, map);
    EXPECT_EQ(map.mesh.triangles, coarse.mesh.triangles);
    EXPECT_EQ(map.attempt.control, coarse.attempt.control);
    EXPECT_EQ(map.attempt.domain.points, coarse.attempt.domain.points);
    EXPECT_EQ(map.attempt.g, coarse.attempt.g);
  }
}

class RefineTarget : public Refine {};

// It stops at the target: a looser one needs no more triangles.
TEST_P(RefineTarget, StopsThere) {
  const ExactMap coarse = exact_map(GetParam().loops);
  ASSERT_TRUE(coarse.attempt.success);
  ExactMap loose = coarse, tight = coarse;
  const double target = 0.9 * coarse.attempt.g;
  refine({target, 4, 12}, loose);
  EXPECT_LE(loose.attempt.g, target);
  refine({0, 4, 12}, tight);
  EXPECT_LE(loose.mesh.triangle_count(), tight.mesh.triangle_count());
  expect_exact(loose);
}

std::vector<Shape> shapes_that_gain() {
  std::vector<Shape> out = shapes();
  std::erase_if(out, [](const Shape& shape) { return !shape.gains; });
  return out;
}

const auto name_of = [](const auto& test) { return std::string(test.param.name); };
INSTANTIATE_TEST_SUITE_P(Shapes, Refine, testing::ValuesIn(shapes()), name_of);
INSTANTIATE_TEST_SUITE_P(Shapes, RefineTarget, testing::ValuesIn(shapes_that_gain()), name_of);

// The bounds n_i, d_k of a polynomial of degree > 1 come closer to it where the triangle is cut:
// without any move of the map g falls.
TEST(RefineBounds, BisectionAloneMakesThemSharper) {
  const ExactMap coarse = exact_map({pillow()});
  ASSERT_TRUE(coarse.attempt.success);
  ASSERT_EQ(count_exceptional(coarse.attempt.roles), 0);
  ExactMap map = coarse;
  ExactOptions still;
  still.final_exponent = 1;  // no norm is tried
  refine_where_distorted({0, 3, 12}, still, map.mesh, map.joints, map.attempt, {});
  EXPECT_LT(map.attempt.g, coarse.attempt.g);
  EXPECT_GT(map.mesh.vertex_count(), coarse.mesh.vertex_count());
  // Old vertices: moved by the projection's roundings alone.
  for (int v = 0; v < coarse.mesh.vertex_count(); ++v)
    EXPECT_LT((map.attempt.control[v] - coarse.attempt.control[v]).norm(), 1e-12);
}

// Does an edge lie on one of these, end points given?
bool lies_on(const std::vector<std::array<Point, 2>>& lines, const Point& a, const Point& b) {
  return std::any_of(lines.begin(), lines.end(), [&](const auto& line) {
    const Point whole = line[1] - line[0];
    return std::max(std::abs(cross(whole, a - line[0])), std::abs(cross(whole, b - line[0]))) <
               1e-12 * whole.squaredNorm() &&
           std::abs((a + b - line[0] - line[1]).dot(whole)) < whole.squaredNorm();
  });
}

// Across the edges that bisection makes the map is exactly C1, as it was across the old ones. Only
// where a relaxed edge is halved something new is asked: its far half ends in no exceptional
// vertex.
TEST(RefineBounds, BisectionAsksNothingNewButOfHalvesOfRelaxedEdges) {
  const ExactMap coarse = exact_map({test::blob(8, 0.5, 5)});
  ASSERT_TRUE(coarse.attempt.success);
  CurvedMesh mesh = as_mesh(coarse);
  std::vector<char> exceptional(mesh.vertex_count(), 0);
  for (const Joint& joint : coarse.joints[0])
    if (gives_up_c1(coarse.attempt.roles[0][joint.position])) exceptional[joint.vertex] = 1;
  std::vector<std::array<Point, 2>> relaxed;
  for (const MeshEdge& e : MeshTopology(mesh).edges)
    if (e.triangle[1] >= 0 && (exceptional[e.a] || exceptional[e.b]))
      relaxed.push_back({mesh.domain[e.a], mesh.domain[e.b]});
  ASSERT_FALSE(relaxed.empty());
  std::vector<int> all(mesh.triangle_count());
  std::iota(all.begin(), all.end(), 0);
  bisect_triangles(mesh, all, std::vector<char>(mesh.vertex_count(), 0));
  const Joints joints = find_joints_again(mesh, coarse.joints);
  const Roles roles = roles_on(coarse.joints, coarse.attempt.roles, joints);
  PointMatrix domain(mesh.vertex_count(), 2);
  for (int v = 0; v < mesh.vertex_count(); ++v) domain.row(v) = mesh.domain[v].transpose();
  int kept = 0, halves = 0;
  double broken = 0;
  for (const C1Edge& e : asked_edges(mesh, joints, roles)) {
    const double residue = largest_residue({e}, domain, mesh.control);
    if (lies_on(relaxed, mesh.domain[e.vertex[0]], mesh.domain[e.vertex[1]])) {
      ++halves;
      broken = std::max(broken, residue);
    } else {
      ++kept;
      EXPECT_LT(residue, kExact);
    }
  }
  EXPECT_GT(kept, static_cast<int>(all.size()));
  EXPECT_GT(halves, 0);
  EXPECT_GT(broken, 1e-6);
}

}  // namespace
}  // namespace c1mesh
