// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/look.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace c1mesh {
namespace {

[[noreturn]] void unknown(std::string_view what, std::string_view value) {
  throw std::invalid_argument(fmt::format("a picture cannot have the {} '{}'", what, value));
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

// #rgb, #rrggbb or none.
void set_colour(Paint& paint, std::string_view value) {
  paint.none = value == "none";
  if (paint.none) return;
  if (value.empty() || value[0] != '#' || (value.size() != 4 && value.size() != 7))
    unknown("colour", value);
  const std::size_t digits = (value.size() - 1) / 3;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string_view part = value.substr(1 + k * digits, digits);
    int level = 0;
    const auto read = std::from_chars(part.data(), part.data() + part.size(), level, 16);
    if (read.ptr != part.data() + part.size()) unknown("colour", value);
    paint.rgb[k] = (digits == 1 ? 17 * level : level) / 255.0;
  }
}

// One of two words.
bool choice(std::string_view what, std::string_view value, std::string_view no,
            std::string_view yes) {
  if (value != no && value != yes) unknown(what, value);
  return value == yes;
}

Anchor anchor_of(std::string_view value) {
  if (value == "start") return Anchor::start;
  if (value == "middle") return Anchor::middle;
  if (value == "end") return Anchor::end;
  unknown("text-anchor", value);
}

}  // namespace

std::vector<std::string_view> pieces_of(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(separators), text.size());
    const std::string_view piece = trimmed(text.substr(0, end));
    if (!piece.empty()) out.push_back(piece);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

double number_of(std::string_view text) {
  text = trimmed(text);
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view rest(read.ptr, text.data() + text.size() - read.ptr);
  if (read.ec != std::errc() || (!rest.empty() && rest != "px")) unknown("number", text);
  return value;
}

bool set_property(Look& look, std::string_view property, std::string_view value) {
  if (property == "fill")
    set_colour(look.fill, value);
  else if (property == "stroke")
    set_colour(look.stroke, value);
  else if (property == "fill-opacity")
    look.fill.opacity = number_of(value);
  else if (property == "stroke-opacity")
    look.stroke.opacity = number_of(value);
  else if (property == "fill-rule")
    look.even_odd = choice(property, value, "nonzero", "evenodd");
  else if (property == "stroke-width")
    look.stroke_width = number_of(value);
  else if (property == "stroke-linecap")
    look.round_caps = choice(property, value, "butt", "round");
  else if (property == "stroke-linejoin")
    look.round_joins = choice(property, value, "miter", "round");
  else if (property == "paint-order")
    look.stroke_first = choice(property, value, "normal", "stroke");
  else if (property == "font-size")
    look.font_size = number_of(value);
  else if (property == "font-weight")
    look.bold = choice(property, value, "normal", "bold");
  else if (property == "text-anchor")
    look.anchor = anchor_of(value);
  else if (property == "stroke-dasharray") {
    look.dashes.clear();
    if (value != "none")
      for (const std::string_view dash : pieces_of(value, " ,"))
        look.dashes.push_back(number_of(dash));
  } else
    return property == "font-family";  // there is one font
  return true;
}

void set_declarations(Look& look, std::string_view declarations) {
  for (const std::string_view declaration : pieces_of(declarations, ";")) {
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos ||
        !set_property(look, trimmed(declaration.substr(0, colon)),
                      trimmed(declaration.substr(colon + 1))))
      unknown("property", declaration);
  }
}

StyleSheet::StyleSheet(std::string_view text) {
  for (const std::string_view rule : pieces_of(text, "}")) {
    const std::size_t brace = rule.find('{');
    if (brace == std::string_view::npos) unknown("rule", rule);
    for (const std::string_view selector : pieces_of(rule.substr(0, brace), ",")) {
      Rule made{{}, 0, std::string(rule.substr(brace + 1))};
      for (const std::string_view part : pieces_of(selector, " ")) {
        if (part.find_first_of(".#:>[*", 1) != std::string_view::npos || part[0] == '#')
          unknown("selector", selector);
        made.selector.emplace_back(part);
        made.specificity += part[0] == '.' ? 1000 : 1;
      }
      rules_.push_back(std::move(made));
    }
  }
  std::stable_sort(rules_.begin(), rules_.end(),
                   [](const Rule& a, const Rule& b) { return a.specificity < b.specificity; });
}

bool StyleSheet::matches(const Rule& rule, const std::vector<Tagged>& path) {
  const auto fits = [](const std::string& part, const Tagged& element) {
    if (part[0] != '.') return element.tag == part;
    const std::string_view name = std::string_view(part).substr(1);
    return std::find(element.classes.begin(), element.classes.end(), name) != element.classes.end();
  };
  if (!fits(rule.selector.back(), path.back())) return false;
  std::size_t left = rule.selector.size() - 1;
  for (std::size_t k = path.size() - 1; k-- > 0 && left > 0;)
    if (fits(rule.selector[left - 1], path[k])) --left;
  return left == 0;
}

void StyleSheet::apply(Look& look, const std::vector<Tagged>& path) const {
  for (const Rule& rule : rules_)
    if (matches(rule, path)) set_declarations(look, rule.declarations);
}

}  // namespace c1mesh
