// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace c1mesh::charts {
namespace {

constexpr double kApart = 14;       // pixels: width of the bins 0 and infinity
constexpr double kApartGap = 10;    // between those and the others
constexpr double kNarrowest = 3.5;  // pixels of a bar
constexpr double kNameRoom = 34;    // pixels of a tick's name

int floor_div(int a, int b) {
  return a >= 0 ? a / b : -((b - 1 - a) / b);
}

/// Every how many decades one is named, so that names keep apart.
int named_every(double decade) {
  for (const int every : {1, 2, 3, 4, 5, 10, 20, 50})
    if (every * decade >= kNameRoom) return every;
  return 100;
}

}  // namespace

LogAxis::LogAxis(const std::vector<const LogHistogram*>& row, double width) {
  for (const LogHistogram* h : row) {
    zeros_ = zeros_ || h->zeros > 0;
    infinite_ = infinite_ || h->infinite > 0;
    if (h->counts.empty()) continue;
    const int low = floor_div(h->first, LogHistogram::per_decade);
    const int last = h->first + static_cast<int>(h->counts.size()) - 1;
    const int high = floor_div(last, LogHistogram::per_decade) + 1;
    low_ = any_ ? std::min(low_, low) : low;
    high_ = any_ ? std::max(high_, high) : high;
    any_ = true;
  }
  place(width);
}

void LogAxis::place(double width) {
  const double left = zeros_ ? kApart + kApartGap : 0;
  const double right = width - (infinite_ ? kApart + kApartGap : 0);
  const double decade = (right - left) / (high_ - low_);
  while (merged_ < LogHistogram::per_decade &&
         decade * merged_ / LogHistogram::per_decade < kNarrowest)
    merged_ *= 2;
  const int bins = (high_ - low_) * LogHistogram::per_decade / merged_;
  if (zeros_) {
    axis_.bins.push_back({0, kApart});
    axis_.ticks.push_back({kApart / 2, "0", "", false});
  }
  for (int k = 0; k < bins; ++k)
    axis_.bins.push_back(
        {left + (right - left) * k / bins, left + (right - left) * (k + 1) / bins});
  const int every = named_every(decade);
  for (int power = low_; any_ && power <= high_; ++power) {
    const double at = decade * (power - low_);
    const bool named = floor_div(power, every) * every == power && !beside_zero(at);
    if (named)
      axis_.ticks.push_back({left + at, "10", std::to_string(power), true});
    else if (decade >= kNarrowest)
      axis_.ticks.push_back({left + at, "", "", true});
  }
  if (infinite_) {
    axis_.bins.push_back({width - kApart, width});
    axis_.ticks.push_back({width - kApart / 2, "∞", "", false});
  }
}

bool LogAxis::beside_zero(double from_left) const {
  return zeros_ && from_left + kApartGap + kApart / 2 < 0.8 * kNameRoom;
}

std::vector<double> LogAxis::counts(const LogHistogram& histogram) const {
  std::vector<double> out(axis_.bins.size(), 0);
  const int offset = zeros_ ? 1 : 0;
  if (zeros_) out.front() += static_cast<double>(histogram.zeros);
  if (infinite_) out.back() += static_cast<double>(histogram.infinite);
  for (std::size_t k = 0; k < histogram.counts.size(); ++k) {
    const int bin = histogram.first + static_cast<int>(k) - low_ * LogHistogram::per_decade;
    out[offset + bin / merged_] += static_cast<double>(histogram.counts[k]);
  }
  return out;
}

WholeAxis::WholeAxis(const std::vector<const ValueCounts*>& row, double width) {
  int high = 0;
  for (const ValueCounts* values : row) {
    if (values->empty()) continue;
    low_ = std::min(low_, values->begin()->first);
    high = std::max(high, values->rbegin()->first);
  }
  constexpr double kRoom = 9;  // pixels of a bin: three bars stand in it
  while ((high - low_ + step_) / step_ * kRoom > width) ++step_;
  low_ = floor_div(low_, step_) * step_;
  const int bins = (high - low_) / step_ + 1;
  const double each = width / bins;
  constexpr double kDigits = 22;  // pixels of a whole number
  const int every = std::max(1, static_cast<int>(std::ceil(kDigits / each)));
  for (int k = 0; k < bins; ++k) {
    axis_.bins.push_back({each * k, each * (k + 1)});
    const int value = low_ + k * step_;
    if (floor_div(value, every * step_) * every * step_ == value)
      axis_.ticks.push_back({each * (k + 0.5), std::to_string(value), "", false});
  }
}

std::vector<double> WholeAxis::counts(const ValueCounts& values) const {
  std::vector<double> out(axis_.bins.size(), 0);
  for (const auto& [value, count] : values)
    out[(value - low_) / step_] += static_cast<double>(count);
  return out;
}

ShareAxis::ShareAxis(double least, double width) {
  // At least the upper fifth, so that shares near 1 look near 1.
  low_ = std::clamp(10 * static_cast<int>(std::floor(10 * least + 1e-9)), 0, 80);
  step_ = low_ >= 80 ? 1 : low_ >= 60 ? 2 : 5;
  const int bins = (100 - low_) / step_;
  for (int k = 0; k < bins; ++k) axis_.bins.push_back({width * k / bins, width * (k + 1) / bins});
  const int mark = low_ >= 80 ? 5 : low_ >= 60 ? 10 : 20;
  for (int value = (low_ + mark - 1) / mark * mark; value <= 100; value += mark)
    axis_.ticks.push_back(
        {width * (value - low_) / (100 - low_), fmt::format("{:g}", value / 100.0), "", true});
}

std::vector<double> ShareAxis::counts(const std::vector<double>& sample) const {
  std::vector<double> out(axis_.bins.size(), 0);
  const int last = static_cast<int>(out.size()) - 1;
  for (const double x : sample) {
    // 1e-9: a share of k hundredths belongs to the bin that starts there, whatever its rounding.
    const int bin = static_cast<int>(std::floor((100 * x - low_) / step_ + 1e-9));
    out[std::clamp(bin, 0, last)] += 1;
  }
  return out;
}

}  // namespace c1mesh::charts
