// SPDX-License-Identifier: GPL-3.0-or-later
// run --method paper and project, as commands.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "c1mesh/result.h"
#include "c1mesh/verify.h"
#include "program.h"

namespace c1mesh {
namespace {

using testing_app::Folder;
using testing_app::Ran;

const std::string kBlob = C1MESH_EXAMPLES "/blob.svg";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

nlohmann::json parameters_of(const Folder& folder, const std::string& file) {
  return nlohmann::json::parse(folder.read(file))["parameters"];
}

TEST(PaperCommand, WritesAResultThatVerifies) {
  const Folder folder;
  const Ran ran = folder.run("run --method paper -o out " + kBlob);
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(folder.files("out"), (std::vector<std::string>{"blob.c1.json", "blob.svg"}));
  EXPECT_EQ(folder.run("verify out/blob.c1.json --input " + kBlob).status, 0);
  const auto parameters = parameters_of(folder, "out/blob.c1.json");
  EXPECT_EQ(parameters["method"], "paper");
  EXPECT_EQ(parameters["lambda_reg_one"], 1e-6);
  EXPECT_EQ(parameters["lambda_reg_two"], 1e-8);
  EXPECT_EQ(parameters["lambda_hard_one"], 100);
  EXPECT_EQ(parameters["lambda_hard_two"], 1);
  EXPECT_EQ(parameters["iterations_one"], 300);
  EXPECT_EQ(parameters["iterations_two"], 60);
}

// "A" is for both phases, "A,B" one for each.
TEST(PaperCommand, OptionsTakeOneValueOrTwo) {
  const Folder folder;
  // A drawing right behind one value is not taken for the second.
  const Ran ran = folder.run(
      "run --method paper --last-stage one --iterations 3,2 --lambda-hard 50,2 "
      "--smoothing 1e-3,1e-4 --rho 0.2 --alpha-lift 2 --straighten fractions --repeat 2 -o out "
      "--lambda-reg 1e-7 " +
      kBlob);
  EXPECT_EQ(ran.status, 4) << ran.err;  // it claims C1 nowhere
  const auto parameters = parameters_of(folder, "out/blob.c1.json");
  EXPECT_EQ(parameters["lambda_reg_one"], 1e-7);
  EXPECT_EQ(parameters["lambda_reg_two"], 1e-7);
  EXPECT_EQ(parameters["iterations_one"], 3);
  EXPECT_EQ(parameters["iterations_two"], 2);
  EXPECT_EQ(parameters["lambda_hard_one"], 50);
  EXPECT_EQ(parameters["lambda_hard_two"], 2);
  EXPECT_EQ(parameters["smoothing_first"], 1e-3);
  EXPECT_EQ(parameters["smoothing_last"], 1e-4);
  EXPECT_EQ(parameters["rho"], 0.2);
  EXPECT_EQ(parameters["alpha_lift"], 2);
  EXPECT_EQ(parameters["straightening"], "fractions");
  EXPECT_EQ(parameters["repeat"], 2);
}

class WrongPaperCommandLine : public testing::TestWithParam<const char*> {};

TEST_P(WrongPaperCommandLine, IsStatusTwoAndWritesNothing) {
  const Folder folder;
  const Ran ran = folder.run(std::string(GetParam()) + " " + kBlob);
  EXPECT_EQ(ran.status, 2) << ran.err;
  EXPECT_NE(ran.err, "");
  EXPECT_TRUE(folder.files().empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongPaperCommandLine,
    testing::Values(
        "run -o out --method newton", "run -o out --method",
        "run -o out --method paper --lambda-reg -1", "run -o out --method paper --lambda-reg 1,2,3",
        "run -o out --method paper --lambda-reg 1,x", "run -o out --method paper --lambda-hard nan",
        "run -o out --method paper --iterations 0", "run -o out --method paper --iterations 5,0",
        "run -o out --method paper --iterations 2.5", "run -o out --method paper --smoothing 0",
        "run -o out --method paper --smoothing 1e-3,-1", "run -o out --method paper --rho 0",
        "run -o out --method paper --extent -1", "run -o out --method paper --alpha-lift 0.5",
        "run -o out --method paper --straighten sideways",
        "run -o out --method paper --last-stage three", "run -o out --method paper --c1-bound 0",
        "run -o out --method paper --repeat 0", "project", "project -o out --conformance-bound 0",
        "project -o out --conformance-bound x"));

TEST(PaperCommand, ProjectionIsForThisMethodOnly) {
  const Folder folder;
  const Ran ran = folder.run("run --project -o out " + kBlob);
  EXPECT_EQ(ran.status, 2) << ran.err;
  EXPECT_TRUE(contains(ran.err, "project")) << ran.err;
  EXPECT_TRUE(folder.files().empty());
}

// The command does to the file what --project does in the run.
TEST(ProjectCommand, MakesAFileExactlyC1) {
  const Folder folder;
  const std::string run = "run --method paper --iterations 100,30 --formats json ";
  ASSERT_NE(folder.run(run + "-o out " + kBlob).status, 1);
  const Ran ran = folder.run("project out/blob.c1.json -o projected");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(contains(ran.err, "valid")) << ran.err;
  EXPECT_EQ(folder.files("projected"), std::vector<std::string>{"blob.c1.json"});
  const Result before = parse_result(folder.read("out/blob.c1.json"), "blob");
  const Result after = parse_result(folder.read("projected/blob.c1.json"), "blob");
  EXPECT_GT(verify(before).metrics.d_ei.max, 1e-9);
  EXPECT_LE(verify(after).metrics.d_ei.max, 1e-13);
  EXPECT_EQ(after.metrics.d_ei.max, verify(after).metrics.d_ei.max);
  EXPECT_EQ(folder.run("verify projected/blob.c1.json").status, 0);
  ASSERT_EQ(folder.run(run + "--project -o at_once " + kBlob).status, 0);
  const Result at_once = parse_result(folder.read("at_once/blob.c1.json"), "blob");
  EXPECT_EQ(at_once.domain_vertices, after.domain_vertices);
  double worst = 0;
  for (std::size_t k = 0; k < after.control_points.size(); ++k)
    worst = std::max(worst, (after.control_points[k] - at_once.control_points[k]).norm());
  EXPECT_EQ(worst, 0) << "doubles are written so that they read back bit for bit";
}

// What the boundary may go is part of the claim: it is kept to, or the status says so.
TEST(ProjectCommand, AMissedConformanceBoundIsStatusFour) {
  const Folder folder;
  folder.run("run --method paper --iterations 100,30 --formats json -o out " + kBlob);
  const Ran ran = folder.run("project out/blob.c1.json --conformance-bound 1e-9 -o projected");
  EXPECT_EQ(ran.status, 4) << ran.err;
  EXPECT_TRUE(contains(ran.err, "conformance")) << ran.err;
  EXPECT_EQ(folder.run("verify projected/blob.c1.json").status, 4);
}

TEST(ProjectCommand, MissingAndBrokenFilesAreStatusThreeAndDoNotStopTheOthers) {
  const Folder folder;
  ASSERT_EQ(folder.run("run -o out --formats json " + kBlob).status, 0);
  folder.write("broken.c1.json", "{");
  EXPECT_EQ(folder.run("project absent.c1.json -o projected").status, 3);
  EXPECT_TRUE(folder.files("projected").empty());
  const Ran ran = folder.run("project absent.c1.json broken.c1.json out/blob.c1.json -o projected");
  EXPECT_EQ(ran.status, 3);
  EXPECT_TRUE(contains(ran.err, "absent")) << ran.err;
  EXPECT_TRUE(contains(ran.err, "broken")) << ran.err;
  EXPECT_EQ(folder.files("projected"), std::vector<std::string>{"blob.c1.json"});
}

// A domain triangle of no area has no equations; the message says so.
TEST(ProjectCommand, AFlatDomainTriangleIsStatusThree) {
  const Folder folder;
  ASSERT_EQ(folder.run("run -o out --formats json " + kBlob).status, 0);
  auto json = nlohmann::json::parse(folder.read("out/blob.c1.json"));
  const int a = json["triangles"][0][0], b = json["triangles"][0][1];
  json["domain_vertices"][a] = json["domain_vertices"][b];
  folder.write("flat.c1.json", json.dump());
  const Ran ran = folder.run("project flat.c1.json -o projected");
  EXPECT_EQ(ran.status, 3) << ran.err;
  EXPECT_TRUE(contains(ran.err, "flat or inverted")) << ran.err;
  EXPECT_TRUE(folder.files("projected").empty());
}

}  // namespace
}  // namespace c1mesh
