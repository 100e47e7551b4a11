// SPDX-License-Identifier: GPL-3.0-or-later
// The main job: a shape in, a C1 map out.
#pragma once

#include "c1mesh/options.h"
#include "c1mesh/progress.h"
#include "c1mesh/result.h"
#include "c1mesh/shape.h"
#include "c1mesh/trace.h"
#include "c1mesh/verify.h"

namespace c1mesh {

/// A result and what its verification found.
struct Outcome {
  Result result;                      ///< the map, in the input's units
  VerifyReport report;                ///< of `verify`, on the doubles of `result`
  bool within_bounds = false;         ///< all that was asked holds (exit status 0, else 4)
  bool gave_up = false;               ///< some region keeps C1 at no boundary vertex (last resort)
  bool time_limit_hit = false;        ///< the best state so far was taken (exit status 5)
  std::vector<std::string> remedies;  ///< what the run had to give up or try, in order
  /// By stage; not part of the result, whose bytes must not depend on the clock.
  std::vector<std::pair<std::string, double>> seconds;
};

/// Computes the map of every region of `shape`, verified. Throws Interrupted if `progress` says so
/// before any valid state exists, std::invalid_argument for options out of range. `trace` is told
/// of every iteration.
Outcome parametrize(const Shape& shape, const Options& options = {}, const Progress& progress = {},
                    const Trace& trace = {});

}  // namespace c1mesh
