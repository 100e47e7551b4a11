// SPDX-License-Identifier: GPL-3.0-or-later
// Text of a trace: read back bit for bit, and every malformed line refused by its number.
#include "c1mesh/trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "c1mesh/error.h"

namespace c1mesh {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

TraceLine line_of(const std::string& shape, const std::string& stage, int iteration) {
  TraceLine line;
  line.shape = shape;
  line.record.region = 2;
  line.record.pass = 3;
  line.record.stage = stage;
  line.record.iteration = iteration;
  line.record.e_s = 1.0 / 3;
  line.record.e_reg = -2e-308;
  line.record.g = 1e300 / 7;
  line.record.step = 0.1 + 0.2;
  return line;
}

void expect_equal(const TraceLine& a, const TraceLine& b) {
  EXPECT_EQ(a.shape, b.shape);
  EXPECT_EQ(a.record.region, b.record.region);
  EXPECT_EQ(a.record.pass, b.record.pass);
  EXPECT_EQ(a.record.stage, b.record.stage);
  EXPECT_EQ(a.record.iteration, b.record.iteration);
  EXPECT_EQ(a.record.e_s, b.record.e_s);
  EXPECT_EQ(a.record.e_reg, b.record.e_reg);
  EXPECT_EQ(a.record.g, b.record.g);
  EXPECT_EQ(a.record.step, b.record.step);
  EXPECT_EQ(a.record.exceptional, b.record.exceptional);
}

TEST(TraceText, ReadsBackBitForBit) {
  std::vector<TraceLine> lines = {line_of("a \"b\"\n\t\\", "phase one", 1),
                                  line_of("µ {\"e_s\":1}", "", 2147483647), line_of("", "x", 1)};
  lines[1].record.exceptional = 0;
  lines[1].record.g = lines[1].record.e_reg = lines[1].record.e_s = kInfinite;
  lines[2].record.exceptional = 17;
  lines[2].record.e_s = lines[2].record.step = 0;
  lines[2].record.g = std::numeric_limits<double>::denorm_min();
  const std::vector<TraceLine> back = parse_trace(format_trace(lines));
  ASSERT_EQ(back.size(), lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) expect_equal(back[i], lines[i]);
}

TEST(TraceText, IsOneObjectPerLine) {
  std::vector<TraceLine> lines = {line_of("a\nb", "s", 1), line_of("c", "s", 2)};
  lines[1].record.exceptional = 4;
  lines[1].record.g = kInfinite;
  const std::string text = format_trace(lines);
  ASSERT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
  EXPECT_EQ(text.back(), '\n');
  const std::size_t end = text.find('\n');
  const Json first = Json::parse(text.substr(0, end)), second = Json::parse(text.substr(end));
  EXPECT_EQ(first["shape"], "a\nb");
  EXPECT_EQ(first["e_s"], 1.0 / 3);
  EXPECT_FALSE(first.contains("exceptional"));
  EXPECT_EQ(second["exceptional"], 4);
  EXPECT_TRUE(second["g"].is_null());
  EXPECT_EQ(format_trace({}), "");
}

// Nothing that is not a number may reach the file as one.
TEST(TraceText, WritesNullForWhatIsNotFinite) {
  TraceLine line = line_of("a", "s", 1);
  line.record.g = std::nan("");
  line.record.e_s = kInfinite;
  const Json json = Json::parse(format_trace({line}));
  EXPECT_TRUE(json["g"].is_null());
  EXPECT_TRUE(json["e_s"].is_null());
  EXPECT_EQ(parse_trace(json.dump()).at(0).record.g, kInfinite);
}

TEST(TraceText, MayLackItsLastLineEndAndHoldUnknownKeys) {
  Json json = Json::parse(format_trace({line_of("a", "s", 1)}));
  json["remark"] = "of another program";
  EXPECT_EQ(parse_trace(json.dump()).size(), 1u);
  EXPECT_EQ(parse_trace(json.dump() + "\n" + json.dump()).size(), 2u);
  EXPECT_TRUE(parse_trace("").empty());
}

void expect_refused(const std::string& bad) {
  const std::string good = format_trace({line_of("a", "s", 1), line_of("a", "s", 2)});
  try {
    parse_trace(good + bad + "\n" + good);
    ADD_FAILURE() << "accepted: " << bad;
  } catch (const InputError& error) {
    ASSERT_EQ(error.defects().size(), 1u);
    EXPECT_EQ(error.defects()[0].kind, DefectKind::malformed);
    EXPECT_NE(error.defects()[0].message.find("line 3 "), std::string::npos)
        << error.defects()[0].message;
  }
}

TEST(TraceText, RefusesMalformedLinesByTheirNumber) {
  for (const char* bad : {"", "x", "{", "[]", "null", "7", "{}", "{\"shape\":\"a\"}"})
    expect_refused(bad);
  TraceLine whole = line_of("a", "s", 1);
  whole.record.exceptional = 3;
  const Json good = Json::parse(format_trace({whole}));
  expect_refused(good.dump().substr(0, 40));
  expect_refused(good.dump() + good.dump());
  for (const auto& [key, value] : good.items()) {
    if (key != "exceptional") {
      Json missing = good;
      missing.erase(key);
      expect_refused(missing.dump());
    }
    for (const Json& wrong : {Json(Json::array()), Json(true), Json(Json::object())}) {
      Json mutant = good;
      mutant[key] = wrong;
      expect_refused(mutant.dump());
    }
  }
  const std::vector<std::pair<const char*, Json>> values = {
      {"shape", 1},        {"stage", nullptr},
      {"region", -1},      {"region", 0.5},
      {"pass", 0},         {"pass", 2147483648},
      {"iteration", 0},    {"iteration", nullptr},
      {"iteration", "1"},  {"iteration", 18446744073709551615ull},
      {"e_s", -1e-300},    {"e_s", "1"},
      {"g", -1},           {"step", -0.5},
      {"exceptional", -1}, {"exceptional", nullptr}};
  for (const auto& [key, value] : values) {
    Json mutant = good;
    mutant[key] = value;
    expect_refused(mutant.dump());
  }
  std::string huge = good.dump();
  huge.replace(huge.find("\"e_s\":") + 6, 1, "1e999");
  expect_refused(huge);
}

TEST(TraceText, IsToldFromOtherText) {
  EXPECT_TRUE(is_trace(format_trace({line_of("a", "s", 1)})));
  EXPECT_TRUE(is_trace(format_trace({line_of("a", "s", 1)}) + "broken"));
  for (const char* other :
       {"", "{}", "[]", "{\"format\":\"c1mesh\",\"version\":1,\n", "<svg/>", "{\"e_s\":1}"})
    EXPECT_FALSE(is_trace(other)) << other;
}

}  // namespace
}  // namespace c1mesh
