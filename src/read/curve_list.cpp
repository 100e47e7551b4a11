// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/curve_list.h"

#include <fmt/format.h>

#include <optional>

#include "base/float_traps.h"
#include "base/hostile_text.h"
#include "read/formats.h"

namespace c1mesh::detail {
namespace {

using nlohmann::json;

// A curve of the highest degree has about a hundred; the rest is for what other programs add.
constexpr std::size_t kMostValues = 100'000;

// Hears the parser's events: finds the list, builds its items, passes over all else.
class CurveList : public nlohmann::json_sax<json> {
 public:
  using Entry = std::function<void(const json&, std::size_t)>;

  CurveList(const ReadOptions& options, const Entry& entry) : options_(options), entry_(entry) {}

  void finish() const {
    if (!found_)
      refuse(DefectKind::malformed, "the object has no \"curves\"",
             "put the curves under \"curves\"");
    if (count_ == 0)
      refuse(DefectKind::empty, "the list of curves is empty", "give at least one curve");
  }

  bool null() override {
    return scalar([](auto& tree) { return tree.null(); });
  }
  bool boolean(bool value) override {
    return scalar([=](auto& tree) { return tree.boolean(value); });
  }
  bool number_integer(number_integer_t value) override {
    return scalar([=](auto& tree) { return tree.number_integer(value); });
  }
  bool number_unsigned(number_unsigned_t value) override {
    return scalar([=](auto& tree) { return tree.number_unsigned(value); });
  }
  bool number_float(number_float_t value, const string_t& text) override {
    return scalar([&](auto& tree) { return tree.number_float(value, text); });
  }
  bool string(string_t& value) override {
    return scalar([&](auto& tree) { return tree.string(value); });
  }
  bool binary(binary_t&) override { return false; }  // not in JSON text
  bool start_object(std::size_t size) override {
    return start(false, [=](auto& tree) { return tree.start_object(size); });
  }
  bool end_object() override {
    return end([](auto& tree) { return tree.end_object(); });
  }
  bool start_array(std::size_t size) override {
    return start(true, [=](auto& tree) { return tree.start_array(size); });
  }
  bool end_array() override {
    return end([](auto& tree) { return tree.end_array(); });
  }
  bool key(string_t& name) override {
    if (tree_) return tree_->key(name);
    if (depth_ == 1) at_curves_ = name == "curves";
    if (depth_ == 1 && at_curves_ && found_)
      refuse(DefectKind::malformed, "the object has \"curves\" twice",
             "put all curves into one list");
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& e) override {
    refuse(DefectKind::malformed, "not valid JSON: " + json_error_text(e.what()),
           "repair the file's syntax");
  }

 private:
  using Tree = nlohmann::detail::json_sax_dom_parser<json>;

  bool in_list() const { return list_open_ && depth_ == list_depth_; }

  void begin_item() {
    if (count_ >= options_.max_curves)
      refuse(DefectKind::limit, fmt::format("more than {} curves", options_.max_curves),
             "split the drawing or raise the limit (--max-curves)");
    item_ = json();
    tree_.emplace(item_, true);
    values_ = 0;
  }

  void end_item() {
    tree_.reset();
    entry_(item_, count_++);
  }

  void count_value() {
    if (++values_ > kMostValues)
      refuse(
          DefectKind::limit,
          fmt::format("curve number {} of the list has more than {} values", count_, kMostValues),
          "give curves of lower degree, and leave out what is no curve");
  }

  // The value of "curves" is something else than a list.
  void refuse_other() const {
    if (depth_ == 1 && at_curves_ && !list_open_)
      refuse(DefectKind::malformed, "\"curves\" is not a list", "give a list of curves");
  }

  template <class Forward>
  bool scalar(const Forward& forward) {
    if (tree_) {
      count_value();
      return forward(*tree_);
    }
    if (in_list()) {
      begin_item();
      forward(*tree_);
      end_item();
      return true;
    }
    refuse_other();
    return true;
  }

  template <class Forward>
  bool start(bool array, const Forward& forward) {
    if (tree_ || in_list()) {
      if (!tree_) begin_item();
      count_value();
      ++item_depth_;
      return forward(*tree_);
    }
    const bool list = array && (depth_ == 0 || (depth_ == 1 && at_curves_));
    if (!list) refuse_other();
    ++depth_;
    if (list) {
      found_ = list_open_ = true;
      list_depth_ = depth_;
    }
    return true;
  }

  template <class Forward>
  bool end(const Forward& forward) {
    if (tree_) {
      const bool good = forward(*tree_);
      if (--item_depth_ == 0) end_item();
      return good;
    }
    if (in_list()) list_open_ = at_curves_ = false;
    --depth_;
    return true;
  }

  const ReadOptions& options_;
  const Entry& entry_;
  bool found_ = false;      // the list was there
  bool list_open_ = false;  // we are within it
  bool at_curves_ = false;  // the root's key "curves" was the last one
  int depth_ = 0, list_depth_ = 0;
  std::size_t count_ = 0;
  json item_;                 // in work while there is a tree
  std::optional<Tree> tree_;  // fills it
  int item_depth_ = 0;
  std::size_t values_ = 0;
};

}  // namespace

void for_each_curve(const std::string& text, const ReadOptions& options,
                    const std::function<void(const json&, std::size_t)>& entry) {
  // The parser itself does not recurse, but what reads an item may.
  if (json_deeper_than(text, options.max_depth))
    refuse(DefectKind::limit,
           fmt::format("the input is nested deeper than {} levels", options.max_depth),
           "give a flat list of curves, or raise the limit (--max-depth)");
  CurveList list(options, entry);
  const FloatTrapsOff overflow;  // of 1e999, refused as out of range
  json::sax_parse(text, &list);
  list.finish();
}

}  // namespace c1mesh::detail
