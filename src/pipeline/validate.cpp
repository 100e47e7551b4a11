// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/validate.h"

#include <cmath>
#include <stdexcept>

#include "base/float_traps.h"

namespace c1mesh {
namespace {

void validate(const PaperOptions& paper) {
  if (!(paper.extent > 0) || !std::isfinite(paper.extent))
    throw std::invalid_argument("extent must be positive");
  if (!(paper.barrier > 0)) throw std::invalid_argument("rho must be positive");
  if (!(paper.alpha_lift >= 1)) throw std::invalid_argument("alpha_lift must be at least 1");
  for (int phase = 0; phase < 2; ++phase) {
    if (!(paper.regularisation[phase] >= 0) || !(paper.hard_penalty[phase] >= 0))
      throw std::invalid_argument("weights must not be negative");
    if (!(paper.smoothing[phase] > 0)) throw std::invalid_argument("smoothing must be positive");
    if (paper.iterations[phase] < 1) throw std::invalid_argument("iterations must be at least 1");
  }
}

}  // namespace

void validate(const Options& options) {
  const FloatTrapsOff not_a_number;  // fails every comparison and is so refused
  if (!(options.mips_bound > 2)) throw std::invalid_argument("mips_bound must exceed 2");
  if (!(options.alpha >= 1)) throw std::invalid_argument("alpha must be at least 1");
  if (options.degree < 3 || options.degree > 20)
    throw std::invalid_argument("degree must be from 3 to 20");
  if (options.refine != 0 && !(options.refine >= 1 && std::isfinite(options.refine)))
    throw std::invalid_argument("refine must be 0 or at least 1");
  if (!(options.corner_angle >= 0 && options.corner_angle <= 180))
    throw std::invalid_argument("corner_angle must be from 0 to 180 degrees");
  if (!(options.time_limit >= 0)) throw std::invalid_argument("time_limit must not be negative");
  if (options.project && options.method != Method::paper)
    throw std::invalid_argument("project is for the paper's method: the exact one needs none");
  if (options.repeat < 1) throw std::invalid_argument("repeat must be at least 1");
  if (!(options.c1_bound >= 0) || !std::isfinite(options.c1_bound))
    throw std::invalid_argument("c1_bound must not be negative");
  validate(options.paper);
  if (options.threads < 0) throw std::invalid_argument("threads must not be negative");
}

double distortion_asked(const Options& options) {
  const double lift = options.method == Method::paper ? options.paper.alpha_lift : 1;
  return lift * options.alpha * options.mips_bound;
}

}  // namespace c1mesh
