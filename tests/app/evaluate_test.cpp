// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh evaluate: statuses, files, what goes where.
#include <gtest/gtest.h>

#include <filesystem>

#include "c1mesh/result.h"
#include "program.h"
#include "result/example_results.h"

namespace c1mesh {
namespace {

using testing_app::Folder;
using testing_app::Ran;

const std::vector<std::string> kOutputs = {"evaluation.csv", "evaluation.json", "evaluation.txt",
                                           "histograms.svg", "projection.svg"};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Two folders, `a` of two results and a failure, `b` of one result.
void write_sets(const Folder& folder) {
  for (const char* name : {"a", "b", "empty"})
    std::filesystem::create_directory(folder.path(std::string("work/") + name));
  folder.write("a/one.c1.json", format_result(example::square()));
  folder.write("a/one.log", "STATUS 0\nWALL 1.5\n");
  folder.write("a/two.c1.json", format_result(example::grid(2, 3, example::cubic_map())));
  folder.write("a/lost.log", "STATUS 1\nWALL 9.00\n");
  folder.write("b/one.c1.json", format_result(example::grid(4, 3, example::cubic_map())));
}

TEST(EvaluateCommand, WritesItsFilesAndPrintsTheTable) {
  const Folder folder;
  write_sets(folder);
  const Ran ran = folder.run("evaluate a b -o out");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(folder.files("out"), kOutputs);
  EXPECT_EQ(ran.out, folder.read("out/evaluation.txt"));
  EXPECT_TRUE(contains(ran.out, "a: lost: no result; the run ended with status 1")) << ran.out;
}

TEST(EvaluateCommand, WithoutOutputItOnlyPrints) {
  const Folder folder;
  write_sets(folder);
  const auto before = folder.files();
  const Ran ran = folder.run("evaluate a/ ./b");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out, folder.run("evaluate a b").out);
  EXPECT_EQ(folder.files(), before);
}

TEST(EvaluateCommand, SameBytesWhateverTheThreads) {
  const Folder folder;
  write_sets(folder);
  ASSERT_EQ(folder.run("evaluate a b --compare b a --threads 1 -o one").status, 0);
  ASSERT_EQ(folder.run("evaluate a b --compare b a --threads 2 -o two").status, 0);
  ASSERT_EQ(folder.files("one"), kOutputs);
  for (const std::string& file : kOutputs)
    EXPECT_EQ(folder.read("one/" + file), folder.read("two/" + file)) << file;
}

TEST(EvaluateCommand, LabelsAndComparison) {
  const Folder folder;
  write_sets(folder);
  const Ran ran = folder.run("evaluate --labels 'Set A,Set B' a b --compare b a -o out");
  EXPECT_EQ(ran.status, 0) << ran.err;
  const std::string svg = folder.read("out/histograms.svg");
  EXPECT_TRUE(contains(svg, ">Set A<"));
  EXPECT_TRUE(contains(svg, "light: b"));
  EXPECT_TRUE(contains(svg, "class=\"all-light\""));
  EXPECT_TRUE(contains(folder.read("out/evaluation.csv"), "\nSet B,0,one,"));
  EXPECT_TRUE(contains(folder.read("out/evaluation.csv"), "\na,1,lost,"));
}

TEST(EvaluateCommand, TwoFoldersOfOneNameAreToldApart) {
  const Folder folder;
  write_sets(folder);
  std::filesystem::create_directory(folder.path("work/b/a"));
  folder.write("b/a/one.c1.json", format_result(example::square()));
  const Ran ran = folder.run("evaluate a b/a -o out");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(contains(folder.read("out/evaluation.csv"), "\na-2,0,one,"));
}

TEST(EvaluateCommand, ABadFileIsSaidAndTheRestEvaluated) {
  const Folder folder;
  write_sets(folder);
  folder.write("a/cut.c1.json", format_result(example::square()).substr(0, 200));
  const Ran ran = folder.run("evaluate a b -o out");
  EXPECT_EQ(ran.status, 3);
  EXPECT_TRUE(contains(ran.err, "a/cut.c1.json")) << ran.err;
  EXPECT_EQ(folder.files("out"), kOutputs);
  EXPECT_TRUE(contains(folder.read("out/evaluation.csv"), "\na,0,two,"));
}

TEST(EvaluateCommand, AFolderWithoutResultsIsStatusThreeAndWritesNothing) {
  const Folder folder;
  write_sets(folder);
  for (const char* missing : {"empty", "absent", "a/one.log"}) {
    const Ran ran = folder.run(std::string("evaluate a ") + missing + " -o out");
    EXPECT_EQ(ran.status, 3) << missing;
    EXPECT_TRUE(contains(ran.err, missing)) << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_TRUE(folder.files("out").empty());
  }
}

TEST(EvaluateCommand, CountsThatDoNotMatchAreStatusTwo) {
  const Folder folder;
  write_sets(folder);
  for (const char* arguments :
       {"evaluate", "evaluate a b --compare a -o out", "evaluate a b --labels A -o out",
        "evaluate a --labels A,B -o out", "evaluate a -o", "evaluate a --threads -1 -o out"}) {
    const Ran ran = folder.run(arguments);
    EXPECT_EQ(ran.status, 2) << arguments << ran.err;
    EXPECT_NE(ran.err, "");
    EXPECT_EQ(ran.out, "");
  }
  EXPECT_TRUE(folder.files("out").empty());
}

TEST(EvaluateCommand, AnUnwritableFolderIsStatusOne) {
  const Folder folder;
  write_sets(folder);
  EXPECT_EQ(folder.run("evaluate a -o a/one.log").status, 1);
}

}  // namespace
}  // namespace c1mesh
