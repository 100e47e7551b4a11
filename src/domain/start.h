// SPDX-License-Identifier: GPL-3.0-or-later
// First positions for the domain's unknowns, and extra elements that keep holes open.
#pragma once

#include <map>
#include <vector>

#include "domain/energy.h"
#include "domain/layout.h"
#include "mesh/curved_mesh.h"

namespace c1mesh {

enum class Start {
  shape,   ///< chain ends stay where the shape has them, interior vertices follow harmonically
  convex,  ///< outer loop on a convex polygon, holes filled, Tutte's embedding
};

/// Values of the layout's unknowns. Chain vertices follow from the layout; triangles may be
/// inverted.
PointMatrix start_positions(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                            const DomainLayout& layout, Start start);

/// The domain's vertices as rows, and back; `points` may have further rows.
PointMatrix domain_points(const CurvedMesh& mesh);
void set_domain(CurvedMesh& mesh, const PointMatrix& points);

/// A domain independent of a layout: vertex positions and, by vertex, the vectors w of its bent
/// joints with the length |d0| they go with. (From positions alone w could be had only up to an
/// error of 1 / kappa roundings.)
struct DomainShape {
  struct Bend {
    Point w;
    double length;
  };
  PointMatrix points;
  std::map<int, Bend> bends;
  bool empty() const { return points.rows() == 0; }
};

DomainShape shape_of_domain(int vertices, const Joints& joints, const DomainLayout& layout,
                            const PointMatrix& unknowns);

/// The unknowns whose layout gives this domain; exact for positions that satisfy the layout's
/// chains (a solution for stricter roles, or of the mesh before a refinement, does).
PointMatrix unknowns_of_shape(const DomainShape& shape, const Joints& joints,
                              const DomainLayout& layout);

/// Unknowns for positions that satisfy the chains nearly: chain vertices move onto them, and the
/// vectors w are the incoming edges turned by 90 degrees, the optimum of the joints' wedges.
PointMatrix unknowns_near_points(const PointMatrix& points, const Joints& joints,
                                 const DomainLayout& layout);

/// Interior vertices not wound exactly once and boundary vertices wound more than once, given that
/// all triangles are positive. Positive triangles alone do not exclude them.
std::vector<int> winding_faults(const CurvedMesh& mesh, const PointMatrix& points);

/// Pairs of crossing boundary edges of the domain (the domain overlaps itself in the plane).
int boundary_crossings(const CurvedMesh& mesh, const PointMatrix& points);

/// The ends of those edges, four for each pair.
std::vector<int> crossing_vertices(const CurvedMesh& mesh, const PointMatrix& points);

}  // namespace c1mesh
