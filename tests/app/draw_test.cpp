// SPDX-License-Identifier: GPL-3.0-or-later
// draw of several results and of parts of them, from the command line.
#include <gtest/gtest.h>

#include <utility>

#include "program.h"

namespace c1mesh {
namespace {

using testing_app::Folder;
using testing_app::Ran;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const char* const kTrapezium =
    R"([{"curve_id":0,"type":"BezierCurve","degree":1,"poles":[[0,0],[2,0]]},
        {"curve_id":1,"type":"BezierCurve","degree":1,"poles":[[2,0],[1,1]]},
        {"curve_id":2,"type":"BezierCurve","degree":2,"poles":[[1,1],[0.5,1.2],[0,1]]},
        {"curve_id":3,"type":"BezierCurve","degree":1,"poles":[[0,1],[0,0]]}])";

class DrawResults : public testing::Test {
 protected:
  void SetUp() override {
    folder.write("a.json", kTrapezium);
    folder.write("b.json", kTrapezium);
    ASSERT_EQ(folder.run("run a.json b.json -o . --formats json").status, 0);
  }
  Folder folder;
};

TEST_F(DrawResults, SeveralResultsWithPartsAndTitles) {
  const Ran ran = folder.run(
      "draw a.c1.json b.c1.json --columns 2 --parts mesh,domain --titles 'the first,the second' "
      "-o -");
  ASSERT_EQ(ran.status, 0) << ran.err;
  for (const char* part : {">the first<", ">the second<", "id=\"mesh\"", "id=\"domain\"",
                           "id=\"mesh-2\"", "id=\"domain-2\""})
    EXPECT_TRUE(contains(ran.out, part)) << part;
  EXPECT_FALSE(contains(ran.out, "id=\"shape"));
  EXPECT_EQ(folder.run("draw a.c1.json --parts shape,domain --columns 1 -o -").out,
            folder.run("draw a.c1.json -o -").out);
}

TEST_F(DrawResults, OverAndZoom) {
  const Ran ran = folder.run("draw a.c1.json --over b.c1.json --zoom apart,0.1 -o -");
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(contains(ran.out, "class=\"over\""));
  EXPECT_TRUE(contains(ran.out, "id=\"domain-zoom\""));
  EXPECT_TRUE(contains(folder.run("draw a.c1.json --zoom 0,0.1 -o -").out, "id=\"shape-zoom\""));
}

TEST_F(DrawResults, RefusesWhatCannotBeDrawn) {
  for (const char* options : {"--parts picture", "--zoom 3", "--zoom x,0.1", "--zoom 1,0",
                              "--zoom -2,0.1", "--columns 0"})
    EXPECT_EQ(folder.run(std::string("draw a.c1.json -o - ") + options).status, 2) << options;
  EXPECT_NE(folder.run("draw a.c1.json -o - --zoom 100000,0.1").status, 0);
  EXPECT_NE(folder.run("draw a.c1.json -o - --zoom apart,0.1").status, 0);
  EXPECT_NE(folder.run("draw a.c1.json --titles one,two -o -").status, 0);
  const Ran missing = folder.run("draw a.c1.json none.c1.json -o -");
  EXPECT_NE(missing.status, 0);
  EXPECT_TRUE(contains(missing.err, "none.c1.json"));
  EXPECT_TRUE(missing.out.empty());
}

// Width and height as the file's header states them; nothing of what is no PNG file.
std::pair<int, int> png_size(const std::string& png) {
  if (png.size() < 24 || png.substr(0, 8) != "\x89PNG\r\n\x1a\n") return {0, 0};
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t k = 0; k < 4; ++k)
      value = 256 * value + static_cast<unsigned char>(png[at + k]);
    return value;
  };
  return {number(16), number(20)};
}

TEST_F(DrawResults, PixelsByExtension) {
  for (const int width : {300, 3000}) {
    const std::string name = std::to_string(width) + ".png";
    const std::string command = "draw a.c1.json -o " + name + " --width " + std::to_string(width);
    const Ran ran = folder.run(command);
    ASSERT_EQ(ran.status, 0) << ran.err;
    const std::string once = folder.read(name);
    EXPECT_EQ(png_size(once).first, width);
    EXPECT_GT(png_size(once).second, width / 4);
    ASSERT_EQ(folder.run(command).status, 0);
    EXPECT_EQ(folder.read(name), once);
  }
  ASSERT_EQ(folder.run("convert a.c1.json -o c.png").status, 0);
  EXPECT_EQ(png_size(folder.read("c.png")).first, 1200);
  ASSERT_EQ(folder.run("run a.json -o out --formats json,png").status, 0);
  EXPECT_EQ(folder.files("out"), (std::vector<std::string>{"a.c1.json", "a.png"}));
  EXPECT_EQ(folder.read("out/a.png"), folder.read("c.png"));
  for (const char* colour : {"none", "distortion", "c1-deviation", "checkerboard"})
    EXPECT_EQ(
        folder
            .run(std::string("draw a.c1.json -o d.png --control-net --transparent --colour ") +
                 colour)
            .status,
        0)
        << colour;
}

