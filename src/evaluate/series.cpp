// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes of a folder, summed up.
#include <algorithm>

#include "c1mesh/evaluate.h"

namespace c1mesh {
namespace {

using Shapes = std::vector<ShapeEvaluation>;

/// A number of every evaluated shape.
template <class Number>
Distribution over_shapes(const Shapes& shapes, const Number& number) {
  std::vector<double> sample;
  for (const ShapeEvaluation& shape : shapes)
    if (shape.evaluated) sample.push_back(static_cast<double>(number(shape)));
  return distribution_of(sample);
}

/// A shape whose sample is empty (C1 is asked nowhere) has no largest value.
PooledDistribution pooled(const Shapes& shapes, std::vector<double> Samples::*member) {
  std::vector<double> all, largest;
  for (const ShapeEvaluation& shape : shapes) {
    const std::vector<double>& own = shape.samples.*member;
    if (own.empty()) continue;
    all.insert(all.end(), own.begin(), own.end());
    largest.push_back(*std::max_element(own.begin(), own.end()));
  }
  return {distribution_of(all), distribution_of(largest)};
}

void count_shapes(const Shapes& shapes, SeriesSummary& summary) {
  summary.shapes = shapes.size();
  for (const ShapeEvaluation& shape : shapes) {
    if (shape.status)
      ++summary.statuses[*shape.status];
    else
      ++summary.unknown_status;
    if (!shape.evaluated) continue;
    ++summary.evaluated;
    summary.regular += shape.regular;
    summary.conforming += shape.conforming;
    summary.c1 += shape.c1;
    summary.valid += shape.valid;
    summary.overlapping += shape.metrics.domain_overlaps;
    ++summary.exceptional[shape.metrics.exceptional];
    ++summary.surplus[shape.metrics.surplus];
    ++summary.surplus_paper[shape.surplus_paper()];
  }
}

SeriesSummary summary_of(const Shapes& shapes) {
  SeriesSummary out;
  count_shapes(shapes, out);
  out.d_ei = pooled(shapes, &Samples::d_ei);
  out.gradient_angle_deg = pooled(shapes, &Samples::gradient_angle_deg);
  out.gradient_magnitude = pooled(shapes, &Samples::gradient_magnitude);
  out.conformance = pooled(shapes, &Samples::conformance);
  out.triangles = over_shapes(shapes, [](const auto& s) { return s.metrics.triangles; });
  out.g = over_shapes(shapes, [](const auto& s) { return s.metrics.mips_bound_max; });
  out.flatness_ratio = over_shapes(shapes, [](const auto& s) { return s.metrics.flatness_ratio; });
  std::vector<double> seconds;
  for (const ShapeEvaluation& shape : shapes)
    if (shape.seconds) seconds.push_back(*shape.seconds);
  out.seconds = distribution_of(seconds);
  return out;
}

}  // namespace

Series make_series(const std::string& label, std::vector<ShapeEvaluation> shapes) {
  std::sort(shapes.begin(), shapes.end(),
            [](const ShapeEvaluation& a, const ShapeEvaluation& b) { return a.name < b.name; });
  SeriesSummary summary = summary_of(shapes);
  return {label, std::move(shapes), std::move(summary)};
}

}  // namespace c1mesh
