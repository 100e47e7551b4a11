// SPDX-License-Identifier: GPL-3.0-or-later
// What pictures show beyond lines: colours, squares, legends, keys, sizes; and as pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "c1mesh/png.h"
#include "c1mesh/write.h"
#include "raster/pixels.h"
#include "result/example_results.h"
#include "write/colour_scale.h"
#include "write/xml_text.h"

namespace c1mesh {
namespace {

using testing_pixels::pixels_of;
using testing_xml::parsed;
using testing_xml::path_points;

std::array<double, 3> linear_rgb(const std::string& colour) {
  std::array<double, 3> out;
  for (int k = 0; k < 3; ++k) {
    const double c = std::stoi(colour.substr(1 + 2 * k, 2), nullptr, 16) / 255.0;
    out[k] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return out;
}

/// CIE L*a*b* under D65.
std::array<double, 3> lab(const std::array<double, 3>& rgb) {
  const auto f = [](double t) {
    return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  };
  const double x = 0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2];
  const double y = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
  const double z = 0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2];
  const double fx = f(x / 0.9505), fy = f(y), fz = f(z / 1.089);
  return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

// Equal steps look equal: lightness falls evenly, and so it does for whoever lacks the red or the
// green cones (Machado, Oliveira & Fernandes 2009, severity 1).
TEST(ColourScale, LightnessFallsEvenlyForEveryEye) {
  using Matrix = std::array<std::array<double, 3>, 3>;
  const std::vector<Matrix> eyes{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                 {{{0.152286, 1.052583, -0.204868},
                                   {0.114503, 0.786281, 0.099216},
                                   {-0.003882, -0.048116, 1.051998}}},
                                 {{{0.367322, 0.860646, -0.227968},
                                   {0.280085, 0.672501, 0.047413},
                                   {-0.011820, 0.042940, 0.968881}}}};
  for (const Matrix& eye : eyes) {
    std::vector<double> lightness;
    for (int k = 0; k <= 12; ++k) {
      const auto rgb = linear_rgb(scale_colour(k / 12.0));
      std::array<double, 3> seen{};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) seen[i] += eye[i][j] * rgb[j];
      for (double& c : seen) c = std::clamp(c, 0.0, 1.0);
      lightness.push_back(lab(seen)[0]);
    }
    EXPECT_GT(lightness.front(), 95);
    EXPECT_LT(lightness.back(), 30);
    const double mean = (lightness.front() - lightness.back()) / 12;
    for (std::size_t k = 1; k < lightness.size(); ++k) {
      EXPECT_GT(lightness[k - 1] - lightness[k], 0.5 * mean) << k;
      EXPECT_LT(lightness[k - 1] - lightness[k], 1.6 * mean) << k;
    }
  }
}

TEST(ColourScale, RunsToRoundValuesWithRoundTicks) {
  using Values = std::vector<double>;
  const ColourScale narrow = distortion_scale(2.3), middle = distortion_scale(9.1),
                    wide = distortion_scale(137);
  EXPECT_FALSE(narrow.logarithmic);
  EXPECT_EQ(narrow.high, 3);
  ASSERT_EQ(narrow.ticks(12).size(), 11u);
  EXPECT_NEAR(narrow.ticks(12)[3], 2.3, 1e-9);
  EXPECT_FALSE(middle.logarithmic);
  EXPECT_EQ(middle.ticks(12), (Values{2, 3, 4, 5, 6, 7, 8, 9, 10}));
  EXPECT_EQ(middle.ticks(6), (Values{2, 4, 6, 8, 10}));
  EXPECT_TRUE(wide.logarithmic);
  EXPECT_EQ(wide.ticks(12), (Values{2, 5, 10, 20, 50, 100, 200}));
  EXPECT_EQ(wide.ticks(4), (Values{10, 100}));
  EXPECT_EQ(distortion_scale(std::numeric_limits<double>::infinity()).high, 1e9);
  const ColourScale deviation = deviation_scale(3e-16, 2e-14);
  EXPECT_NEAR(deviation.low / 1e-16, 1, 1e-9);
  EXPECT_NEAR(deviation.high / 1e-11, 1, 1e-9);
  EXPECT_EQ(deviation_scale(0, 0).ticks(12).empty(), false);
  for (const ColourScale& scale : {narrow, middle, wide, deviation})
    for (const int most : {2, 3, 5, 12}) {
      const std::vector<double> ticks = scale.ticks(most);
      EXPECT_FALSE(ticks.empty());
      EXPECT_LE(ticks.size(), static_cast<std::size_t>(most));
      EXPECT_TRUE(std::is_sorted(ticks.begin(), ticks.end()));
      for (const double tick : ticks) {
        EXPECT_GE(tick, scale.low * (1 - 1e-9));
        EXPECT_LE(tick, scale.high * (1 + 1e-9));
      }
    }
}

TEST(ColourScale, SharesAreOfTheValueOrOfItsLogarithm) {
  const ColourScale linear{2, 6, false, ""}, logarithmic{1, 10000, true, ""};
  EXPECT_DOUBLE_EQ(linear.share(3), 0.25);
  EXPECT_DOUBLE_EQ(logarithmic.share(10), 0.25);
  EXPECT_EQ(linear.share(1), 0);
  EXPECT_EQ(linear.share(7), 1);
  EXPECT_EQ(linear.share(std::numeric_limits<double>::infinity()), 1);
  EXPECT_EQ(linear.step(2), 0);
  EXPECT_EQ(linear.step(6), ColourScale::kSteps - 1);
  EXPECT_EQ(scale_colour(0), "#fcfdbf");
  EXPECT_EQ(scale_colour(1), "#3b0f70");
}

/// (2x, y): MIPS is (4 + 1) / 2 everywhere.
const example::Polynomial kStretched{{1, 0, Point(2, 0)}, {0, 1, Point(0, 1)}};

TEST(Picture, FillHasTheColourOfTheKnownDistortion) {
  DrawOptions options;
  options.colour = Colour::distortion;
  const std::string svg = draw_svg(example::grid(4, 3, kStretched), options);
  const auto doc = parsed(svg);
  // The scale runs from 2 to 3: half way, in the lower end of step 32 or the upper one of step 31.
  const std::set<std::string> expected{scale_colour(31.5 / 64), scale_colour(32.5 / 64)};
  for (const char* group : {"shape", "domain"}) {
    const auto fills =
        doc.select_nodes(("//g[@id='" + std::string(group) + "']/path[@style]").c_str());
    ASSERT_GE(fills.size(), 1u);
    for (const auto& fill : fills) {
      const std::string style = fill.node().attribute("style").value();
      EXPECT_EQ(expected.count(style.substr(5, 7)), 1u) << style;
    }
  }
  const auto pixels = pixels_of(png_of(svg));
  // Between lines of the shape, whatever is drawn over the fill, the most common colour is it.
  std::map<testing_pixels::Rgba, int> counts;
  for (int x = 40; x < 560; ++x)
    for (int y = 250; y < 420; ++y) ++counts[pixels.at(x, y)];
  const auto common = std::max_element(counts.begin(), counts.end(), [](auto& a, auto& b) {
                        return a.second < b.second;
                      })->first;
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", common[0], common[1], common[2]);
  EXPECT_EQ(expected.count(text), 1u) << text;
}

TEST(Picture, DeviationIsOfTheEdgesWhereC1IsAsked) {
  Result result = example::grid(2, 3, example::identity());
  DrawOptions options;
  options.colour = Colour::c1_deviation;
  const auto highest_tick = [&] {
    const auto doc = parsed(draw_svg(result, options));
    return doc.select_nodes("//g[@id='legend']/text[@text-anchor]")
        .end()[-1]
        .node()
        .text()
        .as_double();
  };
  EXPECT_NEAR(highest_tick() / 1e-11, 1, 1e-9);
  // The vertex in the middle of the square is moved: not C1 across the edges around it.
  result.domain_vertices[4] += Point(0.05, 0.02);
  EXPECT_GE(highest_tick(), 0.01);
  for (const auto& t : result.triangles)
    for (int k = 0; k < 3; ++k) result.relaxed_edges.push_back({t[k], t[(k + 1) % 3]});
  result.exceptional_vertices = {4};
  EXPECT_NEAR(highest_tick() / 1e-11, 1, 1e-9);
}

/// Area of the closed polygons of a path, curves by their ends.
double area_of(const std::string& data) {
  double sum = 0;
  std::istringstream parts(data);
  for (std::string contour; std::getline(parts, contour, 'Z');) {
    const std::vector<Point> p = path_points(contour);
    for (std::size_t k = 0; k < p.size(); ++k) sum += 0.5 * cross(p[k], p[(k + 1) % p.size()]);
  }
  return std::abs(sum);
}

std::string squares_of(const pugi::xml_document& doc, const std::string& group) {
  return doc.select_node(("//g[@id='" + group + "']/path[@class='squares']").c_str())
      .node()
      .attribute("d")
      .value();
}

TEST(Picture, CheckerboardHasHalfOfTheArea) {
  DrawOptions options;
  options.colour = Colour::checkerboard;
  options.grid_lines = 7;  // six whole squares between lines, half ones at the sides: 8 x 8
  const auto doc = parsed(draw_svg(example::grid(5, 3, kStretched), options));
  const double panel = (1200 - 3 * 28) / 2.0;
  // Of the 8 x 8 cells every second one is dark: by symmetry half of the area, and the same on both
  // sides of an affine map.
  EXPECT_NEAR(area_of(squares_of(doc, "domain")) / (panel * panel), 0.5, 1e-4);
  EXPECT_NEAR(area_of(squares_of(doc, "shape")) / (panel * panel / 2), 0.5, 1e-4);
  EXPECT_FALSE(doc.select_node("//path[@class='u']"));
  EXPECT_FALSE(doc.select_node("//g[@id='legend']"));
  options.grid_lines = 0;
  EXPECT_THROW(draw_svg(example::square(), options), std::invalid_argument);
}

// Corners of the squares on the shape are images of the grid's crossings.
TEST(Picture, CheckerboardOnTheShapeIsTheImageOfTheDomains) {
  DrawOptions options;
  options.colour = Colour::checkerboard;
  options.grid_lines = 4;
  options.parts = {Part::domain};
  const Result result = example::square(3, example::cubic_map());
  const auto first_points = [](const std::string& data) {
    std::vector<Point> out;
    std::istringstream parts(data);
    for (std::string contour; std::getline(parts, contour, 'Z');)
      if (!path_points(contour).empty()) out.push_back(path_points(contour)[0]);
    return out;
  };
  const auto domain = first_points(squares_of(parsed(draw_svg(result, options)), "domain"));
  options.parts = {Part::shape};
  const auto shape = first_points(squares_of(parsed(draw_svg(result, options)), "shape"));
  ASSERT_EQ(domain.size(), shape.size());
  ASSERT_GT(domain.size(), 8u);
  const double side = 1200 - 2 * 28;
  // The shape's box is that of its control points.
  Point low = result.control_points[0], high = low;
  for (const Point& p : result.control_points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double scale = side / (high - low).x();
  const double height = std::min(1.5 * side, scale * (high - low).y());
  for (std::size_t k = 0; k < domain.size(); ++k) {
    const Point uv((domain[k].x() - 28) / side, 1 - (domain[k].y() - 58) / side);
    const Point image = example::evaluate(example::cubic_map(), uv);
    EXPECT_NEAR(shape[k].x(), 28 + scale * (image.x() - low.x()), 0.01);
    EXPECT_NEAR(shape[k].y(), 58 + height - scale * (image.y() - low.y()), 0.01);
  }
}

std::string after_header(const std::string& svg) {
  return svg.substr(svg.find("<title>"));
}

TEST(Picture, LargePicturesAreEnlargedAndSmallOnesStayReadable) {
  Result result = example::grid(2, 3, example::cubic_map());
  DrawOptions options;
  const std::string usual = draw_svg(result, options);
  options.width = 3000;
  const std::string large = draw_svg(result, options);
  EXPECT_EQ(after_header(large), after_header(usual));  // the same drawing, 2.5 times as large
  const auto large_doc = parsed(large);
  const auto root = large_doc.child("svg");
  EXPECT_EQ(root.attribute("width").as_double(), 3000);
  EXPECT_EQ(std::string(root.attribute("viewBox").value()).substr(0, 8), "0 0 1200");
  options.width = 300;
  const auto small_doc = parsed(draw_svg(result, options));
  const auto small = small_doc.child("svg");
  EXPECT_EQ(small.attribute("width").as_double(), 300);
  EXPECT_EQ(std::string(small.attribute("viewBox").value()).substr(0, 7), "0 0 400");
  for (const double width : {300.0, 3000.0}) {
    options.width = width;
    const std::string svg = draw_svg(result, options);
    const auto pixels = pixels_of(png_of(svg));
    EXPECT_EQ(pixels.width, width);
    EXPECT_EQ(pixels.height, parsed(svg).child("svg").attribute("height").as_int());
    // The domain is a square: its boundary, two units thick, runs down its left side.
    const double unit = width == 300 ? 0.75 : 2.5;
    int dark = 0;
    for (int x = pixels.width / 2; x < 3 * pixels.width / 4; ++x)
      dark += pixels.at(x, static_cast<int>(0.6 * pixels.height))[1] < 60;
    EXPECT_NEAR(dark, 2 * unit, 1.01);
  }
}

TEST(Picture, TextEndsWhereItsBlockEnds) {
  Result result = example::square();
  result.name = std::string(500, 'n');
  DrawOptions options;
  options.width = 300;
  const auto doc = parsed(draw_svg(result, options));
  const std::string title = doc.select_node("//text[@font-weight]").node().text().get();
  EXPECT_LT(title.size(), 60u);
  EXPECT_TRUE(title.ends_with("…"));
  EXPECT_EQ(doc.child("svg").child("title").text().get(), result.name);
}

TEST(Picture, KeyExplainsWhatIsThere) {
  Result result = example::grid(2, 3, example::cubic_map());
  DrawOptions options;
  const auto words = [&] {
    std::set<std::string> out;
    const auto doc = parsed(draw_svg(result, options));
    for (const auto& node : doc.select_nodes("//g[@id='key']/text"))
      out.insert(node.node().text().get());
    return out;
  };
  using Words = std::set<std::string>;
  EXPECT_EQ(words(), (Words{"u constant", "v constant"}));
  result.exceptional_vertices = {0};
  result.relaxed_edges = {{0, 4}};
  options.show_control_net = true;
  EXPECT_EQ(words(), (Words{"u constant", "v constant", "exceptional vertex", "control net",
                            "C1 not asked across"}));
  options.parts = {Part::outline};
  EXPECT_EQ(words(), Words{});
  options.parts = {Part::shape};
  options.show_key = false;
  EXPECT_EQ(words(), Words{});
}

TEST(Picture, ControlNetHasEveryControlPoint) {
  const Result result = example::grid(2, 4, example::cubic_map());
  DrawOptions options;
  options.show_control_net = true;
  const auto doc = parsed(draw_svg(result, options));
  const std::string data =
      doc.select_node("//g[@id='shape']/path[@class='points']").node().attribute("d").value();
  EXPECT_EQ(path_points(data).size(), 2 * result.control_points.size());
}

TEST(Picture, GroundCanBeLeftOut) {
  DrawOptions options;
  EXPECT_EQ(pixels_of(png_of(draw_svg(example::square(), options))).at(1, 1)[3], 255);
  options.transparent = true;
  EXPECT_EQ(pixels_of(png_of(draw_svg(example::square(), options), {true})).at(1, 1)[3], 0);
}

}  // namespace
}  // namespace c1mesh
