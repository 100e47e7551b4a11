// SPDX-License-Identifier: GPL-3.0-or-later
// JSON arrangements: the format of the public Bezier Guarding and TriWild programs.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/hostile_text.h"
#include "read/curve_list.h"
#include "read/formats.h"

namespace c1mesh::detail {
namespace {

using nlohmann::json;

constexpr std::size_t kMostDefects = 100;
// Every defect repeats the names of its curves.
constexpr std::size_t kLongestId = 4096, kQuoted = 100;

// Reads one curve; what is wrong with it is appended to `defects`.
class CurveReader {
 public:
  CurveReader(const json& entry, std::size_t index, std::vector<Defect>& defects)
      : entry_(entry), index_(index), defects_(defects) {}

  InputCurve read() {
    InputCurve out;
    if (!entry_.is_object()) {
      id_ = std::to_string(index_);
      complain(DefectKind::malformed, "is not an object",
               "write it as {\"curve_id\": …, \"poles\": …}");
      return out;
    }
    read_id();
    out.id = id_;
    if (check_type()) out.curve.poles = read_poles();
    read_mark(out);
    return out;
  }

 private:
  void complain(DefectKind kind, const std::string& what, const std::string& remedy) {
    if (defects_.size() >= kMostDefects) return;
    Defect defect;
    defect.kind = kind;
    defect.curves = {id_};
    defect.message =
        fmt::format("curve {} (number {} of the list) {}", clipped(id_, kQuoted), index_, what);
    defect.remedy = remedy;
    defects_.push_back(defect);
  }

  void read_id() {
    id_ = std::to_string(index_);
    const auto found = entry_.find("curve_id");
    if (found == entry_.end()) return;
    if (found->is_string())
      id_ = found->get<std::string>();
    else if (found->is_number())
      id_ = found->dump();
    else
      complain(DefectKind::malformed, "has a curve_id that is neither a number nor a string",
               "name curves by numbers or strings");
    if (id_.size() <= kLongestId) return;
    id_ = clipped(id_, kQuoted);
    complain(DefectKind::limit, fmt::format("has a curve_id of more than {} bytes", kLongestId),
             "give it a shorter name");
  }

  void read_mark(InputCurve& out) {
    const auto found = entry_.find("feature");
    if (found == entry_.end()) return;
    if (found->is_boolean())
      out.feature = found->get<bool>();
    else
      complain(DefectKind::malformed, "has a \"feature\" that is neither true nor false",
               "mark curves that bound nothing by \"feature\": true");
  }

  bool check_type() {
    const auto type = entry_.find("type");
    if (type != entry_.end() && !type->is_string()) {
      complain(DefectKind::malformed, "has a type that is not a string",
               "the type is \"BezierCurve\"");
      return false;
    }
    if (type != entry_.end() && *type != "BezierCurve") {
      complain(DefectKind::unsupported,
               "has the type \"" + clipped(type->get_ref<const std::string&>(), kQuoted) +
                   "\"; only polynomial Bezier curves "
                   "(\"BezierCurve\") can be used",
               "approximate it by polynomial Bezier curves");
      return false;
    }
    // "weigths" is how TriWild's files spell it.
    if (entry_.contains("weights") || entry_.contains("weigths")) {
      complain(DefectKind::unsupported, "has weights; rational curves cannot be used",
               "approximate it by polynomial Bezier curves");
      return false;
    }
    return true;
  }

  std::vector<Point> read_poles() {
    const auto poles = entry_.find("poles");
    if (poles == entry_.end() || !poles->is_array()) {
      complain(DefectKind::malformed, "has no list \"poles\"",
               "give its control points as [[x, y], …]");
      return {};
    }
    if (poles->size() < 2) {
      complain(DefectKind::malformed, fmt::format("has {} poles", poles->size()),
               "give at least two control points");
      return {};
    }
    std::vector<Point> out;
    for (std::size_t i = 0; i < poles->size(); ++i) {
      const json& pole = (*poles)[i];
      if (!pole.is_array() || pole.size() != 2 || !pole[0].is_number() || !pole[1].is_number()) {
        complain(DefectKind::malformed,
                 fmt::format("has a pole (number {}) that is not two numbers", i),
                 "give every control point as [x, y]");
        return {};
      }
      out.emplace_back(pole[0].get<double>(), pole[1].get<double>());
    }
    check_degree(static_cast<int>(out.size()) - 1);
    return out;
  }

  void check_degree(int degree) {
    const auto found = entry_.find("degree");
    if (found == entry_.end()) return;
    if (!found->is_number_integer() || found->get<long long>() != degree)
      complain(DefectKind::malformed,
               fmt::format("says degree {} but has {} poles",
                           found->is_number() ? found->dump() : found->type_name(), degree + 1),
               "a curve of degree n has n + 1 poles");
  }

  const json& entry_;
  std::size_t index_;
  std::vector<Defect>& defects_;
  std::string id_;
};

}  // namespace

Drawing read_json(const std::string& text, const std::string& name, const ReadOptions& options) {
  Drawing drawing;
  drawing.name = name;
  std::vector<Defect> defects;
  for_each_curve(text, options, [&](const json& entry, std::size_t index) {
    drawing.curves.push_back(CurveReader(entry, index, defects).read());
  });
  if (!defects.empty()) throw InputError(defects);
  return drawing;
}

}  // namespace c1mesh::detail
