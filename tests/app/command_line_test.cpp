// SPDX-License-Identifier: GPL-3.0-or-later
// The conventions of the command line: statuses, what goes where, nothing written for bad input.
#include <gtest/gtest.h>

#include "c1mesh/generate.h"
#include "program.h"

namespace c1mesh {
namespace {

using testing_app::Folder;
using testing_app::Ran;

constexpr const char* kBowTie =
    R"([{"curve_id":0,"type":"BezierCurve","degree":1,"poles":[[0,0],[1,1]]},
        {"curve_id":1,"type":"BezierCurve","degree":1,"poles":[[1,1],[1,0]]},
        {"curve_id":2,"type":"BezierCurve","degree":1,"poles":[[1,0],[0,1]]},
        {"curve_id":3,"type":"BezierCurve","degree":1,"poles":[[0,1],[0,0]]}])";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CommandLine, HelpOfEveryCommandGoesToStandardOutput) {
  const Folder folder;
  for (const char* command : {"", "run", "batch", "check", "verify", "project", "draw", "convert",
                              "generate", "evaluate", "manual", "completion"}) {
    const Ran ran = folder.run(std::string(command) + " --help");
    EXPECT_EQ(ran.status, 0) << command;
    EXPECT_TRUE(contains(ran.out, "Usage: c1mesh")) << command;
    EXPECT_TRUE(contains(ran.out, "Exit status:")) << command;
    EXPECT_EQ(ran.err, "") << command;
  }
}

TEST(CommandLine, VersionIsOneLine) {
  const Ran ran = Folder().run("--version");
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.out.rfind("c1mesh ", 0), 0u);
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1);
}

class WrongCommandLine : public testing::TestWithParam<const char*> {};

TEST_P(WrongCommandLine, IsStatusTwoAndWritesNothing) {
  const Folder folder;
  folder.write("a.json", drawing_json(generate('A', 1, 1).front()));
  const Ran ran = folder.run(GetParam());
  EXPECT_EQ(ran.status, 2) << ran.err;
  EXPECT_NE(ran.err, "");
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(folder.files(), std::vector<std::string>{"a.json"});
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongCommandLine,
    testing::Values("", "frobnicate", "run", "run a.json", "run -o out", "run a.json -o",
                    "run a.json -o out --degree 2", "run a.json -o out --degree three",
                    "run a.json -o out --alpha nan", "run a.json -o out --alpha 0",
                    "run a.json -o out --mips-bound 2", "run a.json -o out --exceptional -1",
                    "run a.json -o out --exceptional most", "run a.json -o out --refine 0.5",
                    "run a.json -o - --trade-off", "run a.json -o out --refine nan",
                    "run a.json -o out --refine", "run a.json -o out --formats json,stl",
                    "run a.json -o out --time-limit -3", "run a.json -o out --trace -",
                    "run a.json -o out --corner-angle 181", "run a.json -o out --no-such-option",
                    "check", "verify", "draw a.json", "convert a.json", "convert a.json -o a.stl",
                    "convert a.json -o a.msh --lagrange",
                    "convert a.json -o a.vtu --tessellation 4",
                    "convert a.json -o a.obj --tessellation 0", "generate -o out",
                    "generate --set D -o out", "generate --set A --count -1 -o out",
                    "generate --set A --seed x -o out", "generate --family cube -o out",
                    "generate --set A --family comb -o out",
                    "generate --family degrees --formats json,svg -o out"));

TEST(CommandLine, MissingFilesAreStatusThree) {
  const Folder folder;
  for (const char* arguments :
       {"run absent.json -o out", "check absent.json", "verify absent.c1.json",
        "draw absent.c1.json -o x.svg", "convert absent.c1.json -o x.vtu"}) {
    const Ran ran = folder.run(arguments);
    EXPECT_EQ(ran.status, 3) << arguments;
    EXPECT_TRUE(contains(ran.err, "absent")) << ran.err;
  }
  EXPECT_TRUE(folder.files().empty());
}

TEST(CommandLine, BadInputIsStatusThreeSaysWhyAndWritesNothing) {
  const Folder folder;
  folder.write("bow.json", kBowTie);
  folder.write("broken.json", "[{\"curve_id\":0,");
  folder.write("text.svg", "this is no drawing");
  for (const char* name : {"bow.json", "broken.json", "text.svg"}) {
    for (const std::string& command : {std::string("check "), std::string("run -o out ")}) {
      const Ran ran = folder.run(command + name);
      EXPECT_EQ(ran.status, 3) << command << name << "\n" << ran.err;
      EXPECT_TRUE(contains(ran.err, name)) << ran.err;
      EXPECT_EQ(ran.out, "");
    }
  }
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"bow.json", "broken.json", "text.svg"}));
}

