// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and files for other programs.
#pragma once

#include <string>

#include "c1mesh/result.h"

namespace c1mesh {

/// What fills the triangles of a picture.
enum class Colour {
  none,
  distortion,    ///< MIPS of the map at each point: |J|_F^2 / det J, 2 where it is a similarity
  c1_deviation,  ///< per triangle, the largest d_ei of its three edges relative to the extent
};

struct DrawOptions {
  double width = 1200;  ///< of the picture, in pixels
  int grid_lines = 24;  ///< iso-lines along the longer side of the domain; 0: none
  bool show_mesh = true;
  bool show_control_net = false;
  Colour colour = Colour::none;
};

/// An SVG picture: left the shape with the images of the domain's grid lines, right the domain with
/// the grid itself; mesh, boundary, exceptional vertices (green dots) on both.
std::string draw_svg(const Result& result, const DrawOptions& options = {});

/// VTK XML unstructured grid of Bezier triangles (cell type 76) and of Bezier curves (75) for
/// boundary, feature and relaxed edges. `domain`: the straight domain mesh instead of the shape, as
/// cells of the same degree with the same numbering. Point data: domain (u, v), c1_deviation,
/// exceptional. Cell data: distortion (g of eq. 4.5; -1 if not proven regular), min_det, region,
/// edge_kind (0 triangle, 1 boundary, 2 feature, 3 relaxed; edges take the values of a triangle).
std::string format_vtu(const Result& result, bool domain = false);

/// The result as text for a file of this name, by its extension: `.vtu` (`.domain.vtu`: the
/// domain),
/// `.svg`, `.json`. Throws InputError (unsupported) for any other.
std::string convert(const Result& result, const std::string& path);

}  // namespace c1mesh
