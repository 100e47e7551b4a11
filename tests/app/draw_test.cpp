// SPDX-License-Identifier: GPL-3.0-or-later
// draw of several results and of parts of them, from the command line.
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace c1mesh
