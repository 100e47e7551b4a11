// SPDX-License-Identifier: GPL-3.0-or-later
// JSON arrangements: the format of the public Bezier Guarding and TriWild programs.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/float_traps.h"
#include "read/formats.h"

namespace c1mesh::detail {
namespace {

using nlohmann::json;

constexpr std::size_t kMostDefects = 100;

// Counts brackets outside strings before the parser runs, so that depth is bounded up front.
void check_depth(const std::string& text, int max_depth) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > max_depth)
        refuse(DefectKind::limit,
               fmt::format("the input is nested deeper than {} levels", max_depth),
               "give a flat list of curves");
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
}

json parse(const std::string& text) {
  try {
    const FloatTrapsOff overflow;  // of 1e999, refused as out of range
    return json::parse(text);
  } catch (const json::exception& error) {
    // The library's message starts with its own error number in brackets: not for the user.
    const std::string what = error.what();
    const std::size_t bracket = what.find("] ");
    refuse(DefectKind::malformed,
           "not valid JSON: " + (bracket == std::string::npos ? what : what.substr(bracket + 2)),
           "repair the file's syntax");
  }
}

const json& curve_list(const json& root) {
  const json* list = &root;
  if (root.is_object()) {
    const auto found = root.find("curves");
    if (found == root.end())
      refuse(DefectKind::malformed, "the object has no \"curves\"",
             "put the curves under \"curves\"");
    list = &*found;
  }
  if (!list->is_array())
    refuse(DefectKind::malformed, "\"curves\" is not a list", "give a list of curves");
  if (list->empty())
    refuse(DefectKind::empty, "the list of curves is empty", "give at least one curve");
  return *list;
}

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
    defect.message = fmt::format("curve {} (number {} of the list) {}", id_, index_, what);
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
               "has the type \"" + type->get<std::string>() +
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
               fmt::format("says degree {} but has {} poles", found->dump(), degree + 1),
               "a curve of degree n has n + 1 poles");
  }

  const json& entry_;
  std::size_t index_;
  std::vector<Defect>& defects_;
  std::string id_;
};

}  // namespace

Drawing read_json(const std::string& text, const std::string& name, const ReadOptions& options) {
  check_depth(text, options.max_depth);
  const json root = parse(text);
  const json& list = curve_list(root);
  if (list.size() > options.max_curves)
    refuse(DefectKind::limit, fmt::format("more than {} curves", options.max_curves),
           "split the drawing or raise the limit");
  Drawing drawing;
  drawing.name = name;
  std::vector<Defect> defects;
  drawing.curves.reserve(list.size());
  for (std::size_t i = 0; i < list.size(); ++i)
    drawing.curves.push_back(CurveReader(list[i], i, defects).read());
  if (!defects.empty()) throw InputError(defects);
  return drawing;
}

}  // namespace c1mesh::detail
