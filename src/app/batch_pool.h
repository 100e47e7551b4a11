// SPDX-License-Identifier: GPL-3.0-or-later
// The parent's side of a batch: starts children, hears them, notices their ends.
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <list>
#include <string>
#include <vector>

#include "app/batch_child.h"

namespace c1mesh::app {

/// What became of an input.
struct InputEnd {
  Finished finished;
  bool for_good = true;  ///< false: a resumed batch must do it again (it was killed from
                         ///< outside, or its files could not be written)
};

/// Works through inputs, so many at a time, until all are done or a signal asks for the end.
class Pool {
 public:
  using Heard = std::function<void(const InputEnd&)>;

  /// `heard` is called in this thread, once per input that came to an end.
  Pool(const BatchOptions& options, Heard heard);
  /// After a signal children are asked to stop; those that do not within three seconds are killed.
  void work(const std::vector<BatchInput>& inputs);

 private:
  using Clock = std::chrono::steady_clock;

  /// An input in work.
  struct Work {
    BatchInput input;
    Child child;
    std::string heard;  // the beginning of a line whose rest has not come yet
    InputEnd end;
    std::string drawing;       // begun and without record, or empty
    std::size_t begun = 0;     // drawings begun, those of earlier children too
    bool ended = false;        // the child said so
    bool stopped = false;      // the child was asked to stop and did
    bool out_of_time = false;  // we killed it
    Clock::time_point since;
  };

  void start(Work& work);
  bool listen(Work& work);
  void hear(Work& work, const Json& line);
  void look_at_clock(Work& work);
  bool bury(Work& work);
  void record_end(Work& work, int wait_status);
  void stop_all();

  const BatchOptions& options_;
  Heard heard_;
  std::list<Work> working_;
};

}  // namespace c1mesh::app
