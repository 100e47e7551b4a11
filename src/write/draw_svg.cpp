// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a result: the shape on the left, its domain on the right.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/xml.h"
#include "c1mesh/write.h"
#include "write/grid_lines.h"
#include "write/mesh_edges.h"
#include "write/svg_canvas.h"

namespace c1mesh {
namespace {

constexpr double kMargin = 28, kHeader = 58, kLegend = 56;  // pixels
constexpr double kTallest = 1.5;                            // a panel's height over its width
constexpr int kColours = 48;                                // steps of the colour scale
constexpr int kCuts = 6;                                    // pieces per triangle side when filled

constexpr const char* kStyle = R"(<style>
text{font-family:Helvetica,Arial,sans-serif;fill:#2a2f38}
path,line{fill:none;stroke-linecap:round;stroke-linejoin:round}
.mesh{stroke:#bfc6d0;stroke-width:.7}
.u{stroke:#2c6fb7;stroke-width:.9}
.v{stroke:#c9742b;stroke-width:.9}
.coloured .u,.coloured .v{stroke:#20262e;stroke-width:.6;stroke-opacity:.38}
.coloured .mesh{stroke:#20262e;stroke-width:.5;stroke-opacity:.22}
.net{stroke:#b48ac0;stroke-width:.5}
.boundary{stroke:#171b22;stroke-width:2}
.feature{stroke:#171b22;stroke-width:1.3}
.relaxed{stroke:#199a4c;stroke-width:1.1;stroke-dasharray:4 2.5}
.inside{fill:#f8f9fb;fill-rule:evenodd;stroke:none}
.exceptional{fill:#199a4c;stroke:#fff;stroke-width:1.2}
</style>
)";

/// Values mapped to the colour scale by logarithm.
struct Scale {
  double low = 1, high = 10;
  std::string label;
  int step(double value) const {
    if (!(value > low)) return 0;
    const double share = std::log(value / low) / std::log(high / low);
    return std::clamp(static_cast<int>(share * kColours), 0, kColours - 1);
  }
};

class Picture {
 public:
  Picture(const Result& result, const DrawOptions& options)
      : result_(result),
        options_(options),
        map_(result),
        edges_(edges_of(map_)),
        lines_(iso_lines(result, options.grid_lines)) {}

  std::string draw() {
    const Box shape = box_of(result_.control_points), domain = box_of(result_.domain_vertices);
    const double width = std::max(50.0, (options_.width - 3 * kMargin) / 2);
    const auto height_of = [&](const Box& box) {
      const Point size = box.high - box.low;
      return width * std::min(kTallest, size.y() / std::max(size.x(), 1e-300));
    };
    const double height = std::max({height_of(shape), height_of(domain), 0.2 * width});
    const bool coloured = options_.colour != Colour::none;
    const double total = kHeader + height + kMargin + (coloured ? kLegend : 0);
    const Panel left(shape.low, shape.high, kMargin, kHeader, width, height);
    const Panel right(domain.low, domain.high, 2 * kMargin + width, kHeader, width, height);

    std::string out = header(total);
    if (coloured) choose_scale();
    out += panel(left, false);
    out += panel(right, true);
    if (coloured) out += legend(kHeader + height + kMargin);
    return out + "</svg>\n";
  }

 private:
  struct Box {
    Point low = Point::Zero(), high = Point::Zero();
  };

  static Box box_of(const std::vector<Point>& points) {
    Box box;
    if (points.empty()) return box;
    box.low = box.high = points[0];
    for (const Point& p : points) {
      box.low = box.low.cwiseMin(p);
      box.high = box.high.cwiseMax(p);
    }
    return box;
  }

  std::string header(double height) const {
    const std::string name = xml_escaped(result_.name.empty() ? "c1mesh result" : result_.name);
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\">\n<title>{2}</title>\n",
        options_.width, height, name);
    out += kStyle;
    out += fmt::format("<rect width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#fff\"/>\n", options_.width,
                       height);
    out += fmt::format("<text x=\"{}\" y=\"28\" font-size=\"17\" font-weight=\"bold\">{}</text>\n",
                       kMargin, name);
    const std::size_t exceptional = result_.exceptional_vertices.size();
    out += fmt::format(
        "<text x=\"{}\" y=\"46\" font-size=\"12\">{} triangles of degree {}, {} "
        "exceptional {}</text>\n",
        kMargin, result_.triangles.size(), result_.degree, exceptional,
        exceptional == 1 ? "vertex" : "vertices");
    return out;
  }

  std::string panel(const Panel& panel, bool domain) const {
    const bool coloured = options_.colour != Colour::none;
    std::string out = fmt::format("<g id=\"{}\"{}>\n", domain ? "domain" : "shape",
                                  coloured ? " class=\"coloured\"" : "");
    out += coloured ? fill(panel, domain) : inside(panel, domain);
    if (options_.show_mesh) out += edge_path(panel, domain, EdgeKind::smooth, "mesh");
    if (options_.show_control_net && !domain) out += control_net(panel);
    for (const int axis : {0, 1}) out += iso_path(panel, domain, axis);
    if (options_.show_mesh) out += edge_path(panel, domain, EdgeKind::relaxed, "relaxed");
    out += edge_path(panel, domain, EdgeKind::feature, "feature");
    out += edge_path(panel, domain, EdgeKind::boundary, "boundary");
    out += dots(panel, domain);
    return out + "</g>\n";
  }

  std::vector<Point> poles_of(const DrawnEdge& e, bool domain) const {
    if (domain) return {result_.domain_vertices[e.a], result_.domain_vertices[e.b]};
    return map_.edge(e.triangle[0], e.corner[0]);
  }

  /// A pale ground inside the boundary.
  std::string inside(const Panel& panel, bool domain) const {
    std::map<int, const DrawnEdge*> next;
    for (const DrawnEdge& e : edges_)
      if (e.kind == EdgeKind::boundary) next[e.a] = &e;
    PathData path(panel);
    while (!next.empty()) {
      const int start = next.begin()->first;
      path.move(poles_of(*next[start], domain).front());
      for (auto found = next.find(start); found != next.end();) {
        const DrawnEdge* e = found->second;
        path.curve(poles_of(*e, domain));
        next.erase(found);
        found = next.find(e->b);
      }
      path.close();
    }
    return path_element("inside", path);
  }

  std::string edge_path(const Panel& panel, bool domain, EdgeKind kind, const char* css) const {
    PathData path(panel);
    for (const DrawnEdge& e : edges_) {
      if (e.kind != kind) continue;
      const std::vector<Point> poles = poles_of(e, domain);
      path.move(poles.front());
      path.curve(poles);
    }
    return path_element(css, path);
  }

  std::string iso_path(const Panel& panel, bool domain, int axis) const {
    PathData path(panel);
    for (const IsoLine& line : lines_) {
      if (line.axis != axis) continue;
      if (domain) {
        path.move(map_.domain_point(line.pieces.front().triangle, line.pieces.front().from));
        path.line(map_.domain_point(line.pieces.back().triangle, line.pieces.back().to));
        continue;
      }
      path.move(map_.evaluate(line.pieces.front().triangle, line.pieces.front().from));
      for (const LinePiece& piece : line.pieces)
        path.curve(map_.segment(piece.triangle, piece.from, piece.to));
    }
    return path_element(axis == 0 ? "u" : "v", path);
  }

  std::string control_net(const Panel& panel) const {
    PathData path(panel);
    for (int t = 0; t < static_cast<int>(result_.triangles.size()); ++t)
      for (int j = 0; j < result_.degree; ++j)
        for (int i = 0; i < result_.degree - j; ++i) {
          const auto at = [&](int a, int b) -> const Point& {
            return result_.control_points[map_.control_id(t, 0, a, b)];
          };
          path.move(at(i, j));
          path.line(at(i + 1, j));
          path.line(at(i, j + 1));
          path.close();
        }
    return path_element("net", path);
  }

  std::string dots(const Panel& panel, bool domain) const {
    std::string out;
    for (const int v : result_.exceptional_vertices) {
      const Point p = panel.place(domain ? result_.domain_vertices[v] : vertex_image(v));
      out += fmt::format("<circle class=\"exceptional\" cx=\"{:.3f}\" cy=\"{:.3f}\" r=\"4.5\"/>\n",
                         p.x(), p.y());
    }
    return out;
  }

  Point vertex_image(int v) const {
    for (std::size_t t = 0; t < result_.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k)
        if (result_.triangles[t][k] == v)
          return result_.control_points[map_.control_id(static_cast<int>(t), k, 0, 0)];
    return Point::Zero();
  }

  /// Calls visit(triangle, three barycentric corners) for the small triangles that are filled.
  template <class Visit>
  void pieces(int t, const Visit& visit) const {
    const auto at = [](int i, int j) {
      return Barycentric(double(kCuts - i - j) / kCuts, double(i) / kCuts, double(j) / kCuts);
    };
    for (int j = 0; j < kCuts; ++j)
      for (int i = 0; i < kCuts - j; ++i) {
        visit(t, at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j < kCuts - 1) visit(t, at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }

  std::vector<double> triangle_deviations() const {
    std::vector<double> out(result_.triangles.size(), 0);
    for (const DrawnEdge& e : edges_)
      for (const int t : e.triangle)
        if (t >= 0) out[t] = std::max(out[t], e.c1_deviation);
    return out;
  }

  void choose_scale() {
    if (options_.colour == Colour::c1_deviation) {
      scale_ = {1e-17, 1e-3, "C1 deviation, relative to the extent"};
      return;
    }
    double most = 2;
    for (int t = 0; t < static_cast<int>(result_.triangles.size()); ++t)
      pieces(t,
             [&](int triangle, const Barycentric& a, const Barycentric& b, const Barycentric& c) {
               const double value = map_.distortion(triangle, (a + b + c) / 3);
               if (std::isfinite(value)) most = std::max(most, value);
             });
    scale_ = {2, std::max(3.0, most), "distortion (MIPS: 2 is a similarity)"};
  }

  /// All small triangles of one colour make one path; a hairline of the same colour hides seams.
  std::string fill(const Panel& panel, bool domain) const {
    std::vector<PathData> paths(kColours, PathData(panel));
    const std::vector<double> deviation = triangle_deviations();
    for (int t = 0; t < static_cast<int>(result_.triangles.size()); ++t)
      pieces(t,
             [&](int triangle, const Barycentric& a, const Barycentric& b, const Barycentric& c) {
               const double value = options_.colour == Colour::c1_deviation
                                        ? deviation[triangle]
                                        : map_.distortion(triangle, (a + b + c) / 3);
               PathData& path = paths[std::isfinite(value) ? scale_.step(value) : kColours - 1];
               const auto at = [&](const Barycentric& p) {
                 return domain ? map_.domain_point(triangle, p) : map_.evaluate(triangle, p);
               };
               path.move(at(a));
               path.line(at(b));
               path.line(at(c));
               path.close();
             });
    std::string out;
    for (int k = 0; k < kColours; ++k) {
      if (paths[k].empty()) continue;
      const std::string colour = scale_colour((k + 0.5) / kColours);
      out += "<path style=\"fill:" + colour + ";stroke:" + colour + ";stroke-width:.4\" d=\"" +
             paths[k].text() + "\"/>\n";
    }
    return out;
  }

  std::string legend(double top) const {
    const double width = std::min(420.0, options_.width - 2 * kMargin), bar = width / kColours;
    std::string out = "<g id=\"legend\">\n";
    for (int k = 0; k < kColours; ++k)
      out += fmt::format(
          "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"10\" fill=\"{}\"/>\n",
          kMargin + k * bar, top, bar + 0.3, scale_colour((k + 0.5) / kColours));
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

  const Result& result_;
  const DrawOptions& options_;
  PiecewiseMap map_;
  std::vector<DrawnEdge> edges_;
  std::vector<IsoLine> lines_;
  Scale scale_;
};

}  // namespace

std::string draw_svg(const Result& result, const DrawOptions& options) {
  return Picture(result, options).draw();
}

}  // namespace c1mesh
