// SPDX-License-Identifier: GPL-3.0-or-later
// Folders of results and logs: nothing is dropped.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <stdexcept>

#include "c1mesh/error.h"
#include "c1mesh/evaluate.h"
#include "examples.h"

namespace c1mesh {
namespace {

class Folders : public testing::Test {
 protected:
  Folders() {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "c1mesh_evaluate_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    root_ = pattern;
  }
  ~Folders() override {
    std::error_code ignored;
    std::filesystem::remove_all(root_, ignored);
  }

  void result(const std::string& name) const {
    write_file(root_ + "/" + name + ".c1.json", format_result(example::square()));
  }
  void file(const std::string& name, const std::string& text) const {
    write_file(root_ + "/" + name, text);
  }
  Series read() const { return evaluate_folder(root_, "S"); }

  std::string root_;
};

const ShapeEvaluation& shape(const Series& series, const std::string& name) {
  for (const ShapeEvaluation& s : series.shapes)
    if (s.name == name) return s;
  throw std::runtime_error("no shape " + name);
}

TEST_F(Folders, StatusAndSecondsComeFromTheLogsEnd) {
  result("b");
  file("b.log", "STATUS 77 is what a line may say\nb\n  triangles 2\nSTATUS 4\nWALL 1.25\n");
  result("a");
  const Series series = read();
  ASSERT_EQ(series.shapes.size(), 2u);
  EXPECT_EQ(series.shapes[0].name, "a");
  EXPECT_EQ(series.shapes[0].status, std::nullopt);
  EXPECT_EQ(series.shapes[0].seconds, std::nullopt);
  EXPECT_EQ(series.shapes[1].status, 4);
  EXPECT_EQ(series.shapes[1].seconds, 1.25);
  EXPECT_EQ(series.summary.statuses, (ValueCounts{{4, 1}}));
  EXPECT_EQ(series.summary.unknown_status, 1u);
  EXPECT_EQ(series.summary.seconds.count, 1u);
}

TEST_F(Folders, ALogWithoutResultIsAFailure) {
  result("good");
  file("good.log", "STATUS 0\nWALL 0.5\n");
  file("bad.log", "error: no\nSTATUS 1\nWALL 300.00\n");
  file("cut.log", "mesh 0.1\n");
  const Series series = read();
  EXPECT_EQ(series.summary.shapes, 3u);
  EXPECT_EQ(series.summary.evaluated, 1u);
  EXPECT_EQ(series.summary.failures(), 2u);
  EXPECT_EQ(series.summary.seconds.spread.max, 300);
  EXPECT_NE(shape(series, "bad").fault.find("status 1"), std::string::npos);
  EXPECT_NE(shape(series, "cut").fault.find("no status"), std::string::npos);
  EXPECT_FALSE(shape(series, "bad").unreadable);  // there is no file to blame
}

TEST_F(Folders, ABadFileDoesNotStopTheOthers) {
  result("good");
  file("cut.c1.json", format_result(example::square()).substr(0, 300));
  file("cut.log", "STATUS 0\nWALL 2\n");
  file("other.c1.json", "[]");
  const Series series = read();
  EXPECT_EQ(series.summary.shapes, 3u);
  EXPECT_EQ(series.summary.evaluated, 1u);
  EXPECT_TRUE(shape(series, "cut").unreadable);
  EXPECT_EQ(shape(series, "cut").status, 0);
  EXPECT_TRUE(shape(series, "other").unreadable);
  EXPECT_NE(shape(series, "other").fault, "");
}

// A drawing of several shapes has one log; its status holds for all, its time for none alone.
TEST_F(Folders, OneLogForAllShapesOfADrawing) {
  result("sheet-left");
  result("sheet-right-2");
  file("sheet.log", "STATUS 4\nWALL 7\n");
  Series series = read();
  ASSERT_EQ(series.shapes.size(), 2u);
  for (const ShapeEvaluation& s : series.shapes) {
    EXPECT_EQ(s.status, 4) << s.name;
    EXPECT_EQ(s.seconds, std::nullopt) << s.name;
  }
  file("sheet.log", "STATUS 3\nWALL 7\n");  // one of its shapes has no result
  series = read();
  EXPECT_EQ(series.summary.shapes, 3u);
  EXPECT_FALSE(shape(series, "sheet").evaluated);
}

TEST_F(Folders, OtherFilesAreLeftAlone) {
  result("a");
  file("a.tradeoff.json", "{}");
  file("a.svg", "<svg/>");
  file(".a.c1.json", "half");
  file(".c1.json", "nameless");
  std::filesystem::create_directory(root_ + "/b.c1.json");
  EXPECT_EQ(read().summary.shapes, 1u);
}

TEST_F(Folders, NothingToEvaluateIsAnError) {
  EXPECT_THROW(read(), FileError);
  EXPECT_THROW(evaluate_folder(root_ + "/absent", "S"), FileError);
  file("a.svg", "<svg/>");
  EXPECT_THROW(read(), FileError);
  EXPECT_THROW(evaluate_folder(root_ + "/a.svg", "S"), FileError);
}

}  // namespace
}  // namespace c1mesh
