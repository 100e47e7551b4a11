// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/style.h"

#include <string_view>

namespace c1mesh::detail {
namespace {

std::string_view trimmed(std::string_view text) {
  const char* space = " \t\r\n\f";
  const std::size_t first = text.find_first_not_of(space);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(space) - first + 1);
}

// The last declaration of `property` in a list "name: value; …"; !important changes nothing here.
std::string_view declared(std::string_view style, std::string_view property) {
  std::string_view found;
  while (!style.empty()) {
    const std::size_t end = style.find(';');
    const std::string_view declaration = style.substr(0, end);
    style = end == std::string_view::npos ? std::string_view() : style.substr(end + 1);
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos || trimmed(declaration.substr(0, colon)) != property)
      continue;
    std::string_view value = declaration.substr(colon + 1);
    value = trimmed(value.substr(0, value.find('!')));
    if (!value.empty()) found = value;
  }
  return found;
}

}  // namespace

std::string styled(const pugi::xml_node& element, const std::string& property) {
  return std::string(declared(element.attribute("style").value(), property));
}

std::string property_of(const pugi::xml_node& element, const std::string& property) {
  const std::string in_style = styled(element, property);
  if (!in_style.empty()) return in_style;
  return std::string(trimmed(element.attribute(property.c_str()).value()));
}

Style inherit(const Style& parent, const pugi::xml_node& element) {
  Style out = parent;
  const std::string fill = property_of(element, "fill"), rule = property_of(element, "fill-rule");
  const std::string stroke = property_of(element, "stroke");
  const std::string visibility = property_of(element, "visibility");
  if (!fill.empty() && fill != "inherit") out.filled = fill != "none" && fill != "transparent";
  if (!stroke.empty() && stroke != "inherit")
    out.stroked = stroke != "none" && stroke != "transparent";
  if (rule == "evenodd") out.rule = FillRule::even_odd;
  if (rule == "nonzero") out.rule = FillRule::nonzero;
  if (!visibility.empty() && visibility != "inherit") out.visible = visibility == "visible";
  return out;
}

bool displayed(const pugi::xml_node& element) {
  return property_of(element, "display") != "none";
}

}  // namespace c1mesh::detail
