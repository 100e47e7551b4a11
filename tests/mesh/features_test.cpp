// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes with feature curves: covered from both sides, conforming, kept by every refinement.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "bernstein/curve.h"
#include "mesh/guard.h"
#include "mesh/initial_mesh.h"
#include "mesh/shapes.h"
#include "mesh/split.h"
#include "mesh/topology.h"
#include "mesh/walks.h"

namespace c1mesh {
namespace {

using namespace test;

MeshInput with(MeshInput input, const std::vector<std::vector<BezierCurve>>& paths,
               const std::vector<bool>& closed) {
  for (std::size_t k = 0; k < paths.size(); ++k)
    input.features.push_back(
        {loop_of(paths[k], input.degree, 100 + 10 * static_cast<int>(k)), closed[k]});
  return input;
}

// A disc around (0.5, 0.5) whose joints lie on the axes.
MeshInput disc() {
  return input_of({circle({0.5, 0.5}, 0.4)});
}

const Point kEast(0.9, 0.5), kWest(0.1, 0.5);

struct Named {
  const char* name;
  MeshInput input;
};

void PrintTo(const Named& named, std::ostream* out) {
  *out << named.name;
}

std::vector<Named> inputs() {
  MeshInput d = disc();
  const Point east = d.loops[0][0].bezier.start(), west = d.loops[0][2].bezier.start();
  const Point m(0.5, 0.5);
  std::vector<Named> out;
  out.push_back({"chord", with(d, {{{{east, west}}}}, {false})});
  out.push_back({"bent chord", with(d, {{{{east, {0.7, 0.8}, {0.3, 0.1}, west}}}}, {false})});
  out.push_back({"two chords with the same ends",
                 with(d, {{{{east, {0.6, 0.7}, {0.4, 0.7}, west}}}, {{{east, {0.5, 0.3}, west}}}},
                      {false, false})});
  out.push_back({"dangling", with(d, {{{{east, {0.8, 0.6}, {0.6, 0.3}, m}}}}, {false})});
  out.push_back({"free", with(d, {{{{{0.7, 0.5}, {0.6, 0.7}, {0.4, 0.3}, {0.3, 0.5}}}}}, {false})});
  out.push_back({"free line", with(d, {{{{{0.7, 0.5}, {0.4, 0.6}}}}}, {false})});
  out.push_back({"loop", with(d, {circle({0.52, 0.48}, 0.2)}, {true})});
  out.push_back(
      {"drop from the rim", with(d, {{{{east, {0.3, 0.9}, {0.3, 0.1}, east}}}}, {false})});
  out.push_back({"branch", with(d,
                                {{{{m, {0.6, 0.6}, {0.7, 0.4}, east}}},
                                 {{{m, {0.4, 0.6}, {0.45, 0.7}}}},
                                 {{{m, {0.4, 0.3}, {0.3, 0.3}}}}},
                                {false, false, false})});
  MeshInput ring = input_of({circle({0.5, 0.5}, 0.4), backwards(circle({0.5, 0.5}, 0.15))});
  const Point inner(0.65, 0.5);
  Point nearest = ring.loops[1][0].bezier.start();
  for (const LoopCurve& c : ring.loops[1])
    if ((c.bezier.start() - inner).norm() < (nearest - inner).norm()) nearest = c.bezier.start();
  out.push_back({"from hole to rim", with(ring, {{{{nearest, {0.75, 0.6}, east}}}}, {false})});
  return out;
}

class Features : public testing::TestWithParam<Named> {};

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

// The control points that the triangles on both sides have along a directed edge.
std::vector<std::vector<Point>> rows(const CurvedMesh& mesh, int a, int b) {
  std::vector<std::vector<Point>> out;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int u = mesh.triangles[t][(k + 1) % 3], v = mesh.triangles[t][(k + 2) % 3];
      if (std::minmax(u, v) != std::minmax(a, b)) continue;
      std::vector<Point> row;
      for (const int id : edge_controls(mesh, t, k)) row.push_back(mesh.control[id]);
      if (u == b) std::reverse(row.begin(), row.end());
      out.push_back(row);
    }
  return out;
}

// Edges of each feature path cover its curves in order, from both sides, as exact restrictions (up
// to `tolerance`).
void expect_covered(const MeshInput& input, const CurvedMesh& mesh, double tolerance) {
  ASSERT_EQ(mesh.features.size(), input.features.size());
  for (std::size_t f = 0; f < mesh.features.size(); ++f) {
    EXPECT_EQ(mesh.features[f].closed, input.features[f].closed);
    std::size_t source = 0;
    double reached = 0;
    for (const BoundaryEdge& e : mesh.features[f].edges) {
      const LoopCurve& c = input.features[f].curves.at(source);
      EXPECT_EQ(e.curve, c.curve);
      EXPECT_EQ(e.t0, reached);
      EXPECT_LT(e.t0, e.t1);
      reached = e.t1;
      if (reached == 1) ++source, reached = 0;
      const auto held = rows(mesh, e.a, e.b);
      EXPECT_EQ(held.size(), 2u) << "a feature edge needs a triangle on each side";
      const BezierCurve exact = restrict_exactly(c.bezier, e.t0, e.t1, input.degree);
      for (const auto& row : held)
        for (std::size_t i = 0; i < row.size(); ++i)
          EXPECT_LE((row[i] - exact.poles[i]).norm(), tolerance);
    }
    EXPECT_EQ(source, input.features[f].curves.size());
  }
}

// No other edge joins two vertices on curves; no triangle has curves on all sides.
void expect_guarded(const CurvedMesh& mesh) {
  const MeshTopology topology(mesh);
  const auto feature = feature_flags(mesh, topology);
  const auto on_curve = on_curves(mesh);
  std::size_t feature_edges = 0, expected = 0;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const MeshEdge& edge = topology.edges[e];
    feature_edges += feature[e] != 0;
    EXPECT_FALSE(edge.triangle[1] >= 0 && !feature[e] && on_curve[edge.a] && on_curve[edge.b]);
  }
  for (const FeatureLine& line : mesh.features) expected += line.edges.size();
  EXPECT_EQ(feature_edges, expected);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    int curves = 0;
    for (const int e : topology.triangle_edges[t])
      curves += feature[e] || topology.edges[e].triangle[1] < 0;
    EXPECT_LT(curves, 3);
  }
}

