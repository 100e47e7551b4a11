// SPDX-License-Identifier: GPL-3.0-or-later
// The map of a result as a function: values, derivatives, inverse.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <stdexcept>

#include "c1mesh/barycentric.h"
#include "c1mesh/result.h"

namespace c1mesh {

/// A place of the domain. Where the domain overlaps itself, the triangle tells which of the places
/// over one point of the plane is meant.
struct DomainPoint {
  int triangle = -1;                              ///< index into Result::triangles
  Barycentric barycentric = Barycentric::Zero();  ///< in that triangle
  Point uv = Point::Zero();                       ///< domain coordinates (u, v)
};

/// Second derivatives of x (first) and of y (second): [d²/du², d²/dudv; d²/dudv, d²/dv²], shape
/// units per domain unit squared.
using Hessians = std::array<Eigen::Matrix2d, 2>;

/// The map at one place with its derivatives.
struct Jet {
  Point value = Point::Zero();                         ///< (x, y), the input's units
  Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();  ///< columns d/du, d/dv; rows x, y
  Hessians hessian = {Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Zero()};  ///< of x and of y
};

/// An axis-parallel box.
struct Box {
  Point low = Point::Zero();   ///< least coordinates
  Point high = Point::Zero();  ///< greatest coordinates
};

/// A point was asked for that is not in the domain.
class OutsideDomain : public std::domain_error {
 public:
  /// For the point (u, v).
  explicit OutsideDomain(const Point& uv);
  /// The point that was asked for, domain coordinates.
  const Point& uv() const { return uv_; }

 private:
  Point uv_;
};

/// The map Phi of a result from its domain to its shape, triangle by triangle a polynomial of the
/// result's degree (paper, definition 2), and its inverse. It has a copy of what it needs of the
/// result. Copies share it and cost nothing. Nothing changes after construction and nothing is
/// cached, so any number of threads may use one Map.
///
/// Points on edges and vertices belong to the least of the triangles there. Derivatives are those
/// of the triangle's polynomial: across an edge where the result is C1 those of first order agree,
/// those of second order need not.
class Map {
 public:
  /// Throws InputError: empty (no triangle), malformed (a list is short, an index out of range),
  /// non_finite (a coordinate), unsupported (a triangle of the domain without area).
  explicit Map(const Result& result);

  /// Degree n of every triangle.
  int degree() const;
  /// How many triangles there are.
  int triangles() const;
  /// Of the domain's vertices, domain units.
  const Box& domain_box() const;
  /// Of the control points; the shape lies inside. Shape units.
  const Box& shape_box() const;

  /// How far outside of a triangle `find` may take a point to be in it: 2^-46 (1.4e-14) of the
  /// domain's largest coordinate in size, some rounding errors. Domain units.
  double domain_tolerance() const;
  /// The same of `locate`: 2^-46 of the shape's largest coordinate in size. Shape units.
  double shape_tolerance() const;

  /// The place at domain coordinates (u, v): in the least triangle that contains the point within
  /// domain_tolerance(), so that a barycentric coordinate may be negative by as much; none outside
  /// of the domain, or if u or v is not finite. Where the domain overlaps itself, too, the least
  /// triangle is taken; the others are reached by `at`.
  std::optional<DomainPoint> find(double u, double v) const;

  /// A place named by triangle and barycentric coordinates there. Throws std::out_of_range if there
  /// is no such triangle.
  DomainPoint at(int triangle, const Barycentric& barycentric) const;
  /// A place named by triangle and domain coordinates. The point may be outside of the triangle,
  /// whose polynomial goes on there. Throws std::out_of_range if there is no such triangle.
  DomainPoint at(int triangle, const Point& uv) const;

  /// (x, y) there, shape units. Throws std::out_of_range if there is no such triangle.
  Point evaluate(const DomainPoint& place) const;
  /// The Jacobian there: columns d/du, d/dv of (x, y), shape units per domain unit. Throws
  /// std::out_of_range if there is no such triangle.
  Eigen::Matrix2d jacobian(const DomainPoint& place) const;
  /// The second derivatives there. Throws std::out_of_range if there is no such triangle.
  Hessians hessian(const DomainPoint& place) const;
  /// Value and derivatives there, at the cost of one of them. Throws std::out_of_range if there is
  /// no such triangle.
  Jet jet(const DomainPoint& place) const;

  /// (x, y) at domain coordinates, as `find` finds them. Throws OutsideDomain where it finds none.
  Point evaluate(double u, double v) const;
  /// The Jacobian at domain coordinates. Throws OutsideDomain.
  Eigen::Matrix2d jacobian(double u, double v) const;
  /// The second derivatives at domain coordinates. Throws OutsideDomain.
  Hessians hessian(double u, double v) const;

  /// The inverse: the place whose image is (x, y), in the least triangle whose image contains the
  /// point within shape_tolerance(); none outside of the shape, or if x or y is not finite. No
  /// point inside a regular result's shape is missed: where Newton's method does not find it, the
  /// triangle is cut into quarters as long as the convex hulls of their control points leave it
  /// open whether they contain the point.
  std::optional<DomainPoint> locate(double x, double y) const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace c1mesh
