// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over independent items. Each item writes only its own slot, so that results do not depend
// on the number of threads.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

namespace c1mesh {

template <class Body>
void parallel_for(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 16),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
                    });
}

}  // namespace c1mesh
