// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/xml.h"

namespace c1mesh::charts {
namespace {

constexpr double kLeft = 62, kRight = 20, kGap = 36;  // pixels around and between columns
constexpr double kHeadings = 46, kColumnHeads = 40;   // above everything, above the columns
constexpr double kTitleRoom = 26, kHeight = 118, kBelow = 34;  // of a row: title, plot, names

constexpr const char* kStyle = R"(<style>
text{font-family:Helvetica,Arial,sans-serif;fill:#2a2f38;font-size:12px}
.h1{font-size:17px;font-weight:bold}
.h2{font-size:14px;font-weight:bold}
.h3{font-size:13.5px;font-weight:bold}
.pale{fill:#6b7482}
.axis{stroke:#2a2f38;stroke-width:1;fill:none}
.grid{stroke:#e4e7ec;stroke-width:1;fill:none}
.all{fill:#2c6fb7;fill-opacity:.85}
.largest{fill:#cf3a3a;fill-opacity:.72}
.third{fill:#8fc1e8}
.all-light{fill:#b9d3ec}
.largest-light{fill:#f3c1bd}
.third-light{fill:#dcebf7}
.outline{fill:none;stroke:#fff;stroke-width:.8}
</style>
)";

std::string pixels(double x) {
  std::string out = fmt::format("{:.2f}", x);
  out.erase(out.find_last_not_of('0') + 1);
  if (out.back() == '.') out.pop_back();
  return out == "-0" ? "0" : out;
}

std::string text(double x, double y, const char* anchor, const std::string& words,
                 const char* style = "") {
  return fmt::format(
      "<text x=\"{}\" y=\"{}\" text-anchor=\"{}\"{}>{}</text>\n", pixels(x), pixels(y), anchor,
      *style ? fmt::format(" class=\"{}\"", style) : std::string(), xml_escaped(words));
}

std::string line(const char* style, double x0, double y0, double x1, double y1) {
  return fmt::format("<path class=\"{}\" d=\"M{},{}L{},{}\"/>\n", style, pixels(x0), pixels(y0),
                     pixels(x1), pixels(y1));
}

/// The least of 1, 2, 4, 5, 10, 20, … that is not below `value`, so that its half is round too.
double round_up(double value) {
  double power = 1;
  while (10 * power < value) power *= 10;
  while (power > value && power > 0.01) power /= 10;
  for (const double digit : {1.0, 2.0, 4.0, 6.0, 8.0, 10.0})
    if (digit * power >= value) return digit * power;
  return 10 * power;
}

double top_of(const Row& row) {
  double top = 0;
  for (const Panel& panel : row.panels)
    for (const Layer& layer : panel.layers)
      for (const double height : layer.heights) top = std::max(top, height);
  return top > 0 ? round_up(top) : 1;
}

/// The bars of a layer over the base line y.
std::string bars(const Axis& axis, const Layer& layer, const std::string& style, double x, double y,
                 double top) {
  std::string data;
  for (std::size_t k = 0; k < layer.heights.size(); ++k) {
    if (layer.heights[k] <= 0) continue;
    const Bin& bin = axis.bins[k];
    const double width = bin.right - bin.left;
    // What is there is seen: a bar has at least a pixel.
    const double height = std::max(1.0, kHeight * layer.heights[k] / top);
    data += fmt::format("M{},{}v{}H{}v{}z", pixels(x + bin.left + width * layer.from), pixels(y),
                        pixels(-height), pixels(x + bin.left + width * layer.to), pixels(height));
  }
  if (data.empty()) return "";
  return "<path class=\"" + style + "\" d=\"" + data + "\"/>\n";
}

std::string tick(const Tick& tick, double x, double y) {
  std::string out;
  if (tick.stroke) out += line("axis", x + tick.at, y, x + tick.at, y + 4);
  if (tick.name.empty()) return out;
  std::string words = xml_escaped(tick.name);
  if (!tick.power.empty())
    words += "<tspan dy=\"-5\" font-size=\"9\">" + xml_escaped(tick.power) + "</tspan>";
  return out + fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                           pixels(x + tick.at), pixels(y + 18), words);
}

/// A panel with its lower left corner at (x, y).
std::string panel(const Row& row, const Panel& panel, double x, double y, double width,
                  double top) {
  std::string out = line("grid", x, y - kHeight, x + width, y - kHeight) +
                    line("grid", x, y - kHeight / 2, x + width, y - kHeight / 2);
  for (const Layer& layer : panel.layers) out += bars(row.axis, layer, layer.style, x, y, top);
  for (const Layer& layer : panel.layers)  // what a dark bar hides of a light one
    if (layer.style.ends_with("-light")) out += bars(row.axis, layer, "outline", x, y, top);
  if (!panel.note.empty())
    out += text(x + width / 2, y - kHeight / 2 + 4, "middle", panel.note, "pale");
  out += line("axis", x, y, x + width, y);
  for (const Tick& t : row.axis.ticks) out += tick(t, x, y);
  return out;
}

std::string legend(const Row& row, double right, double y) {
  constexpr double kCharacter = 6.3, kSwatch = 12;  // pixels
  std::string out;
  for (auto entry = row.legend.rbegin(); entry != row.legend.rend(); ++entry) {
    const double words = kCharacter * static_cast<double>(entry->words.size());
    out += text(right - words, y, "start", entry->words);
    out += fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
                       entry->style, pixels(right - words - kSwatch - 5), pixels(y - 10), kSwatch,
                       kSwatch);
    right -= words + kSwatch + 22;
  }
  return out;
}

std::string vertical_axis(const Row& row, double y, double top) {
  std::string out;
  for (const double share : {0.0, 0.5, 1.0})
    out += text(kLeft - 6, y - share * kHeight + 4, "end", fmt::format("{:g}", share * top));
  return out + fmt::format(
                   "<text class=\"pale\" text-anchor=\"middle\" transform=\"translate(16 {}) "
                   "rotate(-90)\">{}</text>\n",
                   pixels(y - kHeight / 2), xml_escaped(row.vertical));
}

}  // namespace

double panel_width(std::size_t columns) {
  constexpr double kPage = 1200, kLeast = 150, kMost = 850;
  const auto n = static_cast<double>(columns);
  const double room = (kPage - kLeft - kRight - (n - 1) * kGap) / n;
  return std::clamp(std::floor(room), kLeast, kMost);
}

std::string sheet(const std::string& title, const std::string& subtitle,
                  const std::vector<Head>& heads, const std::vector<Row>& rows) {
  const std::size_t columns = heads.size();
  const double each = panel_width(columns);
  const double right = kLeft + static_cast<double>(columns) * (each + kGap) - kGap;
  const double page = std::max(right + kRight, 930.0);  // room for titles and legends
  const double row_height = kTitleRoom + kHeight + kBelow;
  const double height =
      kHeadings + kColumnHeads + static_cast<double>(rows.size()) * row_height + 10;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\">\n<title>{2}</title>\n",
      pixels(page), pixels(height), xml_escaped(title));
  out += kStyle;
  out += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  out += text(kLeft, 24, "start", title, "h1") + text(kLeft, 42, "start", subtitle, "pale");
  const auto left_of = [&](std::size_t c) {
    return kLeft + static_cast<double>(c) * (each + kGap);
  };
  for (std::size_t c = 0; c < columns; ++c) {
    out += text(left_of(c) + each / 2, kHeadings + 18, "middle", heads[c].title, "h2");
    out += text(left_of(c) + each / 2, kHeadings + 34, "middle", heads[c].subtitle, "pale");
  }
  double y = kHeadings + kColumnHeads;
  for (const Row& row : rows) {
    const double base = y + kTitleRoom + kHeight, top = top_of(row);
    out += text(kLeft, y + 17, "start", row.title, "h3");
    out += legend(row, page - kRight, y + 17);
    out += vertical_axis(row, base, top);
    for (std::size_t c = 0; c < columns; ++c)
      out += panel(row, row.panels[c], left_of(c), base, each, top);
    y += row_height;
  }
  return out + "</svg>\n";
}

}  // namespace c1mesh::charts
