// SPDX-License-Identifier: GPL-3.0-or-later
// What a caller may ask of a run; the command line has the same names.
#pragma once

#include <cstdint>
#include <string>

namespace c1mesh {

/// Which method makes the map.
enum class Method {
  exact,  ///< C1 to rounding (docs/method.md)
  paper,  ///< the paper's two phases (docs/paper.md)
};

/// How near-flat domain vertices are moved onto the line between two corners (paper, section 4.3).
enum class Straightening {
  orthogonal,  ///< orthogonally, as the paper says
  fractions,   ///< to the fractions that C1 at smooth boundary vertices asks for
};

/// Where the paper's method ends. A result before the last stage claims C1 nowhere.
enum class PaperStage {
  initial,    ///< the initial triangulation and its domain (paper, section 4.1)
  phase_one,  ///< domain not straightened yet
  phase_two,  ///< all of it
};

/// Parameters of the paper's method, with the paper's values (section 5.1) as defaults. Two values
/// are for phase one and phase two. Lengths are measured where the larger side of the shape's
/// bounding box is `extent` units: E_s grows with it, E_reg with its square, E_g not at all.
struct PaperOptions {
  double extent = 1000;                     ///< larger side of the shape for the weights below
  double regularisation[2] = {1e-6, 1e-8};  ///< lambda_reg
  double hard_penalty[2] = {100, 1};        ///< lambda_h
  double barrier = 0.1;                     ///< rho
  double alpha_lift = 3;                    ///< factor on alpha in phase two
  double smoothing[2] = {1e-3, 1e-9};       ///< of the norms in E_s, first and last, tenfold
                                            ///< falling; relative to the extent
  int iterations[2] = {300, 60};            ///< at most, in each phase
  Straightening straightening = Straightening::orthogonal;  ///< between the phases
  PaperStage last_stage = PaperStage::phase_two;            ///< where to end
};

/// What is asked of a run. Out of range: std::invalid_argument from what takes them.
struct Options {
  Method method = Method::exact;  ///< how the map is made
  double alpha = 100;       ///< g(t) <= alpha * mips_bound is asked of every triangle (eq. 4.5)
  double mips_bound = 10;   ///< mu, the MIPS bound of the initial triangulation
  int degree = 3;           ///< at least 3; raised to the input's highest degree
  int exceptional = -1;     ///< how many exceptional vertices are allowed; -1: fewest within alpha
  double refine = 0;        ///< at most so many times the triangles, for as low a g as that gives;
                            ///< at least 1 (none), or 0: up to 2 times, while g exceeds 20
  bool no_overlap = false;  ///< the domain must not overlap itself in the plane
  double corner_angle = 8;  ///< degrees: a joint that turns by more is a corner
  int threads = 0;          ///< 0: as many as there are cores; the result does not depend on it
  std::uint64_t seed = 1;   ///< of every random choice
  double time_limit = 0;    ///< seconds; 0: none
  int repeat = 1;           ///< paper's method: how often phases one and two are run
  bool project = false;     ///< afterwards onto the C1 space, boundary and all (paper, section 5.4)
  /// Every d_ei relative to the extent is asked to be at most this, with nothing for rounding;
  /// 0: to rounding, and for the paper's method 1e-4.
  double c1_bound = 0;
  PaperOptions paper;  ///< of the paper's method only
};

/// The bound of d_ei that is asked, relative to the extent; 0: to rounding.
inline double c1_asked(const Options& options) {
  constexpr double kOfThePaper = 1e-4;
  if (options.c1_bound > 0) return options.c1_bound;
  return options.method == Method::paper ? kOfThePaper : 0;
}

/// The largest g(t) that is asked: alpha mips_bound, in the paper's method with alpha as lifted.
double distortion_asked(const Options& options);

}  // namespace c1mesh
