// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/xml.h"

#include <cstdint>
#include <string_view>

namespace c1mesh {
namespace {

/// Bytes of the UTF-8 character that the text begins with; 0 if it begins with none that XML knows
/// (overlong forms, surrogates, U+FFFE and U+FFFF are none).
std::size_t character_at(std::string_view text) {
  const auto byte = [&](std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u;
  };
  if (byte(0) < 0x80) return 1;
  const std::size_t size = byte(0) >> 5 == 6    ? 2
                           : byte(0) >> 4 == 14 ? 3
                           : byte(0) >> 3 == 30 ? 4
                                                : 0;
  if (size == 0) return 0;
  std::uint32_t value = byte(0) & (0xFFu >> (size + 1));
  for (std::size_t k = 1; k < size; ++k) {
    if (byte(k) >> 6 != 2) return 0;
    value = value << 6 | (byte(k) & 0x3F);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool none = value < kLeast[size] || (value >= 0xD800 && value < 0xE000) ||
                    value == 0xFFFE || value == 0xFFFF || value > 0x10FFFF;
  return none ? 0 : size;
}

}  // namespace

std::string xml_escaped(const std::string& text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = character_at(std::string_view(text).substr(at));
    const char c = text[at];
    if (size == 0)
      out += "\xEF\xBF\xBD";  // U+FFFD
    else if (size > 1)
      out.append(text, at, size);
    else if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (static_cast<unsigned char>(c) >= 0x20 || c == '\t')
      out += c;
    at += size == 0 ? 1 : size;
  }
  return out;
}

}  // namespace c1mesh
