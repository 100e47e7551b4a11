// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <pugixml.hpp>

#include "c1mesh/error.h"
#include "c1mesh/png.h"
#include "c1mesh/write.h"
#include "result/example_results.h"
#include "write/xml_text.h"

namespace c1mesh {
namespace {

using testing_xml::parsed;
using testing_xml::path_points;

std::string path_of(const pugi::xml_document& doc, const std::string& group,
                    const std::string& css) {
  const std::string query = "//g[@id='" + group + "']/path[@class='" + css + "']";
  return doc.select_node(query.c_str()).node().attribute("d").value();
}

TEST(Svg, IsWellFormedWithEveryOption) {
  Result result = example::grid(2, 5, example::cubic_map());
  result.name = "a <b> & \"c\"\x01";
  result.exceptional_vertices = {0, 4};
  result.relaxed_edges = {{4, 5}};
  for (const Colour colour : {Colour::none, Colour::distortion, Colour::c1_deviation}) {
    DrawOptions options;
    options.colour = colour;
    options.show_control_net = true;
    const auto doc = parsed(draw_svg(result, options));
    EXPECT_STREQ(doc.child("svg").child("title").text().get(), "a <b> & \"c\"");
    EXPECT_TRUE(doc.child("svg").attribute("viewBox"));
    EXPECT_EQ(doc.select_nodes("//circle").size(), 4u);  // two vertices in two panels
    EXPECT_EQ(doc.select_nodes("//g[@id='legend']").size(), colour == Colour::none ? 0u : 1u);
    EXPECT_FALSE(path_of(doc, "shape", "net").empty());
    EXPECT_FALSE(path_of(doc, "domain", "relaxed").empty());
  }
}

TEST(Svg, LeavesOutWhatIsNotAskedFor) {
  DrawOptions options;
  options.grid_lines = 0;
  options.show_mesh = false;
  const auto doc = parsed(draw_svg(example::grid(2, 3, example::identity()), options));
  for (const char* css : {"u", "v", "mesh", "net"}) EXPECT_TRUE(path_of(doc, "shape", css).empty());
  EXPECT_FALSE(path_of(doc, "shape", "boundary").empty());
}

// An affine map of the square: the image of the grid line u = c is the segment between the images
// of (c, 0) and (c, 1), so every point of the path lies on it. The page is a similarity of the
// plane, found from the boundary's corners.
TEST(Svg, GridOfAnAffineMapLiesOnItsClosedForm) {
  const example::Polynomial affine{
      {0, 0, Point(5, -2)}, {1, 0, Point(2, 1)}, {0, 1, Point(-0.5, 1)}};
  for (const int degree : {3, 4}) {
    DrawOptions options;
    options.grid_lines = 5;
    const Result result = example::grid(4, degree, affine);
    const auto doc = parsed(draw_svg(result, options));
    // The bounding box of the image is [4.5, 7] x [-2, 0]; the panel is (1200 - 3*28) / 2 wide.
    const double scale = (1200 - 3 * 28) / 2.0 / 2.5;
    const std::vector<Point> boundary = path_points(path_of(doc, "shape", "boundary"));
    double left = 1e9, bottom = -1e9;
    for (const Point& p : boundary) {
      left = std::min(left, p.x());
      bottom = std::max(bottom, p.y());
    }
    EXPECT_NEAR(left, 28, 1e-2);
    for (const int axis : {0, 1}) {
      const std::vector<Point> points = path_points(path_of(doc, "shape", axis == 0 ? "u" : "v"));
      ASSERT_GT(points.size(), 10u);
      for (const Point& page : points) {
        const Point p(4.5 + (page.x() - left) / scale, -2 - (page.y() - bottom) / scale);
        // Inverse of [2 -0.5; 1 1], determinant 2.5.
        const Point d = p - Point(5, -2);
        const Point uv((d.x() + 0.5 * d.y()) / 2.5, (2 * d.y() - d.x()) / 2.5);
        const double line = uv[axis] * 5 - 0.5;  // lines at 0.1, 0.3, 0.5, 0.7, 0.9
        EXPECT_NEAR(line, std::round(line), 1e-4);
        EXPECT_GT(uv[1 - axis], -1e-4);
        EXPECT_LT(uv[1 - axis], 1 + 1e-4);
      }
    }
  }
}

TEST(Svg, CubicEdgesAreExactPaths) {
  // The boundary's path holds the control points themselves: M p0 C p1 p2 p3.
  const auto doc = parsed(draw_svg(example::square(3, example::cubic_map())));
  const std::string data = path_of(doc, "shape", "boundary");
  EXPECT_EQ(std::count(data.begin(), data.end(), 'M'), 4);
  EXPECT_EQ(std::count(data.begin(), data.end(), 'C'), 4);
  EXPECT_EQ(path_points(data).size(), 16u);
}

TEST(Svg, SameResultSameBytes) {
  const Result result = example::grid(3, 3, example::cubic_map());
  EXPECT_EQ(draw_svg(result), draw_svg(result));
}

Point first_point(const pugi::xml_document& doc, const std::string& group, const std::string& css) {
  return path_points(path_of(doc, group, css)).at(0);
}

TEST(Svg, PartsAreDrawnInTheirOrder) {
  DrawOptions options;
  options.parts = {Part::domain, Part::outline, Part::mesh};
  Result result = example::grid(2, 3, example::cubic_map());
  result.exceptional_vertices = {0};
  result.relaxed_edges = {{0, 4}};
  const auto doc = parsed(draw_svg(result, options));
  const auto left = [&](const char* group) { return first_point(doc, group, "boundary").x(); };
  EXPECT_LT(left("domain"), left("outline"));
  EXPECT_LT(left("outline"), left("mesh"));
  for (const char* css : {"u", "v", "mesh", "relaxed"}) {
    EXPECT_TRUE(path_of(doc, "outline", css).empty()) << css;
    EXPECT_FALSE(path_of(doc, "domain", css).empty()) << css;
  }
  EXPECT_FALSE(path_of(doc, "mesh", "mesh").empty());
  EXPECT_TRUE(path_of(doc, "mesh", "u").empty());
  EXPECT_EQ(doc.select_nodes("//circle").size(), 2u);  // none on the outline
  EXPECT_FALSE(doc.select_node("//g[@id='shape']"));
}

TEST(Svg, SeveralResultsAreBlocksInRows) {
  Result a = example::square(), b = example::grid(2, 3, example::cubic_map()), c = a;
  a.name = "first";
  DrawOptions options;
  options.columns = 2;
  options.parts = {Part::domain};
  const auto doc = parsed(
      draw_svg({{&a, "", nullptr}, {&b, "the <second>", nullptr}, {&c, "c", nullptr}}, options));
  const Point one = first_point(doc, "domain", "boundary"),
              two = first_point(doc, "domain-2", "boundary"),
              three = first_point(doc, "domain-3", "boundary");
  EXPECT_NEAR(two.x() - one.x(), (1200 - 28) / 2.0, 1e-2);
  EXPECT_NEAR(two.y(), one.y(), 1e-2);
  EXPECT_NEAR(three.x(), one.x(), 1e-2);
  EXPECT_GT(three.y(), one.y() + 500);
  std::vector<std::string> titles;
  for (const auto& node : doc.select_nodes("//text[@font-weight]"))
    titles.push_back(node.node().text().get());
  EXPECT_EQ(titles, (std::vector<std::string>{"first", "the <second>", "c"}));
  EXPECT_THROW(draw_svg(std::vector<Drawn>{}, options), std::invalid_argument);
}

// The window is centred where the vertex is and magnified as the text says; a vertex that the
// domain drawn over has moved is found.
TEST(Svg, BlowUpIsAroundItsVertex) {
  const Result result = example::grid(3, 3, example::identity());
  Result moved = result;
  const int vertex = 2;
  moved.domain_vertices[vertex] += Point(0.01, 0.01);
  DrawOptions options;
  options.parts = {Part::domain};
  options.zoom = Zoom{vertex, 0.25};
  const std::vector<Drawn> drawn{{&result, "", &moved}};
  const std::string svg = draw_svg(drawn, options);
  const auto doc = parsed(svg);
  EXPECT_FALSE(path_of(doc, "domain", "over").empty());
  const auto frames = doc.select_nodes("//rect[@class='window']");
  ASSERT_EQ(frames.size(), 2u);
  const double small = frames[0].node().attribute("width").as_double(),
               large = frames[1].node().attribute("width").as_double();
  const double panel = (1200 - 3 * 28) / 2.0;
  EXPECT_NEAR(large, panel, 0.1);
  EXPECT_NEAR(small, 0.25 * panel, 0.1);  // the domain is the unit square
  EXPECT_NEAR(frames[0].node().attribute("x").as_double() + small / 2, 28 + panel * 2 / 3, 0.1);
  // The vertex is near the lower side, so the window is moved up to it: the panel ends there.
  EXPECT_NEAR(frames[0].node().attribute("y").as_double() + small, 58 + panel, 0.1);
  EXPECT_NE(svg.find(">4 times<"), std::string::npos);
  options.zoom->vertex = Zoom::kApart;
  EXPECT_EQ(draw_svg(drawn, options), svg);
  options.zoom->vertex = static_cast<int>(result.domain_vertices.size());
  EXPECT_THROW(draw_svg(drawn, options), std::invalid_argument);
  options.zoom->vertex = Zoom::kApart;
  EXPECT_THROW(draw_svg(result, options), std::invalid_argument);
}

TEST(Svg, ResultThatClaimsNothingHasNoMarks) {
  Result result = example::grid(2, 3, example::cubic_map());
  result.relaxed_edges = {{4, 5}};
  for (int v = 0; v < static_cast<int>(result.domain_vertices.size()); ++v)
    result.exceptional_vertices.push_back(v);
  const std::string svg = draw_svg(result);
  EXPECT_NE(svg.find("C1 claimed nowhere"), std::string::npos);
  const auto doc = parsed(svg);
  EXPECT_EQ(doc.select_nodes("//circle").size(), 0u);
  EXPECT_TRUE(path_of(doc, "domain", "relaxed").empty());
  EXPECT_EQ(doc.select_nodes("//g[@id='domain']/path[@class='mesh']").size(), 2u);
  result.exceptional_vertices.pop_back();
  EXPECT_EQ(parsed(draw_svg(result)).select_nodes("//circle").size(),
            2 * result.exceptional_vertices.size());
}

TEST(Convert, GoesByExtension) {
  const Result result = example::square();
  EXPECT_EQ(convert(result, "a/b.vtu"), format_vtu(result, false));
  EXPECT_EQ(convert(result, "a/b.domain.vtu"), format_vtu(result, true));
  ConvertOptions options;
  options.cells = VtuCells::lagrange;
  options.tessellation = 3;
  EXPECT_EQ(convert(result, "b.vtu", options), format_vtu(result, false, VtuCells::lagrange));
  EXPECT_EQ(convert(result, "b.msh"), format_msh(result, false));
  EXPECT_EQ(convert(result, "b.domain.msh"), format_msh(result, true));
  EXPECT_EQ(convert(result, "b.mesh"), format_mfem(result, false));
  EXPECT_EQ(convert(result, "b.domain.mesh"), format_mfem(result, true));
  EXPECT_EQ(convert(result, "b.obj"), format_obj(result, 8));
  EXPECT_EQ(convert(result, "b.obj", options), format_obj(result, 3));
  EXPECT_EQ(convert(result, "b.svg"), draw_svg(result));
  EXPECT_EQ(convert(result, "b.png"), png_of(draw_svg(result)));
  EXPECT_EQ(convert(result, "b.c1.json"), format_result(result));
  for (const char* path : {"b.stl", "b", "svg", "b.svg.gz"})
    EXPECT_THROW(convert(result, path), InputError);
}

}  // namespace
}  // namespace c1mesh
