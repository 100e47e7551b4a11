// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures in pixels.
#pragma once

#include <string>

namespace c1mesh {

/// The longest side of a picture, in pixels.
constexpr double kLongestPngSide = 30000;
/// The most pixels of a picture: at most 400 MB while they are painted.
constexpr double kMostPngPixels = 100e6;

/// How a picture becomes pixels.
struct PngOptions {
  bool transparent = false;  ///< what nothing is painted on stays transparent instead of white
};

/// The bytes of a PNG file: a picture that this library drew as SVG (draw_svg, draw_contact_sheet,
/// draw_trace, draw_trade_off, draw_evaluation), as many pixels large as its `width` and `height`
/// say. Text is set in DejaVu Sans, which the library carries: no font need be installed, and the
/// same text gives the same bytes. Throws std::invalid_argument if the picture is larger than the
/// limits above, or if the text is not of the SVG that this library writes.
std::string png_of(const std::string& svg, const PngOptions& options = {});

}  // namespace c1mesh
