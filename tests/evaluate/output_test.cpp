// SPDX-License-Identifier: GPL-3.0-or-later
// Tables and pictures, read back.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "c1mesh/evaluate.h"
#include "examples.h"

namespace c1mesh {
namespace {

using Json = nlohmann::json;
using Rows = std::vector<std::vector<std::string>>;

constexpr const char* kNasty = "a,\"b\" & <c>\nd";

ShapeEvaluation named(const std::string& name, const Result& result) {
  ShapeEvaluation shape = evaluate(result);
  shape.name = name;
  return shape;
}

/// Two sets: one with a failure, a name that asks for quoting and a shape without time; one whose
/// results are all failures.
Evaluation example_evaluation() {
  std::vector<ShapeEvaluation> shapes = {named("bent", example::bent_square(0x1p-20)),
                                         named(kNasty, example::notched()),
                                         named("flat", example::square())};
  shapes[0].status = 4;
  shapes[0].seconds = 2.5;
  ShapeEvaluation failed;
  failed.name = "lost\nline";
  failed.status = 1;
  failed.fault = "no result";
  shapes.push_back(failed);
  Evaluation out;
  out.series.push_back(make_series("A & B", shapes));
  out.series.push_back(make_series("none", {failed}));
  return out;
}

/// RFC 4180 with line feeds.
Rows parse_csv(const std::string& text) {
  Rows rows = {{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"')
      rows.back().back() += text[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted && c == ',')
      rows.back().emplace_back();
    else if (!quoted && c == '\n')
      rows.push_back({""});
    else
      rows.back().back() += c;
  }
  EXPECT_FALSE(quoted);
  EXPECT_EQ(rows.back(), std::vector<std::string>{""});  // the text ends with a line's end
  rows.pop_back();
  return rows;
}

void expect_well_formed(const std::string& svg) {
  pugi::xml_document doc;
  const pugi::xml_parse_result read = doc.load_string(svg.c_str());
  EXPECT_TRUE(read) << read.description();
  EXPECT_STREQ(doc.document_element().name(), "svg");
  // Parsers differ in what they forgive.
  for (const auto& found : doc.select_nodes("//text")) EXPECT_STRNE(found.node().child_value(), "");
  EXPECT_FALSE(doc.select_nodes("//path").empty());
  for (const auto& found : doc.select_nodes("//path"))
    EXPECT_EQ(found.node().attribute("d").as_string()[0], 'M');
}

TEST(Csv, ALinePerShapeWithACellPerHead) {
  const Evaluation evaluation = example_evaluation();
  const Rows rows = parse_csv(format_evaluation_csv(evaluation));
  ASSERT_EQ(rows.size(), 6u);
  std::map<std::string, std::size_t> column;
  for (std::size_t k = 0; k < rows[0].size(); ++k) column[rows[0][k]] = k;
  EXPECT_EQ(column.size(), rows[0].size());  // no head twice
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  const auto cell = [&](std::size_t row, const std::string& name) {
    return rows[row][column.at(name)];
  };
  EXPECT_EQ(cell(1, "name"), kNasty);  // sorted by bytes: "," before letters
  EXPECT_EQ(cell(1, "series"), "A & B");
  EXPECT_EQ(cell(1, "seconds"), "");
  EXPECT_EQ(cell(1, "minimum"), "1");
  EXPECT_EQ(cell(1, "minimum_paper"), "0");
  EXPECT_EQ(cell(2, "name"), "bent");
  EXPECT_EQ(cell(2, "status"), "4");
  EXPECT_EQ(cell(2, "seconds"), "2.5");
  EXPECT_EQ(cell(2, "c1"), "0");
  // Numbers read back bit for bit.
  const Metrics& m = evaluation.series[0].shapes[1].metrics;
  EXPECT_EQ(std::strtod(cell(2, "d_ei_max").c_str(), nullptr), m.d_ei.max);
  EXPECT_EQ(std::strtod(cell(2, "gradient_angle_deg_max").c_str(), nullptr),
            m.gradient_angle_deg.max);
  EXPECT_EQ(std::strtod(cell(2, "g").c_str(), nullptr), m.mips_bound_max);
  EXPECT_EQ(cell(4, "fault"), "no result");
  EXPECT_EQ(cell(4, "triangles"), "");
  EXPECT_EQ(cell(5, "series"), "none");
}

/// The counts of a histogram's bins are those of its sample.
void expect_sums(const Json& value) {
  if (value.is_object() && value.contains("histogram")) {
    const Json& h = value["histogram"];
    std::size_t sum = h["zeros"].get<std::size_t>() + h["infinite"].get<std::size_t>();
    for (const Json& count : h["counts"]) sum += count.get<std::size_t>();
    EXPECT_EQ(sum, value["count"].get<std::size_t>());
  }
  if (value.is_structured())
    for (const Json& item : value) expect_sums(item);
}

TEST(JsonOutput, HistogramsSumUpAndCountsAgree) {
  const Json json = Json::parse(format_evaluation(example_evaluation()));
  expect_sums(json);
  const Json& first = json["series"][0];
  EXPECT_EQ(first["label"], "A & B");
  const Json& summary = first["summary"];
  EXPECT_EQ(summary["shapes"], 4);
  EXPECT_EQ(summary["failures"], 1);
  EXPECT_EQ(summary["statuses"], Json::parse("[[1,1],[4,1]]"));
  std::size_t values = 0, exceptional = 0;
  for (const Json& shape : first["shapes"])
    if (shape["evaluated"]) values += shape["d_ei"]["count"].get<std::size_t>();
  EXPECT_EQ(summary["d_ei"]["all"]["count"], values);
  EXPECT_EQ(values, 3u + 3u + 3u * 72);
  for (const Json& pair : summary["exceptional"]) exceptional += pair[1].get<std::size_t>();
  EXPECT_EQ(exceptional, 3u);
  EXPECT_TRUE(json["compared"].empty());
}

TEST(JsonOutput, WhatIsUnknownOrInfiniteIsNull) {
  Result flipped = example::square();
  flipped.control_points[example::control_id(flipped, 0, 1, 1)] += Point(-3, 3);
  Evaluation evaluation;
  evaluation.series.push_back(make_series("S", {named("flipped", flipped)}));
  const Json shape = Json::parse(format_evaluation(evaluation))["series"][0]["shapes"][0];
  EXPECT_TRUE(shape["g"].is_null());
  EXPECT_TRUE(shape["status"].is_null());
  EXPECT_TRUE(shape["seconds"].is_null());
  EXPECT_EQ(shape["regular"], false);
}

// Names come from files: they break no line.
TEST(TextTable, NamesColumnsAndFailures) {
  const std::string text = evaluation_text(example_evaluation());
  EXPECT_NE(text.find("A & B"), std::string::npos);
  EXPECT_NE(text.find("A & B: lost?line: no result"), std::string::npos);
  EXPECT_NE(text.find("none: lost?line: no result"), std::string::npos);
}

TEST(Pictures, AreWellFormedWithAndWithoutComparison) {
  Evaluation evaluation = example_evaluation();
  for (const bool compare : {false, true}) {
    if (compare) evaluation.compared = example_evaluation().series;
    for (const std::string& svg : {draw_histograms(evaluation), draw_projection(evaluation)}) {
      expect_well_formed(svg);
      EXPECT_NE(svg.find("A &amp; B"), std::string::npos);
      EXPECT_EQ(svg.find("nan"), std::string::npos);
      EXPECT_EQ(svg.find("inf"), std::string::npos);
      EXPECT_EQ(svg.find("class=\"all-light\"") != std::string::npos, compare);
    }
  }
}

// The heights of the bars of a layer, over the height of the axis, sum up to 100 percent: four
// shapes of the notched kind give the same layer as one.
TEST(Pictures, SharesDoNotDependOnHowManyShapesThereAre) {
  const auto picture = [](int count) {
    std::vector<ShapeEvaluation> shapes;
    for (int k = 0; k < count; ++k)
      shapes.push_back(named(std::to_string(k), example::bent_square(0x1p-20)));
    Evaluation evaluation;
    evaluation.series.push_back(make_series("S", shapes));
    std::string svg = draw_projection(evaluation);
    // All but the number of shapes under the column's title.
    const std::string words = std::to_string(count) + (count == 1 ? " shape" : " shapes");
    const std::size_t at = svg.find(words);
    EXPECT_NE(at, std::string::npos);
    return svg.erase(at, words.size());
  };
  EXPECT_EQ(picture(1), picture(4));
}

TEST(Outputs, AreTheSameBytesEveryTime) {
  const Evaluation one = example_evaluation(), two = example_evaluation();
  EXPECT_EQ(format_evaluation(one), format_evaluation(two));
  EXPECT_EQ(format_evaluation_csv(one), format_evaluation_csv(two));
  EXPECT_EQ(evaluation_text(one), evaluation_text(two));
  EXPECT_EQ(draw_histograms(one), draw_histograms(two));
}

}  // namespace
}  // namespace c1mesh
