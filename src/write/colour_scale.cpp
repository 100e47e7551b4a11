// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/colour_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/xml.h"

namespace c1mesh {
namespace {

constexpr double kTickRoom = 38;       // pixels that the number at a tick takes
constexpr double kLargestShown = 1e9;  // a distortion; what is above is as hopeless

/// 1, 2, 5, 10, 20, … by their number; 0 is 1.
double round_value(int k) {
  constexpr std::array<double, 3> kDigits{1, 2, 5};
  const int decade = static_cast<int>(std::floor(k / 3.0));
  return kDigits[k - 3 * decade] * std::pow(10.0, decade);
}

std::string tick_text(double value) {
  if (value == 0 || (value >= 1e-3 && value < 1e5)) return fmt::format("{:.6g}", value);
  const int decade = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  return fmt::format("{:.3g}e{}", value / std::pow(10.0, decade), decade);
}

}  // namespace

double ColourScale::share(double value) const {
  if (!std::isfinite(value)) return 1;
  if (!(value > low)) return 0;
  if (value >= high) return 1;
  return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

int ColourScale::step(double value) const {
  return std::clamp(static_cast<int>(share(value) * kSteps), 0, kSteps - 1);
}

std::vector<double> ColourScale::ticks(int most) const {
  std::vector<double> out;
  if (!logarithmic) {
    int k = -6;
    while ((high - low) / round_value(k) + 1 > most + 1e-9) ++k;
    const double step = round_value(k);
    for (double tick = std::ceil(low / step - 1e-9) * step; tick <= high + 1e-9 * step;
         tick += step)
      out.push_back(tick);
    return out;
  }
  // Every 1-2-5, every decade, every second one and so on: the first that fits.
  for (int every = 1;; every = every < 3 ? 3 : every + 3) {
    out.clear();
    const int first = 3 * static_cast<int>(std::floor(std::log10(low) + 1e-9));
    for (int k = first; round_value(k) <= high * (1 + 1e-9); ++k)
      if (round_value(k) >= low * (1 - 1e-9) && (k - first) % every == 0)
        out.push_back(round_value(k));
    if (static_cast<int>(out.size()) <= std::max(most, 2)) return out;
  }
}

ColourScale distortion_scale(double largest) {
  constexpr double kLinearTo = 10;
  ColourScale scale{2, 3, false, "distortion (MIPS: 2 is a similarity)"};
  if (!std::isfinite(largest)) largest = kLargestShown;
  for (const double high : {3.0, 4.0, 6.0, 8.0, kLinearTo}) {
    scale.high = high;
    if (largest <= high) return scale;
  }
  int k = 3;
  while (round_value(k) < std::min(largest, kLargestShown)) ++k;
  return {2, round_value(k), true, scale.label + ", logarithmic"};
}

ColourScale deviation_scale(double least_positive, double largest) {
  constexpr double kSmallest = 1e-17, kTolerance = 1e-11, kLargest = 1e3;
  const double most = std::clamp(largest, kTolerance, kLargest);
  const double least = std::clamp(least_positive, kSmallest, 1e-3 * most);
  const double low = std::floor(std::log10(least) + 1e-9),
               high = std::ceil(std::log10(most) - 1e-9);
  return {std::pow(10.0, low), std::pow(10.0, high), true,
          "C1 deviation, relative to the extent, logarithmic"};
}

std::string scale_colour(double share) {
  static constexpr std::array<std::array<int, 3>, 9> kStops{{{0xFC, 0xFD, 0xBF},
                                                             {0xFE, 0xCE, 0x91},
                                                             {0xFE, 0x9F, 0x6D},
                                                             {0xF7, 0x6F, 0x5C},
                                                             {0xDE, 0x49, 0x68},
                                                             {0xB6, 0x36, 0x79},
                                                             {0x8C, 0x29, 0x81},
                                                             {0x64, 0x1A, 0x80},
                                                             {0x3B, 0x0F, 0x70}}};
  const double at = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const auto first = std::min<std::size_t>(static_cast<std::size_t>(at), kStops.size() - 2);
  const double rest = at - static_cast<double>(first);
  std::array<long, 3> rgb;
  for (int k = 0; k < 3; ++k)
    rgb[k] = std::lround((1 - rest) * kStops[first][k] + rest * kStops[first + 1][k]);
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

std::string legend(const ColourScale& scale, double left, double top, double width) {
  constexpr int kSteps = ColourScale::kSteps;
  const double bar = width / kSteps;
  std::string out = "<g id=\"legend\" font-size=\"11\">\n";
  out += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", left, top + 11,
                     xml_escaped(scale.label));
  for (int k = 0; k < kSteps; ++k)  // the next one covers what overlaps, so that no gap shows
    out += fmt::format(
        "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"10\" fill=\"{}\"/>\n",
        left + k * bar, top + 17, k + 1 < kSteps ? bar + 0.5 : bar,
        scale_colour((k + 0.5) / kSteps));
  out += fmt::format(
      "<rect class=\"frame\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"10\"/>\n", left,
      top + 17, width);
  for (const double tick : scale.ticks(static_cast<int>(width / kTickRoom))) {
    const double x = left + scale.share(tick) * width;
    out += fmt::format("<path class=\"tick\" d=\"M{:.2f},{:.2f}v4\"/>\n", x, top + 27);
    out += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"middle\">{}</text>\n", x,
                       top + 42, tick_text(tick));
  }
  return out + "</g>\n";
}

}  // namespace c1mesh
