// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh batch: the index is the same however the work was split, killed and resumed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.h"

namespace c1mesh {
namespace {

using nlohmann::json;
using testing_app::Folder;
using testing_app::Ran;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A regular polygon with `corners` straight sides.
std::string polygon(int corners) {
  std::ostringstream out;
  const auto point = [&](int k) {
    const double angle = 6.283185307179586 * (k % corners) / corners;
    std::ostringstream text;
    text << "[" << std::cos(angle) << "," << std::sin(angle) << "]";
    return text.str();
  };
  for (int k = 0; k < corners; ++k)
    out << (k ? "," : "[") << R"({"curve_id":)" << k
        << R"(,"type":"BezierCurve","degree":1,"poles":[)" << point(k) << "," << point(k + 1)
        << "]}";
  return out.str() + "]";
}

// Eight good inputs and two with bad shapes.
void write_shapes(const Folder& folder) {
  ASSERT_EQ(folder.run("generate --set A --count 2 -o in").status, 0);
  for (int corners = 3; corners < 9; ++corners)
    folder.write("in/p" + std::to_string(corners) + ".json", polygon(corners));
  folder.write("in/broken.json", "[{\"curve_id\":0,");
  folder.write("in/p3.svg",
               R"(<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H4V3z"/><path d="M9 0h4v3z"/>
                  <path id="bow" d="M0 9l4 4v-4l-4 4z"/></svg>)");
}

std::vector<json> lines_of(const std::string& text) {
  std::vector<json> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(json::parse(line));
  return lines;
}

// Everything but what the journal and the clock say.
std::map<std::string, std::string> results_in(const Folder& folder, const std::string& name) {
  std::map<std::string, std::string> out;
  for (const std::string& file : folder.files(name))
    if (!contains(file, "journal") && !contains(file, "times"))
      out[file] = folder.read(name + "/" + file);
  return out;
}

// Shell commands that wait until a file has so many lines.
std::string wait_for_lines(const std::string& file, int count) {
  return "until [ \"$(cat " + file + " 2>/dev/null | wc -l)\" -ge " + std::to_string(count) +
         " ]; do sleep 0.01; done; ";
}

// The only child of the batch whose process id is in $pid (the shell's), once it has one.
constexpr const char* kFindChild =
    "until child=$(cat /proc/[0-9]*/stat 2>/dev/null | awk -v p=$pid '$4 == p && $3 != \"Z\" "
    "{ print $1 }' | head -n 1) && [ -n \"$child\" ]; do sleep 0.01; done; ";

TEST(Batch, IndexHasALinePerResultAndTheWorstStatusCounts) {
  const Folder folder;
  write_shapes(folder);
  const Ran ran = folder.run("batch in -o out --formats json");
  EXPECT_EQ(ran.status, 3) << ran.err;
  EXPECT_TRUE(contains(ran.err, "10 inputs, 12 results")) << ran.err;
  const std::vector<json> lines = lines_of(folder.read("out/index.jsonl"));
  ASSERT_EQ(lines.size(), 12u);
  std::map<std::string, json> by_name;
  for (const json& line : lines) by_name[line["name"]] = line;
  for (int corners = 3; corners < 9; ++corners) {
    const json& line = by_name.at(std::string("p").append(std::to_string(corners)));
    EXPECT_EQ(line["status"], 0);
    EXPECT_EQ(line["exceptional"], 0);  // every corner is convex
    EXPECT_GE(line["g"], 2 - 1e-9);     // |J|² >= 2 det J
    EXPECT_GE(line["triangles"], corners - 2);
    EXPECT_LE(line["d_ei_max"], 1e-12);
  }
  EXPECT_EQ(by_name.at("broken")["status"], 3);
  EXPECT_TRUE(contains(by_name.at("broken")["message"], "malformed"));
  EXPECT_TRUE(by_name.at("broken")["g"].is_null());
  // The file p3.svg holds three shapes: p3 is taken, and the third crosses itself.
  EXPECT_EQ(by_name.at("p3~2-1")["status"], 0);
  EXPECT_EQ(by_name.at("p3~2-2")["status"], 0);
  EXPECT_EQ(by_name.at("p3~2-bow")["status"], 3);
  EXPECT_TRUE(contains(by_name.at("p3~2-bow")["message"], "crossing"));
  const auto files = folder.files("out");
  EXPECT_EQ(std::count_if(files.begin(), files.end(),
                          [](const std::string& f) { return f.ends_with(".c1.json"); }),
            10);
  EXPECT_FALSE(contains(folder.read("out/index.jsonl"), "seconds"));
  EXPECT_EQ(lines_of(folder.read("out/times.jsonl")).size(), 12u);
}

TEST(Batch, ResultsAreThoseOfRun) {
  const Folder folder;
  write_shapes(folder);
  folder.run("batch in -o out");
  ASSERT_EQ(folder.run("run in/p5.json -o alone --threads 1").status, 0);
  for (const char* file : {"/p5.c1.json", "/p5.svg"})
    EXPECT_EQ(folder.read(std::string("out") + file), folder.read(std::string("alone") + file));
}

TEST(Batch, JobsAndShardsMakeNoDifference) {
  const Folder folder;
  write_shapes(folder);
  EXPECT_EQ(folder.run("batch in -o one -j 1 --formats json").status, 3);
  EXPECT_EQ(folder.run("batch in -o two -j 2 --formats json").status, 3);
  EXPECT_EQ(results_in(folder, "one"), results_in(folder, "two"));
  for (int shard = 1; shard <= 3; ++shard)
    folder.run("batch in -o parts --formats json --shard " + std::to_string(shard) + "/3");
  EXPECT_EQ(folder
                .run("--version; LC_ALL=C sort parts/index.*-of-3.jsonl > parts/index.jsonl; "
                     "LC_ALL=C sort parts/times.*-of-3.jsonl > parts/times.jsonl; "
                     "rm parts/index.*-of-3.jsonl")
                .status,
            0);
  EXPECT_EQ(results_in(folder, "one"), results_in(folder, "parts"));
  EXPECT_EQ(lines_of(folder.read("parts/times.jsonl")).size(), 12u);
}

// The cluster's part played by the shell.
TEST(Batch, TheSlurmScriptDoesItsShardsAndMergesThem) {
  const Folder folder;
  write_shapes(folder);
  EXPECT_EQ(folder.run("batch in -o one --formats json").status, 3);
  const std::string script = "'" C1MESH_EXAMPLES "/../docs/slurm.sh' ";
  const auto task = [&](int k) {
    return folder
        .run("--version; C1MESH='" C1MESH_PROGRAM "' SLURM_ARRAY_TASK_ID=" + std::to_string(k) +
             " SLURM_ARRAY_TASK_COUNT=2 SLURM_CPUS_PER_TASK=2 " + script + "in out --formats json")
        .status;
  };
  EXPECT_EQ(task(1), 3);
  EXPECT_EQ(folder.run("--version; " + script + "merge out 2").status, 5);
  EXPECT_EQ(folder.read("out/index.jsonl"), "");
  task(2);
  EXPECT_EQ(folder.run("--version; " + script + "merge out 2").status, 0);
  EXPECT_EQ(folder.read("out/index.jsonl"), folder.read("one/index.jsonl"));
}

TEST(Batch, AListMayComeFromStandardInputInAnyOrder) {
  const Folder folder;
  write_shapes(folder);
  folder.write("list", "# two shapes\nin/p4.json\r\n\n  in/p3.json\n");
  EXPECT_EQ(folder.run("batch list -o one").status, 0);
  EXPECT_EQ(folder.run("batch - -o two < list").status, 0);
  folder.write("list", "in/p3.json\nin/p4.json");
  EXPECT_EQ(folder.run("batch list -o three").status, 0);
  EXPECT_EQ(results_in(folder, "one"), results_in(folder, "two"));
  EXPECT_EQ(results_in(folder, "one"), results_in(folder, "three"));
  EXPECT_EQ(lines_of(folder.read("one/index.jsonl")).size(), 2u);
}

// "a" of two folders, and an SVG drawing whose element is called as another file is.
TEST(Batch, NoTwoInputsWriteTheSameFile) {
  const Folder folder;
  const std::string two = R"(<svg xmlns="http://www.w3.org/2000/svg"><path id="1" d="M0 0H4V3z"/>
                             <path id="x" d="M9 0h4v3z"/></svg>)";
  folder.run("generate --set A --count 0 -o i");
  folder.run("generate --set A --count 0 -o j");
  for (const char* name : {"i/a.json", "i/a-1.json", "i/a.domain.json", "j/a.json", "i/index.json"})
    folder.write(name, polygon(3));
  folder.write("i/a.svg", two);
  folder.write("list", "j/a.json\ni/a.json\ni/a-1.json\ni/a.domain.json\ni/a.svg\ni/index.json\n");
  ASSERT_EQ(folder.run("batch list -o out --formats json,vtu").status, 0);
  std::map<std::string, std::string> names;
  for (const json& line : lines_of(folder.read("out/index.jsonl")))
    EXPECT_TRUE(names.emplace(line["name"], line["input"]).second) << line;
  EXPECT_EQ(names, (std::map<std::string, std::string>{{"a-1", "i/a-1.json"},
                                                       {"a.domain", "i/a.domain.json"},
                                                       {"a~2", "i/a.json"},
                                                       {"a~3-1", "i/a.svg"},
                                                       {"a~3-x", "i/a.svg"},
                                                       {"a~4", "j/a.json"},
                                                       {"index~2", "i/index.json"}}));
  EXPECT_EQ(folder.files("out").size(), 7u * 3 + 3);  // index, times, journal
}

class Interrupted : public testing::TestWithParam<const char*> {};

// Killed twice at moments spread over the whole run, then resumed to the end.
TEST_P(Interrupted, ResumesToTheSameIndexByteForByte) {
  const std::string signal = GetParam();
  const Folder folder;
  write_shapes(folder);
  ASSERT_EQ(folder.run("batch in -o whole -j 2 --formats json").status, 3);
  const auto whole = results_in(folder, "whole");
  int broken_off = 0;
  for (const char* moment : {"0.01", "0.03", "0.06", "0.1"}) {
    const std::string out = std::string("out") + moment;
    for (int time = 0; time < 2; ++time) {
      const Ran ran =
          folder.run("batch in -o " + out + " -j 2 --formats json --resume & pid=$!; sleep " +
                     moment + "; kill -" + signal + " $pid; wait $pid");
      if (ran.status == 3) continue;  // it was faster
      ++broken_off;
      // 128 + 15: on a slow machine the signal came before the program could heed it.
      EXPECT_TRUE(signal == "KILL" ? ran.status == 128 + 9
                                   : ran.status == 5 || ran.status == 128 + 15)
          << ran.status << ran.err;
      for (const std::string& file : folder.files(out))
        EXPECT_TRUE(!file.ends_with(".c1.json") || json::accept(folder.read(out + "/" + file)));
      EXPECT_FALSE(results_in(folder, out).count("index.jsonl"));
    }
    EXPECT_EQ(folder.run("batch in -o " + out + " -j 1 --formats json --resume").status, 3);
    EXPECT_EQ(results_in(folder, out), whole);
  }
  EXPECT_GT(broken_off, 0);
}

INSTANTIATE_TEST_SUITE_P(Batch, Interrupted, testing::Values("KILL", "TERM"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Batch, ResumingRedoesWhatIsMissingTornOrChanged) {
  const Folder folder;
  write_shapes(folder);
  folder.run("batch in -o out --formats json");
  const auto whole = results_in(folder, "out");
  const std::string journal = folder.read("out/journal.jsonl");
  const auto lines = [&] {
    const std::string text = folder.read("out/journal.jsonl");
    return std::count(text.begin(), text.end(), '\n');
  };
  ASSERT_EQ(lines(), 11);  // the first says what all depends on
  EXPECT_EQ(folder.run("batch in -o out --formats json --resume").status, 3);
  EXPECT_EQ(lines(), 11);  // nothing was left to do
  // The last line torn: that input again.
  folder.write("out/journal.jsonl", journal.substr(0, journal.size() - 20));
  EXPECT_EQ(folder.run("batch in -o out --formats json --resume").status, 3);
  EXPECT_EQ(lines(), 11);
  EXPECT_EQ(results_in(folder, "out"), whole);
  // A result gone: that input again.
  EXPECT_EQ(folder.run("--version; rm out/p7.c1.json").status, 0);
  EXPECT_EQ(folder.run("batch in -o out --formats json --resume").status, 3);
  EXPECT_EQ(lines(), 12);
  EXPECT_EQ(results_in(folder, "out"), whole);
  // A changed input again, and leftovers of killed processes go.
  folder.write("out/.p7.c1.json.abcdef", "half");
  folder.write("in/p7.json", polygon(20));
  EXPECT_EQ(folder.run("batch in -o out --formats json --resume").status, 3);
  EXPECT_EQ(lines(), 13);
  EXPECT_NE(results_in(folder, "out"), whole);
  EXPECT_EQ(results_in(folder, "out").count(".p7.c1.json.abcdef"), 0u);
}

TEST(Batch, AJournalIsOfOneSetOfOptions) {
  const Folder folder;
  write_shapes(folder);
  ASSERT_EQ(folder.run("batch in -o out --formats json").status, 3);
  const Ran again = folder.run("batch in -o out --formats json");
  EXPECT_EQ(again.status, 2);
  EXPECT_TRUE(contains(again.err, "--resume")) << again.err;
  const Ran other = folder.run("batch in -o out --formats json --resume --alpha 50");
  EXPECT_EQ(other.status, 2);
  EXPECT_TRUE(contains(other.err, "--alpha was \"100\" and is \"50\"")) << other.err;
  const Ran into = folder.run("batch in -o in");
  EXPECT_EQ(into.status, 2);
  EXPECT_TRUE(contains(into.err, "output folder")) << into.err;
}

// An input that is a pipe nobody writes to: its process waits until it is killed.
TEST(Batch, AKilledChildIsThatInputsFailureAlone) {
  const Folder folder;
  write_shapes(folder);
  ASSERT_EQ(folder.run("--version; mkfifo in/endless.json").status, 0);
  for (const auto& [signal, number] : {std::pair("ABRT", "6"), std::pair("KILL", "9")}) {
    const std::string out = std::string("out") + number;
    const Ran ran = folder.run("batch in -o " + out + " -j 2 --formats json & pid=$!; " +
                               wait_for_lines(out + "/journal.jsonl", 11) + kFindChild + "kill -" +
                               signal + " $child; wait $pid");
    EXPECT_EQ(ran.status, 1) << ran.err;
    const std::vector<json> lines = lines_of(folder.read(out + "/index.jsonl"));
    ASSERT_EQ(lines.size(), 13u);
    int good = 0;
    for (const json& line : lines) {
      good += line["status"] == 0;
      if (line["name"] != "endless") continue;
      EXPECT_EQ(line["status"], 1);
      EXPECT_TRUE(contains(line["message"], std::string("signal ") + number)) << line;
    }
    EXPECT_EQ(good, 10);
  }
}

TEST(Batch, WhatTakesTooLongIsKilled) {
  const Folder folder;
  ASSERT_EQ(folder.run("--version; mkfifo endless.json; echo endless.json > list").status, 0);
  const Ran ran = folder.run("batch list -o out --kill-after 0.2");
  EXPECT_EQ(ran.status, 5) << ran.err;
  const std::vector<json> lines = lines_of(folder.read("out/index.jsonl"));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0]["status"], 5);
  EXPECT_TRUE(contains(lines[0]["message"], "ended after 0.2 seconds")) << lines[0];
}

