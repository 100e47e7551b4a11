// SPDX-License-Identifier: GPL-3.0-or-later
// The two pictures of an evaluation, after the paper's figures 18, 19 and 20.
#include <fmt/format.h>

#include <algorithm>

#include "c1mesh/evaluate.h"
#include "evaluate/chart.h"

namespace c1mesh {
namespace {

using charts::Layer;
using charts::LegendEntry;
using charts::Panel;
using charts::Row;

constexpr const char* kLight = "-light";  // the style of a compared series

/// The rows of one sheet. Every row has a panel per series; what is compared stands behind.
class Sheet {
 public:
  explicit Sheet(const Evaluation& evaluation)
      : evaluation_(evaluation), width_(charts::panel_width(evaluation.series.size())) {}

  void pooled(const std::string& title, const std::string& unit, const std::string& all,
              PooledDistribution SeriesSummary::*member) {
    std::vector<const LogHistogram*> row;
    for (const Series* s : everything()) {
      row.push_back(&(s->summary.*member).all.histogram);
      row.push_back(&(s->summary.*member).largest.histogram);
    }
    const charts::LogAxis axis(row, width_);
    add({title,
         "% of " + unit,
         {{"all", all}, {"largest", "largest of each shape"}},
         axis.axis(),
         {}},
        [&](const SeriesSummary& s, const std::string& light) -> std::vector<Layer> {
          const PooledDistribution& d = s.*member;
          if (d.all.count == 0) return {};
          return {{percent(axis.counts(d.all.histogram)), "all" + light},
                  {percent(axis.counts(d.largest.histogram)), "largest" + light}};
        });
  }

  void counts(const std::string& title) {
    std::vector<const ValueCounts*> row;
    for (const Series* s : everything())
      for (const auto* values :
           {&s->summary.exceptional, &s->summary.surplus, &s->summary.surplus_paper})
        row.push_back(values);
    const charts::WholeAxis axis(row, width_);
    add({title,
         "shapes",
         {{"largest", "exceptional vertices"},
          {"all", "surplus, the paper's minimum"},
          {"third", "surplus, the true minimum"}},
         axis.axis(),
         {}},
        [&](const SeriesSummary& s, const std::string& light) -> std::vector<Layer> {
          if (s.evaluated == 0) return {};
          // The light bars are wider, so that they are seen beside the dark ones.
          const double narrow = light.empty() ? 0.05 : 0;
          const auto third = [&](int k, const ValueCounts& values, const std::string& style) {
            const double left = 0.08 + 0.28 * k;
            return Layer{axis.counts(values), style + light, left + narrow, left + 0.28 - narrow};
          };
          return {third(0, s.exceptional, "largest"), third(1, s.surplus_paper, "all"),
                  third(2, s.surplus, "third")};
        });
  }

  void flatness(const std::string& title) {
    double least = 1;
    for (const Series* s : everything())
      if (s->summary.evaluated) least = std::min(least, s->summary.flatness_ratio.min);
    const charts::ShareAxis axis(least, width_);
    std::vector<Panel> panels;
    Row row{title, "shapes", {{"all", "flatness ratio"}}, axis.axis(), {}};
    const auto sample = [](const Series& series) {
      std::vector<double> out;
      for (const ShapeEvaluation& shape : series.shapes)
        if (shape.evaluated) out.push_back(shape.metrics.flatness_ratio);
      return out;
    };
    for (std::size_t c = 0; c < evaluation_.series.size(); ++c) {
      Panel panel;
      if (!evaluation_.compared.empty())
        panel.layers.push_back({axis.counts(sample(evaluation_.compared[c])), "all-light"});
      panel.layers.push_back({axis.counts(sample(evaluation_.series[c])), "all"});
      row.panels.push_back(panel);
    }
    rows_.push_back(row);
  }

  void seconds(const std::string& title) {
    std::vector<const LogHistogram*> row;
    for (const Series* s : everything()) row.push_back(&s->summary.seconds.histogram);
    const charts::LogAxis axis(row, width_);
    add({title, "shapes", {{"all", "seconds"}}, axis.axis(), {}},
        [&](const SeriesSummary& s, const std::string& light) -> std::vector<Layer> {
          if (s.seconds.count == 0) return {};
          return {{axis.counts(s.seconds.histogram), "all" + light}};
        });
  }

  std::string draw(const std::string& title) const {
    std::vector<charts::Head> heads;
    for (std::size_t c = 0; c < evaluation_.series.size(); ++c) {
      const Series& series = evaluation_.series[c];
      std::string below = words_for(series);
      if (!evaluation_.compared.empty())
        below += fmt::format("; light: {}", evaluation_.compared[c].label);
      heads.push_back({series.label, below});
    }
    const std::string subtitle =
        evaluation_.compared.empty()
            ? "a column per set; lengths relative to the extent, logarithmic axes but for counts "
              "and "
              "ratios"
            : "a column per set, the compared one light behind; lengths relative to the extent";
    return charts::sheet(title, subtitle, heads, rows_);
  }

 private:
  std::vector<const Series*> everything() const {
    std::vector<const Series*> out;
    for (const auto* list : {&evaluation_.series, &evaluation_.compared})
      for (const Series& series : *list) out.push_back(&series);
    return out;
  }

  static std::string words_for(const Series& series) {
    const SeriesSummary& s = series.summary;
    std::string out = fmt::format("{} shape{}", s.shapes, s.shapes == 1 ? "" : "s");
    if (s.failures()) out += fmt::format(", {} without result", s.failures());
    return out;
  }

  static std::vector<double> percent(std::vector<double> counts) {
    double sum = 0;
    for (const double count : counts) sum += count;
    for (double& count : counts) count *= sum > 0 ? 100 / sum : 0;
    return counts;
  }

  /// `layers(summary, light)`: the layers of one series, none if it has nothing to show.
  template <class Layers>
  void add(Row row, const Layers& layers) {
    for (std::size_t c = 0; c < evaluation_.series.size(); ++c) {
      Panel panel;
      if (!evaluation_.compared.empty())
        panel.layers = layers(evaluation_.compared[c].summary, kLight);
      const std::vector<Layer> dark = layers(evaluation_.series[c].summary, "");
      if (dark.empty()) panel.note = "nothing known";
      panel.layers.insert(panel.layers.end(), dark.begin(), dark.end());
      row.panels.push_back(panel);
    }
    rows_.push_back(std::move(row));
  }

  const Evaluation& evaluation_;
  double width_;
  std::vector<Row> rows_;
};

}  // namespace

std::string draw_histograms(const Evaluation& evaluation) {
  Sheet sheet(evaluation);
  sheet.pooled("(a) C1 deviation d_ei", "values", "all d_ei", &SeriesSummary::d_ei);
  sheet.pooled("(b) gradient angle, degrees", "values", "largest of each edge",
               &SeriesSummary::gradient_angle_deg);
  sheet.pooled("(c) gradient magnitude, relative deviation", "values", "largest of each edge",
               &SeriesSummary::gradient_magnitude);
  sheet.counts("(d) exceptional vertices and surplus");
  sheet.flatness("(e) flatness ratio");
  sheet.seconds("(f) run time, seconds");
  return sheet.draw("Results by set");
}

std::string draw_projection(const Evaluation& evaluation) {
  Sheet sheet(evaluation);
  sheet.pooled("(a) C1 deviation d_ei", "values", "all d_ei", &SeriesSummary::d_ei);
  sheet.pooled("(b) conformance: distance of the boundary's control points", "values",
               "all control points on curves", &SeriesSummary::conformance);
  return sheet.draw("C1 deviation and conformance by set");
}

}  // namespace c1mesh
