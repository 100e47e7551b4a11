// SPDX-License-Identifier: GPL-3.0-or-later
// The committed files, seeds and former findings, through every fuzz target: what was found stays
// mended. A finding ends the process, so that a failure names the file it was at.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "fuzz/target.h"

namespace c1mesh::fuzz {
namespace {

namespace fs = std::filesystem;

// Two targets may share their files.
std::string folder_of(const std::string& target) {
  return std::string(C1MESH_FUZZ_CORPUS "/") + (target == "result_use" ? "result" : target);
}

std::vector<fs::path> files_of(const std::string& target) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(folder_of(target))) out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<std::string> names() {
  std::vector<std::string> out;
  for (const auto& [name, target] : targets()) out.push_back(name);
  return out;
}

// A few random changes: bytes replaced, removed, inserted, blocks copied from another file.
std::string changed(std::string bytes, const std::string& other, std::mt19937_64& random) {
  const auto below = [&](std::size_t most) { return static_cast<std::size_t>(random() % most); };
  for (std::size_t k = 1 + below(6); k-- > 0;) {
    const std::size_t at = below(bytes.size() + 1);
    const char byte = static_cast<char>(random());
    switch (below(4)) {
      case 0:
        bytes.insert(at, 1, byte);
        break;
      case 1:
        bytes.erase(at, 1 + below(4));
        break;
      case 2:
        if (at < bytes.size()) bytes[at] = byte;
        break;
      default:
        bytes.insert(at, other.substr(below(other.size() + 1), 1 + below(32)));
    }
  }
  return bytes;
}

// How many changed files a sweep takes: C1MESH_FUZZ_SWEEP if it is set.
std::size_t sweep_count(std::size_t usual) {
  const char* asked = std::getenv("C1MESH_FUZZ_SWEEP");
  return asked == nullptr ? usual : std::strtoull(asked, nullptr, 10);
}

// Leaves what ends the process behind in the file C1MESH_FUZZ_LAST, if that is set.
void remember(const std::string& bytes) {
  if (const char* path = std::getenv("C1MESH_FUZZ_LAST"))
    std::ofstream(path, std::ios::binary) << bytes;
}

class Fuzz : public testing::TestWithParam<std::string> {};

TEST_P(Fuzz, CommittedFilesEndWell) {
  const std::vector<fs::path> files = files_of(GetParam());
  EXPECT_FALSE(files.empty());
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.string());
    EXPECT_NO_THROW(targets().at(GetParam())(bytes_of(file))) << file;
  }
}

// Without the fuzzer's guidance, but with every compiler and in every test run.
TEST_P(Fuzz, RandomChangesEndWell) {
  std::vector<std::string> seeds;
  for (const fs::path& file : files_of(GetParam())) seeds.push_back(bytes_of(file));
  const std::size_t count = sweep_count(GetParam() == "road" ? 50 : 500);
  std::mt19937_64 random(1);
  for (std::size_t k = 0; k < count; ++k) {
    const std::string& seed = seeds[random() % seeds.size()];
    const std::string bytes = changed(seed, seeds[random() % seeds.size()], random);
    remember(bytes);
    EXPECT_NO_THROW(targets().at(GetParam())(bytes)) << "change " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Fuzz, testing::ValuesIn(names()),
                         [](const auto& info) { return info.param; });

TEST(FuzzTargets, AreAllThere) {
  EXPECT_EQ(names(), (std::vector<std::string>{"batch_list", "certificate", "font_bytes",
                                               "font_text", "path_data", "result", "result_use",
                                               "road", "shape_json", "svg", "trace"}));
}

// The replay would not notice a target that finds nothing.
TEST(FuzzTargets, AFindingEndsTheProcess) {
  EXPECT_DEATH(finding("this one"), "finding: this one");
  EXPECT_DEATH(require(false, "that one"), "finding: that one");
  EXPECT_DEATH(accepted([] { throw InputError({}); }), "without a defect");
  EXPECT_THROW(accepted([] { throw std::runtime_error("untyped"); }), std::runtime_error);
}

}  // namespace
}  // namespace c1mesh::fuzz
