// SPDX-License-Identifier: GPL-3.0-or-later
// Small pieces of SVG: a panel's coordinates, paths of Bezier curves, colours, text.
#pragma once

#include <string>
#include <vector>

#include "c1mesh/types.h"

namespace c1mesh {

/// An axis-aligned rectangle of the plane.
struct Box {
  Point low = Point::Zero(), high = Point::Zero();
};

/// The smallest box around points.
Box box_of(const std::vector<Point>& points);

/// Where a plane lands on the page: fitted into a rectangle, centred, y turned downward.
class Panel {
 public:
  /// Fits the box low..high into (left, top, width, height), all in pixels.
  Panel(const Point& low, const Point& high, double left, double top, double width, double height);
  Point place(const Point& p) const;
  double scale() const { return scale_; }  ///< pixels per unit
  Point size() const { return size_; }     ///< of the box, in pixels

 private:
  Point centre_, middle_, size_;
  double scale_;
};

/// The data of an SVG path, in pixels with three decimals.
class PathData {
 public:
  explicit PathData(const Panel& panel) : panel_(panel) {}
  void move(const Point& p);
  void line(const Point& p);
  /// Continues from the current point along a Bezier curve of any degree: exactly up to degree 3,
  /// above that as four cubics with the curve's points and derivatives at their ends. Where it is
  /// smaller than a pixel, as a line.
  void curve(const std::vector<Point>& poles);
  void close() { text_ += "Z"; }
  bool empty() const { return text_.empty(); }
  const std::string& text() const { return text_; }

 private:
  void cubic(const Point& b, const Point& c, const Point& d);
  bool is_tiny(const std::vector<Point>& poles) const;

  const Panel& panel_;
  std::string text_;
};

/// `<path class="…" d="…"/>`, with a `style` if there is one; nothing for an empty path.
std::string path_element(const std::string& css_class, const PathData& data,
                         const std::string& style = "");

}  // namespace c1mesh
