// SPDX-License-Identifier: GPL-3.0-or-later
// Every single-field mutation of a good file must be refused, with a message.
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "c1mesh/error.h"
#include "result/example_results.h"

namespace c1mesh {
namespace {

using Json = nlohmann::ordered_json;

Json good() {
  return Json::parse(format_result(example::square()));
}

void expect_refused(const std::string& text, const std::string& what) {
  try {
    parse_result(text, "mutant");
    ADD_FAILURE() << "accepted: " << what;
  } catch (const InputError& error) {
    ASSERT_EQ(error.defects().size(), 1u);
    EXPECT_FALSE(error.defects()[0].message.empty());
  }
}

TEST(Parse, AcceptsTheOriginalAndUnknownKeys) {
  Json root = good();
  root["remark"] = "kept by another program";
  EXPECT_NO_THROW(parse_result(root.dump(), "good"));
}

TEST(Parse, RefusesEveryMissingKeyAndEveryWrongType) {
  const Json original = good();
  for (const auto& [key, value] : original.items()) {
    Json missing = good();
    missing.erase(key);
    expect_refused(missing.dump(), "without " + key);
    for (const Json& wrong :
         {Json(nullptr), Json("text"), Json(1.5), Json(Json::array({Json::array()}))}) {
      Json mutant = good();
      mutant[key] = wrong;
      expect_refused(mutant.dump(), key + " = " + wrong.dump());
    }
  }
}

TEST(Parse, RefusesEveryMissingMetric) {
  const Json metrics = good()["metrics"];
  for (const auto& [key, value] : metrics.items()) {
    Json missing = good();
    missing["metrics"].erase(key);
    expect_refused(missing.dump(), "without metrics." + key);
    Json mutant = good();
    mutant["metrics"][key] = "text";
    expect_refused(mutant.dump(), "metrics." + key + " as text");
  }
}

TEST(Parse, RefusesBadValues) {
  const std::vector<std::pair<std::string, std::function<void(Json&)>>> mutations{
      {"format", [](Json& r) { r["format"] = "other"; }},
      {"version", [](Json& r) { r["version"] = 2; }},
      {"degree 0", [](Json& r) { r["degree"] = 0; }},
      {"another degree", [](Json& r) { r["degree"] = 4; }},
      {"huge degree", [](Json& r) { r["degree"] = 2000000000; }},
      {"three coordinates",
       [](Json& r) {
         r["domain_vertices"][0] = {0, 0, 0};
       }},
      {"coordinate as text", [](Json& r) { r["control_points"][3][1] = "0"; }},
      {"coordinate null", [](Json& r) { r["control_points"][3][1] = nullptr; }},
      {"vertex id too large", [](Json& r) { r["triangles"][0][1] = 4; }},
      {"vertex id negative", [](Json& r) { r["triangles"][0][1] = -1; }},
      {"vertex id fractional", [](Json& r) { r["triangles"][0][1] = 1.0; }},
      {"vertex id beyond 64 bits", [](Json& r) { r["triangles"][0][1] = 18446744073709551615ull; }},
      {"vertex twice", [](Json& r) { r["triangles"][0][1] = 0; }},
      {"control id too large", [](Json& r) { r["triangle_control_points"][1][2] = 16; }},
      {"net too short", [](Json& r) { r["triangle_control_points"][1].erase(0); }},
      {"net too long", [](Json& r) { r["triangle_control_points"][1].push_back(0); }},
      {"net missing", [](Json& r) { r["triangle_control_points"].erase(1); }},
      {"curve without poles", [](Json& r) { r["curves"][0].erase("poles"); }},
      {"curve of one pole",
       [](Json& r) {
         r["curves"][0]["poles"] = {{0, 0}};
       }},
      {"curve id", [](Json& r) { r["boundary_edges"][0][2] = 4; }},
      {"edge vertex id", [](Json& r) { r["boundary_edges"][0][0] = 9; }},
      {"edge with four items", [](Json& r) { r["boundary_edges"][0].erase(4); }},
      {"edge parameter above 1", [](Json& r) { r["boundary_edges"][0][4] = 1.5; }},
      {"edge parameter below 0", [](Json& r) { r["boundary_edges"][0][3] = -0.5; }},
      {"edge with empty interval", [](Json& r) { r["boundary_edges"][0][3] = 1; }},
      {"feature edge",
       [](Json& r) {
         r["feature_edges"].push_back({0, 2, 7, 0, 1});
       }},
      {"boundary vertex word", [](Json& r) { r["boundary_vertices"][0][1] = "round"; }},
      {"boundary vertex id", [](Json& r) { r["boundary_vertices"][0][0] = 4; }},
      {"exceptional vertex id", [](Json& r) { r["exceptional_vertices"] = {4}; }},
      {"relaxed edge id",
       [](Json& r) {
         r["relaxed_edges"] = {{0, 4}};
       }},
      {"relaxed edge of one vertex",
       [](Json& r) {
         r["relaxed_edges"] = {{0, 0}};
       }},
      {"parameter list", [](Json& r) { r["parameters"]["x"] = Json::array(); }},
      {"seconds as text", [](Json& r) { r["metrics"]["seconds"]["mesh"] = "1"; }},
      {"count with fraction", [](Json& r) { r["metrics"]["triangles"] = 1.5; }},
  };
  for (const auto& [what, mutate] : mutations) {
    Json root = good();
    mutate(root);
    expect_refused(root.dump(), what);
  }
}

TEST(Parse, RefusesWhatIsNotJsonAndNumbersTooLargeForADouble) {
  const std::string text = format_result(example::square());
  for (const std::string bad : {"", "[]", "null", "{", "NaN"}) expect_refused(bad, bad);
  expect_refused(text.substr(0, text.size() / 2), "half a file");
  std::string huge = text;
  huge.replace(huge.find("[1,0]"), 5, "[1e999,0]");
  expect_refused(huge, "1e999");
  expect_refused(std::string(100000, '['), "deep nesting");
}

}  // namespace
}  // namespace c1mesh
