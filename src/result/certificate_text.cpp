// SPDX-License-Identifier: GPL-3.0-or-later
// Certificate <-> the text of docs/certificate.md.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/float_traps.h"
#include "base/hostile_text.h"
#include "c1mesh/certificate.h"
#include "c1mesh/error.h"
#include "result/read_file.h"

namespace c1mesh {
namespace {

// Keeps the keys in the document's order.
using Json = nlohmann::ordered_json;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// JSON has no infinities: null says that nothing is proven.
Json json_of(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json_of(const VerifyItem& item) {
  return {item.name, name_of(item.verdict), item.message};
}

Json json_of(const TriangleProof& proof) {
  Json out = {proof.depth, json_of(proof.det), json_of(proof.g)};
  if (!proof.marks.empty() || proof.rational) out.push_back(proof.marks);
  if (proof.rational) out.emplace_back("rational");
  return out;
}

Json json_of(const EdgeBound& edge) {
  return {edge.a, edge.b, json_of(edge.bound)};
}

Json json_of(const PairProof& proof) {
  return {proof.edges[0], proof.edges[1], proof.edges[2], proof.edges[3], proof.marks};
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

template <class Item>
void add_list(std::string& out, const char* key, const std::vector<Item>& list) {
  out += fmt::format(",\n\"{}\":[", key);
  for (std::size_t i = 0; i < list.size(); ++i) {
    out += i ? ",\n" : "\n";
    out += text_of(json_of(list[i]));
  }
  out += "]";
}

[[noreturn]] void fail(const std::string& message) {
  Defect defect;
  defect.kind = DefectKind::malformed;
  defect.message = "the certificate " + message;
  defect.remedy = "write it again with c1mesh verify --write-certificate";
  throw InputError({defect});
}

const Json& member(const Json& object, const std::string& key) {
  const auto found = object.find(key);
  if (found == object.end()) fail("has no \"" + key + "\"");
  return *found;
}

/// A list item by item, each a list of `least` to `most` values; every complaint says where.
class Row {
 public:
  Row(const Json& value, std::size_t least, std::size_t most, std::string where)
      : value_(value), where_(std::move(where)) {
    if (!value.is_array() || value.size() < least || value.size() > most) fail_here("is malformed");
  }

  bool has(std::size_t i) const { return i < value_.size(); }

  int integer(std::size_t i) const {
    constexpr int kMost = std::numeric_limits<int>::max();
    // What does not fit 64 bits is an unsigned or a floating number to the parser.
    if (!value_[i].is_number_integer() || value_[i] > kMost || value_[i] < 0)
      fail_here("holds no index where one belongs");
    return value_[i].get<int>();
  }

  /// null: `unknown`.
  double number(std::size_t i, double unknown) const {
    if (value_[i].is_null()) return unknown;
    if (!value_[i].is_number() || !std::isfinite(value_[i].get<double>()))
      fail_here("holds no number where one belongs");
    return value_[i].get<double>();
  }

  std::string text(std::size_t i) const {
    if (!value_[i].is_string()) fail_here("holds no text where it belongs");
    return value_[i].get<std::string>();
  }

  ProofMarks marks(std::size_t i) const {
    const ProofMarks out = text(i);
    if (out.find_first_not_of("01") != std::string::npos) fail_here("has marks other than 0 and 1");
    return out;
  }

  [[noreturn]] void fail_here(const char* what) const { fail(where_ + " " + what); }

 private:
  const Json& value_;
  std::string where_;
};

template <class Item, class Read>
std::vector<Item> read_list(const Json& root, const std::string& key, std::size_t least,
                            std::size_t most, const Read& read) {
  const Json& list = member(root, key);
  if (!list.is_array()) fail("has a \"" + key + "\" that is not a list");
  std::vector<Item> out;
  for (std::size_t i = 0; i < list.size(); ++i)
    out.push_back(read(Row(list[i], least, most, fmt::format("has {}[{}], which", key, i))));
  return out;
}

VerifyItem read_item(const Row& row) {
  VerifyItem out{row.text(0), Verdict::undecided, row.text(2)};
  for (const Verdict verdict : {Verdict::valid, Verdict::invalid, Verdict::undecided})
    if (row.text(1) == name_of(verdict)) {
      out.verdict = verdict;
      return out;
    }
  row.fail_here("has none of the verdicts");
}

TriangleProof read_triangle(const Row& row) {
  TriangleProof out;
  out.depth = row.integer(0);
  out.det = row.number(1, -kInfinity);
  out.g = row.number(2, kInfinity);
  if (row.has(3)) out.marks = row.marks(3);
  out.rational = row.has(4);
  return out;
}

EdgeBound read_edge(const Row& row) {
  return {row.integer(0), row.integer(1), row.number(2, kInfinity)};
}

PairProof read_pair(const Row& row) {
  return {{row.integer(0), row.integer(1), row.integer(2), row.integer(3)}, row.marks(4)};
}

double read_bound(const Json& bounds, const char* key, double unknown) {
  const Json& value = member(bounds, key);
  if (value.is_null()) return unknown;
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    fail(fmt::format("has a bound \"{}\" that is no number", key));
  return value.get<double>();
}

Json parse_json(const std::string& text) {
  constexpr int kDeepest = 8;  // copies and prints recurse
  if (json_deeper_than(text, kDeepest)) fail("is nested too deeply");
  try {
    const FloatTrapsOff overflow;  // of 1e999, refused as out of range
    return Json::parse(text);
  } catch (const Json::exception& error) {
    fail("is not JSON: " + json_error_text(error.what()));
  }
}

}  // namespace

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::valid:
      return "valid";
    case Verdict::invalid:
      return "invalid";
    case Verdict::undecided:
      return "undecided";
  }
  return "unknown";
}

std::string format_certificate(const Certificate& c) {
  std::string out = "{\"format\":\"c1mesh-certificate\",\"version\":1";
  out += ",\n\"name\":" + text_of(Json(c.name));
  out += fmt::format(",\n\"degree\":{}", c.degree);
  out += ",\n\"extent\":" + text_of(json_of(c.extent));
  add_list(out, "items", c.items);
  const Json bounds = {{"c1", json_of(c.c1)},
                       {"conformance", json_of(c.conformance)},
                       {"det", json_of(c.det)},
                       {"g", json_of(c.g)}};
  out += ",\n\"bounds\":" + text_of(bounds);
  add_list(out, "triangles", c.triangles);
  add_list(out, "edges", c.edges);
  add_list(out, "curve_edges", c.curve_edges);
  add_list(out, "boundary", c.boundary);
  return out + "}\n";
}

Certificate parse_certificate(const std::string& text) {
  const Json root = parse_json(text);
  if (!root.is_object()) fail("is not a JSON object");
  if (member(root, "format") != "c1mesh-certificate") fail("has another \"format\"");
  if (member(root, "version") != 1) fail("has a version other than 1");
  const Json& name = member(root, "name");
  const Json& degree = member(root, "degree");
  const Json& bounds = member(root, "bounds");
  if (!name.is_string()) fail("has a \"name\" that is not text");
  if (!degree.is_number_integer() || degree < 1 || degree > 1000) fail("has an odd \"degree\"");
  if (!bounds.is_object()) fail("has \"bounds\" that are not an object");
  Certificate out;
  out.name = name.get<std::string>();
  out.degree = degree.get<int>();
  out.extent = read_bound(root, "extent", kInfinity);
  out.items = read_list<VerifyItem>(root, "items", 3, 3, read_item);
  out.c1 = read_bound(bounds, "c1", kInfinity);
  out.conformance = read_bound(bounds, "conformance", kInfinity);
  out.det = read_bound(bounds, "det", -kInfinity);
  out.g = read_bound(bounds, "g", kInfinity);
  out.triangles = read_list<TriangleProof>(root, "triangles", 3, 5, read_triangle);
  out.edges = read_list<EdgeBound>(root, "edges", 3, 3, read_edge);
  out.curve_edges = read_list<EdgeBound>(root, "curve_edges", 3, 3, read_edge);
  out.boundary = read_list<PairProof>(root, "boundary", 5, 5, read_pair);
  return out;
}

Certificate read_certificate(const std::string& path, std::size_t max_bytes) {
  return parse_certificate(read_file(path, max_bytes));
}

}  // namespace c1mesh
