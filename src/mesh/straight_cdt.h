// SPDX-License-Identifier: GPL-3.0-or-later
// The constrained Delaunay triangulation behind the straight mesh. Included by two files only: CGAL
// is slow to compile.
#pragma once

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <vector>

#include "mesh/straight_mesh.h"

namespace c1mesh::meshing {

/// The three straight lines of segment i: its chord and the warp triangle's inner edges.
enum class Side { chord = 0, left = 1, right = 2 };
inline int line_of(int segment, Side side) {
  return 3 * segment + static_cast<int>(side);
}

/// What is known of a vertex.
struct VertexInfo {
  int number = -1;
  std::vector<int> lines;  ///< the constraint lines it lies on (line_of)
  int inside = -1;         ///< the warp triangle it lies strictly inside of, or -1
  double size = 0;         ///< the local size it stems from: new points keep half of it clear
  double s = 0;            ///< Steiner points on a chord: local parameter, dyadic
};

struct FaceInfo {
  int number = -1;
  bool in_domain = false;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;
using KernelPoint = Triangulation::Point;

inline Point point_of(Vertex v) {
  return {v->point().x(), v->point().y()};
}

/// The warp triangle that contains the face, or -1 (`straight` per segment: it has no warp
/// triangle). A face whose corners all lie in a closed warp triangle lies in it, and two of these
/// share no edge.
int warp_of(Face face, const std::vector<const WarpSegment*>& segments);

/// Adds Steiner points until the angles are those of `thrift`, where the constraints allow it, and
/// no unconstrained edge joins two boundary vertices. `in_domain` must be set and stays right.
void refine_delaunay(Triangulation& cdt, const std::vector<const WarpSegment*>& segments,
                     const Thrift& thrift, const Stop& stop);

}  // namespace c1mesh::meshing
