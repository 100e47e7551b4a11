// SPDX-License-Identifier: GPL-3.0-or-later
// All there is of TBB's loops, apart from what runs in them: TBB's library and its headers are not
// compiled with the thread sanitizer (loop_order.h).
#include "base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace c1mesh::detail {

void parallel_ranges(std::size_t count, std::size_t grain,
                     void (*work)(const void* data, std::size_t begin, std::size_t end),
                     const void* data) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [=](const tbb::blocked_range<std::size_t>& range) {
                      work(data, range.begin(), range.end());
                    });
}

}  // namespace c1mesh::detail
