// SPDX-License-Identifier: GPL-3.0-or-later
// SVG drawings: every filled element becomes a Drawing, y turned upward.
#include <fmt/format.h>

#include <map>
#include <set>

#include "base/float_traps.h"
#include "read/basic_shapes.h"
#include "read/formats.h"
#include "read/svg_document.h"

namespace c1mesh::detail {
namespace {

Defect note(const std::string& message, std::vector<std::string> curves = {}) {
  Defect out;
  out.kind = DefectKind::note;
  out.curves = std::move(curves);
  out.message = message;
  return out;
}

// Result names become file names: only harmless characters.
std::string file_safe(std::string text) {
  for (char& c : text) {
    const bool harmless = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
    if (!harmless) c = '_';
  }
  return text;
}

// Names handed out once each: `wanted`, or with "-2", "-3", … appended.
class Names {
 public:
  std::string claim(const std::string& wanted) {
    if (taken_.insert(wanted).second) return wanted;
    // Where the last search ended: a drawing may give one id to all its elements.
    int& number = last_.emplace(wanted, 1).first->second;
    while (true) {
      std::string name = fmt::format("{}-{}", wanted, ++number);
      if (taken_.insert(name).second) return name;
    }
  }

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> last_;
};

class SvgReader {
 public:
  SvgReader(const std::string& text, const std::string& name, const ReadOptions& options)
      : name_(name), options_(options) {
    load_svg(text, options, document_);
  }

  std::vector<Drawing> read() {
    // Sizes and transforms may take coordinates out of range: refused as not finite, later.
    const FloatTrapsOff overflow;
    SvgWalk walk(document_, options_, [this](const Drawn& drawn) { draw(drawn); });
    walk.run();
    if (drawings_.empty()) refuse_empty(walk);
    name_drawings();
    if (options_.together) unite();
    for (const auto& [tag, count] : walk.ignored())
      drawings_.front().notes.push_back(
          note(fmt::format("{} {} ignored: not supported", count, tag)));
    return std::move(drawings_);
  }

 private:
  void draw(const Drawn& drawn) {
    const std::optional<Outline> outline = outline_of(drawn.element);
    ++ordinal_;
    if (!outline || outline->subpaths.empty()) return;
    const bool feature = options_.together && !drawn.style.filled && drawn.style.stroked;
    if (!drawn.style.visible || !(drawn.style.filled || feature)) {
      ++unfilled_;
      return;
    }
    const std::string id = id_of(drawn.element);
    const std::string label =
        id.empty() ? fmt::format("{}{}", local_name(drawn.element), ordinal_) : id;
    if (feature) {
      features_.push_back(features_of(*outline, drawn, label));
      return;
    }
    drawings_.push_back(drawing_of(*outline, drawn, label));
    labels_.push_back(id.empty() ? std::to_string(drawings_.size()) : id);
  }

  // Lines that are drawn but not filled: the curves as they are, not closed.
  Drawing features_of(Outline outline, const Drawn& drawn, const std::string& label) {
    for (std::size_t i = 0; i < outline.subpaths.size(); ++i)
      if (outline.closing_line[i]) outline.subpaths[i].pop_back();
    outline.closed_by_line = 0;
    Drawing out = drawing_of(outline, drawn, label);
    for (InputCurve& curve : out.curves) curve.feature = true;
    return out;
  }

  Drawing drawing_of(const Outline& outline, const Drawn& drawn, const std::string& label) {
    Drawing out;
    out.fill_rule = drawn.style.rule;
    const Affine map = scaling(1, -1) * drawn.to_user;
    const std::string prefix = curve_prefixes_.claim(label);
    for (const auto& subpath : outline.subpaths)
      for (BezierCurve curve : subpath) {
        for (Point& p : curve.poles) p = map(p);
        out.curves.push_back({fmt::format("{}:{}", prefix, out.curves.size()), std::move(curve)});
      }
    curve_count_ += out.curves.size();
    if (curve_count_ > options_.max_curves)
      refuse(DefectKind::limit, fmt::format("more than {} curves", options_.max_curves),
             "split the drawing or raise the limit (--max-curves)");
    if (outline.arcs > 0)
      out.notes.push_back(note(fmt::format(
          "{}: {} elliptical arc{} became cubics; largest error {:.3g} in the drawing's units",
          prefix, outline.arcs, outline.arcs == 1 ? "" : "s", outline.arc_error * map.stretch())));
    if (outline.closed_by_line > 0)
      out.notes.push_back(note(
          fmt::format("{}: {} open subpath{} closed by a straight line, as "
                      "filling does",
                      prefix, outline.closed_by_line, outline.closed_by_line == 1 ? "" : "s")));
    return out;
  }

  [[noreturn]] void refuse_empty(const SvgWalk& walk) const {
    std::string found;
    if (unfilled_ > 0)
      found = fmt::format("; {} outlines are not filled or not visible", unfilled_);
    for (const auto& [tag, count] : walk.ignored())
      found += fmt::format("; {} {} not supported", count, tag);
    refuse(DefectKind::empty, "the drawing has no filled outline" + found,
           "fill the outlines that are to be meshed; convert text to paths");
  }

  void name_drawings() {
    Names names;
    for (std::size_t i = 0; i < drawings_.size(); ++i)
      drawings_[i].name = drawings_.size() == 1 || options_.together
                              ? name_
                              : names.claim(name_ + "-" + file_safe(labels_[i]));
  }

  // The elements' own fill rules say nothing about the whole: as for JSON, even-odd does.
  void unite() {
    Drawing all;
    all.name = name_;
    all.fill_rule = drawings_.size() == 1 ? drawings_[0].fill_rule : FillRule::even_odd;
    drawings_.insert(drawings_.end(), features_.begin(), features_.end());
    for (Drawing& drawing : drawings_) {
      for (InputCurve& curve : drawing.curves) all.curves.push_back(std::move(curve));
      for (Defect& defect : drawing.notes) all.notes.push_back(std::move(defect));
    }
    drawings_.clear();
    drawings_.push_back(std::move(all));
  }

  pugi::xml_document document_;
  const std::string& name_;
  const ReadOptions& options_;
  std::vector<Drawing> drawings_, features_;
  std::vector<std::string> labels_;  // per drawing: its element's id or ordinal
  Names curve_prefixes_;
  std::size_t curve_count_ = 0;
  int ordinal_ = 0, unfilled_ = 0;
};

}  // namespace

std::vector<Drawing> read_svg(const std::string& text, const std::string& name,
                              const ReadOptions& options) {
  return SvgReader(text, name, options).read();
}

}  // namespace c1mesh::detail
