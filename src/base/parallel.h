// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over independent items. Each item writes only its own slot, so that results do not depend
// on the number of threads.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

#include "base/loop_order.h"

namespace c1mesh {

/// `grain`: how many items at least make a piece of work; 1 for items of many milliseconds.
template <class Body>
void parallel_for(std::size_t count, const Body& body, std::size_t grain = 16) {
  LoopOrder order;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      const LoopOrder::Items items(order);
                      for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
                    });
}

}  // namespace c1mesh
