// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes for the mesher's tests, in the normalised frame.
#pragma once

#include <vector>

#include "bernstein/net_blossom.h"
#include "mesh/initial_mesh.h"

namespace c1mesh::test {

/// Curves that follow one another (ends agree bit for bit), raised to `degree`, numbered from
/// `first`.
std::vector<LoopCurve> loop_of(const std::vector<BezierCurve>& curves, int degree, int first = 0);

/// Straight edges between the points.
std::vector<BezierCurve> polygon(const std::vector<Point>& points);

/// Four cubics, nearly a circle, counter-clockwise.
std::vector<BezierCurve> circle(const Point& centre, double radius);

/// The same loop run through the other way.
std::vector<BezierCurve> backwards(const std::vector<BezierCurve>& loop);

/// A smooth closed curve of `count` cubics around (0.5, 0.5), radius varying by up to `wave`.
std::vector<BezierCurve> blob(int count, double wave, unsigned seed);

/// One cubic that starts and ends in one point, a drop.
std::vector<BezierCurve> drop();

/// Two parallel spirals of `turns`, joined by two lines: a long strip.
std::vector<BezierCurve> spiral(double turns);

/// A lens of two curves that meet at `degrees` on both ends.
std::vector<BezierCurve> lens(double degrees);

MeshInput input_of(const std::vector<std::vector<BezierCurve>>& loops, int degree = 3);

/// The signed area enclosed by the loops, by Green's formula: exact for polynomials up to rounding.
double green_area(const std::vector<BezierCurve>& curves);

/// The signed area covered by a mesh: the mean of a triangle's det coefficients is twice its area.
double mesh_area(const CurvedMesh& mesh);

/// The barycentric coordinates of a point of the domain in triangle t.
Barycentric locate(const CurvedMesh& mesh, int t, const Point& p);

/// The mesh's map from the domain to the shape; outside, the nearest triangle's polynomial.
Point map_at(const CurvedMesh& mesh, const Point& p);

}  // namespace c1mesh::test
