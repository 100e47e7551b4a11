// SPDX-License-Identifier: GPL-3.0-or-later
// The presentation properties that decide what is filled, and how.
#pragma once

#include <pugixml.hpp>
#include <string>

#include "c1mesh/shape.h"

namespace c1mesh::detail {

/// Inherited properties.
struct Style {
  bool filled = true;    ///< `fill` is not `none`
  bool stroked = false;  ///< `stroke` is not `none`, which it is unless set
  bool visible = true;   ///< `visibility` is `visible`
  FillRule rule = FillRule::nonzero;
};

/// What style="…" on this element says of `property`; empty if nothing.
std::string styled(const pugi::xml_node& element, const std::string& property);

/// The value of `property` on this element: from style="…", which wins, or from the attribute.
/// Empty if neither sets it.
std::string property_of(const pugi::xml_node& element, const std::string& property);

/// `parent` with what this element sets.
Style inherit(const Style& parent, const pugi::xml_node& element);

/// display: none takes the element and all within it out of the drawing.
bool displayed(const pugi::xml_node& element);

}  // namespace c1mesh::detail
