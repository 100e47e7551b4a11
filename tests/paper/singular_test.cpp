// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/singular.h"

#include <gtest/gtest.h>

namespace c1mesh {
namespace {

// Four triangles around vertex 0, whose neighbours are the ends of a cross.
CurvedMesh cross_mesh() {
  CurvedMesh mesh;
  mesh.degree = 1;
  mesh.domain = {{0, 0}, {1, 0.5}, {-0.5, 1}, {-2, -1}, {0.25, -0.5}};
  mesh.triangles = {{0, 1, 2}, {3, 0, 2}, {3, 4, 0}, {1, 0, 4}};
  mesh.control = mesh.domain;
  for (const auto& t : mesh.triangles) mesh.nets.insert(mesh.nets.end(), t.begin(), t.end());
  return mesh;
}

PointMatrix points_of(const CurvedMesh& mesh, const Point& centre) {
  PointMatrix domain(5, 2);
  for (int v = 0; v < 5; ++v) domain.row(v) = mesh.domain[v].transpose();
  domain.row(0) = centre.transpose();
  return domain;
}

TEST(MakeSingular, PutsANearlySingularVertexOntoTheCrossing) {
  const CurvedMesh mesh = cross_mesh();
  const MeshTopology topology(mesh);
  const Point off(3e-7, -2e-7);  // the shortest edge is sqrt(5)/4 long: 6.5e-7 of it
  for (const auto& [tolerance, moved] : {std::pair(1e-6, 1), std::pair(5e-7, 0)}) {
    PointMatrix domain = points_of(mesh, off);
    EXPECT_EQ(make_singular(mesh, topology, std::vector<char>(5, 1), tolerance, domain), moved);
    EXPECT_LE((domain.row(0).transpose() - (moved ? Point(0, 0) : off)).norm(), 1e-16);
    for (int v = 1; v < 5; ++v)
      EXPECT_EQ(Point(domain.row(v).transpose()), mesh.domain[v]);  // valence two
  }
}

TEST(MakeSingular, LeavesWhatMayNotMove) {
  const CurvedMesh mesh = cross_mesh();
  PointMatrix domain = points_of(mesh, {1e-8, 0});
  EXPECT_EQ(make_singular(mesh, MeshTopology(mesh), {0, 1, 1, 1, 1}, 1e-6, domain), 0);
  EXPECT_EQ(Point(domain.row(0).transpose()), Point(1e-8, 0));
}

// A triangle more: five edges, no two lines.
TEST(MakeSingular, LeavesVerticesOfAnotherValence) {
  CurvedMesh mesh = cross_mesh();
  mesh.domain.push_back({1, -1});
  mesh.control = mesh.domain;
  mesh.triangles.back() = {5, 0, 4};
  mesh.triangles.push_back({5, 1, 0});
  PointMatrix domain(6, 2);
  for (int v = 0; v < 6; ++v) domain.row(v) = mesh.domain[v].transpose();
  domain(0, 0) = 1e-8;
  EXPECT_EQ(make_singular(mesh, MeshTopology(mesh), std::vector<char>(6, 1), 1e-6, domain), 0);
}

}  // namespace
}  // namespace c1mesh
