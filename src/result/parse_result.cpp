// SPDX-License-Identifier: GPL-3.0-or-later
// Text of docs/format.md -> Result. Whatever passes has indices in range, nets of the right size
// and finite coordinates, so that no other stage has to look again.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/float_traps.h"
#include "base/hostile_text.h"
#include "c1mesh/error.h"
#include "c1mesh/result.h"
#include "result/read_file.h"

namespace c1mesh {
namespace {

using Json = nlohmann::ordered_json;  // parameters and seconds keep their order

constexpr int kHighestDegree = 15;  // the multinomials of det J are then exact doubles

[[noreturn]] void fail(const std::string& message, DefectKind kind = DefectKind::malformed) {
  constexpr std::size_t kMostBytes = 600;  // messages quote keys, which may be anything
  Defect defect;
  defect.kind = kind;
  defect.message = clipped(message, kMostBytes);
  defect.remedy = "write the result again with c1mesh run";
  throw InputError({defect});
}

const Json& member(const Json& object, const std::string& key) {
  const auto found = object.find(key);
  if (found == object.end()) fail("the key \"" + key + "\" is missing");
  return *found;
}

const Json& list(const Json& object, const std::string& key) {
  const Json& value = member(object, key);
  if (!value.is_array()) fail("\"" + key + "\" is not a list");
  return value;
}

/// Fails unless `value` is a list of `size` items.
void want_items(const Json& value, std::size_t size, const std::string& where) {
  if (!value.is_array() || value.size() != size)
    fail(fmt::format("{} is not a list of {} items", where, size));
}

double finite(const Json& value, const std::string& where) {
  if (!value.is_number()) fail(where + " is not a number");
  const double number = value.get<double>();
  if (!std::isfinite(number)) fail(where + " is not finite", DefectKind::non_finite);
  return number;
}

long long integer(const Json& value, const std::string& where) {
  if (!value.is_number_integer()) fail(where + " is not an integer");
  if (value.is_number_unsigned() &&
      value.get<unsigned long long>() > static_cast<unsigned long long>(INT64_MAX))
    fail(where + " is too large");
  return value.get<long long>();
}

int index(const Json& value, std::size_t size, const std::string& where) {
  const long long id = integer(value, where);
  if (id < 0 || id >= static_cast<long long>(size))
    fail(fmt::format("{} refers to {}, but there are only {}", where, id, size));
  return static_cast<int>(id);
}

Point point(const Json& value, const std::string& where) {
  want_items(value, 2, where);
  return {finite(value[0], where), finite(value[1], where)};
}

std::vector<Point> points(const Json& value, const std::string& key) {
  std::vector<Point> out;
  out.reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i)
    out.push_back(point(value[i], fmt::format("{}[{}]", key, i)));
  return out;
}

template <std::size_t N>
std::vector<std::array<int, N>> id_lists(const Json& root, const std::string& key,
                                         std::size_t limit) {
  std::vector<std::array<int, N>> out;
  const Json& items = list(root, key);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string where = fmt::format("{}[{}]", key, i);
    want_items(items[i], N, where);
    std::array<int, N> entry;
    for (std::size_t k = 0; k < N; ++k) entry[k] = index(items[i][k], limit, where);
    for (std::size_t k = 0; k < N; ++k)
      if (entry[k] == entry[(k + 1) % N]) fail(where + " names a vertex twice");
    out.push_back(entry);
  }
  return out;
}

std::vector<std::vector<int>> nets(const Json& root, const Result& result) {
  const std::string key = "triangle_control_points";
  const Json& items = list(root, key);
  want_items(items, result.triangles.size(), key);
  const std::size_t size = (result.degree + 1) * (result.degree + 2) / 2;
  std::vector<std::vector<int>> out;
  for (std::size_t t = 0; t < items.size(); ++t) {
    const std::string where = fmt::format("{}[{}]", key, t);
    want_items(items[t], size, where);
    std::vector<int> net;
    for (const Json& id : items[t]) net.push_back(index(id, result.control_points.size(), where));
    out.push_back(std::move(net));
  }
  return out;
}

std::vector<BezierCurve> curves(const Json& root) {
  std::vector<BezierCurve> out;
  const Json& items = list(root, "curves");
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string where = fmt::format("curves[{}]", i);
    if (!items[i].is_object()) fail(where + " is not an object");
    BezierCurve curve{points(list(items[i], "poles"), where + ".poles")};
    if (curve.degree() < 1) fail(where + " has fewer than two poles");
    out.push_back(std::move(curve));
  }
  return out;
}

std::vector<CurveEdge> curve_edges(const Json& root, const std::string& key, const Result& result) {
  std::vector<CurveEdge> out;
  const Json& items = list(root, key);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string where = fmt::format("{}[{}]", key, i);
    want_items(items[i], 5, where);
    CurveEdge edge;
    edge.a = index(items[i][0], result.domain_vertices.size(), where);
    edge.b = index(items[i][1], result.domain_vertices.size(), where);
    edge.curve = index(items[i][2], result.curves.size(), where);
    edge.t0 = finite(items[i][3], where);
    edge.t1 = finite(items[i][4], where);
    if (edge.a == edge.b) fail(where + " names a vertex twice");
    for (const double t : {edge.t0, edge.t1})
      if (t < 0 || t > 1) fail(where + " has a parameter outside [0, 1]");
    if (edge.t0 == edge.t1) fail(where + " has an empty parameter interval");
    out.push_back(edge);
  }
  return out;
}

