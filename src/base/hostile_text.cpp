// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/hostile_text.h"

namespace c1mesh {

std::string clipped(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  std::size_t end = most;
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };
  // A character has at most three continuation bytes; what has more is no UTF-8.
  for (int k = 0; k < 3 && end > 0 && continues(text[end]); ++k) --end;
  return std::string(text.substr(0, end)) + "…";
}

bool json_deeper_than(std::string_view text, int most) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > most) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

std::string json_error_text(const char* what) {
  constexpr std::size_t kMost = 200;  // it quotes what was read, a string of megabytes too
  const std::string_view text = what;
  const std::size_t bracket = text.find("] ");
  return clipped(bracket == std::string_view::npos ? text : text.substr(bracket + 2), kMost);
}

}  // namespace c1mesh
