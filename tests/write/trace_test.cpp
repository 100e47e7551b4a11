// SPDX-License-Identifier: GPL-3.0-or-later
// The plot of a trace: well-formed, every stage in it, curves where the axes say.
#include "c1mesh/trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <pugixml.hpp>
#include <regex>

#include "write/xml_text.h"

namespace c1mesh {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

struct Part {
  int pass;
  std::string stage;
  std::vector<double> e_s;
};

// g is ten times, E_reg a tenth of E_s.
std::vector<TraceRecord> records_of(const std::vector<Part>& parts) {
  std::vector<TraceRecord> out;
  for (const Part& part : parts)
    for (std::size_t i = 0; i < part.e_s.size(); ++i) {
      TraceRecord r;
      r.pass = part.pass;
      r.stage = part.stage;
      r.iteration = static_cast<int>(i) + 1;
      r.e_s = part.e_s[i];
      r.g = 10 * r.e_s;
      r.e_reg = 0.1 * r.e_s;
      out.push_back(r);
    }
  return out;
}

pugi::xml_document parsed(const std::vector<TraceRecord>& records, double width = 600) {
  return testing_xml::parsed(draw_trace("a <b> & \"c\"", records, width));
}

std::size_t count(const pugi::xml_document& doc, const std::string& css) {
  return doc.select_nodes(("//*[@class='" + css + "']").c_str()).size();
}

// The points of the one path of this class.
std::vector<std::pair<double, double>> points(const pugi::xml_document& doc,
                                              const std::string& css) {
  const std::string data =
      doc.select_node(("//path[@class='" + css + "']").c_str()).node().attribute("d").as_string();
  static const std::regex pair("[ML](-?[0-9.]+),(-?[0-9.]+)");
  std::vector<std::pair<double, double>> out;
  for (std::sregex_iterator it(data.begin(), data.end(), pair), end; it != end; ++it)
    out.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  return out;
}

TEST(TracePicture, IsWellFormedForAnyTrace) {
  const std::vector<std::vector<TraceRecord>> traces = {
      {},
      records_of({{1, "one", {5}}}),
      records_of({{1, "one", {0, 0}}}),
      records_of({{1, "one", {kInfinite}}, {1, "<two> & \"3\"", {1e-300, kInfinite, 1e300}}}),
      records_of({{1, "one", {-1, 3}}}),
      records_of({{1, "one", std::vector<double>(3000, 2.0)}, {2, "two", {1}}}),
      records_of({{1, "", {std::nan(""), 1, 2}}})};
  for (const auto& records : traces)
    for (const double width : {1.0, 600.0, 2000.0}) {
      const std::string text = draw_trace("a <b> & \"c\"", records, width);
      EXPECT_EQ(text.find("nan"), std::string::npos);
      EXPECT_EQ(text.find("inf,"), std::string::npos);
      EXPECT_EQ(text.find("\"inf"), std::string::npos);
      const auto doc = parsed(records, width);
      EXPECT_STREQ(doc.child("svg").child("title").text().get(), "a <b> & \"c\"");
    }
}

// Each part is a band in each of the three panels, as wide as it has iterations; each stage is in
// the legend by name.
TEST(TracePicture, HasABandForEveryPartAndAKeyForEveryStage) {
  const auto doc = parsed(records_of({{1, "domain", {9, 8, 7}},
                                      {1, "joint", {6}},
                                      {2, "domain", {5, 4}},
                                      {2, "<odd>", {3, 2, 1, 1}}}));
  const auto bands = doc.select_nodes("//rect[@class='band']");
  ASSERT_EQ(bands.size(), 12u);
  const double whole = bands[0].node().attribute("width").as_double() / 3;
  const double parts[] = {3, 1, 2, 4};
  for (int k = 0; k < 12; ++k)
    EXPECT_NEAR(bands[k].node().attribute("width").as_double(), parts[k % 4] * whole, 0.02);
  EXPECT_STREQ(bands[0].node().attribute("fill").as_string(),
               bands[2].node().attribute("fill").as_string());
  EXPECT_STRNE(bands[0].node().attribute("fill").as_string(),
               bands[1].node().attribute("fill").as_string());
  EXPECT_STREQ(bands[3].node().child("title").text().get(), "<odd>, pass 2: 4 iterations");
  EXPECT_EQ(count(doc, "key"), 3u);
  EXPECT_EQ(count(doc, "pass"), 3u);  // between the two passes, in each panel
  for (const char* stage : {"domain", "joint", "<odd>"})
    EXPECT_FALSE(doc.select_nodes((std::string("//text[text()='") + stage + "']").c_str()).empty());
  EXPECT_FALSE(doc.select_nodes("//text[text()='pass 2']").empty());
}

// Equal ratios are equal distances down the page, equal numbers of iterations equal ones across.
TEST(TracePicture, AxesAreLinearAndLogarithmic) {
  const auto doc = parsed(records_of({{1, "one", {1000, 10, 1}}, {1, "two", {0.1, 0.1}}}));
  for (const char* css : {"e_s", "g", "e_reg"}) {
    const auto p = points(doc, css);
    ASSERT_EQ(p.size(), 5u) << css;
    for (int k = 1; k < 5; ++k)
      EXPECT_NEAR(p[k].first - p[k - 1].first, p[1].first - p[0].first, 0.2);
    EXPECT_GT(p[1].second, p[0].second + 10);  // a page's y goes down
    EXPECT_NEAR(p[1].second - p[0].second, 2 * (p[2].second - p[1].second), 0.3);
    EXPECT_NEAR(p[3].second - p[2].second, p[2].second - p[1].second, 0.2);
    EXPECT_EQ(p[4].second, p[3].second);
  }
}

// Where a value is infinite the curve is broken and a bar stands for it; zero lies at the bottom.
TEST(TracePicture, ShowsInfiniteValuesAndZeros) {
  const auto doc = parsed(records_of({{1, "one", {kInfinite, 7, 5, kInfinite, 3, 0}}}));
  const std::string data =
      doc.select_node("//path[@class='e_s']").node().attribute("d").as_string();
  EXPECT_EQ(std::count(data.begin(), data.end(), 'M'), 2);
  EXPECT_EQ(count(doc, "e_s infinite"), 1u);
  EXPECT_EQ(count(doc, "g infinite"), 1u);
  const auto p = points(doc, "e_s");
  ASSERT_EQ(p.size(), 4u);
  const auto band = doc.select_node("//rect[@class='band']").node();
  EXPECT_NEAR(p[3].second, band.attribute("y").as_double() + band.attribute("height").as_double(),
              0.2);
  EXPECT_EQ(count(parsed(records_of({{1, "one", {7, 5}}})), "e_s infinite"), 0u);
}

}  // namespace
}  // namespace c1mesh
