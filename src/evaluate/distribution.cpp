// SPDX-License-Identifier: GPL-3.0-or-later
// Samples in few numbers.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "c1mesh/evaluate.h"
#include "verify/spread.h"

namespace c1mesh {

std::size_t LogHistogram::total() const {
  return std::accumulate(counts.begin(), counts.end(), zeros + infinite);
}

LogHistogram log_histogram(const std::vector<double>& sample) {
  LogHistogram out;
  std::map<int, std::size_t> bins;
  for (const double x : sample) {
    if (x == 0)
      ++out.zeros;
    else if (!std::isfinite(x))
      ++out.infinite;
    else
      ++bins[static_cast<int>(std::floor(LogHistogram::per_decade * std::log10(x)))];
  }
  if (bins.empty()) return out;
  out.first = bins.begin()->first;
  out.counts.assign(bins.rbegin()->first - out.first + 1, 0);
  for (const auto& [bin, count] : bins) out.counts[bin - out.first] = count;
  return out;
}

Distribution distribution_of(const std::vector<double>& sample) {
  if (sample.empty()) return {};
  return {sample.size(), *std::min_element(sample.begin(), sample.end()),
          verification::spread_of(sample), log_histogram(sample)};
}

}  // namespace c1mesh
