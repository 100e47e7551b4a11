// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/window_sums.h"

#include <algorithm>
#include <cmath>

namespace c1mesh {

std::vector<double> window_sums(const std::vector<double>& at, const std::vector<double>& weight,
                                const std::vector<double>& places, double window, double length,
                                std::size_t few) {
  std::vector<double> out;
  // Of few, term by term: equal bends stay equal, and the first is chosen.
  if (at.size() * places.size() <= few) {
    for (const double place : places) {
      double sum = 0;
      for (std::size_t j = 0; j < at.size(); ++j) {
        double distance = std::abs(at[j] - place);
        distance = std::min(distance, length - distance);
        sum += std::max(0.0, 1 - distance / window) * weight[j];
      }
      out.push_back(sum);
    }
    return out;
  }
  // The line three times on, and running sums of the weights and of their moments.
  const std::size_t m = at.size();
  std::vector<double> line, total{0}, moment{0};
  for (const double shift : {-length, 0.0, length})
    for (std::size_t j = 0; j < m; ++j) {
      line.push_back(at[j] + shift);
      total.push_back(total.back() + weight[j]);
      moment.push_back(moment.back() + weight[j] * line.back());
    }
  const auto index = [&](double x) {
    return std::lower_bound(line.begin(), line.end(), x) - line.begin();
  };
  for (const double place : places) {
    const auto low = index(place - window), middle = index(place), high = index(place + window);
    const auto part = [&](auto from, auto to) {  // sum of weight (x - place)
      return moment[to] - moment[from] - place * (total[to] - total[from]);
    };
    out.push_back(total[high] - total[low] + (part(low, middle) - part(middle, high)) / window);
  }
  return out;
}

}  // namespace c1mesh
