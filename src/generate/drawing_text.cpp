// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings as JSON and SVG input text. fmt's "{}" writes the shortest decimals that read back bit
// for bit.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/xml.h"
#include "c1mesh/generate.h"

namespace c1mesh {
namespace {

// Ids that are plain integers are written as such, the form other programs use.
std::string json_id(const std::string& id) {
  const bool digits =
      !id.empty() && id.size() < 16 && (id == "0" || id[0] != '0') &&
      std::all_of(id.begin(), id.end(), [](char c) { return c >= '0' && c <= '9'; });
  return digits ? id : nlohmann::json(id).dump();
}

// SVG's y points down. Sums with 0.0 make no negative zero.
std::string svg_point(const Point& p) {
  return fmt::format("{} {}", p.x() + 0.0, 0.0 - p.y());
}

std::string svg_segment(const BezierCurve& curve) {
  constexpr const char* kCommands[] = {"", "L", "Q", "C"};
  if (curve.degree() < 1 || curve.degree() > 3)
    throw std::invalid_argument(fmt::format("SVG has no curves of degree {}", curve.degree()));
  std::string out = kCommands[curve.degree()];
  for (int i = 1; i <= curve.degree(); ++i)
    out += fmt::format("{}{}", i > 1 ? " " : "", svg_point(curve.poles[i]));
  return out;
}

std::string svg_path(const Drawing& drawing) {
  std::string out;
  Point first = Point::Zero(), last = Point::Zero();
  for (std::size_t i = 0; i < drawing.curves.size(); ++i) {
    const BezierCurve& curve = drawing.curves[i].curve;
    if (curve.poles.empty()) throw std::invalid_argument("a curve without control points");
    if (i == 0 || curve.start() != last) {
      first = curve.start();
      out += fmt::format("{}M{}\n", i ? "\n" : "", svg_point(first));
    }
    out += svg_segment(curve);
    last = curve.end();
    out += last == first ? " Z\n" : "\n";
  }
  return out;
}

}  // namespace

std::string drawing_json(const Drawing& drawing) {
  std::string out = "[\n";
  for (std::size_t i = 0; i < drawing.curves.size(); ++i) {
    const auto& [id, curve, feature] = drawing.curves[i];
    std::string poles;
    for (const Point& p : curve.poles)
      poles += fmt::format("{}[{}, {}]", poles.empty() ? "" : ", ", p.x() + 0.0,
                           p.y() + 0.0);  // "-0" would be read as an integer: write plain zero
    out +=
        fmt::format(R"({{"curve_id": {}, "type": "BezierCurve", "degree": {}, "poles": [{}]{}}}{})",
                    json_id(id), curve.degree(), poles, feature ? R"(, "feature": true)" : "",
                    i + 1 < drawing.curves.size() ? ",\n" : "\n");
  }
  return out + "]\n";
}

std::string drawing_svg(const Drawing& drawing) {
  Point low(0, 0), high(1, 1);
  bool first = true;
  for (const InputCurve& input : drawing.curves)
    for (const Point& p : input.curve.poles) {
      low = first ? p : Point(low.cwiseMin(p));
      high = first ? p : Point(high.cwiseMax(p));
      first = false;
    }
  const double margin = 0.02 * std::max(high.x() - low.x(), high.y() - low.y());
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{:.6g} {:.6g} {:.6g} {:.6g}\">\n"
      "<title>{}</title>\n<path fill-rule=\"{}\" d=\"{}\"/>\n</svg>\n",
      low.x() - margin, -high.y() - margin, high.x() - low.x() + 2 * margin,
      high.y() - low.y() + 2 * margin, xml_escaped(drawing.name),
      drawing.fill_rule == FillRule::even_odd ? "evenodd" : "nonzero", svg_path(drawing));
}

}  // namespace c1mesh
