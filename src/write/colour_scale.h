// SPDX-License-Identifier: GPL-3.0-or-later
// From values to colours, and the legend that says which.
#pragma once

#include <string>
#include <vector>

namespace c1mesh {

/// Values of low … high mapped to colours, linearly or by logarithm; what lies outside has the
/// colours of the ends.
struct ColourScale {
  static constexpr int kSteps = 64;  ///< colours that differ
  double low = 1, high = 10;
  bool logarithmic = true;
  std::string label;

  double share(double value) const;  ///< 0 to 1; 1 for what is not finite
  int step(double value) const;      ///< 0 to kSteps - 1
  /// Round values for a legend, ascending, at most so many.
  std::vector<double> ticks(int most) const;
};

/// From 2, linear up to 10, above that logarithmic, to the next round value.
ColourScale distortion_scale(double largest);
/// Whole decades, at least three of them, and up to 1e-11 at least, what `verify` tolerates: what
/// is only rounding looks harmless.
ColourScale deviation_scale(double least_positive, double largest);

/// `#rrggbb` of a share 0 … 1: from pale yellow over orange and magenta to violet. Lightness falls
/// evenly, so the order can be seen in grey print and by whoever does not tell red from green; good
/// places are nearly white and cost no ink. Reversed "magma" of matplotlib (CC0), without its
/// darkest fifth, on which no line would show.
std::string scale_colour(double share);

constexpr double kLegendHeight = 62;  ///< pixels

/// The bar with its ticks and its label, an SVG group `legend`.
std::string legend(const ColourScale& scale, double left, double top, double width);

}  // namespace c1mesh
