// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over independent items. Each item writes only its own slot, so that results do not depend
// on the number of threads.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cfenv>
#include <cstddef>
#include <new>
#include <stdexcept>

#include "base/loop_order.h"

namespace c1mesh {

/// Rounds to nearest while it lives, as TBB's tasks do whatever their caller's mode.
class NearestRounding {
 public:
  NearestRounding() : mode_(std::fegetround()) { std::fesetround(FE_TONEAREST); }
  ~NearestRounding() { std::fesetround(mode_); }
  NearestRounding(const NearestRounding&) = delete;
  NearestRounding& operator=(const NearestRounding&) = delete;

 private:
  int mode_;
};

/// `grain`: how many items at least make a piece of work; 1 for items of many milliseconds. Throws
/// what an item throws, and std::bad_alloc if there is no memory for threads.
template <class Body>
void parallel_for(std::size_t count, const Body& body, std::size_t grain = 16) {
  // TBB makes its threads at the first loop, and again whenever their number may grow: one thread
  // shall need none.
  if (tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) == 1) {
    const NearestRounding nearest;
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  LoopOrder order;
  std::atomic<bool> from_an_item = false;
  try {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        const LoopOrder::Items items(order);
                        try {
                          for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
                        } catch (...) {
                          from_an_item = true;
                          throw;
                        }
                      });
  } catch (const std::runtime_error&) {
    if (from_an_item) throw;
    throw std::bad_alloc();  // TBB says a std::runtime_error when no thread can be made
  }
}

}  // namespace c1mesh
