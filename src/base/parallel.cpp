// SPDX-License-Identifier: GPL-3.0-or-later
// All there is of TBB's loops, apart from what runs in them: TBB's library and its headers are not
// compiled with the thread sanitizer (loop_order.h).
#include "base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cfenv>
#include <new>
#include <stdexcept>

namespace c1mesh::detail {
namespace {

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

}  // namespace

void parallel_ranges(std::size_t count, std::size_t grain,
                     void (*work)(const void* data, std::size_t begin, std::size_t end),
                     const void* data) {
  // TBB makes its threads at the first loop, and again whenever their number may grow: one thread
  // shall need none.
  if (tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) == 1) {
    const NearestRounding nearest;
    return work(data, 0, count);
  }
  std::atomic<bool> from_an_item = false;
  try {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        try {
                          work(data, range.begin(), range.end());
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

}  // namespace c1mesh::detail
