// SPDX-License-Identifier: GPL-3.0-or-later
// What a caller may ask of a run; the command line has the same names.
#pragma once

#include <cstdint>
#include <string>

namespace c1mesh {

struct Options {
  double alpha = 100;       ///< g(t) <= alpha * mips_bound is asked of every triangle (eq. 4.5)
  double mips_bound = 10;   ///< mu, the MIPS bound of the initial triangulation
  int degree = 3;           ///< at least 3; raised to the input's highest degree
  int exceptional = -1;     ///< how many exceptional vertices are allowed; -1: fewest within alpha
  double refine = 0;        ///< at most so many times the triangles, for as low a g as that gives;
                            ///< at least 1 (none), or 0: up to 2 times, while g exceeds 20
  bool no_overlap = false;  ///< the domain must not overlap itself in the plane
  double corner_angle = 8;  ///< degrees: a joint that turns by more is a corner
  int threads = 0;          ///< 0: as many as there are cores; the result does not depend on it
  std::uint64_t seed = 1;
  double time_limit = 0;  ///< seconds; 0: none
};

}  // namespace c1mesh
