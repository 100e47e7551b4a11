// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a trade-off: log g over the number of exceptional vertices.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/xml.h"
#include "c1mesh/trade_off.h"
#include "write/svg_canvas.h"

namespace c1mesh {
namespace {

constexpr double kLeft = 68, kRight = 24, kTop = 64, kBottom = 54;  // pixels around the plot

constexpr const char* kStyle = R"(<style>
text{font-family:Helvetica,Arial,sans-serif;fill:#2a2f38}
path{fill:none;stroke-linejoin:round}
.grid{stroke:#e6e9ee;stroke-width:1}
.axes{stroke:#2a2f38;stroke-width:1.2}
.bound{stroke:#c9742b;stroke-width:1.3;stroke-dasharray:6 4}
.envelope{stroke:#2c6fb7;stroke-width:2}
.point{fill:#2c6fb7;stroke:#fff;stroke-width:1.2}
.dominated{fill:#fff;stroke:#8b95a3;stroke-width:1.5}
.small{font-size:12px;paint-order:stroke;stroke:#fff;stroke-width:3}
</style>
)";

class Plot {
 public:
  Plot(const TradeOff& curve, double width)
      : curve_(curve), width_(std::max(width, 300.0)), height_(0.66 * width_) {
    choose_range();
  }

  std::string draw() const {
    std::string out = header();
    out += grid();
    out += bound();
    out += envelope();
    out += axes();
    out += points();
    return out + "</svg>\n";
  }

 private:
  // The greatest mark up to g, and from there so many marks up: few digits times powers of ten. The
  // axis runs from one mark to another.
  double mark(double g, int steps) const {
    const int count = static_cast<int>(digits_.size());
    const auto value = [&](int i) {
      const int decade = static_cast<int>(std::floor(static_cast<double>(i) / count));
      return digits_[i - count * decade] * std::pow(10.0, decade);
    };
    int index = count * static_cast<int>(std::floor(std::log10(g)));
    while (value(index + 1) <= g) ++index;
    return value(index + steps);
  }

  bool finite_points() const {
    return std::any_of(curve_.points.begin(), curve_.points.end(),
                       [](const TradeOffPoint& p) { return std::isfinite(p.g); });
  }

  void choose_range() {
    first_ = last_ = curve_.minimum;
    if (!finite_points()) return;
    double low = 1e300, high = 0;
    for (const TradeOffPoint& p : curve_.points) {
      if (!std::isfinite(p.g)) continue;
      low = std::min(low, p.g);
      high = std::max(high, p.g);
      first_ = std::min(first_, p.exceptional);
      last_ = std::max(last_, p.exceptional);
    }
    // The bound belongs in the picture where it is near; far away it would flatten the curve.
    if (shows_bound(low, high)) {
      low = std::min(low, curve_.bound);
      high = std::max(high, curve_.bound);
    }
    constexpr double kFew = 20, kMany = 1e4;  // g's range over which other marks are right
    digits_ = high < kFew * low    ? std::vector<double>{1, 1.5, 2, 3, 5, 7}
              : high < kMany * low ? std::vector<double>{1, 2, 5}
                                   : std::vector<double>{1};
    constexpr double kRoom = 1.06;  // for the numbers at the points
    low_ = mark(low / kRoom, 0);
    high_ = mark(high * kRoom, 1);
  }

  bool shows_bound(double low, double high) const {
    constexpr double kNear = 10;
    return curve_.bound > low / kNear && curve_.bound < high * kNear;
  }

  double x(double exceptional) const {
    const double span = std::max(last_ - first_, 1) + 0.8;
    return kLeft + (width_ - kLeft - kRight) * (exceptional - first_ + 0.4) / span;
  }
  double y(double g) const {
    const double share = std::log(g / low_) / std::log(high_ / low_);
    return height_ - kBottom - (height_ - kTop - kBottom) * share;
  }

  std::string header() const {
    const std::string name = xml_escaped(curve_.name.empty() ? "c1mesh trade-off" : curve_.name);
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\">\n<title>{2}</title>\n",
        width_, height_, name);
    out += kStyle;
    out +=
        fmt::format("<rect width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#fff\"/>\n", width_, height_);
    out += fmt::format("<text x=\"{}\" y=\"26\" font-size=\"17\" font-weight=\"bold\">{}</text>\n",
                       kLeft, name);
    out += text(kLeft, 45, "start", "largest distortion bound g over exceptional vertices");
    return out;
  }

  static std::string text(double x, double y, const char* anchor, const std::string& words) {
    return fmt::format(
        "<text class=\"small\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y,
        anchor, xml_escaped(words));
  }

  static std::string segment(const char* css, double x0, double y0, double x1, double y1) {
    return fmt::format("<path class=\"{}\" d=\"M{:.1f},{:.1f}L{:.1f},{:.1f}\"/>\n", css, x0, y0, x1,
                       y1);
  }

  std::string grid() const {
    std::string out;
    for (double g = low_; g <= high_ * 1.001; g = mark(g * 1.001, 1)) {
      out += segment("grid", kLeft, y(g), width_ - kRight, y(g));
      out += text(kLeft - 8, y(g) + 4, "end", fmt::format("{:.4g}", g));
    }
    // Numbers on the lower axis keep 24 pixels apart.
    const double apart = x(first_ + 1) - x(first_);
    const int step = std::max(1, static_cast<int>(std::ceil(24 / apart)));
    for (int n = first_; n <= last_; n += step) {
      out += segment("grid", x(n), kTop, x(n), height_ - kBottom);
      out += text(x(n), height_ - kBottom + 18, "middle", std::to_string(n));
    }
    return out;
  }

  std::string axes() const {
    const double bottom = height_ - kBottom, right = width_ - kRight;
    std::string out = fmt::format("<path class=\"axes\" d=\"M{:.1f},{:.1f}V{:.1f}H{:.1f}\"/>\n",
                                  kLeft, kTop, bottom, right);
    out += text((kLeft + right) / 2, height_ - 14, "middle",
                fmt::format("exceptional vertices (minimum {})", curve_.minimum));
    const double middle = (kTop + bottom) / 2;
    out += fmt::format(
        "<text class=\"small\" x=\"18\" y=\"{0:.1f}\" text-anchor=\"middle\" "
        "transform=\"rotate(-90 18 {0:.1f})\">g, logarithmic</text>\n",
        middle);
    return out;
  }

  std::string bound() const {
    if (!finite_points() || !(curve_.bound >= low_ && curve_.bound <= high_)) return "";
    const double at = y(curve_.bound);
    return segment("bound", kLeft, at, width_ - kRight, at) +
           text(width_ - kRight - 4, at - 6, "end", fmt::format("asked: {:.4g}", curve_.bound));
  }

  // The lowest g that so many vertices, or fewer, allow.
  std::string envelope() const {
    std::vector<Point> best;
    for (const TradeOffPoint& p : curve_.points)
      if (!p.dominated && std::isfinite(p.g)) best.emplace_back(x(p.exceptional), y(p.g));
    if (best.empty()) return "";
    std::sort(best.begin(), best.end(),
              [](const Point& a, const Point& b) { return a.x() < b.x(); });
    std::string data = fmt::format("M{:.1f},{:.1f}", best[0].x(), best[0].y());
    for (std::size_t i = 1; i < best.size(); ++i)
      data += fmt::format("H{:.1f}V{:.1f}", best[i].x(), best[i].y());
    data += fmt::format("H{:.1f}", x(last_ + 0.4));
    return "<path class=\"envelope\" d=\"" + data + "\"/>\n";
  }

  std::string points() const {
    std::string out;
    for (const TradeOffPoint& p : curve_.points) {
      if (!std::isfinite(p.g)) continue;
      out += fmt::format(
          "<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\"><title>{} exceptional, g "
          "{:.4g}</title></circle>\n",
          p.dominated ? "dominated" : "point", x(p.exceptional), y(p.g), p.exceptional, p.g);
      if (!p.dominated)
        out += text(x(p.exceptional) + 4, y(p.g) - 9, "start", fmt::format("{:.3g}", p.g));
    }
    return out;
  }

  const TradeOff& curve_;
  double width_, height_;
  int first_ = 0, last_ = 0;
  double low_ = 1, high_ = 10;
  std::vector<double> digits_ = {1, 2, 5};
};

}  // namespace

std::string draw_trade_off(const TradeOff& curve, double width) {
  return Plot(curve, width).draw();
}

}  // namespace c1mesh
