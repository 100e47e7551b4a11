// SPDX-License-Identifier: GPL-3.0-or-later
// The program from an input file to verified results.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "c1mesh/result.h"
#include "c1mesh/verify.h"
#include "program.h"

namespace c1mesh {
namespace {

using testing_app::Folder;
using testing_app::Ran;

std::string example(const std::string& name) {
  return C1MESH_EXAMPLES "/" + name;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class Examples : public testing::TestWithParam<const char*> {};

TEST_P(Examples, AreDoneWithoutExceptionalVerticesBeyondTheMinimum) {
  const Folder folder;
  const std::string name = GetParam();
  const Ran ran = folder.run("run -o out " + example(name + ".svg"));
  ASSERT_TRUE(ran.status == 0 || ran.status == 4) << ran.err;
  EXPECT_EQ(folder.files("out"), (std::vector<std::string>{name + ".c1.json", name + ".svg"}));
  EXPECT_EQ(folder.run("verify out/" + name + ".c1.json --input " + example(name + ".svg")).status,
            0);
  const Result result = parse_result(folder.read("out/" + name + ".c1.json"), name);
  const Metrics measured = verify(result).metrics;
  EXPECT_LE(measured.conformance_max, 1e-13);
  EXPECT_LE(measured.d_ei.max, 1e-12);
  EXPECT_GT(measured.mips_bound_max, 2 - 1e-9);
  EXPECT_EQ(measured.surplus, 0);
}

INSTANTIATE_TEST_SUITE_P(All, Examples,
                         testing::Values("blob", "puzzle", "annulus", "spiral", "letter",
                                         "clipart"),
                         [](const auto& test) { return std::string(test.param); });

// Four convex corners over a quadrilateral: no exceptional vertex is needed (the paper's fig. 13).
TEST(Pipeline, PuzzlePieceHasNoExceptionalVertex) {
  const Folder folder;
  const Ran ran = folder.run("run -o out " + example("puzzle.svg"));
  ASSERT_EQ(ran.status, 0) << ran.err;
  const auto json = nlohmann::json::parse(folder.read("out/puzzle.c1.json"));
  EXPECT_TRUE(json["exceptional_vertices"].empty());
}

// 1 leaves the triangles as they are, 3 gives three times as many at the most.
TEST(Pipeline, RefineLowersTheDistortionWithinItsTrianglesAndIsRecorded) {
  const Folder folder;
  std::map<double, Result> results;
  for (const char* factor : {"1", "3"}) {
    const std::string out = std::string("out") + factor;
    const Ran ran = folder.run("run --refine " + std::string(factor) + " -o " + out + " " +
                               example("blob.svg"));
    ASSERT_EQ(ran.status, 0) << ran.err;
    const Result result = parse_result(folder.read(out + "/blob.c1.json"), "blob");
    const auto recorded =
        std::find_if(result.parameters.begin(), result.parameters.end(),
                     [](const auto& parameter) { return parameter.first == "refine"; });
    ASSERT_NE(recorded, result.parameters.end());
    EXPECT_EQ(std::get<double>(recorded->second), std::stod(factor));
    results[std::stod(factor)] = result;
  }
  const Metrics plain = verify(results[1]).metrics, fine = verify(results[3]).metrics;
  EXPECT_GT(fine.triangles, plain.triangles);
  EXPECT_LE(fine.triangles, 3 * plain.triangles);
  EXPECT_LT(fine.mips_bound_max, plain.mips_bound_max);
  EXPECT_LE(fine.d_ei.max, 1e-12);
  EXPECT_LE(fine.conformance_max, 1e-13);
}

TEST(Pipeline, BytesDoNotDependOnTheNumberOfThreads) {
  const Folder folder;
  ASSERT_EQ(folder.run("run -o one --threads 1 " + example("blob.svg")).status,
            folder.run("run -o two --threads 4 " + example("blob.svg")).status);
  auto one = nlohmann::json::parse(folder.read("one/blob.c1.json"));
  auto two = nlohmann::json::parse(folder.read("two/blob.c1.json"));
  for (auto* json : {&one, &two}) {
    (*json)["metrics"].erase("seconds");
    (*json)["parameters"].erase("threads");
  }
  EXPECT_EQ(one.dump(), two.dump());
}

TEST(Pipeline, EqualNamesDoNotOverwriteEachOther) {
  const Folder folder;
  ASSERT_EQ(folder.run("generate --set A --count 1 --formats json,svg -o in").status, 0);
  const Ran ran = folder.run("run in/A-0001.json in/A-0001.svg -o out --formats json");
  EXPECT_TRUE(ran.status == 0 || ran.status == 4) << ran.err;
  EXPECT_EQ(folder.files("out"), (std::vector<std::string>{"A-0001-2.c1.json", "A-0001.c1.json"}));
  EXPECT_TRUE(contains(ran.err, "A-0001-2")) << ran.err;
}

TEST(Pipeline, OneBadInputDoesNotStopTheOthersAndDecidesTheStatus) {
  const Folder folder;
  folder.write("bad.json", "[]");
  const Ran ran = folder.run("run bad.json " + example("blob.svg") + " -o out");
  EXPECT_EQ(ran.status, 3);
  EXPECT_EQ(folder.files("out"), (std::vector<std::string>{"blob.c1.json", "blob.svg"}));
}

// g = |J|^2 / det J is at least 2 everywhere, with equality for similarities only; a map from a
// polygon to a smooth blob is far from one, so alpha * mips-bound = 2.01 cannot hold.
TEST(Pipeline, AMissedBoundIsStatusFour) {
  const Folder folder;
  const Ran ran =
      folder.run("run --exceptional 3 --alpha 1 --mips-bound 3 -o out " + example("blob.svg"));
  EXPECT_EQ(ran.status, 4) << ran.err;
  EXPECT_TRUE(contains(ran.err, "exceeds")) << ran.err;
  EXPECT_EQ(folder.files("out"), (std::vector<std::string>{"blob.c1.json", "blob.svg"}));
}

TEST(Pipeline, AllFormatsAndConversionsAgree) {
  const Folder folder;
  ASSERT_EQ(folder.run("run --formats json,svg,html,vtu,msh,mesh,obj -o out " + example("blob.svg"))
                .status,
            0);
  const std::vector<std::string> files = {
      "blob.c1.json", "blob.domain.mesh", "blob.domain.msh", "blob.domain.vtu", "blob.html",
      "blob.mesh",    "blob.msh",         "blob.obj",        "blob.svg",        "blob.vtu"};
  EXPECT_EQ(folder.files("out"), files);
  for (const std::string& file : files) {
    ASSERT_EQ(folder.run("convert out/blob.c1.json -o " + file).status, 0);
    EXPECT_EQ(folder.read(file), folder.read("out/" + file)) << file;
  }
  const Ran drawn = folder.run("draw out/blob.c1.json -o -");
  EXPECT_EQ(drawn.status, 0);
  EXPECT_EQ(drawn.out, folder.read("out/blob.svg"));
}

// Gmsh ends at degree 10: said before the work, and the other formats go further.
TEST(Pipeline, MshOfTooHighADegreeIsRefusedAtOnce) {
  const Folder folder;
  const Ran ran = folder.run("run --formats msh --degree 11 -o out " + example("blob.svg"));
  EXPECT_EQ(ran.status, 3) << ran.err;
  EXPECT_TRUE(contains(ran.err, "msh")) << ran.err;
  EXPECT_TRUE(folder.files("out").empty());
}

TEST(Pipeline, StandardOutputCarriesTheResultAlone) {
  const Folder folder;
  const Ran ran = folder.run("run -o - " + example("blob.svg"));
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(parse_result(ran.out, "blob").name, "blob");
  EXPECT_TRUE(folder.files().empty());
}

// The result is what it is without the option.
TEST(Pipeline, TradeOffIsWrittenBesideTheResult) {
  const Folder folder;
  ASSERT_EQ(folder.run("run -o plain " + example("blob.svg")).status, 0);
  const Ran ran = folder.run("run --trade-off --threads 1 -o out " + example("blob.svg"));
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(folder.files("out"),
            (std::vector<std::string>{"blob.c1.json", "blob.svg", "blob.tradeoff.json",
                                      "blob.tradeoff.svg"}));
  EXPECT_EQ(folder.read("out/blob.c1.json"), folder.read("plain/blob.c1.json"));
  const auto json = nlohmann::json::parse(folder.read("out/blob.tradeoff.json"));
  for (const auto& point : json["points"])
    EXPECT_TRUE(contains(ran.err, std::to_string(point["exceptional"].get<int>()) + " exceptional"))
        << ran.err;
  ASSERT_EQ(folder.run("run --trade-off --threads 4 -o again " + example("blob.svg")).status, 0);
  for (const char* file : {"/blob.tradeoff.json", "/blob.tradeoff.svg"})
    EXPECT_EQ(folder.read(std::string("again") + file), folder.read(std::string("out") + file));
}

TEST(Pipeline, TheTimeLimitIsForResultAndTradeOffTogether) {
  const Folder folder;
  const Ran ran = folder.run("run --trade-off --time-limit 1e-9 -o out " + example("blob.svg"));
  EXPECT_EQ(ran.status, 5) << ran.err;
  const auto json = nlohmann::json::parse(folder.read("out/blob.tradeoff.json"));
  EXPECT_EQ(json["end"], "time limit");
  EXPECT_TRUE(json["points"].empty());
}

// One moved control point breaks C1 or conformance: verify must see it.
TEST(Pipeline, VerifySeesAMovedControlPoint) {
  const Folder folder;
  ASSERT_EQ(folder.run("run -o out " + example("blob.svg")).status, 0);
  auto json = nlohmann::json::parse(folder.read("out/blob.c1.json"));
  json["control_points"][0][0] = json["control_points"][0][0].get<double>() + 1e-3;
  folder.write("moved.c1.json", json.dump());
  EXPECT_EQ(folder.run("verify moved.c1.json").status, 4);
  folder.write("cut.c1.json", json.dump().substr(0, 1000));
  EXPECT_EQ(folder.run("verify cut.c1.json").status, 3);
}

TEST(Pipeline, ASignalEndsWithStatusFiveAndWritesNothing) {
  const Folder folder;
  ASSERT_EQ(folder.run("generate --set C --count 40 -o in").status, 0);
  const Ran ran = folder.run("run in/*.json -o out & pid=$!; sleep 0.3; kill -INT $pid; wait $pid");
  // The shell starts background jobs with SIGINT ignored, unless the program installs a handler.
  EXPECT_EQ(ran.status, 5) << ran.err;
  for (const std::string& file : folder.files("out"))
    EXPECT_TRUE(file.ends_with(".c1.json") || file.ends_with(".svg")) << file;
}

TEST(Pipeline, ATinyTimeLimitIsStatusFive) {
  const Folder folder;
  EXPECT_EQ(folder.run("run --time-limit 1e-9 -o out " + example("spiral.svg")).status, 5);
}

}  // namespace
}  // namespace c1mesh
