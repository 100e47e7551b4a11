// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/xml.h"
#include "raster/font.h"
#include "write/key.h"
#include "write/page_unit.h"
#include "write/result_painter.h"

namespace c1mesh {
namespace {

constexpr double kMargin = 12, kHeader = 50;     // pixels around the page, above the cells
constexpr double kGap = 12, kPad = 5;            // between cells, inside a cell
constexpr double kPictureShare = 0.8;            // a picture's height over its width
constexpr double kWords = 46;                    // height of what is below a picture
constexpr double kName = 10.5, kFigures = 9.5;   // sizes of letters
constexpr double kSmaller = 0.55;                // lines and dots, compared with a whole picture's
constexpr double kCell = 170, kLeastUnit = 0.8;  // a cell's usual width, and how far letters shrink

constexpr const char* kStyle = R"(<style>
text{font-family:Helvetica,Arial,sans-serif;fill:#2a2f38}
path,line{fill:none;stroke-linecap:round;stroke-linejoin:round}
.cell{fill:none;stroke:#d5dae2;stroke-width:.8}
.unreadable{fill:#fdf1ef;stroke:#b3261e;stroke-width:1;stroke-dasharray:5 3}
.certified{stroke:#12703a;stroke-width:2}
.not-certified{stroke:#b3261e;stroke-width:2}
.problem{fill:#8c1d18}
.pale{fill:#59626f}
.frame{fill:none;stroke:#2a2f38;stroke-width:.6}
.tick{stroke:#2a2f38;stroke-width:.8}
)";

std::size_t columns_for(std::size_t count, double width) {
  const auto square = static_cast<std::size_t>(std::ceil(std::sqrt(1.3 * double(count))));
  const auto room = static_cast<std::size_t>(width / (0.9 * kLeastUnit * kCell));
  return std::max<std::size_t>(1, std::min({square, room, count}));
}

std::string plural(std::size_t count, const char* one, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

// The words of a text in lines of at most `width` ems, `most` of them.
std::vector<std::string> lines_of(const std::string& text, double width, std::size_t most) {
  std::vector<std::string> lines{""};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    at = end + 1;
    std::string& line = lines.back();
    const std::string longer = line.empty() ? word : line + " " + word;
    if (line.empty() || text_width(longer, false) <= width) {
      line = longer;
    } else if (lines.size() < most) {
      lines.push_back(word);
    } else {
      line += " …";
      break;
    }
  }
  for (std::string& line : lines) line = text_within(line, width, false);
  return lines;
}

}  // namespace

class ContactSheet::Page {
 public:
  Page(std::size_t count, const DrawOptions& options) : options_(options) {
    count = std::max<std::size_t>(count, 1);
    columns_ = options.columns > 0 ? static_cast<std::size_t>(options.columns)
                                   : columns_for(count, options.width);
    columns_ = std::min(columns_, count);
    const double cell = options.width / static_cast<double>(columns_);
    unit_ =
        std::clamp(cell / kCell, kLeastUnit, std::max(kLeastUnit, 1.6 * page_unit(options.width)));
    width_ = options.width / unit_;
    cell_width_ = (width_ - 2 * kMargin - static_cast<double>(columns_ - 1) * kGap) /
                  static_cast<double>(columns_);
    cell_width_ = std::max(cell_width_, 20.0);
    picture_height_ = kPictureShare * (cell_width_ - 2 * kPad);
    cell_height_ = picture_height_ + kWords + 2 * kPad;
    if (options.colour == Colour::distortion) {
      scale_ = {2, 1000, true, "distortion (MIPS: 2 is a similarity), logarithmic"};
    } else if (options.colour == Colour::c1_deviation) {
      scale_ = {1e-17, 1e-3, true, "C1 deviation, relative to the extent, logarithmic"};
    }
    options_.zoom.reset();
  }

  void add(const Result& result, const std::string& name, const Metrics& metrics, SheetMark mark) {
    open(name);
    pictures(result);
    double left = kPad;
    const double y = kPad + picture_height_ + 14;
    if (mark != SheetMark::none) {
      ++(mark == SheetMark::certified ? certified_ : refuted_);
      cells_ +=
          mark == SheetMark::certified
              ? fmt::format("<path class=\"certified\" d=\"M{0:.1f},{1:.1f}l2.8,3.2l4.8,-7.2\"/>\n",
                            left, y - 3.6)
              : fmt::format(
                    "<path class=\"not-certified\" "
                    "d=\"M{0:.1f},{1:.1f}l6.5,6.5m0,-6.5l-6.5,6.5\"/>\n",
                    left + 0.5, y - 7.2);
      left += 13;
    }
    line(left, y, kName, true, "", name);
    line(kPad, y + 13, kFigures, false, "pale",
         fmt::format("{} exceptional, g {:.4g}", result.exceptional_vertices.size(),
                     metrics.mips_bound_max));
    line(kPad, y + 25, kFigures, false, "pale",
         plural(result.triangles.size(), "triangle", "triangles"));
    cells_ += "</g>\n";
  }

  void add_unreadable(const std::string& name, const std::string& reason) {
    ++unreadable_;
    open(name);
    cells_ += fmt::format(
        "<rect class=\"unreadable\" x=\"{0}\" y=\"{0}\" width=\"{1:.2f}\" height=\"{2:.2f}\"/>\n",
        kPad, cell_width_ - 2 * kPad, picture_height_);
    double y = kPad + 18;
    line(kPad + 6, y, kName, true, "problem", "cannot be read");
    const double room = cell_width_ - 2 * kPad - 12;
    const auto rows = static_cast<std::size_t>(std::max(1.0, (picture_height_ - 26) / 12));
    for (const std::string& words : lines_of(reason, room / kFigures, rows))
      line(kPad + 6, y += 12, kFigures, false, "problem", words);
    line(kPad, kPad + picture_height_ + 14, kName, true, "", name);
    cells_ += "</g>\n";
  }

  std::string svg() const {
    const std::size_t rows = std::max<std::size_t>(1, (added_ + columns_ - 1) / columns_);
    double bottom = kHeader + static_cast<double>(rows) * (cell_height_ + kGap);
    std::string foot;
    if (options_.colour == Colour::distortion || options_.colour == Colour::c1_deviation) {
      foot += legend(scale_, kMargin + 8, bottom + 4,
                     std::max(40.0, std::min(420.0, width_ - 2 * kMargin - 16)));
      bottom += kLegendHeight - 8;
    }
    if (options_.show_key) {
      const Key key = key_of(contents_, kMargin, bottom, width_ - 2 * kMargin);
      foot += key.svg;
      bottom += key.height;
    }
    return header(bottom + 8) + cells_ + foot + "</svg>\n";
  }

 private:
  void open(const std::string& name) {
    const double left = kMargin + static_cast<double>(added_ % columns_) * (cell_width_ + kGap);
    const double top = kHeader + static_cast<double>(added_ / columns_) * (cell_height_ + kGap);
    ++added_;
    cells_ += fmt::format(
        "<g id=\"cell-{}\" transform=\"translate({:.2f} {:.2f})\">\n<title>{}</title>\n", added_,
        left, top, xml_escaped(name));
    cells_ += fmt::format("<rect class=\"cell\" width=\"{:.2f}\" height=\"{:.2f}\"/>\n",
                          cell_width_, cell_height_);
  }

  // Drawn larger than the cell and shrunk, so that lines and dots are finer than in a whole
  // picture.
  void pictures(const Result& result) {
    const ResultPainter painter(result, nullptr, options_);
    const double count = static_cast<double>(std::max<std::size_t>(options_.parts.size(), 1));
    const double width = (cell_width_ - 2 * kPad - (count - 1) * kPad) / count;
    double left = kPad;
    for (const Part part : options_.parts) {
      const Box box = painter.box(part);
      const Panel panel(box.low, box.high, 0, 0, width / kSmaller, picture_height_ / kSmaller);
      cells_ +=
          fmt::format("<g transform=\"translate({:.2f} {}) scale({})\">\n", left, kPad, kSmaller);
      cells_ +=
          painter.paint(panel, part, box, fmt::format("{}-{}", name_of(part), added_), scale_);
      cells_ += "</g>\n";
      left += width + kPad;
    }
    contents_.exceptional |= !painter.claims_nothing() && !result.exceptional_vertices.empty();
    contents_.features |= !result.feature_edges.empty();
  }

  void line(double x, double y, double size, bool bold, const char* css, const std::string& words) {
    cells_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{}\"{}{}>{}</text>\n", x, y,
                          size, bold ? " font-weight=\"bold\"" : "",
                          *css ? fmt::format(" class=\"{}\"", css) : std::string(),
                          xml_escaped(text_within(words, (cell_width_ - kPad - x) / size, bold)));
  }

  std::string header(double height) const {
    const double pixels = std::ceil(height * unit_);
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" "
        "viewBox=\"0 0 {:.6g} {:.6g}\">\n<title>Contact sheet</title>\n",
        options_.width, pixels, width_, pixels / unit_);
    out += kStyle;
    out += kPainterStyle;
    out += "</style>\n";
    if (!options_.transparent) out += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    std::string said;
    const auto say = [&](std::size_t count, const char* what) {
      if (count > 0) said += fmt::format("{}{} {}", said.empty() ? "" : ", ", count, what);
    };
    say(certified_, "certified");
    say(refuted_, "not certified");
    say(unreadable_, "cannot be read");
    const auto heading = [&](double y, double size, const char* more, const std::string& words) {
      out += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{}>{}</text>\n", kMargin, y, size,
                         more, text_within(words, (width_ - 2 * kMargin) / size, *more != 0));
    };
    heading(24, 16, " font-weight=\"bold\"", plural(added_, "result", "results"));
    heading(41, 11, "", said);
    return out;
  }

  DrawOptions options_;
  std::size_t columns_ = 1;
  double unit_ = 1, width_ = 0, cell_width_ = 0, cell_height_ = 0, picture_height_ = 0;
  ColourScale scale_;
  KeyContents contents_;
  std::size_t added_ = 0, certified_ = 0, refuted_ = 0, unreadable_ = 0;
  std::string cells_;
};

ContactSheet::ContactSheet(std::size_t count, const DrawOptions& options)
    : page_(std::make_unique<Page>(count, options)) {}
ContactSheet::~ContactSheet() = default;
ContactSheet::ContactSheet(ContactSheet&&) noexcept = default;
ContactSheet& ContactSheet::operator=(ContactSheet&&) noexcept = default;

void ContactSheet::add(const Result& result, const std::string& name, const Metrics& metrics,
                       SheetMark mark) {
  page_->add(result, name, metrics, mark);
}
void ContactSheet::add_unreadable(const std::string& name, const std::string& reason) {
  page_->add_unreadable(name, reason);
}
std::string ContactSheet::svg() const {
  return page_->svg();
}

}  // namespace c1mesh
