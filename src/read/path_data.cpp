// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/path_data.h"

#include <cctype>

#include "read/scanner.h"

namespace c1mesh::detail {
namespace {

class PathParser {
 public:
  explicit PathParser(std::string_view text) : in_(text) {}

  Outline parse() {
    in_.skip_space();
    while (!in_.at_end()) {
      command();
      in_.skip_space();
    }
    return pen_.finish();
  }

 private:
  void command() {
    const char letter = in_.peek();
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    if (!std::isalpha(static_cast<unsigned char>(letter)) ||
        std::string_view("MLHVCSQTAZ").find(kind) == std::string_view::npos)
      in_.fail("expected a path command");
    if (first_ && kind != 'M') in_.fail("path data must begin with a move (M)");
    first_ = false;
    relative_ = letter != kind;
    in_.advance();
    in_.skip_space();
    if (kind == 'Z') {
      pen_.close();
      previous_ = 'Z';
      return;
    }
    char repeated = kind;
    do {
      segment(repeated);
      previous_ = repeated;
      // Further coordinates after a move are lines (SVG 2, 9.3.3).
      if (repeated == 'M') repeated = 'L';
    } while (another());
  }

  // Is there another set of coordinates for the same command? A comma promises one.
  bool another() {
    in_.skip_space();
    if (in_.peek() == ',') {
      in_.advance();
      in_.skip_space();
      if (!in_.at_number()) in_.fail("expected a number");
    }
    return in_.at_number();
  }

  void segment(char kind) {
    switch (kind) {
      case 'M':
        return pen_.move_to(point());
      case 'L':
        return pen_.line_to(point());
      case 'H':
        return pen_.line_to({coordinate(pen_.at().x()), pen_.at().y()});
      case 'V':
        return pen_.line_to({pen_.at().x(), coordinate(pen_.at().y())});
      case 'C':
        return cubic(point_then_comma());
      case 'S':
        return cubic(reflected('C', 'S'));
      case 'Q':
        return quadratic(point_then_comma());
      case 'T':
        return quadratic(reflected('Q', 'T'));
      default:
        return arc();
    }
  }

  void cubic(const Point& first) {
    handle_ = point_then_comma();
    pen_.curve_to({first, handle_, point()});
  }

  void quadratic(const Point& handle) {
    handle_ = handle;
    pen_.curve_to({handle, point()});
  }

  void arc() {
    const double rx = number_then_comma(), ry = number_then_comma(), turn = number_then_comma();
    const bool large = in_.flag();
    in_.skip_comma();
    const bool sweep = in_.flag();
    in_.skip_comma();
    pen_.arc_to({rx, ry}, turn, large, sweep, point());
  }

  // The previous handle mirrored at the current point, if the previous command was of this family.
  Point reflected(char full, char smooth) const {
    if (previous_ != full && previous_ != smooth) return pen_.at();
    return 2 * pen_.at() - handle_;
  }

  double coordinate(double origin) { return in_.number() + (relative_ ? origin : 0); }

  double number_then_comma() {
    const double value = in_.number();
    in_.skip_comma();
    return value;
  }

  Point point() {
    const Point origin = relative_ ? pen_.at() : Point(0, 0);
    const double x = in_.number();
    in_.skip_comma();
    return {origin.x() + x, origin.y() + in_.number()};
  }

  Point point_then_comma() {
    Point p = point();
    in_.skip_comma();
    return p;
  }

  Scanner in_;
  Pen pen_;
  Point handle_ = Point::Zero();  // the last curve's second handle (S) or only handle (T)
  char previous_ = 'M';
  bool relative_ = false, first_ = true;
};

}  // namespace

Outline parse_path(std::string_view text) {
  // "none" is how CSS and SVG 2 spell the empty path.
  if (text == "none") return {};
  return PathParser(text).parse();
}

std::vector<Point> parse_points(std::string_view text) {
  Scanner in(text);
  std::vector<Point> out;
  in.skip_space();
  while (!in.at_end()) {
    const double x = in.number();
    in.skip_comma();
    out.emplace_back(x, in.number());
    in.skip_comma();
  }
  return out;
}

}  // namespace c1mesh::detail
