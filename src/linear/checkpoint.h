// SPDX-License-Identifier: GPL-3.0-or-later
// The outside's part in a long computation: it may stop it, and it may watch it.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <functional>
#include <utility>

#include "c1mesh/trace.h"

namespace c1mesh {

/// Thrown by a checkpoint when the time limit is reached.
struct TimeLimitReached {};

/// Called between iterations; what it throws ends the computation (cancellation, time limit). A
/// computation may also be watched: `observe` is told of its state after every iteration, and makes
/// of it a record for `trace`. Nobody watches unless `trace` is set, and then nothing is computed
/// for it.
struct Checkpoint {
  /// The variables, and the length of the step that led there, 0 if none was possible.
  using Observer = std::function<void(const Eigen::VectorXd& x, double step)>;

  Checkpoint() = default;
  template <std::invocable Stop>
  Checkpoint(Stop throws_to_stop, Trace watching = {})  // NOLINT: a callable is a checkpoint
      : stop(std::move(throws_to_stop)), trace(std::move(watching)) {}

  explicit operator bool() const { return static_cast<bool>(stop); }
  void operator()() const { stop(); }

  /// The same for a part of the computation that has a meaning of its own for its variables.
  Checkpoint observed_by(Observer observer) const {
    Checkpoint out = *this;
    out.observe = std::move(observer);
    return out;
  }

  /// The same for a part whose variables are others: `observe` is told of map(x).
  template <class Map>
  Checkpoint over(Map map) const {
    if (!observe) return *this;
    return observed_by([map = std::move(map), to = observe](const Eigen::VectorXd& x, double step) {
      to(map(x), step);
    });
  }

  /// The same for a part of which every record is changed by `change` (TraceRecord&) on its way.
  template <class Change>
  Checkpoint marked(Change change) const {
    Checkpoint out = *this;
    if (trace)
      out.trace = [change = std::move(change), to = trace](const TraceRecord& record) {
        TraceRecord marked = record;
        change(marked);
        to(marked);
      };
    return out;
  }

  std::function<void()> stop;
  Trace trace;
  Observer observe;
};

}  // namespace c1mesh
