// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/split.h"

#include <gtest/gtest.h>

#include <random>

#include "bernstein/curve.h"
#include "mesh/shapes.h"
#include "mesh/topology.h"

namespace c1mesh {
namespace {

using namespace test;

CurvedMesh sample(int degree, unsigned seed = 2) {
  MeshReport report;
  return initial_mesh(input_of({blob(6, 0.3, seed), backwards(circle({0.5, 0.5}, 0.1))}, degree),
                      {}, report);
}

void expect_same_map(const CurvedMesh& before, const CurvedMesh& after) {
  EXPECT_EQ(check_mesh(after), std::vector<std::string>());
  std::mt19937 random(17);
  std::uniform_real_distribution<double> unit(0.05, 1);
  for (int t = 0; t < before.triangle_count(); ++t) {
    Barycentric w(unit(random), unit(random), unit(random));
    w /= w.sum();
    Point p = Point::Zero();
    for (int k = 0; k < 3; ++k) p += w[k] * before.domain[before.triangles[t][k]];
    EXPECT_LT((map_at(before, p) - map_at(after, p)).norm(), 1e-13);
  }
}

class Split : public testing::TestWithParam<int> {};

TEST_P(Split, EveryInteriorEdgeKeepsTheMap) {
  const CurvedMesh before = sample(GetParam());
  CurvedMesh after = before;
  const MeshTopology topology(before);
  int splits = 0;
  for (std::size_t e = 0; e < topology.edges.size(); e += 5) {
    const MeshEdge& edge = topology.edges[e];
    if (edge.triangle[1] < 0) continue;
    const double t = 0.25 + 0.05 * (splits % 10);
    const Point expected = (1 - t) * before.domain[edge.a] + t * before.domain[edge.b];
    const int v = split_edge(after, edge.a, edge.b, t);
    EXPECT_EQ(v, before.vertex_count() + splits);
    EXPECT_EQ(after.domain[v], expected);
    ++splits;
  }
  EXPECT_EQ(after.triangle_count(), before.triangle_count() + 2 * splits);
  expect_same_map(before, after);
}

TEST_P(Split, BoundaryEdgesAreHalvedAtExactParameters) {
  const CurvedMesh before = sample(GetParam());
  CurvedMesh after = before;
  for (int loop : {0, 1}) {
    const BoundaryEdge whole = after.loops[loop][2];
    const int v = split_boundary_edge(after, loop, 2);
    const BoundaryEdge first = after.loops[loop][2], second = after.loops[loop][3];
    EXPECT_EQ(first.a, whole.a);
    EXPECT_EQ(first.b, v);
    EXPECT_EQ(second.a, v);
    EXPECT_EQ(second.b, whole.b);
    EXPECT_EQ(first.t0, whole.t0);
    EXPECT_EQ(second.t1, whole.t1);
    EXPECT_EQ(first.t1, second.t0);
    EXPECT_EQ(first.t1 - first.t0, second.t1 - second.t0);
  }
  expect_same_map(before, after);
}

TEST_P(Split, CloughTocherKeepsTheMap) {
  const CurvedMesh before = sample(GetParam());
  CurvedMesh after = before;
  for (int t = 0; t < before.triangle_count(); t += 3) {
    const int v = clough_tocher_split(after, t);
    const auto& c = before.triangles[t];
    EXPECT_LT(
        (after.domain[v] - (before.domain[c[0]] + before.domain[c[1]] + before.domain[c[2]]) / 3)
            .norm(),
        1e-15);
  }
  expect_same_map(before, after);
}

TEST_P(Split, UniformRefinementKeepsTheMap) {
  const CurvedMesh before = sample(GetParam());
  CurvedMesh after = before;
  refine_uniform(after);
  EXPECT_EQ(after.triangle_count(), 4 * before.triangle_count());
  for (std::size_t k = 0; k < before.loops.size(); ++k)
    EXPECT_EQ(after.loops[k].size(), 2 * before.loops[k].size());
  for (int t = 0; t < before.triangle_count(); ++t) {
    EXPECT_EQ(after.triangles[4 * t][0], before.triangles[t][0]);
    EXPECT_EQ(after.warped[4 * t + 3], before.warped[t]);
  }
  expect_same_map(before, after);
}

INSTANTIATE_TEST_SUITE_P(Degrees, Split, testing::Values(3, 4, 5));

TEST(SplitPaths, HalvingAllIsHalvingOneAfterTheOther) {
  CurvedMesh one = sample(3), all = one;
  const int last = static_cast<int>(one.loops[0].size()) - 1;
  const std::vector<int> indices = {last, last - 1, 3, 0};
  for (const int index : indices) split_boundary_edge(one, 0, index);
  MeshSplitter(all).halve_all(all.loops[0], indices, false);
  EXPECT_EQ(one.triangles, all.triangles);
  EXPECT_EQ(one.nets, all.nets);
  EXPECT_EQ(one.control, all.control);
  ASSERT_EQ(one.loops[0].size(), all.loops[0].size());
  for (std::size_t k = 0; k < one.loops[0].size(); ++k) {
    const BoundaryEdge &a = one.loops[0][k], &b = all.loops[0][k];
    EXPECT_TRUE(a.a == b.a && a.b == b.b && a.curve == b.curve && a.t0 == b.t0 && a.t1 == b.t1);
  }
}

TEST(SplitArguments, EdgesThatDoNotExistAreRefused) {
  CurvedMesh mesh = sample(3);
  const CurvedMesh before = mesh;
  const BoundaryEdge boundary = mesh.loops[0][0];
  EXPECT_THROW(split_edge(mesh, boundary.a, boundary.b), std::invalid_argument);
  EXPECT_THROW(split_edge(mesh, -1, 0), std::invalid_argument);
  EXPECT_THROW(clough_tocher_split(mesh, mesh.triangle_count()), std::invalid_argument);
  EXPECT_EQ(mesh.control, before.control);
  EXPECT_EQ(mesh.nets, before.nets);
}

// The blossom's diagonal is the map, and restriction to a triangle evaluates like the whole.
TEST(NetBlossom, RestrictionIsComposition) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int n : {1, 2, 3, 4, 5}) {
    Net net;
    for (int k = 0; k < (n + 1) * (n + 2) / 2; ++k) net.emplace_back(unit(random), unit(random));
    const Barycentric a(0.7, 0.2, 0.1), b(0.1, 0.8, 0.1), c(0.3, 0.1, 0.6), w(0.2, 0.3, 0.5);
    const Net part = restrict_net(net, n, a, b, c);
    const Barycentric whole = w[0] * a + w[1] * b + w[2] * c;
    EXPECT_LT((evaluate(part, n, w) - evaluate(net, n, whole)).norm(), 1e-14);
    const auto line = restrict_net_to_line(net, n, a, b);
    EXPECT_LT((evaluate(BezierCurve{line}, 0.3) - evaluate(net, n, 0.7 * a + 0.3 * b)).norm(),
              1e-14);
  }
}

}  // namespace
}  // namespace c1mesh
