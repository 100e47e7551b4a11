// SPDX-License-Identifier: GPL-3.0-or-later
// Files from strangers: each ends soon, with the status of its kind and a way out, in bounded
// memory. What is large is made here.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>

#include "c1mesh/generate.h"
#include "program.h"

namespace c1mesh {
namespace {

using testing_app::Folder;
using testing_app::Ran;

constexpr const char* kSvg = "<svg xmlns=\"http://www.w3.org/2000/svg\">";
constexpr const char* kSquare =
    R"([{"poles":[[0,0],[1,0]]},{"poles":[[1,0],[1,1]]},{"poles":[[1,1],[0,1]]},{"poles":[[0,1],[0,0]]}])";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string repeated(const std::string& text, std::size_t count) {
  std::string out;
  for (std::size_t k = 0; k < count; ++k) out += text;
  return out;
}

// Sanitizers reserve more address space than any limit leaves.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kCanLimitMemory = false;
#else
constexpr bool kCanLimitMemory = true;
#endif
// A megabyte of message is no message; 1.5 GB are far below what a hundred times the input takes.
constexpr const char* kMemory = kCanLimitMemory ? " --memory-limit 1500" : "";
constexpr std::size_t kMostWords = 100'000;
constexpr double kMostSeconds = 60;  // of a slow, busy machine

void expect_refused(const Ran& ran, const std::string& word, const std::string& what) {
  EXPECT_EQ(ran.status, 3) << what << "\n" << ran.err.substr(0, 1000);
  EXPECT_TRUE(contains(ran.err, word)) << what << "\n" << ran.err.substr(0, 1000);
  EXPECT_TRUE(contains(ran.err, "; ")) << what << ": no way out";
  EXPECT_LT(ran.err.size(), kMostWords) << what;
}

struct Refusal {
  const char* what;
  std::string text;
  const char* word;  // of the message
};

std::vector<Refusal> refusals() {
  const auto svg = [](const std::string& body) { return kSvg + body + "</svg>"; };
  const auto poles = [](const std::string& x) {
    return "[{\"poles\":[[0,0],[" + x + ",0]]},{\"poles\":[[" + x + ",0],[0,0]]}]";
  };
  // Nine levels of ten `use` each: ten to the ninth squares.
  std::string uses = "<g id=\"u0\"><rect width=\"1\" height=\"1\"/></g>";
  for (int k = 1; k < 10; ++k) {
    const std::string use = "<use href=\"#u" + std::to_string(k - 1) + "\"/>";
    uses += "<g id=\"u" + std::to_string(k) + "\">" + repeated(use, 10) + "</g>";
  }
  std::string utf16 = "\xFF\xFE";
  for (const char c : std::string("[{\"poles\":[[0,0],[1,1]]}]")) utf16 += {c, '\0'};
  return {
      {"nothing", "", "empty"},
      {"spaces", repeated(" \n", 100'000), "neither JSON nor SVG"},
      {"NUL bytes", std::string(100'000, '\0'), "neither JSON nor SVG"},
      {"arrays nested 100,000 deep", repeated("[", 100'000) + repeated("]", 100'000), "limit"},
      {"objects nested 100,000 deep", repeated("{\"a\":", 100'000) + "1" + repeated("}", 100'000),
       "limit"},
      {"a deep value that is not needed",
       "{\"x\":" + repeated("[", 100'000) + repeated("]", 100'000) + ",\"curves\":[]}", "limit"},
      {"groups nested 100,000 deep", svg(repeated("<g>", 100'000) + repeated("</g>", 100'000)),
       "limit"},
      {"entities", "<!DOCTYPE svg [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]>" + svg("&b;"),
       "entities"},
      {"a use of itself", svg("<use id=\"a\" href=\"#a\"/>"), "circle"},
      {"a circle of uses",
       svg("<g id=\"a\"><use href=\"#b\"/></g><g id=\"b\"><use href=\"#a\"/></g>"), "circle"},
      {"uses that multiply", svg(uses), "limit"},
      {"JSON as UTF-16", utf16, "malformed"},
      {"invalid UTF-8", "[{\"curve_id\":\"\xC3\x28\",\"poles\":[[0,0],[1,1]]}]", "not valid JSON"},
      {"NUL within JSON", std::string("[{\"poles\"\0:[[0,0],[1,1]]}]", 26), "not valid JSON"},
      {"NUL within SVG", kSvg + std::string("<rect\0/></svg>", 14), "malformed"},
      {"NaN", "[{\"poles\":[[NaN,0],[1,1]]}]", "not valid JSON"},
      {"Infinity", "[{\"poles\":[[-Infinity,0],[1,1]]}]", "not valid JSON"},
      {"an SVG infinity", svg("<path d=\"M0 0L1e999 1 1 1z\"/>"), "out of range"},
      {"overflow", poles("1e999"), "number overflow"},
      {"a number of 10,000 digits", poles(std::string(10'000, '9')), "number overflow"},
      {"1e308", poles("1e308"), "too large"},
      {"1e150", poles("1e150"), "too large"},
      {"1e-150", poles("1e-150"), "too small"},
      {"sums that overflow", svg("<rect x=\"1e308\" width=\"1e308\" height=\"1e308\"/>"),
       "not a finite number"},
      {"an arc of radii too unlike", svg("<path d=\"M0 0A1e-320 1 0 0 1 1 1z\"/>"),
       "not a finite number"},
      {"matrices that overflow",
       svg("<g transform=\"scale(1e200)\"><rect transform=\"scale(1e200)\" width=\"1\" "
           "height=\"1\"/></g>"),
       "not a finite number"},
      {"a string of 10 MB", "[{\"curve_id\":\"" + std::string(10'000'000, 'x') + "\"}]",
       "curve_id"},
      {"an open string of 10 MB", "[\"" + std::string(10'000'000, 'x'), "not valid JSON"},
      {"a tag of 1 MB", "<" + std::string(1'000'000, 'x') + "/>", "root element"},
      {"a reference of 1 MB", svg("<use href=\"#" + std::string(1'000'000, 'x') + "\"/>"),
       "not there"},
      {"a path of 1 MB that is none", svg("<path d=\"M" + std::string(1'000'000, '-') + "\"/>"),
       "path data"},
      {"a curve of 200,000 control points",
       "[{\"poles\":[" + repeated("[1,2],", 200'000) + "[0,0]]}]", "limit"},
      {"a curve of degree 999", "[{\"poles\":[" + repeated("[1,2],", 999) + "[0,0]]}]", "degree"},
      {"half a million empty items", "[" + repeated("[],", 500'000) + "[]]", "is not an object"},
      {"two lists", "{\"curves\":[{\"poles\":[[0,0],[1,1]]}],\"curves\":[]}", "twice"},
  };
}

TEST(Hostile, EveryFamilyIsRefusedWithAWayOut) {
  const Folder folder;
  for (const Refusal& one : refusals()) {
    folder.write("x.any", one.text);
    const auto start = std::chrono::steady_clock::now();
    expect_refused(folder.run(std::string("check x.any") + kMemory), one.word, one.what);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    EXPECT_LT(taken.count(), kMostSeconds) << one.what;
  }
}

// The same text in every encoding that XML knows and the file says.
TEST(Hostile, EncodingsOfSvgAreRead) {
  const Folder folder;
  const std::string text = std::string(kSvg) + "<rect id=\"r\" width=\"1\" height=\"2\"/></svg>";
  std::string little = "\xFF\xFE", big = "\xFE\xFF";
  for (const char c : text) little += {c, '\0'}, big += {'\0', c};
  folder.write("little.svg", little);
  folder.write("big.svg", big);
  folder.write("mark.svg", "\xEF\xBB\xBF" + text);
  folder.write("latin.svg", "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>" + std::string(kSvg) +
                                "<rect id=\"\xE9\" width=\"1\" height=\"2\"/></svg>");
  folder.write("wrong.svg",
               std::string(kSvg) + "<rect id=\"\xFF\xC3\" width=\"1\" height=\"2\"/></svg>");
  for (const char* name : {"little", "big", "mark", "latin", "wrong"}) {
    const Ran ran = folder.run(std::string("run -o out --formats json ") + name + ".svg");
    EXPECT_EQ(ran.status, 0) << name << "\n" << ran.err;
    EXPECT_EQ(folder.run(std::string("verify out/") + name + ".c1.json").status, 0) << name;
  }
}

TEST(Hostile, WhatHasNoEndStopsAtTheLimit) {
  const Folder folder;
  for (const char* command :
       {"check /dev/zero --max-bytes 1000000", "run /dev/zero -o out --max-bytes 1000000",
        "verify /dev/zero --max-bytes 1000000", "check - --max-bytes 1000000 < /dev/zero"}) {
    const Ran ran = folder.run(command);
    EXPECT_EQ(ran.status, 3) << command << "\n" << ran.err;
    EXPECT_TRUE(contains(ran.err, "larger than 1000000 bytes")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "--max-bytes")) << ran.err;
  }
  expect_refused(folder.run("convert /dev/zero -o x.vtu"), "larger than 200000000 bytes",
                 "convert");
  // Every command that reads results has the limit as an option.
  for (const char* command : {"convert /dev/zero -o x.vtu", "draw /dev/zero -o x.svg",
                              "draw /dev/zero -o x.png --contact-sheet", "project /dev/zero -o out",
                              "verify /dev/zero"}) {
    const std::string limited = command + std::string(" --max-bytes 100000");
    expect_refused(folder.run(limited), "larger than 100000 bytes", limited);
  }
  std::remove(folder.path("work/x.png").c_str());  // a sheet shows what cannot be read
  EXPECT_TRUE(folder.files().empty());
}

TEST(Hostile, APipeThatStaysEmptyIsAnEmptyInput) {
  const Folder folder;
  ASSERT_EQ(mkfifo((folder.path("work/pipe")).c_str(), 0600), 0);
  const Ran ran = folder.run("check pipe & : > pipe; wait $!");
  EXPECT_EQ(ran.status, 3);
  EXPECT_TRUE(contains(ran.err, "empty")) << ran.err;
}

TEST(Hostile, FoldersAreNoFiles) {
  const Folder folder;
  for (const char* command : {"check .", "run . -o out", "verify .", "convert . -o x.vtu",
                              "draw . -o x.svg", "check --font . --text x"}) {
    const Ran ran = folder.run(command);
    EXPECT_EQ(ran.status, 3) << command << "\n" << ran.err;
    EXPECT_TRUE(contains(ran.err, "director")) << command << "\n" << ran.err;
  }
}

TEST(Hostile, EveryLimitIsAnOptionAndSaysSo) {
  const Folder folder;
  folder.write("square.json", kSquare);
  folder.write("deep.svg", kSvg + repeated("<g>", 9) + "<rect width=\"1\" height=\"1\"/>" +
                               repeated("</g>", 9) + "</svg>");
  const struct {
    const char *arguments, *option;
  } cases[] = {{"square.json --max-bytes 50", "--max-bytes"},
               {"square.json --max-curves 3", "--max-curves"},
               {"square.json --max-depth 3", "--max-depth"},
               {"deep.svg --max-depth 9", "--max-depth"}};
  for (const auto& one : cases)
    for (const std::string command : {"check ", "run -o out "}) {
      const Ran ran = folder.run(command + one.arguments);
      expect_refused(ran, one.option, command + one.arguments);
    }
  EXPECT_EQ(folder.run("check square.json --max-bytes 1000 --max-curves 4 --max-depth 4").status,
            0);
  EXPECT_EQ(folder.run("check deep.svg --max-depth 10").status, 0);
  for (const char* wrong : {"--max-bytes 0", "--max-curves 0", "--max-depth 0", "--max-depth 1001",
                            "--max-bytes x", "--memory-limit -1", "--memory-limit nan"})
    EXPECT_EQ(folder.run(std::string("check square.json ") + wrong).status, 2) << wrong;
}

// From no memory to enough: never a crash, and what is written is whole.
TEST(Hostile, AMemoryLimitEndsWithStatusFive) {
  if (!kCanLimitMemory) GTEST_SKIP() << "under a sanitizer there is no limit to memory";
  const Folder folder;
  folder.write("a.json", drawing_json(generate('A', 1, 1).front()));
  folder.write("large.svg", kSvg + repeated("<g></g>", 1'000'000) + "</svg>");
  const Ran large = folder.run("check large.svg --memory-limit 100");
  EXPECT_EQ(large.status, 5) << large.err;
  EXPECT_TRUE(contains(large.err, "out of memory")) << large.err;
  bool ended = false, done = false;
  for (const int megabytes : {1, 20, 30, 34, 40, 50, 60, 200, 1500}) {
    const Ran ran = folder.run("run a.json --threads 1 --formats json -o out --memory-limit " +
                               std::to_string(megabytes));
    ended |= ran.status == 5;
    done |= ran.status == 0;
    EXPECT_TRUE(ran.status == 0 || ran.status == 5) << megabytes << "\n" << ran.err;
    EXPECT_EQ(folder.files("out").size(), ran.status == 0 ? 1u : 0u) << megabytes;
    if (ran.status == 0) std::remove(folder.path("work/out/a.c1.json").c_str());
  }
  // The limit changes nothing of what it allows.
  ASSERT_EQ(folder.run("run a.json --threads 1 --formats json -o free").status, 0);
  ASSERT_EQ(folder.run("run a.json --threads 1 --formats json -o out --memory-limit 2000").status,
            0);
  EXPECT_EQ(folder.read("out/a.c1.json"), folder.read("free/a.c1.json"));
  EXPECT_TRUE(ended);
  EXPECT_TRUE(done);
}

TEST(Hostile, ManyOfOneIdTakeNoSquareTime) {
  const Folder folder;
  folder.write("ids.svg",
               kSvg + repeated("<rect id=\"a\" width=\"1\" height=\"1\"/>", 20'000) + "</svg>");
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(folder.run("check -q ids.svg").status, 0);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_LT(taken.count(), kMostSeconds);
}

// Far from the origin, flat, tiny: a certified result or a typed refusal.
TEST(Hostile, ExtremeCoordinatesEndCertifiedOrRefused) {
  const Folder folder;
  const struct {
    double scale, aspect, offset;
  } cases[] = {{1, 1, 1e9},    {1, 1, 1e15},  {1, 1000, 0},   {1, 1e6, 0},
               {1, 1e12, 0},   {1e-50, 1, 0}, {1e50, 1, 0},   {1e-59, 100, 0},
               {1e-150, 1, 0}, {1e150, 1, 0}, {5e-324, 1, 0}, {1e305, 1, 0}};
  for (const auto& one : cases) {
    Drawing drawing = generate('A', 1, 3).front();
    for (InputCurve& curve : drawing.curves)
      for (Point& p : curve.curve.poles)
        p = one.scale * (p.cwiseProduct(Point(one.aspect, 1)) + Point(one.offset, one.offset));
    folder.write("x.json", drawing_json(drawing));
    const Ran ran =
        folder.run("run x.json -o out --formats json --time-limit 2" + std::string(kMemory));
    EXPECT_TRUE(ran.status == 0 || ran.status == 3 || ran.status == 4 || ran.status == 5)
        << one.scale << " " << one.aspect << " " << one.offset << ": " << ran.status << "\n"
        << ran.err;
    for (const std::string& file : folder.files("out")) {
      const Ran verified = folder.run("verify out/" + file);
      EXPECT_EQ(verified.status, 0) << file << "\n" << verified.err;
      std::remove(folder.path("work/out/" + file).c_str());
    }
  }
}

// A sliver a million times as long as wide, bent: its mesh alone takes many seconds.
TEST(Hostile, ATimeLimitEndsTheMesherToo) {
  const Folder folder;
  folder.write("sliver.json",
               R"([{"poles":[[1e6,0],[5e5,0.54],[300,0.96]]},{"poles":[[300,0.96],[-1e6,0.02]]},
                   {"poles":[[-1e6,0.02],[1e4,-1]]},
                   {"poles":[[1e4,-1],[2e5,-0.7],[6.7e5,-0.33],[1e6,0]]}])");
  const auto start = std::chrono::steady_clock::now();
  const Ran ran = folder.run("run sliver.json -o out --threads 1 --time-limit 0.01");
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(ran.status, 5) << ran.err;
  EXPECT_TRUE(contains(ran.err, "time limit")) << ran.err;
  EXPECT_TRUE(folder.files("out").empty());
  EXPECT_LT(taken.count(), kMostSeconds);
}

TEST(Hostile, ResultsAndTracesOfStrangersAreRefused) {
  const Folder folder;
  const std::string deep = repeated("[", 100'000) + repeated("]", 100'000);
  folder.write("deep.c1.json", "{\"format\":\"c1mesh\",\"version\":1,\"degree\":" + deep + "}");
  folder.write("bare.c1.json", deep);
  folder.write("string.c1.json", "{\"format\":\"" + std::string(10'000'000, 'x'));
  folder.write("deep.jsonl", "{\"e_s\":" + deep + ",\"stage\":1}\n");
  folder.write("zero.c1.json", "");
  const struct {
    const char *command, *word;
  } cases[] = {{"verify deep.c1.json", "nested deeper"},
               {"verify bare.c1.json", "nested deeper"},
               {"verify string.c1.json", "not JSON"},
               {"verify zero.c1.json", "not JSON"},
               {"draw deep.jsonl -o x.svg", "nested deeper"},
               {"convert deep.c1.json -o x.vtu", "nested deeper"}};
  for (const auto& one : cases) expect_refused(folder.run(one.command), one.word, one.command);
}

}  // namespace
}  // namespace c1mesh
