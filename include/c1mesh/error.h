// SPDX-License-Identifier: GPL-3.0-or-later
// What can be wrong with an input, and the one exception type that carries it.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "c1mesh/types.h"

namespace c1mesh {

/// What kind of fault an input has.
enum class DefectKind {
  malformed,             ///< the file is not what its name says: syntax, missing keys, wrong types
  unsupported,           ///< legal but not ours: rational curves, text, images
  limit,                 ///< larger or deeper than the reader's limits
  non_finite,            ///< a coordinate is NaN, infinite, or too large to work with
  empty,                 ///< nothing to mesh
  zero_length,           ///< all control points of a curve coincide
  vanishing_derivative,  ///< the derivative of a curve vanishes at an end or inside
  cusp,                  ///< two curves meet at a zero angle (the boundary turns by 180 degrees)
  open_loop,             ///< a chain of curves does not close
  gap,                   ///< end points that should agree differ by a small distance
  branching,             ///< more than two boundary curves end in one point
  duplicate,             ///< two curves (or parts of them) coincide
  self_intersection,     ///< one curve meets itself
  crossing,              ///< two curves cross
  touching,              ///< two curves touch, or a loop passes twice through one point
  handle,                ///< control points were re-spaced
  note,                  ///< a conversion worth knowing: orientation reversed, arcs approximated
};

/// The kind's name as printed and as written to files, for example "self-intersection".
const char* name_of(DefectKind kind);

/// One finding of `read` or `check`.
struct Defect {
  DefectKind kind = DefectKind::note;  ///< what kind of finding
  std::vector<std::string> curves;     ///< ids of the curves concerned, in the input's own naming
  std::vector<Point> where;            ///< coordinates in the input's units
  std::string message;                 ///< what is wrong, one sentence
  std::string remedy;                  ///< what would mend it, one sentence; empty for notes
  bool repaired = false;               ///< mended on the way; the result uses the mended curve
};

/// "kind: message (curves …, at (x, y)); remedy" on one line.
std::string describe(const Defect& defect);

/// The input cannot be used. Carries every defect found, not just the first (exit status 3).
class InputError : public std::runtime_error {
 public:
  /// what() describes the first of the defects.
  explicit InputError(std::vector<Defect> found);
  /// Everything that was found, in the order in which it was found.
  const std::vector<Defect>& defects() const { return defects_; }

 private:
  std::vector<Defect> defects_;
};

/// A file could not be read or written (exit status 3 when reading, 1 when writing).
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The work was stopped from outside: cancellation or a time limit (exit status 5).
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace c1mesh
