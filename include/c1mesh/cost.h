// SPDX-License-Identifier: GPL-3.0-or-later
// What the stages of a run cost. Nothing of it enters a result: its bytes must not depend on a
// clock.
#pragma once

#include <string>
#include <vector>

namespace c1mesh {

/// One stage's own time in seconds, that of stages within it taken away: by the wall, and of the
/// process's processors (all threads).
struct StageCost {
  std::string stage;         ///< its name
  double wall = 0, cpu = 0;  ///< seconds
};

/// Sums of what stages cost. It is filled while a CostRecording of the thread that runs the stages
/// holds it; otherwise stages are not timed.
class CostLedger {
 public:
  /// In the order in which they first ended.
  const std::vector<StageCost>& stages() const { return stages_; }
  /// Forgets everything.
  void clear() { stages_.clear(); }
  /// Adds to the stage of this name, in seconds; a new name makes a new stage.
  void add(const char* stage, double wall, double cpu);

 private:
  std::vector<StageCost> stages_;
};

/// While it lives, the calling thread's stages go to `ledger`.
class CostRecording {
 public:
  /// `ledger` must outlive the recording.
  explicit CostRecording(CostLedger& ledger);
  ~CostRecording();
  CostRecording(const CostRecording&) = delete;
  CostRecording& operator=(const CostRecording&) = delete;

 private:
  CostLedger* before_;
};

/// A stage lasts as long as its timer. Timers of one thread nest. `stage` must outlive it.
class StageTimer {
 public:
  /// Begins the stage; nothing is measured where no CostRecording of this thread lives.
  explicit StageTimer(const char* stage);
  ~StageTimer();
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  const char* stage_;
  CostLedger* ledger_;  // null: nobody records
  StageTimer* around_ = nullptr;
  double wall_ = 0, cpu_ = 0;              // at the start
  double inner_wall_ = 0, inner_cpu_ = 0;  // of stages within
};

/// The most memory the process has held so far, in bytes; 0 where that is not known.
double peak_memory();

}  // namespace c1mesh
