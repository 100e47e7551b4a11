// SPDX-License-Identifier: GPL-3.0-or-later
// Work that C code calls back and that may run out of memory.
#pragma once

#include <new>

namespace c1mesh {

/// 0, or the C library's own `out_of_memory` in place of std::bad_alloc: C code must see no
/// exception. The work throws no other.
template <class Work>
int called_back(const Work& work, int out_of_memory) {
  try {
    work();
    return 0;
  } catch (const std::bad_alloc&) {
    return out_of_memory;
  }
}

}  // namespace c1mesh
