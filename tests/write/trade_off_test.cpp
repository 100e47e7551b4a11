// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a trade-off: well-formed, points where the axes say.
#include "c1mesh/trade_off.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <pugixml.hpp>

#include "write/xml_text.h"

namespace c1mesh {
namespace {

TradeOff curve_of(const std::vector<std::pair<int, double>>& points) {
  TradeOff curve;
  curve.name = "a <b> & \"c\"";
  curve.bound = 1000;
  for (const auto& [exceptional, g] : points) {
    TradeOffPoint p;
    p.asked = p.exceptional = exceptional;
    p.g = g;
    curve.points.push_back(p);
  }
  if (!points.empty()) curve.minimum = points.front().first;
  return curve;
}

pugi::xml_document parsed(const TradeOff& curve, double width = 600) {
  return testing_xml::parsed(draw_trade_off(curve, width));
}

std::size_t count(const pugi::xml_document& doc, const char* css) {
  return doc.select_nodes((std::string("//*[@class='") + css + "']").c_str()).size();
}

TEST(TradeOffPicture, IsWellFormedForAnyCurve) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const auto& points : std::vector<std::vector<std::pair<int, double>>>{
           {}, {{0, 2}}, {{3, infinite}}, {{3, 9}, {4, infinite}, {5, 4}}, {{0, 1e9}, {40, 2}}})
    for (const double width : {1.0, 600.0, 2000.0}) {
      const std::string text = draw_trade_off(curve_of(points), width);
      EXPECT_EQ(text.find("nan"), std::string::npos);
      EXPECT_EQ(text.find("inf"), std::string::npos);
      const auto doc = parsed(curve_of(points), width);
      EXPECT_STREQ(doc.child("svg").child("title").text().get(), "a <b> & \"c\"");
    }
}

// Equal ratios of g are equal distances down the page, equal numbers equal distances across.
TEST(TradeOffPicture, AxesAreLinearAndLogarithmic) {
  const auto doc = parsed(curve_of({{3, 80}, {4, 40}, {6, 20}, {7, 5}}));
  std::vector<double> x, y;
  for (const auto& node : doc.select_nodes("//circle")) {
    x.push_back(node.node().attribute("cx").as_double());
    y.push_back(node.node().attribute("cy").as_double());
  }
  ASSERT_EQ(x.size(), 4u);
  EXPECT_GT(y[1], y[0] + 10);  // a page's y goes down
  EXPECT_NEAR(y[2] - y[1], y[1] - y[0], 0.2);
  EXPECT_NEAR(y[3] - y[2], 2 * (y[1] - y[0]), 0.2);
  EXPECT_GT(x[1], x[0] + 10);
  EXPECT_NEAR(x[2] - x[1], 2 * (x[1] - x[0]), 0.2);
  EXPECT_NEAR(x[3] - x[2], x[1] - x[0], 0.2);
}

TEST(TradeOffPicture, ShowsTheBoundWhereItIsNearAndMarksDominatedPoints) {
  TradeOff curve = curve_of({{3, 900}, {4, 300}, {5, 400}});
  curve.points[2].dominated = true;
  const auto near = parsed(curve);
  EXPECT_EQ(count(near, "bound"), 1u);
  EXPECT_EQ(count(near, "point"), 2u);
  EXPECT_EQ(count(near, "dominated"), 1u);
  EXPECT_EQ(count(near, "envelope"), 1u);
  EXPECT_EQ(count(parsed(curve_of({{3, 9}, {4, 5}})), "bound"), 0u);
}

}  // namespace
}  // namespace c1mesh
