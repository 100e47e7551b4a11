// SPDX-License-Identifier: GPL-3.0-or-later
// Letters from the command line to certified results.
#include <gtest/gtest.h>

#include <fstream>

#include "program.h"

namespace c1mesh {
namespace {

using testing_app::Folder;
using testing_app::Ran;

constexpr const char* kFont = C1MESH_TEST_FONT;

TEST(FontInput, LettersAreDoneEachAndTogether) {
  if (!std::ifstream(kFont)) GTEST_SKIP() << "no font: install fonts-dejavu-core";
  const Folder folder;
  const std::string font = std::string("--font ") + kFont;
  const Ran each = folder.run("run --formats json -o out --text 'B l' " + font);
  EXPECT_EQ(each.status, 0) << each.err;
  EXPECT_EQ(folder.files("out"),
            (std::vector<std::string>{"DejaVuSans-1-B.c1.json", "DejaVuSans-3-l.c1.json"}));
  const Ran word = folder.run("run --together --formats json -o word --text 'Ll' " + font);
  EXPECT_EQ(word.status, 0) << word.err;
  EXPECT_EQ(folder.files("word"), std::vector<std::string>{"DejaVuSans.c1.json"});
  EXPECT_EQ(folder
                .run("verify out/DejaVuSans-1-B.c1.json out/DejaVuSans-3-l.c1.json "
                     "word/DejaVuSans.c1.json")
                .status,
            0);
}

TEST(FontInput, ResultsAreComparedWithTheirLetters) {
  if (!std::ifstream(kFont)) GTEST_SKIP() << "no font: install fonts-dejavu-core";
  const Folder folder;
  const std::string font = std::string(" --font ") + kFont;
  ASSERT_EQ(folder.run("run --formats json -o out --text 'l i'" + font).status, 0);
  const std::string verify = "verify out/DejaVuSans-1-l.c1.json" + font;
  const Ran same = folder.run(verify + " --text 'l i'");
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_NE(same.err.find("as in the input"), std::string::npos) << same.err;
  EXPECT_EQ(folder.run(verify + " --text L").status, 4);
  EXPECT_EQ(folder.run(verify + " --text 'i o'").status, 3);  // other letters: no such name
  EXPECT_EQ(folder.run(verify).status, 2);
  EXPECT_EQ(folder.run(verify + " --text l --input l.svg").status, 2);
}

TEST(FontInput, StatusesAreThoseOfFiles) {
  if (!std::ifstream(kFont)) GTEST_SKIP() << "no font: install fonts-dejavu-core";
  const Folder folder;
  const std::string font = std::string(" --font ") + kFont;
  EXPECT_EQ(folder.run("check" + font + " --text Bo").status, 0);
  EXPECT_EQ(folder.run("check" + font + " --text ''").status, 3);
  EXPECT_EQ(folder.run("check" + font + " --text ' '").status, 3);
  EXPECT_EQ(folder.run("check" + font).status, 2);
  EXPECT_EQ(folder.run("check --text x").status, 2);
  EXPECT_EQ(folder.run("check --font absent.ttf --text x").status, 3);
  EXPECT_EQ(folder.run("run" + font + " --text x").status, 2);  // no output
}

}  // namespace
}  // namespace c1mesh
