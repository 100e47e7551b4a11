// SPDX-License-Identifier: GPL-3.0-or-later
// The drawings under examples/ and real ones, each with what is expected of it (expected.json).
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "pipeline/runs.h"

namespace c1mesh {
namespace {

using testing_pipeline::data;
using testing_pipeline::example;
using testing_pipeline::expect_valid_and_c1;

struct ExampleCase {
  const char* name;
  int exceptional;
};

// Prints the name, not the bytes.
void PrintTo(const ExampleCase& one, std::ostream* out) {
  *out << one.name;
}

class Examples : public testing::TestWithParam<ExampleCase> {};

TEST_P(Examples, HaveTheFewestExceptionalVertices) {
  const auto [name, exceptional] = GetParam();
  const Outcome outcome = parametrize(example(name));
  expect_valid_and_c1(outcome);
  EXPECT_TRUE(outcome.within_bounds);
  EXPECT_EQ(outcome.result.metrics.exceptional, exceptional);
}

// Three per smooth loop, fewer where there are corners of the right kind: the letter's hole has
// two, the clip art's one.
INSTANTIATE_TEST_SUITE_P(All, Examples,
                         testing::Values(ExampleCase{"blob", 3}, ExampleCase{"puzzle", 0},
                                         ExampleCase{"annulus", 6}, ExampleCase{"spiral", 3},
                                         ExampleCase{"letter", 1}, ExampleCase{"clipart", 2}),
                         [](const auto& test) { return std::string(test.param.name); });

// A drawing of tests/data/corpus: the exit statuses allowed (0: all bounds met, 4: one missed) and
// the most exceptional vertices.
struct RealCase {
  std::string file;
  std::vector<int> status;
  int exceptional = 0;
};

void PrintTo(const RealCase& one, std::ostream* out) {
  *out << one.file;
}

std::vector<RealCase> real_cases() {
  std::ifstream in(C1MESH_TEST_DATA "/corpus_expected.json");
  std::vector<RealCase> cases;
  for (const auto& one : nlohmann::json::parse(in))
    cases.push_back({one.at("file"), one.at("status"), one.at("exceptional")});
  return cases;
}

class RealDrawings : public testing::TestWithParam<RealCase> {};

TEST_P(RealDrawings, AreNoWorseThanExpected) {
  const RealCase& expected = GetParam();
  const Outcome outcome = parametrize(data("corpus/" + expected.file));
  expect_valid_and_c1(outcome);
  const int status = outcome.within_bounds ? 0 : 4;
  EXPECT_EQ(std::count(expected.status.begin(), expected.status.end(), status), 1)
      << "status " << status;
  EXPECT_LE(outcome.result.metrics.exceptional, expected.exceptional);
}

INSTANTIATE_TEST_SUITE_P(Corpus, RealDrawings, testing::ValuesIn(real_cases()),
                         [](const auto& test) {
                           std::string name = test.param.file;
                           name.resize(name.rfind('.'));
                           std::replace_if(
                               name.begin(), name.end(),
                               [](unsigned char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

}  // namespace
}  // namespace c1mesh
