// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/trade_off.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace c1mesh {
namespace {

TEST(TradeOffText, HoldsEveryValueBitForBit) {
  TradeOff curve;
  curve.name = "a \"b\"\n";
  curve.parameters = {{"version", std::string("1")}, {"seed", 7LL}, {"alpha", 0.1}};
  curve.bound = 1000.0 / 3;
  curve.minimum = 3;
  TradeOffPoint p;
  p.asked = 3;
  p.exceptional = 5;
  p.surplus = 2;
  p.g = 20.0 / 3;
  p.g_median = 2.1;
  p.triangles = 22;
  p.d_ei_max = 1e-15 / 3;
  p.regular = p.c1 = true;
  curve.points = {p, p};
  curve.points[1].dominated = true;
  curve.points[1].g = std::numeric_limits<double>::infinity();
  curve.end = TradeOffEnd::most;
  const auto json = nlohmann::json::parse(format_trade_off(curve));
  EXPECT_EQ(json["format"], "c1mesh trade-off");
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["name"], curve.name);
  EXPECT_EQ(json["parameters"], (nlohmann::json{{"version", "1"}, {"seed", 7}, {"alpha", 0.1}}));
  EXPECT_EQ(json["bound"], curve.bound);
  EXPECT_EQ(json["exceptional_minimum"], 3);
  EXPECT_EQ(json["end"], "most");
  ASSERT_EQ(json["points"].size(), 2u);
  EXPECT_EQ(json["points"][0], (nlohmann::json{{"asked", 3},
                                               {"exceptional", 5},
                                               {"surplus", 2},
                                               {"g", 20.0 / 3},
                                               {"g_median", 2.1},
                                               {"triangles", 22},
                                               {"d_ei_max", 1e-15 / 3},
                                               {"regular", true},
                                               {"c1", true},
                                               {"dominated", false}}));
  EXPECT_TRUE(json["points"][1]["g"].is_null());
  EXPECT_EQ(json["points"][1]["dominated"], true);
}

}  // namespace
}  // namespace c1mesh
