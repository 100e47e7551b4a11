// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/transform.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "read/scanner.h"

namespace c1mesh::detail {
namespace {

Affine matrix(const std::vector<double>& m) {
  Affine out;
  out.linear << m[0], m[2], m[1], m[3];
  out.shift = Point(m[4], m[5]);
  return out;
}

double tangent(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

std::vector<double> arguments(Scanner& in) {
  in.skip_space();
  if (in.peek() != '(') in.fail("expected '('");
  in.advance();
  in.skip_space();
  std::vector<double> out;
  while (in.peek() != ')') {
    out.push_back(in.number());
    in.skip_comma();
  }
  in.advance();
  return out;
}

Affine one_function(const std::string& name, const std::vector<double>& a, const Scanner& in) {
  const std::size_t n = a.size();
  if (name == "matrix" && n == 6) return matrix(a);
  if (name == "translate" && (n == 1 || n == 2)) return translation(a[0], n == 2 ? a[1] : 0);
  if (name == "scale" && (n == 1 || n == 2)) return scaling(a[0], n == 2 ? a[1] : a[0]);
  if (name == "rotate" && n == 1) return rotation(a[0]);
  if (name == "rotate" && n == 3)
    return translation(a[1], a[2]) * rotation(a[0]) * translation(-a[1], -a[2]);
  if (name == "skewX" && n == 1) return matrix({1, 0, tangent(a[0]), 1, 0, 0});
  if (name == "skewY" && n == 1) return matrix({1, tangent(a[0]), 0, 1, 0, 0});
  throw SyntaxError("'" + name + "' with " + std::to_string(n) + " numbers is no transform",
                    in.position());
}

}  // namespace

Affine Affine::operator*(const Affine& inner) const {
  return {linear * inner.linear, linear * inner.shift + shift};
}

double Affine::stretch() const {
  // Singular values of a 2x2 matrix: s1 + s2 and |s1 - s2| are the lengths of its conformal and
  // anticonformal parts, doubled.
  const double a = linear(0, 0), b = linear(0, 1), c = linear(1, 0), d = linear(1, 1);
  return (std::hypot(a + d, c - b) + std::hypot(a - d, c + b)) / 2;
}

Affine translation(double x, double y) {
  return {Eigen::Matrix2d::Identity(), Point(x, y)};
}

Affine scaling(double x, double y) {
  Affine out;
  out.linear << x, 0, 0, y;
  return out;
}

Affine rotation(double degrees) {
  const double turn = std::remainder(degrees, 360.0);
  double c = std::cos(turn * std::numbers::pi / 180), s = std::sin(turn * std::numbers::pi / 180);
  if (std::remainder(turn, 90.0) == 0) c = std::round(c), s = std::round(s);
  Affine out;
  out.linear << c, -s, s, c;
  return out;
}

Affine parse_transform(std::string_view text) {
  Scanner in(text);
  Affine out;
  in.skip_space();
  if (text == "none") return out;
  while (!in.at_end()) {
    const std::string name(in.word());
    if (name.empty()) in.fail("expected a transform function");
    const std::vector<double> a = arguments(in);
    out = out * one_function(name, a, in);
    in.skip_comma();
  }
  return out;
}

}  // namespace c1mesh::detail
