// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a picture: blocks of panels, one block for each result, and a legend.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/xml.h"
#include "c1mesh/write.h"
#include "raster/font.h"
#include "write/key.h"
#include "write/page_unit.h"
#include "write/result_painter.h"

namespace c1mesh {
namespace {

constexpr double kMargin = 28, kHeader = 58;  // pixels
constexpr double kTallest = 1.5;              // a panel's height over its width
constexpr double kNarrow = 340;               // a block in which text is kept short

constexpr const char* kStyle = R"(<style>
text{font-family:Helvetica,Arial,sans-serif;fill:#2a2f38}
path,line{fill:none;stroke-linecap:round;stroke-linejoin:round}
)";

/// One panel on the page: its frame in pixels.
struct Frame {
  double left, top, width, height;
};

class Page {
 public:
  Page(const std::vector<Drawn>& results, const DrawOptions& options)
      : results_(results),
        options_(options),
        columns_(std::clamp<std::size_t>(options.columns, 1, results.size())),
        unit_(page_unit(options.width)),
        width_(options.width / unit_),
        block_width_((width_ - kMargin) / static_cast<double>(columns_)) {
    const std::size_t panels = options.parts.size() * (options.zoom ? 2 : 1);
    panel_width_ = std::max(
        50.0, (block_width_ - static_cast<double>(panels) * kMargin) / static_cast<double>(panels));
    painters_.reserve(results.size());
    for (const Drawn& r : results) painters_.emplace_back(*r.result, r.over, options);
  }

  std::string draw() {
    const bool scaled =
        options_.colour == Colour::distortion || options_.colour == Colour::c1_deviation;
    if (scaled) choose_scale();
    std::string blocks;
    double top = 0;
    for (std::size_t first = 0; first < results_.size(); first += columns_) {
      const std::size_t last = std::min(first + columns_, results_.size());
      double height = 0.2 * panel_width_;
      for (std::size_t k = first; k < last; ++k) height = std::max(height, height_of(painters_[k]));
      for (std::size_t k = first; k < last; ++k)
        blocks += block(k, static_cast<double>(k - first) * block_width_, top, height);
      top += kHeader + height + (last < results_.size() ? 0.5 * kMargin : kMargin);
    }
    if (scaled) {
      blocks += legend(scale_, kMargin, top, std::min(420.0, width_ - 2 * kMargin));
      top += kLegendHeight;
    }
    const Key key = options_.show_key
                        ? key_of(contents(), kMargin, top - (scaled ? 6 : 14), width_ - 2 * kMargin)
                        : Key{};
    if (key.height > 0) top += key.height;
    return header(top) + blocks + key.svg + "</svg>\n";
  }

 private:
  double height_of(const ResultPainter& painter) const {
    double height = 0;
    for (const Part part : options_.parts) {
      const Box box = painter.box(part);
      const Point size = box.high - box.low;
      const double share = options_.zoom ? std::max(1.0, size.y() / std::max(size.x(), 1e-300))
                                         : size.y() / std::max(size.x(), 1e-300);
      height = std::max(height, panel_width_ * std::min(kTallest, share));
    }
    return height;
  }

  std::string header(double height) const {
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" "
        "viewBox=\"0 0 {:.6g} {:.6g}\">\n<title>{}</title>\n",
        options_.width, std::ceil(height * unit_), width_, std::ceil(height * unit_) / unit_,
        xml_escaped(title_of(0)));
    out += kStyle;
    out += kPainterStyle;
    // What only some pictures need.
    const auto& parts = options_.parts;
    if (options_.grid_lines == 0 || std::count(parts.begin(), parts.end(), Part::mesh))
      out += ".bare .mesh{stroke:#7c8797}\n";
    if (options_.zoom) out += ".window{fill:none;stroke:#2a2f38;stroke-width:.8}\n";
    if (std::any_of(results_.begin(), results_.end(), [](const Drawn& r) { return r.over; }))
      out += ".over{stroke:#d0342c;stroke-width:1.4}\n";
    if (options_.colour != Colour::none)
      out +=
          ".frame{fill:none;stroke:#2a2f38;stroke-width:.6}\n"
          ".tick{stroke:#2a2f38;stroke-width:.8}\n";
    out += "</style>\n";
    if (!options_.transparent) out += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    return out;
  }

  // What of all that a key can explain is in the picture.
  KeyContents contents() const {
    const auto& parts = options_.parts;
    const auto has = [&](Part part) { return std::count(parts.begin(), parts.end(), part) > 0; };
    const bool inner = has(Part::mesh) || has(Part::shape) || has(Part::domain);
    KeyContents out;
    out.lines = options_.grid_lines > 0 && options_.colour != Colour::checkerboard &&
                options_.colour == Colour::none && (has(Part::shape) || has(Part::domain));
    out.net = options_.show_control_net && (has(Part::mesh) || has(Part::shape));
    for (std::size_t k = 0; k < results_.size(); ++k) {
      const Result& result = *results_[k].result;
      const bool marked = inner && !painters_[k].claims_nothing();
      out.exceptional |= marked && !result.exceptional_vertices.empty();
      out.relaxed |=
          marked && options_.show_mesh && result.relaxed_edges.size() > result.feature_edges.size();
      out.features |= !result.feature_edges.empty();
      out.over |= results_[k].over && has(Part::domain);
    }
    return out;
  }

