// SPDX-License-Identifier: GPL-3.0-or-later
// evaluation.txt: rows of measures, a column per series.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "c1mesh/evaluate.h"

namespace c1mesh {
namespace {

using Cell = std::function<std::string(const SeriesSummary&)>;

std::string real(double value) {
  if (!std::isfinite(value)) return "infinite";
  constexpr double kWhole = 1e9;  // larger whole numbers are no counts
  const bool whole = value == std::floor(value) && std::abs(value) < kWhole;
  return whole ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

/// How many characters UTF-8 text shows.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) >> 6) != 2; }));
}

std::string printable(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return text;
}

class Table {
 public:
  explicit Table(std::vector<const Series*> columns) : columns_(std::move(columns)) {
    std::vector<std::string> head = {""};
    for (const Series* series : columns_) head.push_back(printable(series->label));
    rows_.push_back(head);
  }

  void row(const std::string& name, const Cell& cell) {
    std::vector<std::string> row = {name};
    for (const Series* series : columns_) row.push_back(cell(series->summary));
    rows_.push_back(row);
  }

  void title(const std::string& name) { rows_.push_back({name}); }

  void number(const std::string& name, std::size_t SeriesSummary::*member) {
    row(name, [member](const SeriesSummary& s) { return std::to_string(s.*member); });
  }

  void spread(const std::function<Distribution(const SeriesSummary&)>& of) {
    const auto part = [&](const char* name, double Spread::*member) {
      row(name, [&](const SeriesSummary& s) {
        const Distribution d = of(s);
        return d.count ? real(d.spread.*member) : std::string("-");
      });
    };
    part("  median", &Spread::median);
    part("  99 %", &Spread::p99);
    part("  max", &Spread::max);
  }

  void pooled(const std::string& name, const std::string& of_each,
              PooledDistribution SeriesSummary::*member) {
    title(name + ", " + of_each);
    spread([&](const SeriesSummary& s) { return (s.*member).all; });
    title(name + ", the largest of each shape");
    spread([&](const SeriesSummary& s) { return (s.*member).largest; });
  }

  /// A row for every value that occurs.
  void counts(const std::string& name, ValueCounts SeriesSummary::*member) {
    std::set<int> values;
    for (const Series* series : columns_)
      for (const auto& [value, count] : series->summary.*member) values.insert(value);
    title(name);
    for (const int value : values)
      row(fmt::format("  {}", value), [&](const SeriesSummary& s) {
        const auto found = (s.*member).find(value);
        return found == (s.*member).end() ? std::string("0") : std::to_string(found->second);
      });
  }

  std::string text() const {
    std::vector<std::size_t> width(columns_.size() + 1, 0);
    for (const auto& row : rows_)
      if (row.size() > 1)
        for (std::size_t k = 0; k < row.size(); ++k)
          width[k] = std::max(width[k], width_of(row[k]));
    std::string out;
    for (const auto& row : rows_) {
      out += row[0];
      for (std::size_t k = 1; k < row.size(); ++k) {
        if (k == 1) out += std::string(width[0] - width_of(row[0]), ' ');
        out += std::string(2 + width[k] - width_of(row[k]), ' ') + row[k];
      }
      out += "\n";
    }
    return out;
  }

 private:
  std::vector<const Series*> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// The sum of a count over the shapes.
std::string sum_of(const ValueCounts& counts) {
  long long sum = 0;
  for (const auto& [value, count] : counts) sum += value * static_cast<long long>(count);
  return std::to_string(sum);
}

void add_shapes(Table& table) {
  table.number("shapes", &SeriesSummary::shapes);
  table.row("without a usable result",
            [](const SeriesSummary& s) { return std::to_string(s.failures()); });
  table.number("certified valid", &SeriesSummary::valid);
  table.number("certified regular", &SeriesSummary::regular);
  table.number("certified conforming", &SeriesSummary::conforming);
  table.number("certified C1", &SeriesSummary::c1);
  table.number("domain overlaps itself", &SeriesSummary::overlapping);
  table.counts("exit status of the run", &SeriesSummary::statuses);
  table.number("  unknown", &SeriesSummary::unknown_status);
}

void add_samples(Table& table) {
  table.title("triangles");
  table.spread([](const SeriesSummary& s) { return s.triangles; });
  table.pooled("C1 deviation d_ei / extent", "all", &SeriesSummary::d_ei);
  table.pooled("gradient angle, degrees", "the largest of each edge",
               &SeriesSummary::gradient_angle_deg);
  table.pooled("gradient magnitude, relative", "the largest of each edge",
               &SeriesSummary::gradient_magnitude);
  table.pooled("conformance / extent", "all control points on curves", &SeriesSummary::conformance);
}

void add_counts(Table& table) {
  const auto sum = [&](const char* name, ValueCounts SeriesSummary::*member) {
    table.row(name, [member](const SeriesSummary& s) { return sum_of(s.*member); });
  };
  table.counts("exceptional vertices: shapes with", &SeriesSummary::exceptional);
  sum("  in all", &SeriesSummary::exceptional);
  table.counts("surplus over the paper's minimum: shapes with", &SeriesSummary::surplus_paper);
  sum("  in all", &SeriesSummary::surplus_paper);
  table.counts("surplus over the true minimum: shapes with", &SeriesSummary::surplus);
  sum("  in all", &SeriesSummary::surplus);
}

void add_rest(Table& table) {
  table.title("flatness ratio");
  table.row("  least", [](const SeriesSummary& s) {
    return s.flatness_ratio.count ? real(s.flatness_ratio.min) : std::string("-");
  });
  table.row("  median", [](const SeriesSummary& s) {
    return s.flatness_ratio.count ? real(s.flatness_ratio.spread.median) : std::string("-");
  });
  table.title("distortion bound g, the largest of each shape");
  table.spread([](const SeriesSummary& s) { return s.g; });
  table.title("seconds of a run");
  table.spread([](const SeriesSummary& s) { return s.seconds; });
}

std::string failures_of(const std::vector<const Series*>& columns) {
  std::string out;
  for (const Series* series : columns)
    for (const ShapeEvaluation& shape : series->shapes)
      if (!shape.evaluated)
        out +=
            printable(fmt::format("  {}: {}: {}", series->label, shape.name, shape.fault)) + "\n";
  return out.empty() ? "" : "\nwithout a usable result\n" + out;
}

}  // namespace

std::string evaluation_text(const Evaluation& evaluation) {
  std::vector<const Series*> columns;
  for (const auto* list : {&evaluation.series, &evaluation.compared})
    for (const Series& series : *list) columns.push_back(&series);
  Table table(columns);
  add_shapes(table);
  add_samples(table);
  add_counts(table);
  add_rest(table);
  return table.text() + failures_of(columns);
}

}  // namespace c1mesh
