// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/svg_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <set>

#include "base/hostile_text.h"
#include "read/basic_shapes.h"
#include "read/formats.h"
#include "read/scanner.h"

namespace c1mesh::detail {
namespace {

const std::set<std::string_view> kContainers = {"g", "a", "switch"};
// They draw nothing by themselves and hold nothing that is drawn in place.
const std::set<std::string_view> kSilent = {
    "defs",           "symbol", "title",         "desc",      "metadata",  "linearGradient",
    "radialGradient", "stop",   "script",        "view",      "namedview", "filter",
    "cursor",         "font",   "color-profile", "solidcolor"};
const std::set<std::string_view> kUnsupported = {"text",
                                                 "image",
                                                 "clipPath",
                                                 "mask",
                                                 "pattern",
                                                 "marker",
                                                 "foreignObject",
                                                 "style",
                                                 "line",
                                                 "animate",
                                                 "animateTransform",
                                                 "animateMotion",
                                                 "set",
                                                 "video",
                                                 "audio",
                                                 "canvas",
                                                 "iframe"};

// How much of an id, a tag, a reference is quoted; names of files are made of ids.
constexpr std::size_t kQuoted = 100;

// A node of the parser's tree takes sixteen times the bytes of the shortest element, so the tree is
// bounded before it grows: so many elements and attributes for every curve that may be.
void check_size(const std::string& text, const ReadOptions& options) {
  constexpr std::size_t kNodesPerCurve = 10;
  const auto nodes =
      std::count_if(text.begin(), text.end(), [](char c) { return c == '<' || c == '='; });
  if (static_cast<std::size_t>(nodes) / kNodesPerCurve > options.max_curves)
    refuse(DefectKind::limit,
           fmt::format("the file has {} elements and attributes, too many for {} curves", nodes,
                       options.max_curves),
           "simplify the drawing or raise the limit (--max-curves)");
}

pugi::xml_attribute href(const pugi::xml_node& node) {
  const pugi::xml_attribute plain = node.attribute("href");
  if (plain) return plain;
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    const std::string_view name = attribute.name();
    if (name.size() > 5 && name.substr(name.size() - 5) == ":href") return attribute;
  }
  return {};
}

// viewBox -> (0, 0, width, height), as preserveAspectRatio="xMidYMid meet" (the default) or "none".
Affine view_box_transform(const pugi::xml_node& node, const pugi::xml_node& size) {
  const pugi::xml_attribute box = node.attribute("viewBox");
  if (!box) return {};
  Scanner in(box.value());
  double v[4];
  in.skip_space();
  for (double& x : v) {
    x = in.number();
    in.skip_comma();
  }
  const auto width = length(size.attribute("width") ? size : node, "width");
  const auto height = length(size.attribute("height") ? size : node, "height");
  if (!width || !height || v[2] <= 0 || v[3] <= 0) return translation(-v[0], -v[1]);
  Point scale(*width / v[2], *height / v[3]);
  if (std::string_view(node.attribute("preserveAspectRatio").value()) != "none")
    scale.setConstant(scale.minCoeff());
  const Point slack = Point(*width, *height) - scale.cwiseProduct(Point(v[2], v[3]));
  return translation(slack.x() / 2, slack.y() / 2) * scaling(scale.x(), scale.y()) *
         translation(-v[0], -v[1]);
}

Affine own_transform(const pugi::xml_node& node) {
  // A transform in style="…" wins over the attribute and has a syntax of its own (units).
  if (!styled(node, "transform").empty())
    refuse(DefectKind::unsupported, label_of(node) + " has a transform in its style",
           "write it as a transform attribute", {label_of(node)});
  return parse_transform(node.attribute("transform").value());
}

}  // namespace

std::string id_of(const pugi::xml_node& element) {
  return clipped(element.attribute("id").value(), kQuoted);
}

std::string label_of(const pugi::xml_node& element) {
  const std::string id = id_of(element);
  return id.empty() ? fmt::format("<{}>", clipped(local_name(element), kQuoted)) : id;
}

void load_svg(const std::string& text, const ReadOptions& options, pugi::xml_document& document) {
  check_size(text, options);
  const pugi::xml_parse_result result =
      document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_doctype);
  if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
  if (!result)
    refuse(DefectKind::malformed,
           fmt::format("not well-formed XML at byte {}: {}", result.offset, result.description()),
           "repair the file; it may have been cut short");
  for (const pugi::xml_node& node : document.children())
    if (node.type() == pugi::node_doctype &&
        std::string_view(node.value()).find("<!ENTITY") != std::string_view::npos)
      refuse(DefectKind::unsupported, "the file declares XML entities, which are not expanded",
             "save it as plain SVG without a DOCTYPE");
  if (local_name(document.document_element()) != "svg")
    refuse(DefectKind::malformed, "the root element is not <svg>", "give an SVG drawing");
}

SvgWalk::SvgWalk(const pugi::xml_document& document, const ReadOptions& options, Visitor visit)
    : document_(document), options_(options), visit_(std::move(visit)) {}

