// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <stdexcept>

#include "c1mesh/generate.h"

namespace c1mesh {
namespace {

Drawing awkward() {
  const double tiny = std::numeric_limits<double>::denorm_min();
  Drawing drawing;
  drawing.name = "a<b & \"c\"";
  drawing.curves = {{"7", {{Point(0.1, -0.0), Point(1e308, tiny), Point(1.0 / 3, 2)}}},
                    {"x\"y", {{Point(1.0 / 3, 2), Point(0.1, -0.0)}}}};
  return drawing;
}

TEST(DrawingText, JsonReadsBackBitForBit) {
  const Drawing drawing = awkward();
  const auto json = nlohmann::json::parse(drawing_json(drawing));
  ASSERT_EQ(json.size(), drawing.curves.size());
  EXPECT_EQ(json[0]["curve_id"], 7);
  EXPECT_EQ(json[1]["curve_id"], "x\"y");
  for (std::size_t i = 0; i < json.size(); ++i) {
    const BezierCurve& curve = drawing.curves[i].curve;
    EXPECT_EQ(json[i]["type"], "BezierCurve");
    EXPECT_EQ(json[i]["degree"], curve.degree());
    ASSERT_EQ(json[i]["poles"].size(), curve.poles.size());
    for (std::size_t k = 0; k < curve.poles.size(); ++k) {
      EXPECT_EQ(json[i]["poles"][k][0].get<double>(), curve.poles[k].x());
      EXPECT_EQ(json[i]["poles"][k][1].get<double>(), curve.poles[k].y());
    }
  }
}

TEST(DrawingText, SvgIsWellFormedAndTurnsYDown) {
  Drawing drawing;
  drawing.name = "a<b & \"c\"";
  drawing.curves = {{"0", {{Point(0, 0), Point(4, 0)}}},
                    {"1", {{Point(4, 0), Point(4, 3), Point(0, 3)}}},
                    {"2", {{Point(0, 3), Point(-1, 2), Point(-1, 1), Point(0, 0)}}}};
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(drawing_svg(drawing).c_str()));
  EXPECT_EQ(document.child("svg").child_value("title"), drawing.name);
  std::string path = document.child("svg").child("path").attribute("d").value();
  std::replace(path.begin(), path.end(), '\n', ' ');
  EXPECT_EQ(path, "M0 0 L4 0 Q4 -3 0 -3 C-1 -2 -1 -1 0 0 Z ");
}

TEST(DrawingText, SvgStartsASubpathPerLoop) {
  const Drawing shape = generate('A', 1, 1).front();
  Drawing two = shape;
  for (InputCurve input : shape.curves) {
    for (Point& p : input.curve.poles) p *= 0.25;
    two.curves.push_back(input);
  }
  const std::string text = drawing_svg(two);
  EXPECT_EQ(std::count(text.begin(), text.end(), 'M'), 2);
  EXPECT_EQ(std::count(text.begin(), text.end(), 'Z'), 2);
}

TEST(DrawingText, SvgRefusesWhatItCannotSay) {
  Drawing drawing;
  drawing.curves = {{"0", {{Point(0, 0), Point(1, 0), Point(2, 1), Point(1, 2), Point(0, 0)}}}};
  EXPECT_THROW(drawing_svg(drawing), std::invalid_argument);
}

}  // namespace
}  // namespace c1mesh
