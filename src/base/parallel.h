// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over independent items. Each item writes only its own slot, so that results do not depend
// on the number of threads.
#pragma once

#include <cstddef>

#include "base/loop_order.h"

namespace c1mesh {

namespace detail {

/// Calls work(data, begin, end) for ranges that make up [0, count), in any order and threads.
void parallel_ranges(std::size_t count, std::size_t grain,
                     void (*work)(const void* data, std::size_t begin, std::size_t end),
                     const void* data);

}  // namespace detail

/// `grain`: how many items at least make a piece of work; 1 for items of many milliseconds. Throws
/// what an item throws, and std::bad_alloc if there is no memory for threads.
template <class Body>
void parallel_for(std::size_t count, const Body& body, std::size_t grain = 16) {
  struct Loop {
    const Body& body;
    LoopOrder order;  // last: it begins when all else is written
  };
  const Loop loop{body, {}};
  detail::parallel_ranges(
      count, grain,
      [](const void* data, std::size_t begin, std::size_t end) {
        const Loop& here = *static_cast<const Loop*>(data);
        const LoopOrder::Items items(here.order);  // before anything of the caller is read
        for (std::size_t i = begin; i != end; ++i) here.body(i);
      },
      &loop);
}

}  // namespace c1mesh
