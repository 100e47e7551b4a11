// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation of folders of results: the metrics of the paper's section 5.3, recomputed from the
// files, per shape and per folder, as tables and histograms (docs/evaluate.md).
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "c1mesh/result.h"
#include "c1mesh/verify.h"

namespace c1mesh {

/// How many values of a sample lie where on a logarithmic axis: bin k holds the x with
/// 10^(k / per_decade) <= x < 10^((k + 1) / per_decade). What is 0 or infinite is counted apart.
struct LogHistogram {
  static constexpr int per_decade = 4;  ///< bins

  int first = 0;                        ///< the bin of counts[0]
  std::vector<std::size_t> counts;      ///< from the first bin that is not empty to the last one
  std::size_t zeros = 0, infinite = 0;  ///< values that no bin holds

  /// Of all values, zeros and infinite ones included.
  std::size_t total() const;
};

/// Precondition: no value is negative or NaN.
LogHistogram log_histogram(const std::vector<double>& sample);

/// A sample in few numbers; all 0 if it is empty.
struct Distribution {
  std::size_t count = 0;   ///< how many values
  double min = 0;          ///< the least
  Spread spread;           ///< by nearest rank
  LogHistogram histogram;  ///< of all values
};

/// Precondition: no value is negative or NaN.
Distribution distribution_of(const std::vector<double>& sample);

/// What a folder tells of one shape.
struct ShapeEvaluation {
  std::string name;               ///< of the shape
  std::optional<int> status;      ///< exit status of the run, from its log
  std::optional<double> seconds;  ///< wall time of the run, from its log

  bool evaluated = false;   ///< the result could be read; else `fault` says why not
  bool unreadable = false;  ///< there is a result file that cannot be used
  std::string fault;        ///< why it was not evaluated; else empty

  Metrics metrics;  ///< recomputed (`seconds` is empty)
  Samples samples;  ///< what the metrics sum up
  bool regular = false, conforming = false, c1 = false, valid = false;  ///< as VerifyReport's

  /// Exceptional vertices beyond the paper's minimum, max(0, 3 - corners) per loop.
  int surplus_paper() const { return metrics.exceptional - metrics.exceptional_minimum_paper; }
};

/// Measures a result from its data alone. `fault` is set if it has not the structure of one.
ShapeEvaluation evaluate(const Result& result);

/// A sample of all shapes together, and the largest value of each shape.
struct PooledDistribution {
  Distribution all, largest;  ///< of every value; of the largest value of each shape
};

/// How many shapes have which value.
using ValueCounts = std::map<int, std::size_t>;

/// All shapes of a folder together. Distributions are over the evaluated shapes, `seconds` over all
/// whose time is known.
struct SeriesSummary {
  std::size_t shapes = 0, evaluated = 0;  ///< how many there are, and could be measured
  /// How many are so; `overlapping`: over a domain that overlaps itself.
  std::size_t regular = 0, conforming = 0, c1 = 0, valid = 0, overlapping = 0;
  ValueCounts statuses;            ///< of the runs whose status is known
  std::size_t unknown_status = 0;  ///< shapes without log
  /// As in Metrics: lengths relative to each shape's extent, angles in degrees.
  PooledDistribution d_ei, gradient_angle_deg, gradient_magnitude, conformance;
  ValueCounts exceptional, surplus, surplus_paper;     ///< by number of vertices
  Distribution triangles, g, flatness_ratio, seconds;  ///< a value for each shape

  /// Shapes that could not be measured.
  std::size_t failures() const { return shapes - evaluated; }
};

/// The shapes of one folder, a column of the tables and pictures.
struct Series {
  std::string label;                    ///< title of the column
  std::vector<ShapeEvaluation> shapes;  ///< by name
  SeriesSummary summary;                ///< of all of them
};

/// Sorts the shapes by name and sums them up.
Series make_series(const std::string& label, std::vector<ShapeEvaluation> shapes);

/// Reads and measures every `NAME.c1.json` of the folder, in parallel, with `NAME.log` where it
/// lies beside. A log without result is a shape that failed. A file that cannot be read or used is
/// an `unreadable` shape, not an exception. Throws FileError if the folder cannot be read or holds
/// neither results nor logs. `threads`: 0 for as many as cores; the series does not depend on it.
/// `max_bytes`: a larger result is unreadable.
Series evaluate_folder(const std::string& folder, const std::string& label, int threads = 0,
                       std::size_t max_bytes = 200'000'000);

/// What a table or a picture is made of.
struct Evaluation {
  std::vector<Series> series;    ///< the columns
  std::vector<Series> compared;  ///< none, or one for each of `series`
};

/// `evaluation.json`: everything but the raw samples, of which it has the histograms.
std::string format_evaluation(const Evaluation& evaluation);

/// `evaluation.csv` (RFC 4180, lines end in a line feed): a head, then a line per shape and series.
std::string format_evaluation_csv(const Evaluation& evaluation);

/// `evaluation.txt`: a table for people, a column per series; then what failed.
std::string evaluation_text(const Evaluation& evaluation);

/// SVG, a column of histograms per series, after the paper's figure 18 (and 20, where there are
/// compared series: they are drawn light, behind).
std::string draw_histograms(const Evaluation& evaluation);

/// SVG after the paper's figure 19: C1 deviation and conformance only.
std::string draw_projection(const Evaluation& evaluation);

}  // namespace c1mesh
