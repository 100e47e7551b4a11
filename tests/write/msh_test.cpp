// SPDX-License-Identifier: GPL-3.0-or-later
// The MSH file read back as text: orders of nodes, entities, groups. Gmsh itself reads it in
// tests/formats.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

#include "c1mesh/error.h"
#include "c1mesh/write.h"
#include "result/example_results.h"

namespace c1mesh {
namespace {

/// A section's words, without its marks.
std::istringstream section(const std::string& text, const std::string& name) {
  const std::string open = "$" + name + "\n", close = "$End" + name + "\n";
  const std::size_t from = text.find(open), to = text.find(close);
  EXPECT_NE(from, std::string::npos) << name;
  EXPECT_NE(to, std::string::npos) << name;
  return std::istringstream(text.substr(from + open.size(), to - from - open.size()));
}

struct Block {
  int dimension, tag, type;
  std::vector<std::vector<int>> elements;
};

struct File {
  std::map<int, Point> nodes;
  std::map<int, std::array<int, 2>> entity_of;  // node -> dimension, tag
  std::vector<Block> blocks;
  std::map<int, Point> view;
};

int nodes_of(int type, int n) {
  return type == 15                                                        ? 1
         : type == 1 || type == 8 || type > 60 || (type > 25 && type < 29) ? n + 1
                                                                           : (n + 1) * (n + 2) / 2;
}

File read(const std::string& text, int n) {
  File file;
  std::istringstream nodes = section(text, "Nodes");
  std::size_t blocks, count, least, most;
  nodes >> blocks >> count >> least >> most;
  for (std::size_t b = 0; b < blocks; ++b) {
    int dimension, tag, parametric, size;
    nodes >> dimension >> tag >> parametric >> size;
    std::vector<int> tags(size);
    for (int& id : tags) nodes >> id;
    for (const int id : tags) {
      double x, y, z;
      nodes >> x >> y >> z;
      EXPECT_TRUE(file.nodes.emplace(id, Point(x, y)).second) << "node " << id << " twice";
      file.entity_of[id] = {dimension, tag};
    }
  }
  EXPECT_EQ(file.nodes.size(), count);
  EXPECT_EQ(file.nodes.begin()->first, static_cast<int>(least));
  EXPECT_EQ(file.nodes.rbegin()->first, static_cast<int>(most));
  std::istringstream elements = section(text, "Elements");
  elements >> blocks >> count >> least >> most;
  for (std::size_t b = 0, tag = 0; b < blocks; ++b) {
    Block block;
    int size;
    elements >> block.dimension >> block.tag >> block.type >> size;
    for (int e = 0; e < size; ++e) {
      std::size_t found;
      elements >> found;
      EXPECT_EQ(found, ++tag);
      std::vector<int> ids(nodes_of(block.type, n));
      for (int& id : ids) elements >> id;
      block.elements.push_back(ids);
    }
    file.blocks.push_back(block);
  }
  std::istringstream view = section(text, "NodeData");
  std::string word;
  int number = 0;
  view >> number >> word >> number >> number >> number >> number >> number >> number;
  EXPECT_EQ(word, "\"domain\"");
  for (int k = 0; k < number; ++k) {
    int id;
    double u, v, w;
    view >> id >> u >> v >> w;
    file.view[id] = Point(u, v);
  }
  EXPECT_FALSE(view.fail() || nodes.fail() || elements.fail());
  return file;
}

const std::vector<Point>& order(int n) {
  // Gmsh's reference manual, "Node ordering": the identity of (0, 0), (n, 0), (0, n).
  static const std::map<int, std::vector<Point>> orders = {
      {1, {{0, 0}, {1, 0}, {0, 1}}},
      {2, {{0, 0}, {2, 0}, {0, 2}, {1, 0}, {1, 1}, {0, 1}}},
      {3, {{0, 0}, {3, 0}, {0, 3}, {1, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}, {0, 1}, {1, 1}}},
      {4,
       {{0, 0},
        {4, 0},
        {0, 4},
        {1, 0},
        {2, 0},
        {3, 0},
        {3, 1},
        {2, 2},
        {1, 3},
        {0, 3},
        {0, 2},
        {0, 1},
        {1, 1},
        {2, 1},
        {1, 2}}}};
  return orders.at(n);
}

class MshOrder : public testing::TestWithParam<int> {};

TEST_P(MshOrder, FollowsGmsh) {
  const int n = GetParam();
  const double s = n;
  const Result result =
      example::polynomial_result(n, example::identity(), {{0, 0}, {s, 0}, {0, s}}, {{0, 1, 2}});
  const File file = read(format_msh(result), n);
  const std::map<int, std::array<int, 2>> types = {
      {1, {1, 2}}, {2, {8, 9}}, {3, {26, 21}}, {4, {27, 23}}};
  ASSERT_EQ(file.blocks.size(), 4u);  // three curves, one surface
  const Block& triangle = file.blocks.back();
  EXPECT_EQ(triangle.type, types.at(n)[1]);
  const std::vector<int>& ids = triangle.elements.front();
  for (std::size_t k = 0; k < ids.size(); ++k) EXPECT_EQ(file.nodes.at(ids[k]), order(n)[k]) << k;
  const Block& line = file.blocks.front();
  EXPECT_EQ(line.type, types.at(n)[0]);
  EXPECT_EQ(line.elements.front().size(), static_cast<std::size_t>(n + 1));
}

INSTANTIATE_TEST_SUITE_P(Degrees, MshOrder, testing::Values(1, 2, 3, 4));

// The nodes are points of the map at the domain's places, which the view holds.
TEST(Msh, NodesAreValuesOfTheMap) {
  const int n = 5;
  const auto map = example::cubic_map();
  const Result result = example::grid(2, n, map);
  const File file = read(format_msh(result), n);
  const File domain = read(format_msh(result, true), n);
  ASSERT_EQ(file.nodes.size(), result.control_points.size());
  for (const auto& [id, p] : file.nodes) {
    EXPECT_EQ(file.view.at(id), domain.nodes.at(id));
    EXPECT_LT((p - example::evaluate(map, domain.nodes.at(id))).norm(), 4e-16);
  }
  EXPECT_EQ(file.entity_of, domain.entity_of);
  EXPECT_EQ(domain.view, file.view);
}

// Curve K has tag K + 1; its elements run along it, whatever the boundary's direction.
TEST(Msh, CurvesRunInTheirOwnDirection) {
  Result result = example::grid(2, 3, example::cubic_map());
  std::reverse(result.curves[2].poles.begin(), result.curves[2].poles.end());
  result.boundary_edges[2].t0 = 1;
  result.boundary_edges[2].t1 = 0;
  result.feature_edges.push_back({4, 3, static_cast<int>(result.curves.size()), 0, 1});
  result.curves.push_back({{Point(0.5, 0.5), Point(0, 0.5)}});
  const File file = read(format_msh(result), 3);
  std::set<int> seen;
  for (const Block& block : file.blocks) {
    if (block.dimension != 1) continue;
    seen.insert(block.tag);
    const BezierCurve& curve = result.curves[block.tag - 1];
    const std::vector<int>& ids = block.elements.front();
    ASSERT_EQ(block.elements.size(), 1u);
    if (static_cast<std::size_t>(block.tag) == result.curves.size()) continue;  // straight stand-in
    EXPECT_EQ(file.nodes.at(ids[0]), curve.start());
    EXPECT_EQ(file.nodes.at(ids[1]), curve.end());
    const auto& p = curve.poles;
    const Point third = (8 * p[0] + 12 * p[1] + 6 * p[2] + p[3]) / 27;
    EXPECT_LT((file.nodes.at(ids[2]) - third).norm(), 1e-15);
  }
  EXPECT_EQ(seen.size(), result.curves.size());
}

TEST(Msh, GroupsAreNamedAndExceptionalVerticesArePoints) {
  Result result = example::grid(2, 3, example::cubic_map());
  result.exceptional_vertices = {4, 0};
  const std::string text = format_msh(result);
  std::string names = section(text, "PhysicalNames").str();
  EXPECT_NE(names.find("0 1 \"exceptional\""), std::string::npos);
  EXPECT_NE(names.find("1 8 \"curve 7\""), std::string::npos);
  EXPECT_NE(names.find("2 1 \"region 0\""), std::string::npos);
  const File file = read(text, 3);
  std::vector<Point> points;
  for (const Block& block : file.blocks)
    if (block.dimension == 0) points.push_back(file.nodes.at(block.elements.front().front()));
  EXPECT_EQ(points,
            (std::vector<Point>{Point(0, 0), example::evaluate(example::cubic_map(), {0.5, 0.5})}));
}

// A control point that no triangle uses is no node.
TEST(Msh, LeavesUnusedPointsOut) {
  Result result = example::square();
  result.control_points.emplace_back(17, 17);
  const File file = read(format_msh(result), 3);
  EXPECT_EQ(file.nodes.size(), result.control_points.size() - 1);
  EXPECT_EQ(file.view.size(), file.nodes.size());
}

TEST(Msh, AboveDegreeTenIsRefused) {
  EXPECT_NO_THROW(format_msh(example::square(10)));
  try {
    format_msh(example::square(11));
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(e.defects().front().kind, DefectKind::unsupported);
  }
}

}  // namespace
}  // namespace c1mesh
