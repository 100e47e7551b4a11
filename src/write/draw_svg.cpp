// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a picture: blocks of panels, one block for each result, and a legend.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/xml.h"
#include "c1mesh/write.h"
#include "write/result_painter.h"

namespace c1mesh {
namespace {

constexpr double kMargin = 28, kHeader = 58, kLegend = 56;  // pixels
constexpr double kTallest = 1.5;                            // a panel's height over its width
constexpr double kNarrow = 340;                             // a block in which text is kept short

constexpr const char* kStyle = R"(<style>
text{font-family:Helvetica,Arial,sans-serif;fill:#2a2f38}
path,line{fill:none;stroke-linecap:round;stroke-linejoin:round}
)";

const char* name_of(Part part) {
  switch (part) {
    case Part::outline:
      return "outline";
    case Part::mesh:
      return "mesh";
    case Part::shape:
      return "shape";
    default:
      return "domain";
  }
}

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
        block_width_((options.width - kMargin) / static_cast<double>(columns_)) {
    const std::size_t panels = options.parts.size() * (options.zoom ? 2 : 1);
    panel_width_ = std::max(
        50.0, (block_width_ - static_cast<double>(panels) * kMargin) / static_cast<double>(panels));
    painters_.reserve(results.size());
    for (const Drawn& r : results) painters_.emplace_back(*r.result, r.over, options);
  }

  std::string draw() {
    const bool coloured = options_.colour != Colour::none;
    if (coloured) choose_scale();
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
    return header(top + (coloured ? kLegend : 0)) + blocks + (coloured ? legend(top) : "") +
           "</svg>\n";
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
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\">\n<title>{2}</title>\n",
        options_.width, height, title_of(0));
    out += kStyle;
    out += kPainterStyle;
    // What only some pictures need.
    const auto& parts = options_.parts;
    if (options_.grid_lines == 0 || std::count(parts.begin(), parts.end(), Part::mesh))
      out += ".bare .mesh{stroke:#7c8797}\n";
    if (options_.zoom) out += ".window{fill:none;stroke:#2a2f38;stroke-width:.8}\n";
    if (std::any_of(results_.begin(), results_.end(), [](const Drawn& r) { return r.over; }))
      out += ".over{stroke:#d0342c;stroke-width:1.4}\n";
    out += "</style>\n";
    out += fmt::format("<rect width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#fff\"/>\n", options_.width,
                       height);
    return out;
  }

  std::string title_of(std::size_t k) const {
    const Drawn& r = results_[k];
    if (!r.title.empty()) return xml_escaped(r.title);
    return xml_escaped(r.result->name.empty() ? "c1mesh result" : r.result->name);
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
    std::string out =
        fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"17\" font-weight=\"bold\">{}</text>\n",
                    left + kMargin, top + 28, title_of(k));
    out += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"12\">{}</text>\n", left + kMargin,
                       top + 46, summary_of(result, painters_[k].claims_nothing()));
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
      scale_ = {1e-17, 1e-3, "C1 deviation, relative to the extent"};
      return;
    }
    double most = 3;
    for (const ResultPainter& painter : painters_)
      most = std::max(most, painter.largest_distortion());
    scale_ = {2, most, "distortion (MIPS: 2 is a similarity)"};
  }

  std::string legend(double top) const {
    constexpr int kSteps = ColourScale::kSteps;
    const double width = std::min(420.0, options_.width - 2 * kMargin), bar = width / kSteps;
    std::string out = "<g id=\"legend\">\n";
    for (int k = 0; k < kSteps; ++k)
      out += fmt::format(
          "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"10\" fill=\"{}\"/>\n",
          kMargin + k * bar, top, bar + 0.3, scale_colour((k + 0.5) / kSteps));
    for (const double share : {0.0, 0.5, 1.0}) {
      const double value = scale_.low * std::pow(scale_.high / scale_.low, share);
      const char* anchor = share == 0 ? "start" : share == 1 ? "end" : "middle";
      out += fmt::format(
          "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"11\" text-anchor=\"{}\">{:.3g}"
          "</text>\n",
          kMargin + share * width, top + 24, anchor, value);
    }
    out += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"11\">{}</text>\n",
                       kMargin + width + 16, top + 9, scale_.label);
    return out + "</g>\n";
  }

  const std::vector<Drawn>& results_;
  const DrawOptions& options_;
  std::size_t columns_;
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
