// SPDX-License-Identifier: GPL-3.0-or-later
// Letters as shapes: the outlines of a font's glyphs.
#pragma once

#include <string>
#include <vector>

#include "c1mesh/shape.h"

namespace c1mesh {

/// The outlines of `text` (UTF-8), set in one line in the scalable font of the file `font`: one
/// drawing per character, or with `options.together` one of all. Units are the font's own, y
/// upward; every control point is exact: no scaling, no hinting (TrueType: degree 2, implied points
/// may be half integers; CFF and Type 1: degree 3). Advance widths and the font's kerning table
/// (`kern`, not GPOS) set the distances. The fill rule is nonzero. Characters without outline, such
/// as the space, give no drawing. Drawings are named FONT-POSITION-LETTER (FONT: the file's name
/// without extension; POSITION: of the character in the text, from 1; LETTER: an ASCII letter or
/// digit as it is, anything else U+XXXX), together FONT. Throws FileError if the font cannot be
/// opened; InputError: malformed (no font, bad UTF-8), unsupported (a font of bitmaps, characters
/// the font does not have), limit, empty (no outline).
std::vector<Drawing> read_font(const std::string& font, const std::string& text,
                               const ReadOptions& options = {});

}  // namespace c1mesh
