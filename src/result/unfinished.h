// SPDX-License-Identifier: GPL-3.0-or-later
// The temporary files that exist at this moment, in a form that a signal handler can read.
#pragma once

#include <sys/types.h>

#include <string>

namespace c1mesh {

/// A file that has no final name yet; until forget() it is known to discard_unfinished_files().
class Unfinished {
 public:
  Unfinished() = default;
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  ~Unfinished() { forget(); }

  /// open(2) of a new file for writing. -1 and errno on failure; ECANCELED once files were
  /// discarded.
  int create(const std::string& path, mode_t mode);
  /// The file has its final name, or is removed.
  void forget();

 private:
  int slot_ = -1;
};

}  // namespace c1mesh
