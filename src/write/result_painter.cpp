// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/result_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string_view>

#include "write/checkerboard.h"

namespace c1mesh {
namespace {

/// Calls visit with the barycentric corners of the cuts^2 small triangles of a triangle.
template <class Visit>
void pieces(int cuts, const Visit& visit) {
  const auto at = [cuts](int i, int j) {
    return Barycentric(double(cuts - i - j) / cuts, double(i) / cuts, double(j) / cuts);
  };
  for (int j = 0; j < cuts; ++j)
    for (int i = 0; i < cuts - j; ++i) {
      visit(at(i, j), at(i + 1, j), at(i, j + 1));
      if (i + j < cuts - 1) visit(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
}

bool meets(const std::vector<Point>& poles, const Box& seen) {
  const Box box = box_of(poles);
  return (box.low.array() <= seen.high.array()).all() &&
         (box.high.array() >= seen.low.array()).all();
}

}  // namespace

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

const char* const kPainterStyle = R"(.mesh{stroke:#bfc6d0;stroke-width:.7}
.u{stroke:#2c6fb7;stroke-width:.9}
.v{stroke:#c9742b;stroke-width:.9}
.coloured .u,.coloured .v{stroke:#20262e;stroke-width:.6;stroke-opacity:.38}
.coloured .mesh{stroke:#20262e;stroke-width:.5;stroke-opacity:.3}
.squares{fill:#8aa5c6}
.net{stroke:#8e5aa3;stroke-width:.6}
.points{stroke:#8e5aa3;stroke-width:2.6}
.boundary{stroke:#171b22;stroke-width:2}
.feature{stroke:#171b22;stroke-width:1.3}
.relaxed{stroke:#199a4c;stroke-width:1.1;stroke-dasharray:4 2.5}
.inside{fill:#f8f9fb;fill-rule:evenodd;stroke:none}
.exceptional{fill:#199a4c;stroke:#fff;stroke-width:1.2}
)";

ResultPainter::ResultPainter(const Result& result, const Result* over, const DrawOptions& options)
    : result_(result),
      over_(over),
      options_(options),
      map_(result),
      edges_(edges_of(map_)),
      lines_(iso_lines(result, options.grid_lines)),
      claims_nothing_(result.exceptional_vertices.size() == result.domain_vertices.size() &&
                      result.exceptional_vertices.size() > result.boundary_vertices.size()) {
  if (options.colour == Colour::checkerboard && options.grid_lines < 1)
    throw std::invalid_argument("a checkerboard has as many squares as the grid; it needs lines");
  corner_of_.assign(result.domain_vertices.size(), {-1, 0});
  for (int t = 0; t < static_cast<int>(result.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k)
      if (corner_of_[result.triangles[t][k]].first < 0) corner_of_[result.triangles[t][k]] = {t, k};
}

Box ResultPainter::box(Part part) const {
  if (part != Part::domain) return box_of(result_.control_points);
  std::vector<Point> points = result_.domain_vertices;
  if (over_)
    points.insert(points.end(), over_->domain_vertices.begin(), over_->domain_vertices.end());
  return box_of(points);
}

Box ResultPainter::window(Part part) const {
  const Box whole = box(part);
  const Point size = whole.high - whole.low;
  const double half = 0.5 * options_.zoom->size * size.maxCoeff();
  Point centre = place_of(zoomed_vertex(), part == Part::domain);
  for (int axis = 0; axis < 2; ++axis) {
    const double low = whole.low[axis] + half, high = whole.high[axis] - half;
    centre[axis] = low < high ? std::clamp(centre[axis], low, high) : 0.5 * (low + high);
  }
  return {centre - Point(half, half), centre + Point(half, half)};
}

// The vertex asked for, or where the two domains are farthest apart.
int ResultPainter::zoomed_vertex() const {
  const int count = static_cast<int>(result_.domain_vertices.size());
  const int vertex = options_.zoom->vertex;
  if (vertex >= count)
    throw std::invalid_argument(
        fmt::format("vertex {} is asked for, the last one is {}", vertex, count - 1));
  if (vertex >= 0) return vertex;
  if (!over_) throw std::invalid_argument("only domains drawn over one another can be apart");
  if (over_->domain_vertices.size() != result_.domain_vertices.size())
    throw std::invalid_argument("the domains are not of one mesh");
  int farthest = 0;
  double most = -1;
  for (int v = 0; v < count; ++v) {
    const double apart = (result_.domain_vertices[v] - over_->domain_vertices[v]).norm();
    if (apart > most) {
      most = apart;
      farthest = v;
    }
  }
  return farthest;
}

std::string ResultPainter::paint(const Panel& panel, Part part, const Box& seen,
                                 const std::string& id, const ColourScale& scale) const {
  const bool domain = part == Part::domain;
  const bool coloured = options_.colour != Colour::none && part != Part::outline;
  const bool bare = !coloured && (part == Part::mesh || options_.grid_lines == 0);
  const char* css = coloured ? " class=\"coloured\"" : bare ? " class=\"bare\"" : "";
  std::string out = fmt::format("<g id=\"{}\"{}>\n", id, css);
  const bool checkered = coloured && options_.colour == Colour::checkerboard;
  out += coloured && !checkered ? fill(panel, domain, seen, scale) : inside(panel, domain);
  if (checkered) out += squares(panel, domain);
  if (part != Part::outline) {
    if (options_.show_mesh) {
      out += edge_path(panel, domain, seen, EdgeKind::smooth, "mesh");
      if (claims_nothing_) out += edge_path(panel, domain, seen, EdgeKind::relaxed, "mesh");
    }
    if (options_.show_control_net && !domain) out += control_net(panel);
    if (part != Part::mesh && !checkered)
      for (const int axis : {0, 1}) out += iso_path(panel, domain, seen, axis);
    if (options_.show_mesh && !claims_nothing_)
      out += edge_path(panel, domain, seen, EdgeKind::relaxed, "relaxed");
  }
  out += edge_path(panel, domain, seen, EdgeKind::feature, "feature");
  out += edge_path(panel, domain, seen, EdgeKind::boundary, "boundary");
  if (over_ && domain) out += over_path(panel);
  if (part != Part::outline && !claims_nothing_) out += dots(panel, domain);
  return out + "</g>\n";
}

// Fewer points of each triangle where there are very many triangles.
double ResultPainter::largest_distortion() const {
  constexpr double kMostPoints = 200000;
  const auto count = static_cast<double>(result_.triangles.size());
  const int cuts = std::clamp(static_cast<int>(std::sqrt(kMostPoints / (count + 1))), 1, 6);
  double most = 2;
  for (int t = 0; t < static_cast<int>(result_.triangles.size()); ++t)
    pieces(cuts, [&](const Barycentric& a, const Barycentric& b, const Barycentric& c) {
      const double value = map_.distortion(t, (a + b + c) / 3);
      if (std::isfinite(value)) most = std::max(most, value);
    });
  return most;
}

std::pair<double, double> ResultPainter::range_of_deviations() const {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const double value : triangle_deviations()) {
    if (value > 0) least = std::min(least, value);
    most = std::max(most, value);
  }
  return {std::min(least, most), most};
}

std::vector<Point> ResultPainter::poles_of(const DrawnEdge& e, bool domain) const {
  if (domain) return {result_.domain_vertices[e.a], result_.domain_vertices[e.b]};
  return map_.edge(e.triangle[0], e.corner[0]);
}

/// A pale ground inside the boundary.
std::string ResultPainter::inside(const Panel& panel, bool domain) const {
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

std::string ResultPainter::edge_path(const Panel& panel, bool domain, const Box& seen,
                                     EdgeKind kind, const char* css) const {
  PathData path(panel);
  for (const DrawnEdge& e : edges_) {
    if (e.kind != kind) continue;
    const std::vector<Point> poles = poles_of(e, domain);
    if (!meets(poles, seen)) continue;
    path.move(poles.front());
    path.curve(poles);
  }
  return path_element(css, path, thin(panel, css));
}

// Where edges are closer than this, thinner lines keep the mesh from becoming one dark area.
std::string ResultPainter::thin(const Panel& panel, const char* css) const {
  constexpr double kApart = 7, kThinnest = 0.05;
  if (std::string_view(css) != "mesh" || result_.triangles.empty()) return "";
  const Point size = panel.size();
  const double apart =
      std::sqrt(size.x() * size.y() / static_cast<double>(result_.triangles.size()));
  if (apart >= kApart) return "";
  return fmt::format("stroke-width:{:.2f}", std::max(kThinnest, 0.7 * apart / kApart));
}

// In the domain a line is straight from its first to its last piece. On the shape, a piece outside
// the window interrupts the path.
std::string ResultPainter::iso_path(const Panel& panel, bool domain, const Box& seen,
                                    int axis) const {
  PathData path(panel);
  for (const IsoLine& line : lines_) {
    if (line.axis != axis) continue;
    if (domain) {
      const Point from = map_.domain_point(line.pieces.front().triangle, line.pieces.front().from);
      const Point to = map_.domain_point(line.pieces.back().triangle, line.pieces.back().to);
      if (!meets({from, to}, seen)) continue;
      path.move(from);
      path.line(to);
      continue;
    }
    bool drawing = false;
    for (const LinePiece& piece : line.pieces) {
      const std::vector<Point> poles = map_.segment(piece.triangle, piece.from, piece.to);
      const bool visible = meets(poles, seen);
      if (visible && !drawing) path.move(map_.evaluate(piece.triangle, piece.from));
      if (visible) path.curve(poles);
      drawing = visible;
    }
  }
  return path_element(axis == 0 ? "u" : "v", path);
}

std::string ResultPainter::control_net(const Panel& panel) const {
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
  PathData points(panel);  // dots: lines of length zero with round ends
  for (const Point& p : result_.control_points) {
    points.move(p);
    points.line(p);
  }
  return path_element("net", path) + path_element("points", points);
}

std::string ResultPainter::over_path(const Panel& panel) const {
  PathData path(panel);
  for (const CurveEdge& e : over_->boundary_edges) {
    path.move(over_->domain_vertices[e.a]);
    path.line(over_->domain_vertices[e.b]);
  }
  return path_element("over", path);
}

std::string ResultPainter::dots(const Panel& panel, bool domain) const {
  std::string out;
  for (const int v : result_.exceptional_vertices) {
    const Point p = panel.place(place_of(v, domain));
    out += fmt::format("<circle class=\"exceptional\" cx=\"{:.3f}\" cy=\"{:.3f}\" r=\"4.5\"/>\n",
                       p.x(), p.y());
  }
  return out;
}

Point ResultPainter::place_of(int vertex, bool domain) const {
  if (domain) return result_.domain_vertices[vertex];
  const auto [t, k] = corner_of_[vertex];
  return t < 0 ? Point::Zero() : result_.control_points[map_.control_id(t, k, 0, 0)];
}

std::string ResultPainter::squares(const Panel& panel, bool domain) const {
  PathData path(panel);
  add_dark_squares(path, map_, grid_of(result_, options_.grid_lines), domain);
  return path_element("squares", path, "stroke:none");
}

std::vector<double> ResultPainter::triangle_deviations() const {
  std::vector<double> out(result_.triangles.size(), 0);
  for (const DrawnEdge& e : edges_) {
    if (e.kind != EdgeKind::smooth && !claims_nothing_) continue;
    for (const int t : e.triangle)
      if (t >= 0) out[t] = std::max(out[t], e.c1_deviation);
  }
  return out;
}

std::vector<Point> ResultPainter::corners_of(int t, bool domain) const {
  std::vector<Point> out;
  if (!domain)
    for (const int id : result_.triangle_control_points[t])
      out.push_back(result_.control_points[id]);
  else
    for (const int v : result_.triangles[t]) out.push_back(result_.domain_vertices[v]);
  return out;
}

// One colour where the value is one; small straight triangles, of some pixels each, where it
// varies.
std::string ResultPainter::fill(const Panel& panel, bool domain, const Box& seen,
                                const ColourScale& scale) const {
  constexpr double kPiece = 5;  // pixels
  constexpr int kMostCuts = 48;
  std::vector<PathData> paths(ColourScale::kSteps, PathData(panel));
  const bool constant = options_.colour == Colour::c1_deviation;
  const std::vector<double> deviation = constant ? triangle_deviations() : std::vector<double>();
  for (int t = 0; t < static_cast<int>(result_.triangles.size()); ++t) {
    const std::vector<Point> poles = corners_of(t, domain);
    if (!meets(poles, seen)) continue;
    if (constant) {
      PathData& path = paths[scale.step(deviation[t])];
      for (int k = 0; k < 3; ++k) {
        const std::vector<Point> side =
            domain ? std::vector{poles[k], poles[(k + 1) % 3]} : map_.edge(t, k);
        if (k == 0) path.move(side.front());
        path.curve(side);
      }
      path.close();
      continue;
    }
    const Box box = box_of(poles);
    const double size = (box.high - box.low).maxCoeff() * panel.scale();
    fill_triangle(paths, t, std::clamp(static_cast<int>(size / kPiece) + 1, 1, kMostCuts), domain,
                  scale);
  }
  std::string out;
  for (int k = 0; k < ColourScale::kSteps; ++k) {
    if (paths[k].empty()) continue;
    const std::string colour = scale_colour((k + 0.5) / ColourScale::kSteps);
    out += "<path style=\"fill:" + colour + ";stroke:" + colour + ";stroke-width:.4\" d=\"" +
           paths[k].text() + "\"/>\n";
  }
  return out;
}

void ResultPainter::fill_triangle(std::vector<PathData>& paths, int t, int cuts, bool domain,
                                  const ColourScale& scale) const {
  const auto place = [&](const Barycentric& p) {
    return domain ? map_.domain_point(t, p) : map_.evaluate(t, p);
  };
  pieces(cuts, [&](const Barycentric& a, const Barycentric& b, const Barycentric& c) {
    PathData& path = paths[scale.step(map_.distortion(t, (a + b + c) / 3))];
    path.move(place(a));
    path.line(place(b));
    path.line(place(c));
    path.close();
  });
}

}  // namespace c1mesh
