// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/topology.h"

#include <gtest/gtest.h>

#include "mesh/shapes.h"

namespace c1mesh {
namespace {

using namespace test;

CurvedMesh sample() {
  MeshReport report;
  return initial_mesh(input_of({blob(6, 0.3, 2), backwards(circle({0.5, 0.5}, 0.1))}), {}, report);
}

TEST(Topology, EdgesAndTrianglesNameEachOther) {
  const CurvedMesh mesh = sample();
  const MeshTopology topology(mesh);
  std::size_t sides = 0;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const MeshEdge& edge = topology.edges[e];
    for (int side : {0, 1}) {
      const int t = edge.triangle[side], k = edge.corner[side];
      if (t < 0) continue;
      ++sides;
      EXPECT_EQ(topology.triangle_edges[t][k], static_cast<int>(e));
      EXPECT_EQ(mesh.triangles[t][(k + 1) % 3], side == 0 ? edge.a : edge.b);
      EXPECT_EQ(mesh.triangles[t][(k + 2) % 3], side == 0 ? edge.b : edge.a);
    }
  }
  EXPECT_EQ(sides, 3 * mesh.triangles.size());
}

TEST(Topology, VertexTrianglesAreAllThatUseIt) {
  const CurvedMesh mesh = sample();
  const MeshTopology topology(mesh);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    std::vector<int> expected;
    for (int t = 0; t < mesh.triangle_count(); ++t)
      for (int w : mesh.triangles[t])
        if (w == v) expected.push_back(t);
    EXPECT_EQ(topology.vertex_triangles[v], expected);
  }
}

TEST(Topology, BoundaryVerticesAreThoseOfTheLoops) {
  const CurvedMesh mesh = sample();
  const MeshTopology topology(mesh);
  std::vector<char> expected(mesh.domain.size(), 0);
  for (const auto& loop : mesh.loops)
    for (const BoundaryEdge& e : loop) expected[e.a] = 1;
  EXPECT_EQ(topology.on_boundary, expected);
}

// The checker must find every kind of damage.
TEST(CheckMesh, FindsDamage) {
  const CurvedMesh sound = sample();
  ASSERT_EQ(check_mesh(sound), std::vector<std::string>());
  const auto damaged = [&](auto&& damage) {
    CurvedMesh mesh = sound;
    damage(mesh);
    return !check_mesh(mesh).empty();
  };
  EXPECT_TRUE(damaged([](CurvedMesh& m) { std::swap(m.triangles[0][0], m.triangles[0][1]); }));
  EXPECT_TRUE(damaged([](CurvedMesh& m) { m.triangles[3][1] = 1000000; }));
  EXPECT_TRUE(damaged([](CurvedMesh& m) { m.nets[5] = -1; }));
  EXPECT_TRUE(damaged([](CurvedMesh& m) { m.nets.pop_back(); }));
  EXPECT_TRUE(damaged([](CurvedMesh& m) { m.warped.push_back(0); }));
  EXPECT_TRUE(damaged([](CurvedMesh& m) { m.control[m.control_id(0, 1, 1)] += Point(9, 9); }));
  EXPECT_TRUE(damaged([](CurvedMesh& m) { m.loops[0].pop_back(); }));
  EXPECT_TRUE(damaged([](CurvedMesh& m) { std::swap(m.loops[0][0], m.loops[0][1]); }));
  EXPECT_TRUE(damaged([](CurvedMesh& m) { m.loops.pop_back(); }));
  EXPECT_TRUE(damaged([](CurvedMesh& m) { m.loops[0][0].t1 = m.loops[0][0].t0; }));
  EXPECT_TRUE(damaged([](CurvedMesh& m) {
    m.triangles.pop_back();
    m.warped.pop_back();
    m.nets.resize(m.nets.size() - m.net_size());
  }));
  // An edge whose two triangles hold different control points is a crack.
  EXPECT_TRUE(damaged([](CurvedMesh& m) {
    const MeshTopology topology(m);
    for (const MeshEdge& e : topology.edges) {
      if (e.triangle[1] < 0) continue;
      const int id = edge_controls(m, e.triangle[0], e.corner[0])[1];
      for (int k = 0; k < m.net_size(); ++k) {
        int& held = m.nets[e.triangle[0] * m.net_size() + k];
        if (held == id) held = static_cast<int>(m.control.size());
      }
      m.control.push_back(m.control[id]);
      return;
    }
  }));
}

}  // namespace
}  // namespace c1mesh