  std::string title_of(std::size_t k) const {
    const Drawn& r = results_[k];
    if (!r.title.empty()) return r.title;
    return r.result->name.empty() ? "c1mesh result" : r.result->name;
  }

  // A line of text over a block, cut where the block ends.
  std::string line_over(double left, double y, double size, bool bold,
                        const std::string& words) const {
    return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{}>{}</text>\n", left + kMargin, y,
                       size, bold ? " font-weight=\"bold\"" : "",
                       xml_escaped(text_within(words, (block_width_ - kMargin) / size, bold)));
  }

  // In a narrow block without what can be spared.
  std::string summary_of(const Result& result, bool claims_nothing) const {
    const std::size_t exceptional = result.exceptional_vertices.size();
    const bool narrow = block_width_ < kNarrow;
    return fmt::format("{} triangles{}, {}", result.triangles.size(),
                       narrow ? "" : fmt::format(" of degree {}", result.degree),
                       claims_nothing ? "C1 claimed nowhere"
                                      : fmt::format("{} exceptional{}", exceptional,
                                                    narrow             ? ""
                                                    : exceptional == 1 ? " vertex"
                                                                       : " vertices"));
  }

  std::string block(std::size_t k, double left, double top, double height) const {
    const Result& result = *results_[k].result;
    std::string out = line_over(left, top + 28, 17, true, title_of(k));
    out += line_over(left, top + 46, 12, false, summary_of(result, painters_[k].claims_nothing()));
    Frame frame{left + kMargin, top + kHeader, panel_width_, height};
    for (const Part part : options_.parts) {
      const std::string id = name_of(part) + (k == 0 ? std::string() : fmt::format("-{}", k + 1));
      const Box box = painters_[k].box(part);
      const Panel panel(box.low, box.high, frame.left, frame.top, frame.width, frame.height);
      out += painters_[k].paint(panel, part, box, id, scale_);
      frame.left += panel_width_ + kMargin;
      if (!options_.zoom) continue;
      out += blow_up(painters_[k], part, panel, frame, id + "-zoom");
      frame.left += panel_width_ + kMargin;
    }
    return out;
  }

  // The window's frame in the panel, then the window itself, as large as its own frame allows.
  std::string blow_up(const ResultPainter& painter, Part part, const Panel& whole,
                      const Frame& frame, const std::string& id) const {
    const Box window = painter.window(part);
    const Panel panel(window.low, window.high, frame.left, frame.top, frame.width, frame.height);
    const auto rectangle = [&](const Panel& on, const char* css) {
      const Point a = on.place(window.low), b = on.place(window.high);
      return fmt::format("<rect{} x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"/>\n",
                         css, a.x(), b.y(), b.x() - a.x(), a.y() - b.y());
    };
    std::string out = rectangle(whole, " class=\"window\"");
    out += "<clipPath id=\"clip-" + id + "\">" + rectangle(panel, "") + "</clipPath>\n";
    out += "<g clip-path=\"url(#clip-" + id + ")\">\n" +
           painter.paint(panel, part, window, id, scale_) + "</g>\n";
    out += rectangle(panel, " class=\"window\"");
    const Point corner = panel.place({window.low.x(), window.high.y()});
    out += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"12\">{:.3g} times</text>\n",
                       corner.x(), corner.y() - 5, panel.scale() / whole.scale());
    return out;
  }

  void choose_scale() {
    if (options_.colour == Colour::c1_deviation) {
      double least = std::numeric_limits<double>::infinity(), most = 0;
      for (const ResultPainter& painter : painters_) {
        const auto [low, high] = painter.range_of_deviations();
        if (high > 0) least = std::min(least, low);
        most = std::max(most, high);
      }
      scale_ = deviation_scale(std::min(least, most), most);
      return;
    }
    double most = 2;
    for (const ResultPainter& painter : painters_)
      most = std::max(most, painter.largest_distortion());
    scale_ = distortion_scale(most);
  }

  const std::vector<Drawn>& results_;
  const DrawOptions& options_;
  std::size_t columns_;
  double unit_, width_;  // the page is laid out this wide, then enlarged by the unit
  double block_width_, panel_width_ = 0;
  std::vector<ResultPainter> painters_;
  ColourScale scale_;
};

}  // namespace

std::string draw_svg(const Result& result, const DrawOptions& options) {
  return draw_svg(std::vector<Drawn>{{&result, "", nullptr}}, options);
}

std::string draw_svg(const std::vector<Drawn>& results, const DrawOptions& options) {
  if (results.empty()) throw std::invalid_argument("no result is given to be drawn");
  return Page(results, options).draw();
}

}  // namespace c1mesh
