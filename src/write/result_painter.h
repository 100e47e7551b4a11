// SPDX-License-Identifier: GPL-3.0-or-later
// Draws one result, or a window of it, into panels: everything of a picture but the page.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "c1mesh/write.h"
#include "write/colour_scale.h"
#include "write/grid_lines.h"
#include "write/mesh_edges.h"
#include "write/piecewise_map.h"
#include "write/svg_canvas.h"

namespace c1mesh {

/// `outline`, `mesh`, `shape` or `domain`.
const char* name_of(Part part);

/// The style sheet of what ResultPainter draws.
extern const char* const kPainterStyle;

class ResultPainter {
 public:
  /// `over`: a result whose domain's boundary is drawn over this one's, or null. Both results and
  /// the options must live as long as the painter.
  ResultPainter(const Result& result, const Result* over, const DrawOptions& options);

  /// The bounding box of what a part shows.
  Box box(Part part) const;
  /// The square around a vertex that `options.zoom` asks for, moved into the box.
  Box window(Part part) const;
  /// Everything of the part that meets `seen`, as an SVG group `id`.
  std::string paint(const Panel& panel, Part part, const Box& seen, const std::string& id,
                    const ColourScale& scale) const;
  /// The largest finite distortion at points spread over every triangle, 2 at least.
  double largest_distortion() const;
  /// The C1 deviations that are drawn: the least that is not zero, and the largest.
  std::pair<double, double> range_of_deviations() const;
  /// A result that gives C1 up at every vertex; marks would tell nothing.
  bool claims_nothing() const { return claims_nothing_; }

 private:
  std::vector<Point> poles_of(const DrawnEdge& e, bool domain) const;
  std::string inside(const Panel& panel, bool domain) const;
  std::string edge_path(const Panel& panel, bool domain, const Box& seen, EdgeKind kind,
                        const char* css) const;
  std::string iso_path(const Panel& panel, bool domain, const Box& seen, int axis) const;
  std::string control_net(const Panel& panel) const;
  std::string over_path(const Panel& panel) const;
  std::string dots(const Panel& panel, bool domain) const;
  std::string squares(const Panel& panel, bool domain) const;
  std::string fill(const Panel& panel, bool domain, const Box& seen,
                   const ColourScale& scale) const;
  void fill_triangle(std::vector<PathData>& paths, int t, int cuts, bool domain,
                     const ColourScale& scale) const;
  std::vector<double> triangle_deviations() const;
  std::vector<Point> corners_of(int t, bool domain) const;
  std::string thin(const Panel& panel, const char* css) const;
  Point place_of(int vertex, bool domain) const;
  int zoomed_vertex() const;
  const Result& result_;
  const Result* over_;
  const DrawOptions& options_;
  PiecewiseMap map_;
  std::vector<DrawnEdge> edges_;
  std::vector<IsoLine> lines_;
  std::vector<std::pair<int, int>> corner_of_;  ///< of each vertex: a triangle and which corner
  bool claims_nothing_;
};

}  // namespace c1mesh
