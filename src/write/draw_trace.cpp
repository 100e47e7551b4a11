// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a trace, after the paper's figure 15: E_s, g and E_reg over the iterations.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/xml.h"
#include "c1mesh/trace.h"
#include "write/page_unit.h"

namespace c1mesh {
namespace {

constexpr double kLeft = 74, kRight = 20, kTop = 60, kBottom = 44;  // pixels around the panels
constexpr double kGap = 26;                                         // between them
constexpr double kSmall = 12;                                       // size of most letters
constexpr double kLetter = 0.58 * kSmall;                           // width of one, about

constexpr const char* kStyle = R"(<style>
text{font-family:Helvetica,Arial,sans-serif;fill:#2a2f38;font-size:12px}
path{fill:none;stroke-linejoin:round}
.grid{stroke:#2a2f38;stroke-opacity:.13;stroke-width:1}
.axes{stroke:#2a2f38;stroke-width:1.2}
.pass{stroke:#2a2f38;stroke-opacity:.55;stroke-width:1;stroke-dasharray:2 3}
.e_s{stroke:#1f5fa8;stroke-width:1.8}
.g{stroke:#b0392b;stroke-width:1.8}
.e_reg{stroke:#4a5262;stroke-width:1.4}
.infinite{stroke-width:4;stroke-opacity:.55;stroke-linecap:butt}
.halo{paint-order:stroke;stroke:#fff;stroke-width:3;stroke-opacity:.8}
</style>
)";

// Backgrounds, by the order in which the stages appear; so light that curves stand out.
constexpr std::array<const char*, 8> kTints = {"#e4eefa", "#fdf0d5", "#e3f3e4", "#f6e3ee",
                                               "#ece7f8", "#e1f2f3", "#f7e6dc", "#eceef1"};

// Iterations first … last - 1 of one stage in one pass.
struct Band {
  std::size_t first, last;
  std::size_t colour;
};

// One quantity and where its panel lies on the page.
struct Quantity {
  const char* css;
  const char* label;
  double TraceRecord::*value;
  double share;  // of the panels' height
  double top = 0, height = 0;
  int low = 0, high = 1;  // decades
};

class Plot {
 public:
  Plot(const std::string& title, const std::vector<TraceRecord>& records, double width)
      : title_(title),
        records_(records),
        unit_(page_unit(width)),
        width_(std::max(width / unit_, 300.0)),
        height_(std::round(300 + 0.42 * width_)) {
    find_bands();
    double top = kTop;
    const double space = height_ - kTop - kBottom - legend_height() - 2 * kGap;
    for (Quantity& q : quantities_) {
      q.top = top;
      q.height = q.share * space;
      top += q.height + kGap;
      choose_decades(q);
    }
  }

  std::string draw() const {
    std::string out = header();
    for (const Quantity& q : quantities_) {
      out += bands(q) + grid(q) + passes(q) + curve(q);
      out += fmt::format("<path class=\"axes\" d=\"M{:.1f},{:.1f}V{:.1f}H{:.1f}\"/>\n", kLeft,
                         q.top, q.top + q.height, width_ - kRight);
      out += text(kLeft + 4, q.top - 7, "start", q.label, "font-weight=\"bold\" ");
    }
    return out + band_names() + pass_names() + numbers() + legend() + "</svg>\n";
  }

 private:
  void find_bands() {
    for (std::size_t i = 0; i < records_.size(); ++i) {
      const TraceRecord& r = records_[i];
      const auto known = std::find(stages_.begin(), stages_.end(), r.stage);
      const std::size_t colour = known - stages_.begin();
      if (known == stages_.end()) stages_.push_back(r.stage);
      if (i == 0 || records_[i - 1].pass != r.pass || records_[i - 1].stage != r.stage)
        bands_.push_back({i, i, colour});
      bands_.back().last = i + 1;
    }
  }

  void choose_decades(Quantity& q) const {
    double low = 1e300, high = 0;
    for (const TraceRecord& r : records_) {
      const double value = r.*q.value;
      if (!std::isfinite(value) || value <= 0) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    if (high == 0) return;
    q.low = static_cast<int>(std::floor(std::log10(low)));
    q.high = std::max(q.low + 1, static_cast<int>(std::ceil(std::log10(high))));
  }

  double x(double iteration) const {
    return kLeft + (width_ - kLeft - kRight) * iteration /
                       static_cast<double>(std::max<std::size_t>(records_.size(), 1));
  }

  // Zero lies on the lower edge.
  double y(const Quantity& q, double value) const {
    const double decade = value > 0 ? std::log10(value) : q.low;
    const double share = (std::max<double>(decade, q.low) - q.low) / (q.high - q.low);
    return q.top + q.height * (1 - share);
  }

  static std::string text(double x, double y, const char* anchor, const std::string& words,
                          const char* more = "") {
    return fmt::format("<text {}x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", more, x,
                       y, anchor, xml_escaped(words));
  }

  static double length(const std::string& words) {
    return kLetter * static_cast<double>(words.size());
  }

  std::string header() const {
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" "
        "viewBox=\"0 0 {:.0f} {:.0f}\">\n<title>{}</title>\n",
        unit_ * width_, unit_ * height_, width_, height_, xml_escaped(title_));
    out += kStyle;
    out +=
        fmt::format("<rect width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#fff\"/>\n", width_, height_);
    out += fmt::format(
        "<text x=\"{}\" y=\"24\" style=\"font-size:17px\" font-weight=\"bold\">{}</text>\n", kLeft,
        xml_escaped(title_));
    return out;
  }

  std::string bands(const Quantity& q) const {
    std::string out;
    for (const Band& band : bands_)
      out += fmt::format(
          "<rect class=\"band\" x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\" "
          "fill=\"{}\"><title>{}, pass {}: {} iterations</title></rect>\n",
          x(band.first), q.top, x(band.last) - x(band.first), q.height,
          kTints[band.colour % kTints.size()], xml_escaped(stages_[band.colour]),
          records_[band.first].pass, band.last - band.first);
    return out;
  }

  std::string grid(const Quantity& q) const {
    std::string out;
    // Marks keep 18 pixels apart.
    const double apart = q.height / (q.high - q.low);
    const int step = std::max(1, static_cast<int>(std::ceil(18 / apart)));
    for (int decade = q.high; decade >= q.low; decade -= step) {
      const double at = q.top + q.height * (q.high - decade) / (q.high - q.low);
      out += fmt::format("<path class=\"grid\" d=\"M{:.1f},{:.1f}H{:.1f}\"/>\n", kLeft, at,
                         width_ - kRight);
      out += text(kLeft - 7, at + 4, "end",
                  decade >= 0 && decade <= 4 ? fmt::format("{:.0f}", std::pow(10.0, decade))
                                             : fmt::format("1e{}", decade));
    }
    return out;
  }

  bool begins_pass(const Band& band) const {
    return band.first == 0 || records_[band.first - 1].pass != records_[band.first].pass;
  }

  std::string passes(const Quantity& q) const {
    std::string out;
    for (const Band& band : bands_)
      if (band.first > 0 && begins_pass(band))
        out += fmt::format("<path class=\"pass\" d=\"M{:.1f},{:.1f}V{:.1f}\"/>\n", x(band.first),
                           q.top - 4, q.top + q.height);
    return out;
  }

  // A value belongs to the middle of its iteration. Where it is infinite the curve is broken, and a
  // bar lies on the upper edge.
  std::string curve(const Quantity& q) const {
    std::string data, infinite;
    bool drawing = false;
    for (std::size_t i = 0; i < records_.size(); ++i) {
      const double value = records_[i].*q.value;
      if (std::isfinite(value)) {
        const bool lonely =
            !drawing && (i + 1 == records_.size() || !std::isfinite(records_[i + 1].*q.value));
        const double at = static_cast<double>(i);
        data += fmt::format("{}{:.1f},{:.1f}", drawing ? 'L' : 'M', x(at + (lonely ? 0.2 : 0.5)),
                            y(q, value));
        if (lonely) data += fmt::format("H{:.1f}", x(at + 0.8));
      } else {
        infinite += fmt::format("M{:.2f},{:.1f}H{:.2f}", x(static_cast<double>(i)), q.top + 2,
                                x(static_cast<double>(i + 1)));
      }
      drawing = std::isfinite(value);
    }
    std::string out;
    if (!infinite.empty())
      out += fmt::format("<path class=\"{} infinite\" d=\"{}\"/>\n", q.css, infinite);
    if (!data.empty()) out += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", q.css, data);
    return out;
  }

  // In the highest panel, along the band where they fit, else up it.
  std::string band_names() const {
    const Quantity& q = quantities_.front();
    std::string out;
    for (const Band& band : bands_) {
      const std::string& name = stages_[band.colour];
      const double space = x(band.last) - x(band.first),
                   middle = (x(band.first) + x(band.last)) / 2;
      if (space > length(name) + 6)
        out += text(middle, q.top + 16, "middle", name, "class=\"halo\" ");
      else if (space > kSmall + 2 && q.height > length(name) + 12)
        out += fmt::format(
            "<text class=\"halo\" transform=\"translate({:.1f} {:.1f}) rotate(-90)\" "
            "text-anchor=\"end\">{}</text>\n",
            middle + 0.35 * kSmall, q.top + 6, xml_escaped(name));
    }
    return out;
  }

  // Over the panels; left out where they would run into one another.
  std::string pass_names() const {
    std::string out;
    double free = kLeft + length("deviation from C1, E_s") + 20;
    for (const Band& band : bands_) {
      const std::string name = fmt::format("pass {}", records_[band.first].pass);
      if (!begins_pass(band) || records_.back().pass == records_.front().pass) continue;
      if (x(band.first) < free || x(band.first) + length(name) > width_) continue;
      out += text(x(band.first), quantities_[0].top - 7, "start", name);
      free = x(band.first) + length(name) + 8;
    }
    return out;
  }

  // Iterations under the lowest panel, at 1, 2 or 5 times a power of ten.
  std::string numbers() const {
    const Quantity& q = quantities_.back();
    const double bottom = q.top + q.height;
    const double apart = (x(1) - x(0));
    double step = 1;
    for (int k = 0; step * apart < 46; ++k) step *= k % 3 == 1 ? 2.5 : 2;
    std::string out;
    for (double n = step; n <= static_cast<double>(records_.size()); n += step)
      out += fmt::format("<path class=\"axes\" d=\"M{0:.1f},{1:.1f}v4\"/>\n", x(n - 0.5), bottom) +
             text(x(n - 0.5), bottom + 17, "middle", fmt::format("{:.0f}", n));
    out += text((kLeft + width_ - kRight) / 2, bottom + 34, "middle", "iteration");
    return out;
  }

  struct Entry {
    double x, y;
  };
  // Places of the legend's entries, row by row, the first at (0, 0).
  std::vector<Entry> legend_entries() const {
    std::vector<Entry> out;
    double at = 0, row = 0;
    for (const std::string& stage : stages_) {
      const double space = 20 + length(stage) + 14;
      if (at > 0 && kLeft + at + space > width_) {
        at = 0;
        row += 18;
      }
      out.push_back({at, row});
      at += space;
    }
    return out;
  }

  double legend_height() const { return stages_.empty() ? 0 : 20 + legend_entries().back().y; }

  std::string legend() const {
    std::string out;
    const std::vector<Entry> entries = legend_entries();
    const double top = height_ - legend_height();
    for (std::size_t k = 0; k < entries.size(); ++k) {
      const double left = kLeft + entries[k].x, above = top + entries[k].y;
      out += fmt::format(
          "<rect class=\"key\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"14\" height=\"12\" fill=\"{}\" "
          "stroke=\"#8b95a3\" stroke-width=\".6\"/>\n",
          left, above, kTints[k % kTints.size()]);
      out += text(left + 19, above + 10, "start", stages_[k]);
    }
    return out;
  }

  const std::string& title_;
  const std::vector<TraceRecord>& records_;
  double unit_, width_, height_;
  std::vector<std::string> stages_;  // in the order of their first iterations
  std::vector<Band> bands_;
  std::array<Quantity, 3> quantities_{
      {{"e_s", "deviation from C1, E_s", &TraceRecord::e_s, 0.44},
       {"g", "largest distortion bound, g", &TraceRecord::g, 0.36},
       {"e_reg", "regularity energy, E_reg", &TraceRecord::e_reg, 0.2}}};
};

}  // namespace

std::string draw_trace(const std::string& title, const std::vector<TraceRecord>& records,
                       double width) {
  return Plot(title, records, width).draw();
}

}  // namespace c1mesh