std::vector<BoundaryVertex> boundary_vertices(const Json& root, std::size_t vertices) {
  std::vector<BoundaryVertex> out;
  const Json& items = list(root, "boundary_vertices");
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string where = fmt::format("boundary_vertices[{}]", i);
    want_items(items[i], 2, where);
    const int vertex = index(items[i][0], vertices, where);
    const bool corner = items[i][1] == "corner";
    if (!corner && items[i][1] != "smooth") fail(where + " is neither \"smooth\" nor \"corner\"");
    out.push_back({vertex, corner});
  }
  return out;
}

std::vector<int> exceptional_vertices(const Json& root, std::size_t vertices) {
  std::vector<int> out;
  for (const Json& id : list(root, "exceptional_vertices"))
    out.push_back(index(id, vertices, "exceptional_vertices"));
  return out;
}

Parameters parameters(const Json& root) {
  const Json& object = member(root, "parameters");
  if (!object.is_object()) fail("\"parameters\" is not an object");
  Parameters out;
  for (const auto& [key, value] : object.items()) {
    if (value.is_boolean())
      out.emplace_back(key, value.get<bool>());
    else if (value.is_string())
      out.emplace_back(key, value.get<std::string>());
    else if (value.is_number_integer())
      out.emplace_back(key, integer(value, "parameters." + key));
    else
      out.emplace_back(key, finite(value, "parameters." + key));
  }
  return out;
}

/// A measured value; null stands for infinity (nothing was proven).
double measure(const Json& object, const std::string& key) {
  const Json& value = member(object, key);
  if (value.is_null()) return std::numeric_limits<double>::infinity();
  return finite(value, "metrics." + key);
}

int count(const Json& object, const std::string& key) {
  const long long value = integer(member(object, key), "metrics." + key);
  if (std::llabs(value) > std::numeric_limits<int>::max()) fail("metrics." + key + " is too large");
  return static_cast<int>(value);
}

Spread spread(const Json& object, const std::string& key) {
  const Json& value = member(object, key);
  if (!value.is_object()) fail("metrics." + key + " is not an object");
  return {measure(value, "median"), measure(value, "p99"), measure(value, "max")};
}

Metrics metrics(const Json& root) {
  const Json& object = member(root, "metrics");
  if (!object.is_object()) fail("\"metrics\" is not an object");
  Metrics out;
  out.d_ei = spread(object, "d_ei");
  out.gradient_angle_deg = spread(object, "gradient_angle_deg");
  out.gradient_magnitude = spread(object, "gradient_magnitude");
  out.mips_bound_max = measure(object, "mips_bound_max");
  out.min_det_coefficient = measure(object, "min_det_coefficient");
  out.conformance_max = measure(object, "conformance_max");
  out.exceptional = count(object, "exceptional");
  out.exceptional_minimum = count(object, "exceptional_minimum");
  out.exceptional_minimum_paper = count(object, "exceptional_minimum_paper");
  out.surplus = count(object, "surplus");
  out.flatness_ratio = measure(object, "flatness_ratio");
  const Json& overlaps = member(object, "domain_overlaps");
  if (!overlaps.is_boolean()) fail("metrics.domain_overlaps is neither true nor false");
  out.domain_overlaps = overlaps.get<bool>();
  out.triangles = count(object, "triangles");
  const Json& seconds = member(object, "seconds");
  if (!seconds.is_object()) fail("metrics.seconds is not an object");
  for (const auto& [stage, value] : seconds.items())
    out.seconds.emplace_back(stage, finite(value, "metrics.seconds." + stage));
  return out;
}

Json parse_json(const std::string& text) {
  constexpr int kDeepest = 32;  // curves: [{"poles": [[x, y]
  if (json_deeper_than(text, kDeepest))
    fail(fmt::format("the file is nested deeper than {} levels", kDeepest), DefectKind::limit);
  try {
    const FloatTrapsOff overflow;  // of 1e999, refused as out of range
    return Json::parse(text);
  } catch (const Json::exception& error) {
    fail("this is not JSON: " + json_error_text(error.what()));
  }
}

std::string name_from(const std::string& path) {
  std::string name = path.substr(path.find_last_of('/') + 1);
  for (const std::string ending : {".json", ".c1"})
    if (name.size() > ending.size() &&
        name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
      name.resize(name.size() - ending.size());
  return name;
}

}  // namespace

Result parse_result(const std::string& text, const std::string& name) {
  const Json root = parse_json(text);
  if (!root.is_object()) fail("the file is not a JSON object");
  if (member(root, "format") != "c1mesh") fail("\"format\" is not \"c1mesh\"");
  if (integer(member(root, "version"), "version") != 1)
    fail("only version 1 of the format is known", DefectKind::unsupported);
  Result result;
  result.name = name;
  const long long degree = integer(member(root, "degree"), "degree");
  if (degree < 1 || degree > kHighestDegree)
    fail(fmt::format("the degree {} is not between 1 and {}", degree, kHighestDegree));
  result.degree = static_cast<int>(degree);
  result.domain_vertices = points(list(root, "domain_vertices"), "domain_vertices");
  const std::size_t vertices = result.domain_vertices.size();
  result.triangles = id_lists<3>(root, "triangles", vertices);
  result.control_points = points(list(root, "control_points"), "control_points");
  result.triangle_control_points = nets(root, result);
  result.curves = curves(root);
  result.boundary_edges = curve_edges(root, "boundary_edges", result);
  result.feature_edges = curve_edges(root, "feature_edges", result);
  result.boundary_vertices = boundary_vertices(root, vertices);
  result.exceptional_vertices = exceptional_vertices(root, vertices);
  result.relaxed_edges = id_lists<2>(root, "relaxed_edges", vertices);
  result.parameters = parameters(root);
  result.metrics = metrics(root);
  return result;
}

Result read_result(const std::string& path, std::size_t max_bytes) {
  return parse_result(read_file(path, max_bytes), name_from(path));
}

}  // namespace c1mesh
