// SPDX-License-Identifier: GPL-3.0-or-later
// The work on one input, in a process of its own: what ends that process ends nothing else.
#pragma once

#include <sys/types.h>

#include <cstddef>

#include "app/batch_inputs.h"
#include "app/batch_journal.h"
#include "app/run_options.h"
#include "app/status.h"

namespace c1mesh::app {

struct BatchOptions {
  RunOptions run;
  int jobs = 0;             ///< inputs at a time; 0: as many as there are cores
  double kill_after = 0;    ///< seconds; 0: see patience()
  double memory_limit = 0;  ///< MB of address space per process; 0: none
  bool verbose = false;

  /// Seconds a shape may take before its process is killed: if nothing is asked, twice the time
  /// limit and ten more, for stages that do not look at the clock; without a time limit 0: no end.
  double patience() const;
};

/// What an input's results depend on beside the options: changed content or names are done anew.
std::string key_of(const BatchInput& input, const std::string& content);

/// A line of the index for a shape without result.
Json failure_record(const BatchInput& input, const std::string& name, Status status,
                    const std::string& message);

/// A started process. Lines of JSON come out of `pipe`, in this order:
///   {"key": …}                             once the input is read
///   {"begin": NAME}                        per drawing, before the work on it, and then
///   {"record": …, "seconds": …, "files": …, "for_good": …}
///   {"end": true}                          or, after a signal, {"stopped": true}
struct Child {
  pid_t process = -1;
  int pipe = -1;
};

/// Forks a process that does the input's drawings from number `first` on. Must be called while this
/// process has one thread only. Throws std::runtime_error if there can be no more processes.
Child start_child(const BatchInput& input, const BatchOptions& options, std::size_t first);

}  // namespace c1mesh::app
