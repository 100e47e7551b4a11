// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/phase.h"

#include <algorithm>
#include <cmath>

#include "domain/apart.h"

namespace c1mesh {
namespace {

// What of the value a step has to gain for the present smoothing to go on.
constexpr double kWorthwhile = 1e-4;

class Phase {
 public:
  Phase(const CurvedMesh& initial, const AskedEdges& asked, const PhaseOptions& options,
        Pair& state, const Checkpoint& checkpoint, const PhaseObserver& observer)
      : initial_(initial),
        asked_(asked),
        options_(options),
        state_(state),
        checkpoint_(checkpoint),
        observer_(observer) {}

  void run() {
    const double first = options_.smoothing[0], last = options_.smoothing[1];
    const int levels = 1 + std::max(0, static_cast<int>(std::lround(std::log10(first / last))));
    const int share = std::max(1, options_.iterations / levels);
    int left = options_.iterations;
    for (int level = 0; level < levels && left > 0; ++level) {
      const bool end = level + 1 == levels;
      smoothing_ = end ? last : first * std::pow(10.0, -level);
      const int allowed = end ? left : std::min(left, share);
      left -= options_.no_overlap && options_.domain_free ? lower_apart(allowed) : lower(allowed);
    }
  }

 private:
  // Newton steps, at most `allowed`; the number taken.
  int lower(int allowed, std::vector<DomainElement> scaffold = {}) {
    PaperObjective objective(initial_, asked_, state_, options_.domain_free, std::move(scaffold));
    objective.weights = options_.weights;
    objective.weights.smoothing = smoothing_;
    Eigen::VectorXd x = objective.pack(state_);
    SparseSolver solver;
    for (int taken = 1;; ++taken) {
      checkpoint_();
      double value, step;
      const double decrease = newton_step(objective, solver, x, value, step);
      state_ = objective.unpack(x);
      if (observer_) observer_(objective, x, step);
      converged_ = !(decrease > kWorthwhile * std::abs(value));
      if (converged_ || taken == allowed) return taken;
    }
  }

  // The same a few steps at a time, each time with a fresh scaffold around the domain. Steps after
  // which the boundary crosses itself nevertheless are undone and taken with the scaffold's flat
  // triangles too.
  int lower_apart(int allowed) {
    constexpr int kSteps = 5;
    Flats flats = Flats::left_out;
    int taken = 0;
    while (taken < allowed) {
      const Pair before = state_;
      taken += lower(std::min(kSteps, allowed - taken),
                     scaffold_elements(initial_, state_.domain, flats, options_.weights.barrier));
      if (!boundary_meets_itself(initial_, state_.domain)) {
        if (converged_) break;
        continue;
      }
      state_ = before;
      if (flats == Flats::kept) break;
      flats = Flats::kept;
    }
    return taken;
  }

  const CurvedMesh& initial_;
  const AskedEdges& asked_;
  const PhaseOptions& options_;
  Pair& state_;
  const Checkpoint& checkpoint_;
  const PhaseObserver& observer_;
  double smoothing_ = 0;
  bool converged_ = false;
};

}  // namespace

void run_phase(const CurvedMesh& initial, const AskedEdges& asked, const PhaseOptions& options,
               Pair& state, const Checkpoint& checkpoint, const PhaseObserver& observer) {
  Phase(initial, asked, options, state, checkpoint, observer).run();
}

}  // namespace c1mesh
