// SPDX-License-Identifier: GPL-3.0-or-later
// CHOLMOD parallelises copying with OpenMP, in four threads whatever is asked. They gain nothing
// here, and where one cannot be made OpenMP ends the process.
#pragma once

// Weak: CHOLMOD need not be built with OpenMP. <omp.h> would not let them be.
extern "C" {
[[gnu::weak]] int omp_get_max_active_levels();
[[gnu::weak]] void omp_set_max_active_levels(int levels);
}

namespace c1mesh {

/// While it lives, OpenMP starts no threads for the calling thread.
class OneThread {
 public:
  OneThread() {
    if (!available()) return;
    levels_ = omp_get_max_active_levels();
    omp_set_max_active_levels(0);
  }
  ~OneThread() {
    if (available()) omp_set_max_active_levels(levels_);
  }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  static bool available() {
    return omp_get_max_active_levels != nullptr && omp_set_max_active_levels != nullptr;
  }
  int levels_ = 0;
};

}  // namespace c1mesh
