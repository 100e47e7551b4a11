// SPDX-License-Identifier: GPL-3.0-or-later
// Reading what may have no end.
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace c1mesh {

/// All of the stream; nothing if it has more than `max_bytes`. In blocks, so that an endless one
/// stops there rather than filling the memory.
inline std::optional<std::string> read_at_most(std::istream& in, std::size_t max_bytes) {
  std::string text;
  std::vector<char> block(1 << 16);
  while (in) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > max_bytes) return std::nullopt;
  }
  return text;
}

}  // namespace c1mesh
