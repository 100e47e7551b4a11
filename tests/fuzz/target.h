// SPDX-License-Identifier: GPL-3.0-or-later
// A fuzz target is a function of bytes that must end without a crash. The same source is a
// libFuzzer program (C1MESH_FUZZ), or one entry of the table that the test `fuzz` replays files
// through.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "c1mesh/error.h"

namespace c1mesh::fuzz {

using Target = std::function<void(const std::string& bytes)>;

/// The targets of this program by name (those linked into it).
std::map<std::string, Target>& targets();

/// Ends the process with this message: a finding.
[[noreturn]] void finding(const std::string& what);

inline void require(bool holds, const char* what) {
  if (!holds) finding(what);
}

/// Runs `work`; the typed errors by which an input is refused, or a time limit ends, are fine if
/// they say what is wrong and what would mend it, anything else is left to fly and ends the
/// process. False: refused.
bool accepted(const std::function<void()>& work);

/// Bytes as a file with a path, for readers that take a path. Nothing is written to a disk.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& bytes);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const;

 private:
  int descriptor_;
};

}  // namespace c1mesh::fuzz

// C1MESH_FUZZ_TARGET(name) { … uses `bytes` … }
#ifdef C1MESH_FUZZ
#define C1MESH_FUZZ_TARGET(name)                                                   \
  static void fuzz_##name(const std::string& bytes);                               \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t n) { \
    fuzz_##name(std::string(reinterpret_cast<const char*>(data), n));              \
    return 0;                                                                      \
  }                                                                                \
  static void fuzz_##name(const std::string& bytes)
#else
#define C1MESH_FUZZ_TARGET(name)                                   \
  static void fuzz_##name(const std::string& bytes);               \
  static const bool fuzz_##name##_known =                          \
      c1mesh::fuzz::targets().emplace(#name, &fuzz_##name).second; \
  static void fuzz_##name(const std::string& bytes)
#endif
