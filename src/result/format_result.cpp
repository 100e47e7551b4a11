// SPDX-License-Identifier: GPL-3.0-or-later
// Result -> text of docs/format.md: one item of each list per line, keys in the document's order.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "c1mesh/result.h"

namespace c1mesh {
namespace {

/// The shortest text that reads back as the same double. JSON readers take "-0" for an integer and
/// lose its sign, so negative zero keeps its fraction; JSON has no infinities, so they are null.
std::string number(double value) {
  if (!std::isfinite(value)) return "null";
  if (value == 0 && std::signbit(value)) return "-0.0";
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

/// As number(), and never mistaken for an integer.
std::string real(double value) {
  std::string text = number(value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string quoted(const std::string& text) {
  using Json = nlohmann::json;
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string item(const Point& p) {
  return fmt::format("[{},{}]", number(p.x()), number(p.y()));
}

template <class Ids>
std::string ids(const Ids& list) {
  std::string out = "[";
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i) out += ",";
    out += std::to_string(list[i]);
  }
  return out + "]";
}

std::string item(const std::array<int, 3>& t) {
  return ids(t);
}
std::string item(const std::array<int, 2>& e) {
  return ids(e);
}
std::string item(const std::vector<int>& net) {
  return ids(net);
}

std::string item(const BezierCurve& curve) {
  std::string out = "{\"poles\":[";
  for (std::size_t i = 0; i < curve.poles.size(); ++i)
    out += fmt::format("{}{}", i ? "," : "", item(curve.poles[i]));
  return out + "]}";
}

std::string item(const CurveEdge& e) {
  return fmt::format("[{},{},{},{},{}]", e.a, e.b, e.curve, number(e.t0), number(e.t1));
}

std::string item(const BoundaryVertex& v) {
  return fmt::format("[{},\"{}\"]", v.vertex, v.corner ? "corner" : "smooth");
}

template <class List>
void add_list(std::string& out, const char* key, const List& list) {
  out += std::string(",\n\"") + key + "\":[";
  for (std::size_t i = 0; i < list.size(); ++i) {
    out += i ? ",\n" : "\n";
    out += item(list[i]);
  }
  out += "]";
}

struct ParameterText {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(long long value) const { return std::to_string(value); }
  std::string operator()(double value) const { return real(value); }
  std::string operator()(const std::string& value) const { return quoted(value); }
};

std::string text_of(const Parameters& parameters) {
  std::string out = "{";
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    out += i ? ",\n" : "\n";
    out += fmt::format("{}:{}", quoted(parameters[i].first),
                       std::visit(ParameterText{}, parameters[i].second));
  }
  return out + "}";
}

std::string text_of(const Spread& s) {
  return fmt::format("{{\"median\":{},\"p99\":{},\"max\":{}}}", number(s.median), number(s.p99),
                     number(s.max));
}

std::string text_of(const Metrics& m) {
  std::string out = "{\n\"d_ei\":" + text_of(m.d_ei);
  const auto add = [&](const char* key, const std::string& value) {
    out += fmt::format(",\n\"{}\":{}", key, value);
  };
  add("gradient_angle_deg", text_of(m.gradient_angle_deg));
  add("gradient_magnitude", text_of(m.gradient_magnitude));
  add("mips_bound_max", number(m.mips_bound_max));
  add("min_det_coefficient", number(m.min_det_coefficient));
  add("conformance_max", number(m.conformance_max));
  add("exceptional", std::to_string(m.exceptional));
  add("exceptional_minimum", std::to_string(m.exceptional_minimum));
  add("exceptional_minimum_paper", std::to_string(m.exceptional_minimum_paper));
  add("surplus", std::to_string(m.surplus));
  add("flatness_ratio", number(m.flatness_ratio));
  add("domain_overlaps", m.domain_overlaps ? "true" : "false");
  add("triangles", std::to_string(m.triangles));
  std::string seconds = "{";
  for (std::size_t i = 0; i < m.seconds.size(); ++i)
    seconds += fmt::format("{}{}:{}", i ? "," : "", quoted(m.seconds[i].first),
                           number(m.seconds[i].second));
  add("seconds", seconds + "}");
  return out + "}";
}

}  // namespace

std::string format_result(const Result& result) {
  std::string out = "{\"format\":\"c1mesh\",\"version\":1,\n\"degree\":";
  out += std::to_string(result.degree);
  add_list(out, "domain_vertices", result.domain_vertices);
  add_list(out, "triangles", result.triangles);
  add_list(out, "control_points", result.control_points);
  add_list(out, "triangle_control_points", result.triangle_control_points);
  add_list(out, "curves", result.curves);
  add_list(out, "boundary_edges", result.boundary_edges);
  add_list(out, "feature_edges", result.feature_edges);
  add_list(out, "boundary_vertices", result.boundary_vertices);
  out += ",\n\"exceptional_vertices\":" + ids(result.exceptional_vertices);
  add_list(out, "relaxed_edges", result.relaxed_edges);
  out += ",\n\"parameters\":" + text_of(result.parameters);
  out += ",\n\"metrics\":" + text_of(result.metrics);
  return out + "}\n";
}

}  // namespace c1mesh