// The diagonals of the unit square cross at its centre.
TEST(CommandLine, CheckNamesTheCurvesAndTheCoordinates) {
  const Folder folder;
  folder.write("bow.json", kBowTie);
  const Ran ran = folder.run("check bow.json");
  EXPECT_TRUE(contains(ran.err, "crossing")) << ran.err;
  EXPECT_TRUE(contains(ran.err, "curves 0, 2")) << ran.err;
  EXPECT_TRUE(contains(ran.err, "(0.5, 0.5)")) << ran.err;
}

TEST(CommandLine, OneBadInputDoesNotStopTheOthers) {
  const Folder folder;
  folder.write("bow.json", kBowTie);
  folder.write("good.json", drawing_json(generate('A', 1, 1).front()));
  const Ran ran = folder.run("check bow.json good.json absent.json");
  EXPECT_EQ(ran.status, 3);
  EXPECT_TRUE(contains(ran.err, "good.json: good: 10 curves, usable")) << ran.err;
  EXPECT_EQ(folder.run("check good.json").status, 0);
}

TEST(CommandLine, ADashIsStandardInput) {
  const Folder folder;
  folder.write("good.json", drawing_json(generate('A', 1, 1).front()));
  const Ran ran = folder.run("check - < good.json");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(contains(ran.err, "10 curves, usable")) << ran.err;
}

// A list option must take one argument, or it would eat the inputs after it.
TEST(CommandLine, InputsMayFollowTheFormats) {
  const Folder folder;
  const Ran ran = folder.run("run --formats json,svg absent.json -o out");
  EXPECT_EQ(ran.status, 3) << ran.err;
}

TEST(CommandLine, QuietSaysErrorsOnly) {
  const Folder folder;
  folder.write("good.json", drawing_json(generate('A', 1, 1).front()));
  EXPECT_EQ(folder.run("check --quiet good.json").err, "");
  EXPECT_NE(folder.run("check --quiet absent.json").err, "");
}

TEST(CommandLine, NoEscapeSequencesReachAFile) {
  const Folder folder;
  folder.write(
      "id.json",
      R"([{"curve_id":"\u001b[31m","type":"BezierCurve","degree":1,"poles":[[0,0],[1,1]]}])");
  EXPECT_FALSE(contains(folder.run("check id.json").err, "\033"));
}

TEST(CommandLine, GenerateWritesTheSameBytesEveryTime) {
  const Folder folder;
  ASSERT_EQ(folder.run("generate --set B --count 5 --seed 42 -o one --formats json,svg").status, 0);
  ASSERT_EQ(folder.run("generate --set B --count 5 --seed 42 -o two --formats json,svg").status, 0);
  const auto files = folder.files("one");
  ASSERT_EQ(files.size(), 10u);
  EXPECT_EQ(files.front(), "B-0001.json");
  EXPECT_EQ(files, folder.files("two"));
  for (const std::string& file : files)
    EXPECT_EQ(folder.read("one/" + file), folder.read("two/" + file));
}

TEST(CommandLine, GenerateAndTheLibraryAgree) {
  const Folder folder;
  ASSERT_EQ(folder.run("generate --set C --count 2 --seed 7 -o out").status, 0);
  EXPECT_EQ(folder.read("out/C-0002.json"), drawing_json(generate('C', 2, 7).back()));
}

TEST(CommandLine, GenerateWritesFamilies) {
  const Folder folder;
  ASSERT_EQ(
      folder.run("generate --family maze --count 3 --seed 5 -o one --formats json,svg").status, 0);
  const auto files = folder.files("one");
  ASSERT_EQ(files.size(), 6u);
  EXPECT_EQ(files.front(), "maze-0001.json");
  EXPECT_EQ(folder.read("one/maze-0003.json"),
            drawing_json(generate_family("maze", 3, 5).back().drawing));
  EXPECT_EQ(folder.run("check one/maze-0003.json one/maze-0003.svg").status, 0);
  // Every family's parameter is in the help, and with --verbose each shape's.
  const std::string help = folder.run("generate --help").out;
  for (const Family& family : families()) EXPECT_TRUE(contains(help, family.parameter));
  EXPECT_TRUE(contains(folder.run("-v generate --family spike --count 2 -o two").err,
                       "spike-0001: 60\nspike-0002: 1\n"));
}

TEST(CommandLine, AnUnwritableFolderIsStatusOne) {
  const Folder folder;
  folder.write("file", "in the way");
  const Ran ran = folder.run("generate --set A --count 1 -o file");
  EXPECT_EQ(ran.status, 1);
  EXPECT_TRUE(contains(ran.err, "cannot create the folder")) << ran.err;
}

}  // namespace
}  // namespace c1mesh
