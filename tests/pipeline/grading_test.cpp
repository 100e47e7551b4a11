// SPDX-License-Identifier: GPL-3.0-or-later
// Grading towards corners: all edges at a corner are halved, corner after corner, level after
// level.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "domain/joints.h"
#include "domain/layout.h"
#include "mesh/split.h"
#include "mesh/topology.h"
#include "pipeline/demotion.h"
#include "pipeline/example_mesh.h"

namespace c1mesh {
namespace {

// The same in so many words: one split after the other, each edge looked up in the whole mesh.
void grade_plainly(CurvedMesh& mesh, const std::vector<int>& corners, int levels) {
  for (; levels > 0; --levels)
    for (const int corner : corners) {
      for (std::size_t f = 0; f < mesh.features.size(); ++f)
        for (int k = static_cast<int>(mesh.features[f].edges.size()) - 1; k >= 0; --k)
          if (mesh.features[f].edges[k].a == corner || mesh.features[f].edges[k].b == corner)
            split_feature_edge(mesh, static_cast<int>(f), k);
      for (std::size_t l = 0; l < mesh.loops.size(); ++l)
        for (int k = static_cast<int>(mesh.loops[l].size()) - 1; k >= 0; --k)
          if (mesh.loops[l][k].a == corner || mesh.loops[l][k].b == corner)
            split_boundary_edge(mesh, static_cast<int>(l), k);
      const MeshTopology topology(mesh);
      const std::vector<char> feature = feature_flags(mesh, topology);
      std::vector<int> ends;
      for (std::size_t i = 0; i < topology.edges.size(); ++i) {
        const MeshEdge& e = topology.edges[i];
        if (e.triangle[1] >= 0 && !feature[i] && (e.a == corner || e.b == corner))
          ends.push_back(e.a == corner ? e.b : e.a);
      }
      for (const int end : ends) split_edge(mesh, corner, end);
    }
}

class Grading : public testing::TestWithParam<const char*> {};

TEST_P(Grading, IsWhatSplittingOneByOneGives) {
  CurvedMesh mesh = testing_pipeline::example_mesh(GetParam());
  const Joints joints = find_joints(mesh, 8);
  const Roles roles = natural_roles(joints);
  std::vector<int> corners;
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k)
      if (joints[l][k].kind == JointKind::corner && roles[l][k] == Role::anchor)
        corners.push_back(joints[l][k].vertex);
  ASSERT_FALSE(corners.empty());
  CurvedMesh expected = mesh;
  grade_plainly(expected, corners, 2);
  grade_corners(mesh, joints, roles, 2);
  EXPECT_EQ(check_mesh(mesh), std::vector<std::string>());
  EXPECT_EQ(mesh.triangles, expected.triangles);
  EXPECT_EQ(mesh.nets, expected.nets);
  EXPECT_EQ(mesh.control, expected.control);
  EXPECT_EQ(mesh.domain, expected.domain);
  for (std::size_t l = 0; l < mesh.loops.size(); ++l) {
    ASSERT_EQ(mesh.loops[l].size(), expected.loops[l].size());
    for (std::size_t k = 0; k < mesh.loops[l].size(); ++k) {
      EXPECT_EQ(mesh.loops[l][k].a, expected.loops[l][k].a);
      EXPECT_EQ(mesh.loops[l][k].t1, expected.loops[l][k].t1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Examples, Grading,
                         testing::Values("letter.svg", "interfaces.json", "puzzle.svg"));

}  // namespace
}  // namespace c1mesh
