// SPDX-License-Identifier: GPL-3.0-or-later
// SVG attribute texts: path data, point lists, transforms; and UTF-8.
#include "read/path_data.h"

#include "fuzz/target.h"
#include "read/scanner.h"
#include "read/transform.h"
#include "read/utf8.h"

namespace {

using namespace c1mesh;

template <class Parse>
void parse(const Parse& parser, const std::string& bytes) {
  try {
    parser(bytes);
  } catch (const detail::SyntaxError& error) {
    fuzz::require(error.position <= bytes.size(), "a syntax error beyond the end of the text");
  }
}

void check_outline(const detail::Outline& outline) {
  fuzz::require(outline.subpaths.size() == outline.closing_line.size(),
                "not a mark for every subpath");
  for (const auto& subpath : outline.subpaths) {
    fuzz::require(!subpath.empty(), "an empty subpath");
    for (const BezierCurve& curve : subpath)
      fuzz::require(curve.degree() >= 1 && curve.degree() <= 3, "a curve of another degree");
  }
}

}  // namespace

C1MESH_FUZZ_TARGET(path_data) {
  parse([](const std::string& text) { check_outline(detail::parse_path(text)); }, bytes);
  parse([](const std::string& text) { detail::parse_points(text); }, bytes);
  parse([](const std::string& text) { detail::parse_transform(text); }, bytes);
  parse([](const std::string& text) { detail::decode_utf8(text); }, bytes);
}
