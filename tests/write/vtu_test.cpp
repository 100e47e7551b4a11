// SPDX-License-Identifier: GPL-3.0-or-later
// The VTU file read back as XML: counts, order of points, fields.
#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <sstream>

#include "c1mesh/write.h"
#include "result/example_results.h"
#include "write/xml_text.h"

namespace c1mesh {
namespace {

using testing_xml::parsed;

std::vector<double> values(const pugi::xml_document& doc, const std::string& name) {
  const std::string query = "//DataArray[@Name='" + name + "']";
  std::istringstream in(doc.select_node(query.c_str()).node().text().get());
  std::vector<double> out;
  for (std::string word; in >> word;) out.push_back(std::stod(word));
  return out;
}

// The identity of the triangle (0,0), (n,0), (0,n): control points are the integer points (i, j),
// so the order can be written down: corners, edges 01, 12, 20, then the inside recursively.
std::vector<Point> expected_order(int n) {
  switch (n) {
    case 1:
      return {{0, 0}, {1, 0}, {0, 1}};
    case 2:
      return {{0, 0}, {2, 0}, {0, 2}, {1, 0}, {1, 1}, {0, 1}};
    case 3:
      return {{0, 0}, {3, 0}, {0, 3}, {1, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
    case 4:
      return {{0, 0}, {4, 0}, {0, 4}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 2},
              {1, 3}, {0, 3}, {0, 2}, {0, 1}, {1, 1}, {2, 1}, {1, 2}};
    default:
      return {{0, 0}, {5, 0}, {0, 5}, {1, 0}, {2, 0}, {3, 0}, {4, 0},
              {4, 1}, {3, 2}, {2, 3}, {1, 4}, {0, 4}, {0, 3}, {0, 2},
              {0, 1}, {1, 1}, {3, 1}, {1, 3}, {2, 1}, {2, 2}, {1, 2}};
  }
}

class VtuOrder : public testing::TestWithParam<int> {};

TEST_P(VtuOrder, FollowsVtk) {
  const int n = GetParam();
  const double s = n;
  const Result result =
      example::polynomial_result(n, example::identity(), {{0, 0}, {s, 0}, {0, s}}, {{0, 1, 2}});
  const auto doc = parsed(format_vtu(result, false));
  const std::vector<double> points = values(doc, "Points"), ids = values(doc, "connectivity");
  const std::vector<Point> expected = expected_order(n);
  ASSERT_EQ(ids.size(), expected.size() + 3 * (n + 1));  // one triangle and three boundary curves
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const auto id = static_cast<std::size_t>(ids[k]);
    EXPECT_NEAR(points[3 * id], expected[k].x(), 1e-14);
    EXPECT_NEAR(points[3 * id + 1], expected[k].y(), 1e-14);
  }
  // The first curve: ends, then the inside.
  for (int k = 0; k <= n; ++k) {
    const auto id = static_cast<std::size_t>(ids[expected.size() + k]);
    EXPECT_NEAR(points[3 * id], k == 0 ? 0 : k == 1 ? n : k - 1, 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, VtuOrder, testing::Values(1, 2, 3, 4, 5));

TEST(Vtu, CountsFieldsAndNumbersAreRight) {
  Result result = example::grid(2, 4, example::cubic_map());
  result.exceptional_vertices = {4};
  result.relaxed_edges = {{4, 5}};
  const std::string text = format_vtu(result, false);
  const auto doc = parsed(text);
  const pugi::xml_node piece = doc.select_node("//Piece").node();
  EXPECT_EQ(piece.attribute("NumberOfPoints").as_uint(), result.control_points.size());
  const std::size_t cells = 8 + 8 + 1;  // triangles, boundary edges, one relaxed edge
  EXPECT_EQ(piece.attribute("NumberOfCells").as_uint(), cells);
  for (const char* field : {"types", "offsets", "distortion", "min_det", "region", "edge_kind"})
    EXPECT_EQ(values(doc, field).size(), cells) << field;
  for (const char* field : {"c1_deviation", "exceptional"})
    EXPECT_EQ(values(doc, field).size(), result.control_points.size()) << field;
  EXPECT_EQ(values(doc, "domain").size(), 2 * result.control_points.size());
  const std::vector<double> types = values(doc, "types"), kinds = values(doc, "edge_kind");
  EXPECT_EQ(std::count(types.begin(), types.end(), 76), 8);
  EXPECT_EQ(std::count(types.begin(), types.end(), 75), 9);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), 3), 1);
  EXPECT_EQ(values(doc, "offsets").back(), 8 * 15 + 9 * 5);
  const std::vector<double> flags = values(doc, "exceptional");
  EXPECT_EQ(std::count(flags.begin(), flags.end(), 1), 1);
  // Coordinates read back bit for bit.
  const std::vector<double> points = values(doc, "Points");
  for (std::size_t i = 0; i < result.control_points.size(); ++i) {
    EXPECT_EQ(points[3 * i], result.control_points[i].x());
    EXPECT_EQ(points[3 * i + 1], result.control_points[i].y());
  }
}

// The domain file shares everything but the points, and those are the field "domain" of the other.
TEST(Vtu, DomainFileHasTheSameNumbering) {
  const Result result = example::grid(2, 3, example::cubic_map());
  const auto shape = parsed(format_vtu(result, false)), domain = parsed(format_vtu(result, true));
  for (const char* field : {"connectivity", "types", "offsets", "domain", "distortion", "region"})
    EXPECT_EQ(values(shape, field), values(domain, field)) << field;
  const std::vector<double> points = values(domain, "Points"), uv = values(shape, "domain");
  for (std::size_t i = 0; 2 * i < uv.size(); ++i) {
    EXPECT_EQ(points[3 * i], uv[2 * i]);
    EXPECT_EQ(points[3 * i + 1], uv[2 * i + 1]);
    // The map is the polynomial: the same control net blossomed from the identity is the domain
    // net.
  }
  const Result identity = example::grid(2, 3, example::identity());
  for (std::size_t i = 0; i < identity.control_points.size(); ++i) {
    EXPECT_NEAR(points[3 * i], identity.control_points[i].x(), 1e-15);
    EXPECT_NEAR(points[3 * i + 1], identity.control_points[i].y(), 1e-15);
  }
}

// Lagrange cells: the same numbering, and points that are values of the map at the domain's places.
TEST(Vtu, LagrangeCellsHoldValuesOfTheMap) {
  const auto map = example::cubic_map();
  const Result result = example::grid(2, 4, map);
  const auto bezier = parsed(format_vtu(result)),
             lagrange = parsed(format_vtu(result, false, VtuCells::lagrange)),
             domain = parsed(format_vtu(result, true, VtuCells::lagrange));
  for (const char* field : {"offsets", "domain", "distortion", "region", "edge_kind"})
    EXPECT_EQ(values(bezier, field), values(lagrange, field)) << field;
  const std::vector<double> types = values(lagrange, "types");
  EXPECT_EQ(std::count(types.begin(), types.end(), 69), 8);
  EXPECT_EQ(std::count(types.begin(), types.end(), 4), 8);
  // Triangles have the same points in the same order; polylines go from end to end.
  std::vector<double> same = values(bezier, "connectivity");
  const std::vector<double> offsets = values(bezier, "offsets");
  for (std::size_t cell = 8; cell < offsets.size(); ++cell) {
    const auto begin = same.begin() + static_cast<long>(offsets[cell - 1]);
    std::rotate(begin + 1, begin + 2, same.begin() + static_cast<long>(offsets[cell]));
  }
  EXPECT_EQ(values(lagrange, "connectivity"), same);
  const std::vector<double> points = values(lagrange, "Points"), uv = values(lagrange, "domain"),
                            straight = values(domain, "Points");
  for (std::size_t i = 0; 2 * i < uv.size(); ++i) {
    const Point place(uv[2 * i], uv[2 * i + 1]), image(points[3 * i], points[3 * i + 1]);
    EXPECT_EQ(Point(straight[3 * i], straight[3 * i + 1]), place);
    EXPECT_LT((image - example::evaluate(map, place)).norm(), 4e-16);
  }
}

TEST(Vtu, AnIrregularTriangleHasNoInfinityInTheFile) {
  Result result = example::square();
  result.control_points[result.triangle_control_points[0][5]] = Point(3, 2);
  const std::string text = format_vtu(result, false);
  EXPECT_EQ(text.find("inf"), std::string::npos);
  EXPECT_EQ(values(parsed(text), "distortion")[0], -1);
}

}  // namespace
}  // namespace c1mesh
