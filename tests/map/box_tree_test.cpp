// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/box_tree.h"

#include <gtest/gtest.h>

#include <random>

namespace c1mesh {
namespace {

TEST(BoxTree, FindsWhatLookingAtEveryBoxFinds) {
  std::mt19937 chance(3);
  const auto number = [&] { return static_cast<double>(chance() % 1000) / 100; };
  for (const int count : {0, 1, 4, 5, 200}) {
    std::vector<Box> boxes;
    for (int k = 0; k < count; ++k) {
      const double x = number(), y = number();
      boxes.push_back({Point(x, y), Point(x + number() / 5, y + number() / 5)});
    }
    const BoxTree tree(boxes);
    int hits = 0;
    for (int trial = 0; trial < 500; ++trial) {
      const double x = number();
      const Point p(x, number());
      std::vector<int> expected;
      for (int k = 0; k < count; ++k)
        if (p.x() >= boxes[k].low.x() && p.x() <= boxes[k].high.x() && p.y() >= boxes[k].low.y() &&
            p.y() <= boxes[k].high.y())
          expected.push_back(k);
      EXPECT_EQ(tree.containing(p), expected);
      hits += static_cast<int>(expected.size());
    }
    if (count == 200) {
      EXPECT_GT(hits, 500);
    }
  }
}

// Equal centres do not keep the tree from ending.
TEST(BoxTree, TakesEqualBoxes) {
  const BoxTree tree(std::vector<Box>(100, Box{Point(0, 0), Point(1, 1)}));
  EXPECT_EQ(tree.containing(Point(1, 0)).size(), 100u);
  EXPECT_TRUE(tree.containing(Point(1.5, 0)).empty());
}

}  // namespace
}  // namespace c1mesh
