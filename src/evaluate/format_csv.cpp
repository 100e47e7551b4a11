// SPDX-License-Identifier: GPL-3.0-or-later
// evaluation.csv: a line per shape and series.
#include <fmt/format.h>

#include <cmath>

#include "c1mesh/evaluate.h"

namespace c1mesh {
namespace {

constexpr const char* kHead =
    "series,compared,name,status,seconds,fault,triangles,"
    "d_ei_median,d_ei_p99,d_ei_max,"
    "gradient_angle_deg_median,gradient_angle_deg_p99,gradient_angle_deg_max,"
    "gradient_magnitude_median,gradient_magnitude_p99,gradient_magnitude_max,"
    "exceptional,minimum,surplus,minimum_paper,surplus_paper,flatness_ratio,g,"
    "conformance_median,conformance_p99,conformance_max,"
    "regular,conforming,c1,valid,domain_overlaps";

/// One line; its length in cells is checked against the head by whoever reads it.
class Line {
 public:
  void text(const std::string& value) {
    if (value.find_first_of(",\"\r\n") == std::string::npos) return cell(value);
    std::string quoted = "\"";
    for (const char c : value) quoted += c == '"' ? "\"\"" : std::string(1, c);
    cell(quoted + "\"");
  }
  void whole(int value) { cell(std::to_string(value)); }
  void real(double value) { cell(std::isfinite(value) ? fmt::format("{}", value) : "inf"); }
  void flag(bool value) { cell(value ? "1" : "0"); }
  void spread(const Spread& s) {
    real(s.median);
    real(s.p99);
    real(s.max);
  }
  void empty(int count) {
    for (int k = 0; k < count; ++k) cell("");
  }
  std::string end() const { return out_ + "\n"; }

 private:
  void cell(const std::string& value) {
    if (started_) out_ += ",";
    started_ = true;
    out_ += value;
  }

  std::string out_;
  bool started_ = false;
};

constexpr int kMeasured = 25;  // cells from `triangles` on

void add_measured(Line& line, const ShapeEvaluation& shape) {
  const Metrics& m = shape.metrics;
  line.whole(m.triangles);
  line.spread(m.d_ei);
  line.spread(m.gradient_angle_deg);
  line.spread(m.gradient_magnitude);
  line.whole(m.exceptional);
  line.whole(m.exceptional_minimum);
  line.whole(m.surplus);
  line.whole(m.exceptional_minimum_paper);
  line.whole(shape.surplus_paper());
  line.real(m.flatness_ratio);
  line.real(m.mips_bound_max);
  line.spread(distribution_of(shape.samples.conformance).spread);
  for (const bool value :
       {shape.regular, shape.conforming, shape.c1, shape.valid, m.domain_overlaps})
    line.flag(value);
}

std::string lines_of(const Series& series, bool compared) {
  std::string out;
  for (const ShapeEvaluation& shape : series.shapes) {
    Line line;
    line.text(series.label);
    line.flag(compared);
    line.text(shape.name);
    shape.status ? line.whole(*shape.status) : line.empty(1);
    shape.seconds ? line.real(*shape.seconds) : line.empty(1);
    line.text(shape.fault);
    shape.evaluated ? add_measured(line, shape) : line.empty(kMeasured);
    out += line.end();
  }
  return out;
}

}  // namespace

std::string format_evaluation_csv(const Evaluation& evaluation) {
  std::string out = std::string(kHead) + "\n";
  for (const Series& series : evaluation.series) out += lines_of(series, false);
  for (const Series& series : evaluation.compared) out += lines_of(series, true);
  return out;
}

}  // namespace c1mesh
