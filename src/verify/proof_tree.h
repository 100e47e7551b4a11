// SPDX-License-Identifier: GPL-3.0-or-later
// A proof by subdivision: found by search and recorded, or followed from a record. Both go through
// the same steps, so that what is recorded is what was proven.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "c1mesh/certificate.h"

namespace c1mesh::verification {

class ProofTree {
 public:
  enum class Step {
    proven,  ///< the piece's test holds
    split,   ///< look at the piece's parts
    fail,    ///< the depth, the work or the record ends here
  };

  /// Of at most `most_pieces` pieces, none deeper than `max_depth`.
  ProofTree(int max_depth, int most_pieces) : max_depth_(max_depth), left_(most_pieces) {}

  /// Follows `marks` from now on; no marks stand for a proof without a split.
  void follow(ProofMarks marks) {
    follows_ = true;
    marks_ = marks.empty() ? "0" : std::move(marks);
  }

  bool follows() const { return follows_; }

  /// One piece. A search tries the test; a record says whether it has to hold.
  template <class Test>
  Step step(int depth, const Test& test) {
    deepest_ = std::max(deepest_, depth);
    if (follows_) {
      if (next_ >= marks_.size()) return Step::fail;
      if (marks_[next_++] == '0') return test() ? Step::proven : Step::fail;
      return may_split(depth) ? Step::split : Step::fail;
    }
    if (test()) {
      marks_ += '0';
      return Step::proven;
    }
    if (!may_split(depth)) return Step::fail;
    marks_ += '1';
    return Step::split;
  }

  int depth() const { return deepest_; }

  /// Has all of the record been used?
  bool complete() const { return !follows_ || next_ == marks_.size(); }

  /// The record; empty where nothing was split.
  ProofMarks marks() const { return marks_ == "0" ? "" : marks_; }

 private:
  bool may_split(int depth) { return depth < max_depth_ && left_-- > 0; }

  int max_depth_, left_, deepest_ = 0;
  bool follows_ = false;
  std::size_t next_ = 0;
  std::string marks_;
};

}  // namespace c1mesh::verification
