// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/energy.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "bernstein/jacobian.h"

namespace c1mesh {
namespace {

Eigen::Matrix2d columns(const Point& a, const Point& b) {
  Eigen::Matrix2d m;
  m.col(0) = a;
  m.col(1) = b;
  return m;
}

// The element of a curved triangle with control points `net`.
DomainElement triangle_element(const JacobianTables& tables, const Net& net,
                               const std::array<int, 3>& corners, double balance) {
  Eigen::Matrix2d Q = Eigen::Matrix2d::Zero();
  for (int a = 0; a < tables.derivative_size; ++a)
    for (int b = 0; b < tables.derivative_size; ++b) {
      const Point ua = net[tables.along_u[a]] - net[tables.origin[a]];
      const Point ub = net[tables.along_u[b]] - net[tables.origin[b]];
      const Point va = net[tables.along_v[a]] - net[tables.origin[a]];
      const Point vb = net[tables.along_v[b]] - net[tables.origin[b]];
      Q(0, 0) += tables.mass(a, b) * ua.dot(ub);
      Q(0, 1) += tables.mass(a, b) * ua.dot(vb);
      Q(1, 1) += tables.mass(a, b) * va.dot(vb);
    }
  const Eigen::VectorXd det = det_coefficients(tables, net);
  const double h = det.cwiseInverse().mean();
  DomainElement element;
  element.points = corners;
  element.metric << h * Q(1, 1), -h * Q(0, 1), -h * Q(0, 1), h * Q(0, 0);
  element.area = det.mean();
  element.balance = balance;
  return element;
}

// e_out against d1 and -e_in against -d0; counter-clockwise for convex corners, else swapped.
DomainElement corner_wedge(int previous, int vertex, int next, const Point& d0, const Point& d1,
                           bool convex) {
  DomainElement wedge;
  const Eigen::Matrix2d S = convex ? columns(d1, -d0) : columns(-d0, d1);
  wedge.points = convex ? std::array<int, 3>{vertex, next, previous}
                        : std::array<int, 3>{vertex, previous, next};
  wedge.metric = metric_of(S);
  wedge.area = S.determinant();
  return wedge;
}

// An equilateral corner of side `length`: convex on an outer loop, reflex on a hole.
DomainElement smooth_exceptional_wedge(int previous, int vertex, int next, double length,
                                       bool outer) {
  const Point ahead(length, 0), behind(0.5 * length, -std::sqrt(0.75) * length);
  DomainElement wedge = corner_wedge(previous, vertex, next, behind, ahead, true);
  if (!outer) std::swap(wedge.points[1], wedge.points[2]);
  return wedge;
}

// (e0, w) against (d0, J d0): the wedge of a mild joint, uniform as the turn vanishes.
DomainElement mild_wedge(const Joint& joint, const Tips& tips) {
  DomainElement wedge;
  const Eigen::Matrix2d S = columns(joint.d0, Point(-joint.d0.y(), joint.d0.x()));
  wedge.points = {joint.vertex, tips.along, tips.across};
  wedge.metric = metric_of(S);
  wedge.area = S.determinant();
  return wedge;
}

}  // namespace

DomainElements domain_elements(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                               const DomainLayout& layout, const DomainWeights& weights) {
  DomainElements out;
  const JacobianTables& tables = JacobianTables::of(mesh.degree);
  Net net(tables.net_size);
  double total = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    for (int k = 0; k < tables.net_size; ++k)
      net[k] = mesh.control[mesh.nets[t * tables.net_size + k]];
    out.all.push_back(triangle_element(tables, net, mesh.triangles[t], weights.balance));
    total += out.all.back().area;
  }
  out.triangles = mesh.triangle_count();
  // Half by area, half uniform: by area alone tiny triangles would be ignored.
  for (DomainElement& e : out.all) e.weight = 0.5 * e.area / total + 0.5 / out.triangles;
  for (std::size_t l = 0; l < joints.size(); ++l) {
    for (std::size_t k = 0; k < joints[l].size(); ++k) {
      const Joint& joint = joints[l][k];
      const int previous = joint.previous, next = joint.next;
      if (roles[l][k] == Role::flat || joint.kind == JointKind::end) continue;
      if (gives_up_c1(roles[l][k])) {
        // Only the side it turns to matters here: a corner keeps its own, a smooth vertex turns
        // as the loop's polygon must. A branch point may do without turning, and a feature's
        // vertex is convex from one of its sides, whichever way it turns.
        DomainElement wedge;
        if (joint.kind != JointKind::corner && (roles[l][k] != Role::exceptional || joint.feature))
          continue;
        if (joint.kind == JointKind::corner)
          wedge = corner_wedge(previous, joint.vertex, next, joint.d0, joint.d1, joint.convex());
        else
          wedge = smooth_exceptional_wedge(previous, joint.vertex, next, joint.d1.norm(), l == 0);
        wedge.weight = weights.exceptional / out.triangles;
        out.all.push_back(wedge);
        continue;
      }
      DomainElement wedge =
          joint.kind == JointKind::mild
              ? mild_wedge(joint, layout.tips[l][k])
              : corner_wedge(previous, joint.vertex, next, joint.d0, joint.d1, joint.convex());
      wedge.weight = weights.wedge / out.triangles;
      out.all.push_back(wedge);
    }
  }
  return out;
}

Eigen::Matrix2d columns_of(const DomainElement& element, const PointMatrix& points) {
  Eigen::Matrix2d D = Eigen::Matrix2d::Zero();
  for (int k = 0; k < 3; ++k)
    D += points.row(element.points[k]).transpose() * element.columns.row(k);
  return D;
}

double determinant_of(const DomainElement& element, const PointMatrix& points) {
  const Eigen::Matrix2d D = columns_of(element, points);
  return D(0, 0) * D(1, 1) - D(1, 0) * D(0, 1);
}

}  // namespace c1mesh
