// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and files for other programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "c1mesh/result.h"

namespace c1mesh {

/// What fills the triangles of a picture.
enum class Colour {
  none,          ///< no fill
  distortion,    ///< MIPS of the map at each point: |J|_F^2 / det J, 2 where it is a similarity
  c1_deviation,  ///< per triangle, the largest d_ei relative to the extent, over those of its edges
                 ///< across which C1 is asked; over all where it is asked of none
  checkerboard,  ///< the squares between the grid's lines, in two colours, instead of the lines
};

/// What a panel of a picture shows of a result.
enum class Part {
  outline,  ///< the shape's boundary and features alone
  mesh,     ///< the shape with its mesh, without iso-curves
  shape,    ///< the shape with mesh and iso-curves
  domain,   ///< the domain with mesh and grid
};

/// A blow-up beside a panel: a square window around a vertex.
struct Zoom {
  static constexpr int kApart =
      -1;               ///< where the domain and the one drawn over it are farthest apart
  int vertex = kApart;  ///< of the domain
  double size = 0.1;    ///< of the window, relative to the larger side of what the panel shows
};

/// How a picture is drawn.
struct DrawOptions {
  double width = 1200;                                    ///< of the picture, in pixels
  std::vector<Part> parts = {Part::shape, Part::domain};  ///< a result's panels, side by side
  int columns = 1;                                        ///< results side by side
  std::optional<Zoom> zoom;       ///< every panel is followed by its blow-up
  int grid_lines = 24;            ///< iso-lines along the longer side of the domain; 0: none
                                  ///< (std::invalid_argument for a checkerboard)
  bool show_mesh = true;          ///< the triangles' edges
  bool show_control_net = false;  ///< the control points
  bool show_key = true;           ///< below the picture, what its lines and dots mean
  bool transparent = false;       ///< no white ground
  Colour colour = Colour::none;   ///< what fills the triangles
};

/// An SVG picture: left the shape with the images of the domain's grid lines, right the domain with
/// the grid itself; mesh, boundary, exceptional vertices (green dots) on both. Lines, dots and text
/// are as thick and as large as a picture of `width` pixels asks for.
/// A result that claims C1 nowhere (all its vertices are exceptional) has no marks.
std::string draw_svg(const Result& result, const DrawOptions& options = {});

/// One of several results in a picture.
struct Drawn {
  const Result* result = nullptr;  ///< not null where it is drawn
  std::string title;               ///< empty: the result's name
  const Result* over = nullptr;    ///< its domain's boundary is drawn (red) over the domain
};

/// Several results in one picture, `options.columns` of them side by side. Throws
/// std::invalid_argument if a result has no such vertex as `options.zoom` asks for.
std::string draw_svg(const std::vector<Drawn>& results, const DrawOptions& options = {});

/// How a VTU file holds the curved triangles and edges.
enum class VtuCells {
  bezier,    ///< cell types 76 and 75: control points, the map bit for bit
  lagrange,  ///< cell types 69 and 68: interpolation nodes, converted exactly and rounded once
};

/// VTK XML unstructured grid of curved triangles, and of curves for boundary, feature and relaxed
/// edges. `domain`: the straight domain mesh instead of the shape, as cells of the same degree with
/// the same numbering. Point data: domain (u, v), c1_deviation, exceptional. Cell data: distortion
/// (g of eq. 4.5; -1 if not proven regular), min_det, region, edge_kind (0 triangle, 1 boundary, 2
/// feature, 3 relaxed; edges take the values of a triangle).
std::string format_vtu(const Result& result, bool domain = false,
                       VtuCells cells = VtuCells::bezier);

/// Gmsh's highest degree.
constexpr int kHighestGmshDegree = 10;

/// Gmsh MSH 4.1 ASCII: complete Lagrange triangles and lines of the map's degree, node k + 1 being
/// the interpolation node at the place of control point k. Physical groups: "curve K" for every
/// input curve that edges lie on (features too), "region K", "exceptional". A view "domain": u, v.
/// `domain`: the straight domain mesh, same numbering. Throws InputError (unsupported) above
/// kHighestGmshDegree.
std::string format_msh(const Result& result, bool domain = false);

/// MFEM mesh v1.0, the control points as its nodes in the positive basis (L2_T2_2D_Pn). Attributes
/// are numbers of regions and, of boundary elements (features too), of input curves, plus 1.
/// `domain`: the straight domain mesh, same numbering, without nodes.
std::string format_mfem(const Result& result, bool domain = false);

/// Wavefront OBJ: every triangle cut into tessellation^2 straight ones (at least 1), points on
/// common edges shared; texture coordinates are the domain's. One group per region. Straight pieces
/// of a much distorted triangle can turn over in the shape.
std::string format_obj(const Result& result, int tessellation = 8);

/// A page to explore the result in a browser, complete in one file (docs/page.md): both sides,
/// layers, the map and its inverse under the pointer, the metrics. It holds the text of
/// format_result() bit for bit, so the same result gives the same bytes. No name in the result can
/// become mark-up or script of the page.
std::string format_html(const Result& result);

/// What some of the formats leave open.
struct ConvertOptions {
  VtuCells cells = VtuCells::bezier;  ///< of .vtu
  int tessellation = 8;               ///< of .obj: pieces along each edge
};

/// The extensions that `convert` knows; before .vtu, .msh and .mesh may stand .domain.
std::vector<std::string> convertible_extensions();

/// The result as text for a file of this name, by its extension: `.vtu`, `.msh`, `.mesh` (MFEM;
/// `.domain.vtu` and so on: the domain mesh), `.obj`, `.svg`, `.png`, `.html`, `.json`. Throws
/// InputError (unsupported) for any other.
std::string convert(const Result& result, const std::string& path,
                    const ConvertOptions& options = {});

}  // namespace c1mesh
