// SPDX-License-Identifier: GPL-3.0-or-later
// Trace <-> the lines of docs/format.md.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/float_traps.h"
#include "base/hostile_text.h"
#include "c1mesh/error.h"
#include "c1mesh/trace.h"

namespace c1mesh {
namespace {

// Keeps the keys in the document's order.
using Json = nlohmann::ordered_json;

Json json_of(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json_of(const TraceLine& line) {
  const TraceRecord& r = line.record;
  Json out = {{"shape", line.shape},       {"region", r.region},       {"pass", r.pass},
              {"stage", r.stage},          {"iteration", r.iteration}, {"e_s", json_of(r.e_s)},
              {"e_reg", json_of(r.e_reg)}, {"g", json_of(r.g)},        {"step", json_of(r.step)}};
  if (r.exceptional != -1) out["exceptional"] = r.exceptional;
  return out;
}

// One line being read; every complaint names its number.
class Line {
 public:
  Line(const std::string& text, std::size_t number) : number_(number) {
    constexpr int kDeepest = 32;  // one is all there is
    if (json_deeper_than(text, kDeepest))
      fail(fmt::format("is nested deeper than {} levels", kDeepest));
    try {
      const FloatTrapsOff overflow;  // of 1e999, refused as out of range
      object_ = Json::parse(text);
    } catch (const Json::exception& error) {
      fail("is not JSON: " + json_error_text(error.what()));
    }
    if (!object_.is_object()) fail("is not a JSON object");
  }

  std::string text(const char* key) const {
    const Json& value = member(key);
    if (!value.is_string()) fail(fmt::format("has a \"{}\" that is not text", key));
    return value.get<std::string>();
  }

  int integer(const char* key, int least) const {
    const Json& value = member(key);
    constexpr int kMost = std::numeric_limits<int>::max();
    // What does not fit 64 bits is an unsigned or a floating number to the parser.
    if (!value.is_number_integer() || value > kMost || value < least)
      fail(fmt::format("has a \"{}\" that is not an integer from {}", key, least));
    return value.get<int>();
  }

  double number(const char* key) const {
    const Json& value = member(key);
    if (value.is_null()) return std::numeric_limits<double>::infinity();
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      fail(fmt::format("has a \"{}\" that is neither null nor a number", key));
    return value.get<double>();
  }

  double magnitude(const char* key) const {
    const double value = number(key);
    if (value < 0) fail(fmt::format("has a \"{}\" that is negative", key));
    return value;
  }

  bool has(const char* key) const { return object_.contains(key); }

 private:
  const Json& member(const char* key) const {
    const auto found = object_.find(key);
    if (found == object_.end()) fail(fmt::format("has no \"{}\"", key));
    return *found;
  }

  [[noreturn]] void fail(const std::string& what) const {
    Defect defect;
    defect.kind = DefectKind::malformed;
    defect.message = fmt::format("line {} of the trace {}", number_, what);
    defect.remedy = "write the trace again with c1mesh run --trace";
    throw InputError({defect});
  }

  Json object_;
  std::size_t number_;
};

TraceLine read_line(const std::string& text, std::size_t number) {
  const Line line(text, number);
  TraceLine out;
  out.shape = line.text("shape");
  TraceRecord& r = out.record;
  r.region = line.integer("region", 0);
  r.pass = line.integer("pass", 1);
  r.stage = line.text("stage");
  r.iteration = line.integer("iteration", 1);
  r.e_s = line.magnitude("e_s");
  r.e_reg = line.number("e_reg");
  r.g = line.magnitude("g");
  r.step = line.magnitude("step");
  if (line.has("exceptional")) r.exceptional = line.integer("exceptional", 0);
  return out;
}

}  // namespace

std::string format_trace(const std::vector<TraceLine>& lines) {
  std::string out;
  for (const TraceLine& line : lines)
    out += json_of(line).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  return out;
}

std::vector<TraceLine> parse_trace(const std::string& text) {
  std::vector<TraceLine> out;
  std::size_t number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    out.push_back(read_line(text.substr(at, end - at), ++number));
    at = end + 1;
  }
  return out;
}

bool is_trace(const std::string& text) {
  const FloatTrapsOff overflow;  // as above
  const Json first = Json::parse(text.substr(0, text.find('\n')), nullptr, false);
  return first.is_object() && first.contains("e_s") && first.contains("stage");
}

}  // namespace c1mesh