void SvgWalk::run() {
  const pugi::xml_node root = document_.document_element();
  index_ids(root);
  // Results are in the root's user units: the scaling that its viewBox, width and height ask for
  // says how large the drawing is shown, not what its coordinates are.
  Drawn context;
  context.style = inherit({}, root);
  if (displayed(root)) children(root, context, 1);
}

// Without recursion: the depth of what is not drawn is not bounded.
void SvgWalk::index_ids(const pugi::xml_node& root) {
  pugi::xml_node node = root;
  while (node) {
    if (const pugi::xml_attribute id = node.attribute("id")) by_id_.emplace(id.value(), node);
    if (node.first_child()) {
      node = node.first_child();
      continue;
    }
    while (node != root && !node.next_sibling()) node = node.parent();
    if (node == root) break;
    node = node.next_sibling();
  }
}

void SvgWalk::children(const pugi::xml_node& node, const Drawn& context, int depth) {
  if (depth > options_.max_depth)
    refuse(DefectKind::limit,
           fmt::format("elements are nested deeper than {} levels", options_.max_depth),
           "ungroup the drawing, or raise the limit (--max-depth)");
  for (const pugi::xml_node& child : node.children())
    if (child.type() == pugi::node_element) element(child, context, depth);
}

// Nested `use` multiplies a few bytes: the drawing must stay within the limits written out.
void SvgWalk::charge(const pugi::xml_node& node) {
  constexpr int kStyleReadings = 8;  // each property that matters is sought in it
  if (++visits_ / 2 > options_.max_curves)
    refuse(DefectKind::limit, "the drawing has too many elements (each use counts anew)",
           "simplify the drawing or raise the limit (--max-curves)");
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    const std::size_t size = std::string_view(attribute.value()).size();
    bytes_ += std::string_view(attribute.name()) == "style" ? kStyleReadings * size : size;
  }
  if (bytes_ > options_.max_bytes)
    refuse(DefectKind::limit,
           fmt::format("the drawing, its use elements written out, is larger than {} bytes",
                       options_.max_bytes),
           "simplify the drawing or raise the limit (--max-bytes)");
}

void SvgWalk::element(const pugi::xml_node& node, Drawn context, int depth) {
  charge(node);
  const std::string_view tag = local_name(node);
  if (kSilent.count(tag)) return;
  if (kUnsupported.count(tag)) {
    ++ignored_[std::string(tag)];
    return;
  }
  if (!displayed(node)) return;
  try {
    context.style = inherit(context.style, node);
    for (const char* cut : {"clip-path", "mask"}) {
      const std::string value = property_of(node, cut);
      if (!value.empty() && value != "none") ++ignored_[std::string(cut) + " property"];
    }
    context.element = node;
    // `transform` on a nested svg applies before its viewport (SVG 2, 8.5).
    context.to_user = context.to_user * own_transform(node);
    if (tag == "use") return use(node, context, depth);
    if (tag == "svg") return viewport(node, node, context, depth);
    if (kContainers.count(tag)) return children(node, context, depth + 1);
    visit_(context);
  } catch (const SyntaxError& error) {
    refuse(DefectKind::malformed,
           fmt::format("{} of {}: {} at byte {}",
                       tag == "path" ? "path data or attribute" : "an attribute", label_of(node),
                       error.what(), error.position),
           "repair the attribute", {label_of(node)});
  }
}

void SvgWalk::use(const pugi::xml_node& node, Drawn context, int depth) {
  const std::string target = href(node).value();
  const auto found =
      target.size() > 1 && target[0] == '#' ? by_id_.find(target.substr(1)) : by_id_.end();
  if (found == by_id_.end())
    refuse(DefectKind::malformed,
           "a use element refers to '" + clipped(target, kQuoted) + "', which is not there",
           "include the element it refers to", {label_of(node)});
  const pugi::xml_node used = found->second;
  if (std::find(being_used_.begin(), being_used_.end(), used) != being_used_.end())
    refuse(DefectKind::malformed,
           "use elements refer to each other in a circle at '" + clipped(target, kQuoted) + "'",
           "break the circle", {label_of(node)});
  context.to_user =
      context.to_user * translation(length(node, "x").value_or(0), length(node, "y").value_or(0));
  if (depth + 1 > options_.max_depth)
    refuse(DefectKind::limit,
           fmt::format("use elements are nested deeper than {} levels", options_.max_depth),
           "flatten the drawing, or raise the limit (--max-depth)");
  being_used_.push_back(used);
  if (local_name(used) == "symbol") {
    context.style = inherit(context.style, used);
    viewport(used, node, context, depth + 1);
  } else {
    element(used, context, depth + 1);
  }
  being_used_.pop_back();
}

// A nested svg, or a symbol instantiated by `use` (whose width and height then count as `size`).
void SvgWalk::viewport(const pugi::xml_node& node, const pugi::xml_node& size, Drawn context,
                       int depth) {
  if (local_name(node) == "svg")
    context.to_user =
        context.to_user * translation(length(node, "x").value_or(0), length(node, "y").value_or(0));
  context.to_user = context.to_user * view_box_transform(node, size);
  children(node, context, depth + 1);
}

}  // namespace c1mesh::detail
