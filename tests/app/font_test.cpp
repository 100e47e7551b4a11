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
