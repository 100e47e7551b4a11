// SPDX-License-Identifier: GPL-3.0-or-later
// Winding numbers and areas of loops.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "check/pieces.h"

namespace c1mesh::detail {

/// How often the loop winds counter-clockwise around `p`, a point of the normalised frame farther
/// from the loop than the resolution: crossings of the ray to the right. Loops are closed bit for
/// bit and pieces share their ends' bits, so the half-open rule counts every crossing once.
int winding_number(const Loop& loop, const Pieces& pieces, const Point& p);

/// Winding numbers of many loops at once: a query costs as much as there are pieces at the point's
/// height. `pieces` must outlive it.
class WindingIndex {
 public:
  WindingIndex(const std::vector<Loop>& loops, const Pieces& pieces);
  /// (loop, winding_number of it around p) where that is not zero, by increasing loop, of the loops
  /// for which `wanted` is true. None of these may pass through p: the search for which side they
  /// are on would be long.
  std::vector<std::pair<int, int>> around(const Point& p,
                                          const std::function<bool(int)>& wanted) const;

 private:
  struct Entry {
    double low, high, right;
    double highest;  // of the entry's subtree
    int loop, piece;
    bool reversed;
  };
  double arrange(int first, int last);
  void search(int first, int last, const Point& p, const std::function<bool(int)>& wanted,
              std::vector<std::pair<int, int>>& out) const;

  const Pieces& pieces_;
  std::vector<Entry> entries_;  // by `low`; a range's middle is the root of its tree
};

/// The signed area the loop encloses, in the normalised frame.
double signed_area(const Loop& loop, const Arrangement& arrangement);

}  // namespace c1mesh::detail
