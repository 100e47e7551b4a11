// SPDX-License-Identifier: GPL-3.0-or-later
// rect, circle, ellipse, polygon and polyline as outlines.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "read/outline.h"

namespace c1mesh::detail {

/// The tag without a namespace prefix: "svg:path" is "path".
std::string_view local_name(const pugi::xml_node& element);

/// A length in user units (CSS pixels: 96 to the inch); nothing if the attribute is absent or
/// "auto". Throws SyntaxError for other units (percentages, em), whose meaning is not in the file.
std::optional<double> length(const pugi::xml_node& element, const char* attribute);

/// The outline of a path or basic shape in its own coordinates, y downward; nothing for an element
/// that is neither. Throws SyntaxError.
std::optional<Outline> outline_of(const pugi::xml_node& element);

}  // namespace c1mesh::detail
