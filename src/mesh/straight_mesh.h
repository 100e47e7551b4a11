// SPDX-License-Identifier: GPL-3.0-or-later
// The straight triangulation T^ from which the curved mesh is cut: the chord polygon, with the warp
// triangles' inner edges as constraints, refined for good angles.
#pragma once

#include <array>
#include <vector>

#include "mesh/warp_layer.h"

namespace c1mesh::meshing {

/// A vertex on a chord: at local parameter s in [0, 1] of its segment.
struct ChordVertex {
  int vertex = -1;
  double s = 0;
};

/// Vertices are first the segments' end points (WarpSegment::start), then the apexes
/// of the warped segments, then Steiner points sorted by coordinates.
struct StraightMesh {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;     ///< counter-clockwise, sorted
  std::vector<int> warp;                         ///< per triangle: flat segment number or -1
  std::vector<std::vector<ChordVertex>> chords;  ///< per segment, flat: start, Steiner…, end
};

/// The domain's point on a segment's chord at local parameter s (straight segments: on the curve).
Point chord_point(const WarpSegment& segment, double s);

/// Triangulates the region bounded by the chords of `layer`. Chord Steiner points have dyadic s.
/// Throws NoMesh if the chords do not bound a region. `stop` is called now and then.
StraightMesh triangulate_layer(const std::vector<std::vector<WarpSegment>>& layer,
                               const Thrift& thrift, const Stop& stop = {});

}  // namespace c1mesh::meshing