// No font is where the program runs.
TEST_F(DrawResults, PixelsNeedNoInstalledFont) {
  ASSERT_EQ(folder.run("draw a.c1.json -o with.png").status, 0);
  folder.write("empty.conf", "<fontconfig></fontconfig>");
  folder.write("run.sh",
               "export FONTCONFIG_FILE=$PWD/empty.conf FONTCONFIG_PATH=/none HOME=/none\n");
  ASSERT_EQ(folder
                .run("--version > /dev/null; . ./run.sh; " C1MESH_PROGRAM
                     " draw a.c1.json -o without.png")
                .status,
            0);
  EXPECT_EQ(folder.read("with.png"), folder.read("without.png"));
}

TEST_F(DrawResults, PixelsHaveLimitsAndErrors) {
  const Ran wide = folder.run("draw a.c1.json -o x.png --width 100000");
  EXPECT_EQ(wide.status, 2);
  EXPECT_TRUE(contains(wide.err, "30000")) << wide.err;
  const Ran large = folder.run("draw a.c1.json -o x.png --width 29000 --columns 1");
  EXPECT_EQ(large.status, 2);
  EXPECT_TRUE(contains(large.err, "too large")) << large.err;
  EXPECT_EQ(folder.run("draw a.c1.json -o x.svg --width 100000").status, 0);
  EXPECT_EQ(folder.run("draw a.c1.json -o none/x.png").status, 1);
  EXPECT_EQ(folder.run("draw none.c1.json -o x.png").status, 3);
  EXPECT_EQ(folder.run("draw a.c1.json --colour checkerboard --grid 0 -o x.png").status, 2);
  for (const std::string& file : folder.files()) EXPECT_NE(file, "x.png");
}

TEST_F(DrawResults, ContactSheets) {
  const Ran ran = folder.run("draw a.c1.json b.c1.json --contact-sheet -o sheet.png");
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(png_size(folder.read("sheet.png")).first, 1200);
  const std::string svg = folder.run("draw a.c1.json b.c1.json --contact-sheet -o -").out;
  EXPECT_TRUE(contains(svg, ">2 results<"));
  EXPECT_TRUE(contains(svg, ">2 certified<"));
  EXPECT_FALSE(
      contains(folder.run("draw a.c1.json --no-verify --contact-sheet -o -").out, ">1 certified<"));
  // What cannot be read has its cell; the sheet is written, the status says so.
  folder.write("broken&<b>.c1.json", "{\"format\": \"c1mesh\"");
  const Ran worse =
      folder.run("draw 'broken&<b>.c1.json' a.c1.json missing.c1.json --contact-sheet -o s.svg");
  EXPECT_EQ(worse.status, 3);
  EXPECT_TRUE(contains(worse.err, "missing.c1.json"));
  const std::string sheet = folder.read("s.svg");
  EXPECT_TRUE(contains(sheet, "1 certified, 2 cannot be read"));
  EXPECT_TRUE(contains(sheet, "broken&amp;&lt;b&gt;"));
  EXPECT_EQ(folder.run("draw a.c1.json --contact-sheet -o none/s.svg").status, 1);
}

TEST_F(DrawResults, ContactSheetsInPages) {
  ASSERT_EQ(folder
                .run("draw a.c1.json b.c1.json a.c1.json --contact-sheet --per-page 2 "
                     "--width 400 -o p.png")
                .status,
            0);
  EXPECT_EQ(png_size(folder.read("p-1.png")).first, 400);
  EXPECT_EQ(png_size(folder.read("p-2.png")).first, 400);
  ASSERT_EQ(folder.run("draw a.c1.json b.c1.json --contact-sheet --per-page 2 -o q.svg").status, 0);
  EXPECT_FALSE(folder.read("q.svg").empty());
  EXPECT_EQ(folder.run("draw a.c1.json b.c1.json --contact-sheet --per-page 1 -o -").status, 2);
  for (const char* options : {"--contact-sheet --zoom 1,0.1", "--contact-sheet --titles a",
                              "--per-page 3", "--no-verify", "--contact-sheet --over b.c1.json"})
    EXPECT_EQ(folder.run(std::string("draw a.c1.json -o x.svg ") + options).status, 2) << options;
}

}  // namespace
}  // namespace c1mesh
