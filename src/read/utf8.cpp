// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/utf8.h"

#include "read/scanner.h"

namespace c1mesh::detail {
namespace {

[[noreturn]] void fail(std::size_t at) {
  throw SyntaxError("the text is no UTF-8", at);
}

// How many bytes follow this first one, and the bits it carries itself (RFC 3629).
struct Lead {
  int following;
  char32_t bits, least;
};

Lead lead_of(unsigned char byte, std::size_t at) {
  if (byte < 0x80) return {0, byte, 0};
  if ((byte & 0xe0) == 0xc0) return {1, byte & 0x1fu, 0x80};
  if ((byte & 0xf0) == 0xe0) return {2, byte & 0x0fu, 0x800};
  if ((byte & 0xf8) == 0xf0) return {3, byte & 0x07u, 0x10000};
  fail(at);
}

}  // namespace

std::vector<char32_t> decode_utf8(std::string_view text) {
  std::vector<char32_t> out;
  for (std::size_t at = 0; at < text.size();) {
    const Lead lead = lead_of(static_cast<unsigned char>(text[at]), at);
    char32_t character = lead.bits;
    for (int k = 1; k <= lead.following; ++k) {
      const std::size_t next = at + static_cast<std::size_t>(k);
      if (next >= text.size()) fail(at);
      const auto byte = static_cast<unsigned char>(text[next]);
      if ((byte & 0xc0) != 0x80) fail(next);
      character = character << 6 | (byte & 0x3fu);
    }
    const bool surrogate = character >= 0xd800 && character <= 0xdfff;
    if (character < lead.least || character > 0x10ffff || surrogate) fail(at);
    out.push_back(character);
    at += static_cast<std::size_t>(lead.following) + 1;
  }
  return out;
}

}  // namespace c1mesh::detail
