// SPDX-License-Identifier: GPL-3.0-or-later
// The XML side of an SVG file, and the walk over all it draws.
#pragma once

#include <functional>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "c1mesh/shape.h"
#include "read/style.h"
#include "read/transform.h"

namespace c1mesh::detail {

/// Parses `text`. Throws InputError: not well formed (a file that was cut short is), entities
/// declared, root not <svg>, more elements and attributes than so many curves need.
void load_svg(const std::string& text, const ReadOptions& options, pugi::xml_document& document);

/// An element to be drawn, with what its ancestors (and the `use` elements that led to it) say.
struct Drawn {
  pugi::xml_node element;
  Affine to_user;  ///< from the element's coordinates to the root's user units, y downward
  Style style;
};

/// Visits every element that may draw something, in document order, following `use`.
class SvgWalk {
 public:
  using Visitor = std::function<void(const Drawn&)>;

  SvgWalk(const pugi::xml_document& document, const ReadOptions& options, Visitor visit);
  /// Throws InputError: nesting or number of elements beyond the limits, `use` in a circle, bad
  /// transforms.
  void run();
  /// Tags met that cannot be used, with how often.
  const std::map<std::string, int>& ignored() const { return ignored_; }

 private:
  void index_ids(const pugi::xml_node& root);
  void charge(const pugi::xml_node& node);
  void element(const pugi::xml_node& node, Drawn context, int depth);
  void children(const pugi::xml_node& node, const Drawn& context, int depth);
  void use(const pugi::xml_node& node, Drawn context, int depth);
  void viewport(const pugi::xml_node& node, const pugi::xml_node& size, Drawn context, int depth);

  const pugi::xml_document& document_;
  const ReadOptions& options_;
  Visitor visit_;
  std::map<std::string, pugi::xml_node> by_id_;
  std::vector<pugi::xml_node> being_used_;
  std::map<std::string, int> ignored_;
  std::size_t visits_ = 0, bytes_ = 0;
};

/// How messages and curves name an element: its id (the beginning, if it is long), or nothing.
std::string id_of(const pugi::xml_node& element);

/// As `id_of`, or the tag of an element without id.
std::string label_of(const pugi::xml_node& element);

}  // namespace c1mesh::detail
