// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/targets/soup.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/float_traps.h"

namespace c1mesh::fuzz {
namespace {

// Bytes from first to last, then zeros.
class Source {
 public:
  explicit Source(const std::string& bytes) : bytes_(bytes) {}
  int byte() { return at_ < bytes_.size() ? static_cast<unsigned char>(bytes_[at_++]) : 0; }
  bool flag(int one_in) { return byte() % one_in == one_in - 1; }
  /// In [-1, 1), 0 for a missing byte. Small bytes are small: cubed.
  double displacement() {
    const double x = static_cast<signed char>(byte()) / 128.0;
    return x * x * x;
  }
  Point vector() {
    const double x = displacement();
    return {x, displacement()};
  }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

// A curve between two points: evenly spaced on the chord, then displaced.
BezierCurve bent(Source& source, const Point& from, const Point& to, int degree) {
  BezierCurve curve;
  const double size = (to - from).norm();
  for (int k = 0; k <= degree; ++k) {
    Point p = from + (to - from) * (static_cast<double>(k) / degree);
    if (k > 0 && k < degree) p += size * source.vector();
    curve.poles.push_back(p);
  }
  curve.poles.front() = from;
  curve.poles.back() = to;
  return curve;
}

// Corners at increasing angles around a centre: simple as long as the curves stay near their
// chords.
std::vector<Point> star(Source& source, int corners, const Point& centre, double radius) {
  std::vector<Point> out;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.3 * source.displacement()) / corners;
    const double r = radius * (1 + 0.7 * source.displacement());
    out.push_back(centre + r * Point(std::cos(angle), std::sin(angle)));
  }
  return out;
}

// Handles along the neighbours' chord make every joint smooth (Catmull-Rom).
std::vector<BezierCurve> blob(const std::vector<Point>& corners) {
  const std::size_t n = corners.size();
  std::vector<BezierCurve> out;
  for (std::size_t k = 0; k < n; ++k) {
    const Point &before = corners[(k + n - 1) % n], &from = corners[k];
    const Point &to = corners[(k + 1) % n], &after = corners[(k + 2) % n];
    out.push_back({{from, from + (to - before) / 6, to - (after - from) / 6, to}});
  }
  return out;
}

std::vector<BezierCurve> loop(Source& source, int corners, const Point& centre, double radius) {
  const std::vector<Point> points = star(source, corners, centre, radius);
  if (source.flag(3)) return blob(points);
  std::vector<BezierCurve> out;
  for (std::size_t k = 0; k < points.size(); ++k)
    out.push_back(bent(source, points[k], points[(k + 1) % points.size()], 1 + source.byte() % 4));
  if (source.flag(4)) {
    for (BezierCurve& curve : out) std::reverse(curve.poles.begin(), curve.poles.end());
    std::reverse(out.begin(), out.end());
  }
  return out;
}

void add(Drawing& drawing, const std::vector<BezierCurve>& curves, bool feature = false) {
  for (const BezierCurve& curve : curves)
    drawing.curves.push_back({std::to_string(drawing.curves.size()), curve, feature});
}

// What spoils a drawing, or nearly.
void disturb(Source& source, Drawing& drawing) {
  constexpr double kGaps[] = {1e-16, 1e-12, 1e-8, 1e-4, 1e-3, 1e-2};
  const std::size_t which = static_cast<std::size_t>(source.byte()) % drawing.curves.size();
  if (source.flag(16)) drawing.curves.push_back(drawing.curves[which]);
  if (source.flag(16)) {
    BezierCurve& curve = drawing.curves[which].curve;
    curve.poles.back() += kGaps[source.byte() % 6] * Point(1, 0.5);
  }
  if (source.flag(16)) drawing.curves.erase(drawing.curves.begin() + static_cast<long>(which));
  if (source.flag(16)) drawing.curves.front().curve.poles[1] = drawing.curves.front().curve.start();
}

void stretch(Source& source, Drawing& drawing) {
  constexpr double kScales[] = {1, 1, 1, 1, 1e-9, 1e9, 1e-55, 1e55, 1e-150, 1e150, 1e-308, 1e308};
  constexpr double kAspects[] = {1, 1, 1, 1, 1, 10, 1e3, 1e6};
  constexpr double kOffsets[] = {0, 0, 0, 0, 0, 1e3, 1e9, -1e12};
  const double scale = kScales[source.byte() % 12], aspect = kAspects[source.byte() % 8];
  const double offset = kOffsets[source.byte() % 8];
  const FloatTrapsOff overflow;  // beyond what a drawing may measure, and it must be refused
  for (InputCurve& curve : drawing.curves)
    for (Point& p : curve.curve.poles)
      p = scale * (Point(aspect * p.x(), p.y()) + Point(offset, 0));
}

}  // namespace

Drawing soup(const std::string& bytes) {
  Source source(bytes);
  Drawing drawing;
  drawing.name = "soup";
  add(drawing, loop(source, 2 + (source.byte() + 1) % 5, {0, 0}, 1));
  if (source.flag(4)) {
    const Point centre = 0.5 * source.vector();
    add(drawing, loop(source, 2 + source.byte() % 3, centre, 0.2));
  }
  if (source.flag(4)) {
    const Point from = 0.5 * source.vector() - Point(0.3, 0),
                to = 0.5 * source.vector() + Point(0.3, 0);
    add(drawing, {bent(source, from, to, 1 + source.byte() % 4)}, true);
  }
  disturb(source, drawing);
  stretch(source, drawing);
  return drawing;
}

}  // namespace c1mesh::fuzz
