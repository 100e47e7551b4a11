// SPDX-License-Identifier: GPL-3.0-or-later
// evaluation.json (docs/evaluate.md): a shape per line, keys in the document's order.
#include <cmath>
#include <nlohmann/json.hpp>

#include "c1mesh/evaluate.h"

namespace c1mesh {
namespace {

using Json = nlohmann::ordered_json;

/// Bytes of file names that are no UTF-8 are replaced.
std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// JSON has no infinities: they are null, as in the result file.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

template <class Number>
Json optional(const std::optional<Number>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const LogHistogram& histogram) {
  return {{"per_decade", LogHistogram::per_decade},
          {"first", histogram.first},
          {"counts", histogram.counts},
          {"zeros", histogram.zeros},
          {"infinite", histogram.infinite}};
}

Json json_of(const Distribution& d, bool with_histogram = true) {
  Json out = {{"count", d.count},
              {"min", number(d.min)},
              {"median", number(d.spread.median)},
              {"p99", number(d.spread.p99)},
              {"max", number(d.spread.max)}};
  if (with_histogram) out["histogram"] = json_of(d.histogram);
  return out;
}

Json json_of(const PooledDistribution& d) {
  return {{"all", json_of(d.all)}, {"largest_of_shape", json_of(d.largest)}};
}

/// [[value, shapes], …], by value.
Json json_of(const ValueCounts& counts) {
  Json out = Json::array();
  for (const auto& [value, count] : counts) out.push_back({value, count});
  return out;
}

Json json_of(const ShapeEvaluation& shape) {
  Json out = {{"name", shape.name},
              {"status", optional(shape.status)},
              {"seconds", optional(shape.seconds)},
              {"evaluated", shape.evaluated}};
  if (!shape.evaluated) {
    out["fault"] = shape.fault;
    return out;
  }
  const Metrics& m = shape.metrics;
  out["regular"] = shape.regular;
  out["conforming"] = shape.conforming;
  out["c1"] = shape.c1;
  out["valid"] = shape.valid;
  out["triangles"] = m.triangles;
  out["exceptional"] = m.exceptional;
  out["minimum"] = m.exceptional_minimum;
  out["surplus"] = m.surplus;
  out["minimum_paper"] = m.exceptional_minimum_paper;
  out["surplus_paper"] = shape.surplus_paper();
  out["flatness_ratio"] = m.flatness_ratio;
  out["g"] = number(m.mips_bound_max);
  out["domain_overlaps"] = m.domain_overlaps;
  out["d_ei"] = json_of(distribution_of(shape.samples.d_ei));
  out["gradient_angle_deg"] = json_of(distribution_of(shape.samples.gradient_angle_deg));
  out["gradient_magnitude"] = json_of(distribution_of(shape.samples.gradient_magnitude));
  out["conformance"] = json_of(distribution_of(shape.samples.conformance));
  return out;
}

Json json_of(const SeriesSummary& s) {
  return {{"shapes", s.shapes},
          {"evaluated", s.evaluated},
          {"failures", s.failures()},
          {"statuses", json_of(s.statuses)},
          {"unknown_status", s.unknown_status},
          {"regular", s.regular},
          {"conforming", s.conforming},
          {"c1", s.c1},
          {"valid", s.valid},
          {"domain_overlaps", s.overlapping},
          {"triangles", json_of(s.triangles, false)},
          {"exceptional", json_of(s.exceptional)},
          {"surplus", json_of(s.surplus)},
          {"surplus_paper", json_of(s.surplus_paper)},
          {"flatness_ratio", json_of(s.flatness_ratio, false)},
          {"g", json_of(s.g)},
          {"seconds", json_of(s.seconds)},
          {"d_ei", json_of(s.d_ei)},
          {"gradient_angle_deg", json_of(s.gradient_angle_deg)},
          {"gradient_magnitude", json_of(s.gradient_magnitude)},
          {"conformance", json_of(s.conformance)}};
}

std::string text_of(const Series& series) {
  std::string out = "{\"label\":" + text_of(Json(series.label));
  out += ",\n\"summary\":" + text_of(json_of(series.summary));
  out += ",\n\"shapes\":[";
  for (std::size_t i = 0; i < series.shapes.size(); ++i)
    out += (i ? ",\n" : "\n") + text_of(json_of(series.shapes[i]));
  return out + "]}";
}

std::string text_of(const std::vector<Series>& list) {
  std::string out = "[";
  for (std::size_t i = 0; i < list.size(); ++i) out += (i ? ",\n" : "") + text_of(list[i]);
  return out + "]";
}

}  // namespace

std::string format_evaluation(const Evaluation& evaluation) {
  return "{\"format\":\"c1mesh evaluation\",\"version\":1,\n\"series\":" +
         text_of(evaluation.series) + ",\n\"compared\":" + text_of(evaluation.compared) + "}\n";
}

}  // namespace c1mesh
