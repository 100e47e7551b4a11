// SPDX-License-Identifier: GPL-3.0-or-later
// What every reader of strangers' text needs before it trusts it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace c1mesh {

/// The text, or its beginning and "…" if it is longer than `most` bytes: for what messages quote.
/// No UTF-8 character is cut in two.
std::string clipped(std::string_view text, std::size_t most);

/// Are brackets of JSON text nested deeper than `most` levels? A parser that builds trees need not
/// recurse, but whoever copies, compares or prints them does.
bool json_deeper_than(std::string_view text, int most);

/// What a JSON library says of a syntax error, short and without the library's own error number.
std::string json_error_text(const char* what);

}  // namespace c1mesh
