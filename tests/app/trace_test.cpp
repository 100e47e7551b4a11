// SPDX-License-Identifier: GPL-3.0-or-later
// run --trace and draw of what it wrote, from the command line.
#include "c1mesh/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "c1mesh/generate.h"
#include "program.h"

namespace c1mesh {
namespace {

using testing_app::Folder;
using testing_app::Ran;
using Json = nlohmann::ordered_json;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Quick shapes: the trapezium, and the same beside a triangle.
const char* const kOne =
    R"([{"curve_id":0,"type":"BezierCurve","degree":1,"poles":[[0,0],[2,0]]},
        {"curve_id":1,"type":"BezierCurve","degree":1,"poles":[[2,0],[1,1]]},
        {"curve_id":2,"type":"BezierCurve","degree":2,"poles":[[1,1],[0.5,1.2],[0,1]]},
        {"curve_id":3,"type":"BezierCurve","degree":1,"poles":[[0,1],[0,0]]}])";
const char* const kTwo =
    R"([{"curve_id":0,"type":"BezierCurve","degree":1,"poles":[[0,0],[2,0]]},
        {"curve_id":1,"type":"BezierCurve","degree":1,"poles":[[2,0],[1,1]]},
        {"curve_id":2,"type":"BezierCurve","degree":2,"poles":[[1,1],[0.5,1.2],[0,1]]},
        {"curve_id":3,"type":"BezierCurve","degree":1,"poles":[[0,1],[0,0]]},
        {"curve_id":4,"type":"BezierCurve","degree":1,"poles":[[3,0],[4,0]]},
        {"curve_id":5,"type":"BezierCurve","degree":1,"poles":[[4,0],[3,1]]},
        {"curve_id":6,"type":"BezierCurve","degree":2,"poles":[[3,1],[2.9,0.5],[3,0]]}])";

std::string without_seconds(const std::string& text) {
  Json json = Json::parse(text);
  json["metrics"].erase("seconds");
  return json.dump();
}

TEST(TraceCommand, WritesOneFileOfAllShapesAndChangesNoResult) {
  const Folder folder;
  folder.write("one.json", kOne);
  folder.write("two.json", kTwo);
  const Ran ran = folder.run("run one.json two.json -o out --formats json --trace new/t.jsonl");
  ASSERT_EQ(ran.status, 0) << ran.err;
  ASSERT_EQ(folder.run("run one.json two.json -o plain --formats json").status, 0);
  EXPECT_EQ(folder.files("new"), std::vector<std::string>{"t.jsonl"});
  for (const char* name : {"one", "two"}) {
    const std::string file = std::string("/") + name + ".c1.json";
    EXPECT_EQ(without_seconds(folder.read("out" + file)),
              without_seconds(folder.read("plain" + file)));
  }
  const std::vector<TraceLine> lines = parse_trace(folder.read("new/t.jsonl"));
  const auto count = [&](const std::string& shape, int region) {
    return std::count_if(lines.begin(), lines.end(), [&](const TraceLine& line) {
      return line.shape == shape && line.record.region == region;
    });
  };
  EXPECT_GT(count("one", 0), 5);
  EXPECT_EQ(count("one", 1), 0);
  EXPECT_GT(count("two", 0), 5);
  EXPECT_GT(count("two", 1), 5);
  EXPECT_EQ(lines.front().shape, "one");
  EXPECT_EQ(lines.back().shape, "two");
}

TEST(TraceCommand, WritesTheFileThoughAShapeFails) {
  const Folder folder;
  folder.write("one.json", kOne);
  folder.write("bad.json", "[{");
  const Ran ran = folder.run("run bad.json one.json absent.json -o out --trace t.jsonl");
  EXPECT_EQ(ran.status, 3) << ran.err;
  EXPECT_EQ(parse_trace(folder.read("t.jsonl")).front().shape, "one");
  EXPECT_EQ(folder.run("run bad.json -o out --trace none.jsonl").status, 3);
  const std::vector<std::string> files = folder.files();
  EXPECT_EQ(std::count(files.begin(), files.end(), "none.jsonl"), 1);
  EXPECT_EQ(folder.read("none.jsonl"), "");
  const Ran drawn = folder.run("draw none.jsonl -o none.svg");
  EXPECT_EQ(drawn.status, 3);
  EXPECT_TRUE(contains(drawn.err, "no iterations")) << drawn.err;
}

TEST(TraceCommand, CannotWriteIsStatusOne) {
  const Folder folder;
  folder.write("one.json", kOne);
  const Ran ran = folder.run("run one.json -o out --formats json --trace one.json/t.jsonl");
  EXPECT_EQ(ran.status, 1) << ran.err;
  EXPECT_EQ(folder.files("out"), std::vector<std::string>{"one.c1.json"});
}

// By its extension or by its content; the first shape and region unless others are asked for.
TEST(TraceCommand, DrawTellsATraceFromAResult) {
  const Folder folder;
  folder.write("one.json", kOne);
  folder.write("two.json", kTwo);
  ASSERT_EQ(folder.run("run one.json two.json -o out --formats json --trace t.jsonl").status, 0);
  folder.write("renamed", folder.read("t.jsonl"));
  ASSERT_EQ(folder.run("draw t.jsonl -o a.svg").status, 0);
  ASSERT_EQ(folder.run("draw renamed -o b.svg --shape one --region 0").status, 0);
  EXPECT_EQ(folder.read("a.svg"), folder.read("b.svg"));
  EXPECT_TRUE(contains(folder.read("a.svg"), "<title>one</title>"));
  for (const char* stage : {"domain", "joint", "continuation", "exact"})
    EXPECT_TRUE(contains(folder.read("a.svg"), std::string(">") + stage + "</text>")) << stage;
  ASSERT_EQ(folder.run("draw t.jsonl --shape two --region 1 --width 600 -o c.svg").status, 0);
  EXPECT_TRUE(contains(folder.read("c.svg"), "<title>two, region 1</title>"));
  EXPECT_TRUE(contains(folder.read("c.svg"), "width=\"600\""));
  ASSERT_EQ(folder.run("draw out/one.c1.json -o d.svg").status, 0);
  EXPECT_FALSE(contains(folder.read("d.svg"), "continuation"));
}

TEST(TraceCommand, DrawSaysWhatIsWrong) {
  const Folder folder;
  folder.write("one.json", kOne);
  ASSERT_EQ(folder.run("run one.json -o out --formats json --trace t.jsonl").status, 0);
  folder.write("broken.jsonl", folder.read("t.jsonl") + "{\"shape\":");
  for (const char* arguments :
       {"broken.jsonl", "t.jsonl --shape two", "t.jsonl --region 1", "absent.jsonl"}) {
    const Ran ran = folder.run(std::string("draw -o x.svg ") + arguments);
    EXPECT_EQ(ran.status, 3) << arguments << ran.err;
    EXPECT_NE(ran.err, "");
  }
  EXPECT_EQ(folder.run("draw out/one.c1.json --region 0 -o x.svg").status, 2);
  EXPECT_EQ(folder.run("draw t.jsonl --region -1 -o x.svg").status, 2);
  const std::vector<std::string> files = folder.files();
  EXPECT_EQ(std::count(files.begin(), files.end(), "x.svg"), 0);
}

}  // namespace
}  // namespace c1mesh