TEST_P(Features, AreCoveredFromBothSides) {
  const MeshInput& input = GetParam().input;
  MeshReport report;
  CurvedMesh mesh = initial_mesh(input, {10}, report);
  EXPECT_EQ(joined(check_mesh(mesh)), "");
  EXPECT_LE(report.mips_bound, 10);
  double area = 0;
  for (const auto& loop : input.loops)
    for (const LoopCurve& c : loop) area += green_area({c.bezier});
  EXPECT_NEAR(mesh_area(mesh), area, 1e-13);
  expect_covered(input, mesh, 0);
  expect_guarded(mesh);
}

TEST_P(Features, AreKeptByEveryRefinement) {
  const MeshInput& input = GetParam().input;
  MeshReport report;
  CurvedMesh mesh = initial_mesh(input, {10}, report);
  const std::size_t before = mesh.features[0].edges.size();
  split_feature_edge(mesh, 0, static_cast<int>(before) - 1);
  split_boundary_edge(mesh, 0, 0);
  EXPECT_EQ(mesh.features[0].edges.size(), before + 1);
  EXPECT_EQ(joined(check_mesh(mesh)), "");
  refine_uniform(mesh);
  EXPECT_EQ(mesh.features[0].edges.size(), 2 * before + 2);
  EXPECT_EQ(joined(check_mesh(mesh)), "");
  expect_covered(input, mesh, 1e-15);
  clough_tocher_split(mesh, 0);
  EXPECT_EQ(joined(check_mesh(mesh)), "");
}

INSTANTIATE_TEST_SUITE_P(Kinds, Features, testing::ValuesIn(inputs()), [](const auto& test) {
  std::string name = test.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

TEST(Walks, GoAlongBothSidesOfAFeature) {
  for (const Named& named : inputs()) {
    const auto walks = meshing::walks_of(named.input);
    std::map<std::pair<int, bool>, int> sides;
    for (const auto& walk : walks)
      for (std::size_t k = 0; k < walk.size(); ++k) {
        const auto &step = walk[k], &next = walk[(k + 1) % walk.size()];
        EXPECT_EQ(step.curve.bezier.end(), next.curve.bezier.start()) << named.name;
        EXPECT_EQ(step.end, next.start);
        ++sides[{step.curve.curve, step.forward}];
        if (!step.feature) continue;
        const auto& twin = walks.at(step.twin_walk).at(step.twin_index);
        EXPECT_EQ(twin.twin_walk, step.walk);
        EXPECT_EQ(reversed(twin.curve.bezier).poles, step.curve.bezier.poles);
      }
    for (const auto& [side, count] : sides) EXPECT_EQ(count, 1) << named.name;
  }
  // A chord divides the disc into two faces; a dangling curve does not.
  EXPECT_EQ(meshing::walks_of(inputs()[0].input).size(), 2u);
  EXPECT_EQ(meshing::walks_of(inputs()[3].input).size(), 1u);
}

}  // namespace
}  // namespace c1mesh
