// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/path_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace c1mesh {
namespace {

// Far more than a picture of common size has in one path.
constexpr int kMostSteps = 50000;

class PathReader {
 public:
  PathReader(Brush& brush, std::string_view data, const Look& look)
      : brush_(brush), rest_(data), look_(look) {}

  void paint() {
    while (skip_separators()) step(command());
    brush_.paint(look_);
  }

 private:
  bool skip_separators() {
    const std::size_t first = rest_.find_first_not_of(" ,\t\r\n");
    rest_.remove_prefix(std::min(first, rest_.size()));
    return !rest_.empty();
  }
  // A number instead of a command repeats the last one, a moveto as lines.
  char command() {
    const char c = rest_.front();
    if ((c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z')) {
      rest_.remove_prefix(1);
      return last_ = c;
    }
    if (last_ == 'M') last_ = 'L';
    if (last_ == 0 || last_ == 'Z') fail();
    return last_;
  }
  double number() {
    skip_separators();
    double value = 0;
    const auto read = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (read.ec != std::errc()) fail();
    rest_.remove_prefix(static_cast<std::size_t>(read.ptr - rest_.data()));
    return value;
  }
  void step(char c) {
    cairo_t* cairo = brush_.cairo();
    double x = 0, y = 0;
    cairo_get_current_point(cairo, &x, &y);
    if (c == 'M') {
      if (steps_ > kMostSteps) {
        brush_.paint_part(look_);
        steps_ = 0;
      }
      x = number();
      cairo_move_to(cairo, x, number());
    } else if (c == 'L') {
      x = number();
      cairo_line_to(cairo, x, number());
    } else if (c == 'C') {
      double p[6];
      for (double& value : p) value = number();
      cairo_curve_to(cairo, p[0], p[1], p[2], p[3], p[4], p[5]);
    } else if (c == 'm' || c == 'l') {
      x = number();
      (c == 'm' ? cairo_rel_move_to : cairo_rel_line_to)(cairo, x, number());
    } else if (c == 'H' || c == 'h') {
      cairo_line_to(cairo, number() + (c == 'h' ? x : 0), y);
    } else if (c == 'V' || c == 'v') {
      cairo_line_to(cairo, x, number() + (c == 'v' ? y : 0));
    } else if (c == 'Z') {
      cairo_close_path(cairo);
    } else {
      fail();
    }
    ++steps_;
  }
  [[noreturn]] void fail() const {
    throw std::invalid_argument(
        fmt::format("a picture's path cannot have '{}'", rest_.substr(0, 20)));
  }

  Brush& brush_;
  std::string_view rest_;
  const Look& look_;
  char last_ = 0;
  int steps_ = 0;
};

}  // namespace

void paint_path(Brush& brush, std::string_view data, const Look& look) {
  PathReader(brush, data, look).paint();
}

}  // namespace c1mesh
