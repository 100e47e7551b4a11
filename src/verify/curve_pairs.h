// SPDX-License-Identifier: GPL-3.0-or-later
// Do two Bezier curves meet? Certified by subdivision in interval arithmetic.
#pragma once

#include <vector>

#include "c1mesh/types.h"
#include "verify/proof_tree.h"

namespace c1mesh::verification {

/// `apart` and `meet` are proven; `unknown` when the depth or the work runs out.
enum class Meeting { apart, meet, unknown };

/// Which points two curves have in common by construction: none, their first points, or their first
/// points and their last points. `apart` then means that they have no other.
enum class Shared { none, start, both_ends };

/// A tree for one comparison: pieces far above what curves that keep apart need.
inline ProofTree comparison_tree(int max_depth) {
  return {max_depth, 20000};
}

/// Where `tree` follows a record, `apart` means that the record proves it; anything else is
/// `unknown`.
Meeting curves_meet(const std::vector<Point>& a, const std::vector<Point>& b, Shared shared,
                    ProofTree& tree);

/// Does one curve meet itself?
Meeting meets_itself(const std::vector<Point>& curve, ProofTree& tree);

/// How often a closed chain of curves winds around q; `known` is false if q is too close to it.
struct Winding {
  int number = 0;
  bool known = true;
};
Winding winding_around(const std::vector<std::vector<Point>>& loop, const Point& q, int max_depth);

/// Sign of the signed area inside a closed chain of curves of one degree; 0: too close to zero.
int area_sign(const std::vector<std::vector<Point>>& loop);

}  // namespace c1mesh::verification
