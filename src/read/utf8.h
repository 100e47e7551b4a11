// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace c1mesh::detail {

/// The characters of UTF-8 text. Throws SyntaxError, with the position of the byte, for what is no
/// UTF-8: stray or missing bytes, overlong forms, surrogates, numbers above U+10FFFF.
std::vector<char32_t> decode_utf8(std::string_view text);

}  // namespace c1mesh::detail