TEST(Batch, ASignalStopsAWaitingChildAndLeavesItUndone) {
  const Folder folder;
  write_shapes(folder);
  const Ran ran =
      folder.run(std::string("--version; mkfifo in/endless.json; ") + C1MESH_PROGRAM +
                 " batch in -o out -j 2 --formats json & pid=$!; " +
                 wait_for_lines("out/journal.jsonl", 11) + "kill -TERM $pid; wait $pid");
  EXPECT_EQ(ran.status, 5) << ran.err;
  EXPECT_TRUE(contains(ran.err, "--resume goes on")) << ran.err;
  EXPECT_FALSE(contains(folder.read("out/journal.jsonl"), "endless"));
  // Without the endless one the batch is whole.
  EXPECT_EQ(folder.run("--version; rm in/endless.json").status, 0);
  EXPECT_EQ(folder.run("batch in -o out --formats json --resume").status, 3);
  EXPECT_EQ(lines_of(folder.read("out/index.jsonl")).size(), 12u);
}

// 1 MB of address space is less than the program has when it starts: what needs no more memory is
// done, all else is refused its memory, and the batch goes on.
TEST(Batch, ShortMemoryEndsAShapeNotTheBatch) {
  const Folder folder;
  ASSERT_EQ(folder.run("generate --set C --count 2 -o in").status, 0);
  folder.write("in/x.json", polygon(3));
  const Ran ran = folder.run("batch in -o out --formats json --memory-limit 1");
  EXPECT_TRUE(ran.status == 1 || ran.status == 5) << ran.err;
  const std::vector<json> lines = lines_of(folder.read("out/index.jsonl"));
  ASSERT_EQ(lines.size(), 3u);
  for (int k = 0; k < 2; ++k) {
    EXPECT_TRUE(lines[k]["status"] == 1 || lines[k]["status"] == 5) << lines[k];
    EXPECT_NE(lines[k]["message"], "");
  }
}

TEST(Batch, WrongCommandLinesAreStatusTwo) {
  const Folder folder;
  write_shapes(folder);
  for (const char* arguments : {"batch", "batch in", "batch in -o -", "batch in -o out --shard 0/3",
                                "batch in -o out --shard 4/3", "batch in -o out --shard 1",
                                "batch in -o out --jobs -1", "batch in -o out --alpha nan"})
    EXPECT_EQ(folder.run(arguments).status, 2) << arguments;
  EXPECT_EQ(folder.run("batch absent -o out").status, 3);
  EXPECT_TRUE(folder.files("out").empty());
}

}  // namespace
}  // namespace c1mesh
