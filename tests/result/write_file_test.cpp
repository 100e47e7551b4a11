// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "c1mesh/error.h"
#include "result/example_results.h"

namespace c1mesh {
namespace {

namespace fs = std::filesystem;

class WriteFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder = fs::path(testing::TempDir()) / (std::string("c1mesh_write_file_") + test->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
  }
  static std::string content(const fs::path& path) {
    std::ostringstream out;
    out << std::ifstream(path, std::ios::binary).rdbuf();
    return out.str();
  }

  fs::path folder;
};

TEST_F(WriteFile, WritesReplacesAndLeavesNothingElse) {
  const fs::path path = folder / "a.c1.json";
  write_file(path, "first");
  write_file(path, std::string("second\0 with a zero", 19));
  EXPECT_EQ(content(path), std::string("second\0 with a zero", 19));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(WriteFile, AnAbsentFolderThrowsAndIsNotMade) {
  EXPECT_THROW(write_file(folder / "absent" / "a.json", "x"), FileError);
  EXPECT_EQ(entries(), 0u);
}

TEST_F(WriteFile, ATargetThatCannotBeReplacedThrowsAndLeavesNoTemporary) {
  fs::create_directories(folder / "taken" / "inside");
  EXPECT_THROW(write_file(folder / "taken", "x"), FileError);
  EXPECT_EQ(entries(), 1u);
}

TEST_F(WriteFile, AFolderWithoutWritePermissionThrows) {
  fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  const bool powerless = !std::ofstream(folder / "probe").is_open();
  fs::remove(folder / "probe");
  if (powerless) {
    EXPECT_THROW(write_file(folder / "a.json", "x"), FileError);
  }
  fs::permissions(folder, fs::perms::owner_all);
  EXPECT_EQ(entries(), 0u);
}

// Of files that belong together none changes if one cannot be written.
TEST_F(WriteFile, AGroupIsWrittenTogetherOrNotAtAll) {
  write_file(folder / "a", "old");
  fs::create_directory(folder / "taken");
  EXPECT_THROW(write_files({{folder / "a", "new"}, {folder / "taken", "x"}}), FileError);
  EXPECT_THROW(write_files({{folder / "a", "new"}, {folder / "absent" / "b", "x"}}), FileError);
  EXPECT_EQ(content(folder / "a"), "old");
  EXPECT_EQ(entries(), 2u);
  write_files({{folder / "a", "new"}, {folder / "b", "too"}});
  EXPECT_EQ(content(folder / "a") + content(folder / "b"), "newtoo");
  EXPECT_EQ(entries(), 3u);
}

TEST_F(WriteFile, TheLongestNameHasRoomForATemporaryOne) {
  const std::string name(255, 'n');
  write_file(folder / name, "x");
  EXPECT_EQ(content(folder / name), "x");
  EXPECT_THROW(write_file(folder / (name + "n"), "x"), FileError);
  EXPECT_EQ(entries(), 1u);
}

// In a process of its own: after it nothing can be written.
TEST_F(WriteFile, NothingIsWrittenOnceFilesAreDiscarded) {
  const auto discard_and_write = [&] {
    discard_unfinished_files();
    try {
      write_file(folder / "a", "x");
    } catch (const FileError&) {
      std::_Exit(entries() == 0 ? 7 : 1);
    }
    std::_Exit(2);
  };
  EXPECT_EXIT(discard_and_write(), testing::ExitedWithCode(7), "");
}

TEST_F(WriteFile, ReadResultTakesTheNameFromThePath) {
  write_file(folder / "leaf.c1.json", format_result(example::square()));
  EXPECT_EQ(read_result(folder / "leaf.c1.json").name, "leaf");
  EXPECT_THROW(read_result(folder / "absent.c1.json"), FileError);
}

}  // namespace
}  // namespace c1mesh
