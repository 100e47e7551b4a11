// SPDX-License-Identifier: GPL-3.0-or-later
// Letters as outlines, from the fonts that the library carries.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "c1mesh/types.h"

namespace c1mesh {

/// One step of an outline: m (move), l (line), c (cubic) to `to`, in ems, y upward.
struct GlyphStep {
  char kind;
  Point first, second, to;
};

/// The characters of UTF-8 text; U+FFFD for what is none.
std::vector<char32_t> characters_of(std::string_view text);

/// Width of a line of text in ems.
double text_width(std::string_view text, bool bold);

/// The text that fits into `width` ems: itself, or its beginning and "…".
std::string text_within(const std::string& text, double width, bool bold);

/// The outlines of a line of text that starts at the origin. Closed contours.
std::vector<GlyphStep> text_outline(std::string_view text, bool bold);

}  // namespace c1mesh
