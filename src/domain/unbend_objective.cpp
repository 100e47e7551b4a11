// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/unbend_objective.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace c1mesh {
namespace {

// A complex factor as the real matrix that does the same.
Eigen::Matrix2d matrix_of(const std::complex<double>& c) {
  Eigen::Matrix2d m;
  m << c.real(), -c.imag(), c.imag(), c.real();
  return m;
}

// The least t in (0, 1) at which a + b t + c t^2 vanishes, given a > 0; 1 if there is none.
double first_root(double a, double b, double c) {
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return 1;
  // The roots are q / c and a / q; neither form cancels.
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  double least = 1;
  for (const double root : {c != 0 ? q / c : -1, q != 0 ? a / q : -1})
    if (root > 0) least = std::min(least, root);
  return least;
}

std::vector<std::vector<std::array<int, 3>>> boundary_fans(const CurvedMesh& mesh) {
  std::vector<int> fan_of(mesh.vertex_count(), -1);
  int count = 0;
  for (const auto& loop : mesh.loops)
    for (const BoundaryEdge& edge : loop) fan_of[edge.a] = count++;
  std::vector<std::vector<std::array<int, 3>>> fans(count);
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      if (fan_of[t[k]] >= 0) fans[fan_of[t[k]]].push_back({t[k], t[(k + 1) % 3], t[(k + 2) % 3]});
  return fans;
}

// Gradient and Hessian entries of the terms, gathered.
struct Terms {
  Eigen::VectorXd& gradient;
  std::vector<Eigen::Triplet<double>> hessian;

  void add_block(int a, int b, const Eigen::Matrix2d& block) {
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        if (2 * a + i >= 2 * b + j) hessian.emplace_back(2 * a + i, 2 * b + j, block(i, j));
  }
  double add(const DomainElement& e, const Eigen::VectorXd& x);
  double add(const Spring& spring, double weight, const Eigen::VectorXd& x);
};

double Terms::add(const DomainElement& e, const Eigen::VectorXd& x) {
  ElementTerms terms = evaluate_element(e, columns_at(e, x), 1, 0);
  project_to_semidefinite(terms.hessian);
  for (int k = 0; k < 3; ++k) {
    gradient.segment<2>(2 * e.points[k]) += e.weight * (e.columns(k, 0) * terms.gradient.head<2>() +
                                                        e.columns(k, 1) * terms.gradient.tail<2>());
    for (int l = 0; l < 3; ++l) {
      if (e.points[k] < e.points[l]) continue;
      Eigen::Matrix2d block = Eigen::Matrix2d::Zero();
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b)
          block += e.columns(k, a) * e.columns(l, b) * terms.hessian.block<2, 2>(2 * a, 2 * b);
      add_block(e.points[k], e.points[l], e.weight * block);
    }
  }
  return e.weight * terms.value;
}

double Terms::add(const Spring& spring, double weight, const Eigen::VectorXd& x) {
  const Point r = residue_of(spring, x);
  const Point force = spring.multiplier + weight * r;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Matrix2d turned = matrix_of(spring.factor[k]).transpose();
    gradient.segment<2>(2 * spring.points[k]) += turned * force;
    for (int l = 0; l < 3; ++l)
      if (spring.points[k] >= spring.points[l])
        add_block(spring.points[k], spring.points[l],
                  weight * turned * matrix_of(spring.factor[l]));
  }
  return spring.multiplier.dot(r) + 0.5 * weight * r.squaredNorm();
}

}  // namespace

Eigen::Matrix2d columns_at(const DomainElement& element, const Eigen::VectorXd& x) {
  Eigen::Matrix2d D = Eigen::Matrix2d::Zero();
  for (int k = 0; k < 3; ++k) D += x.segment<2>(2 * element.points[k]) * element.columns.row(k);
  return D;
}

Point residue_of(const Spring& spring, const Eigen::VectorXd& x) {
  Point sum = Point::Zero();
  for (int k = 0; k < 3; ++k)
    sum += matrix_of(spring.factor[k]) * x.segment<2>(2 * spring.points[k]);
  return sum;
}

UnbendObjective::UnbendObjective(const CurvedMesh& mesh) : fans_(boundary_fans(mesh)) {}

bool UnbendObjective::wound_once(const Eigen::VectorXd& x) const {
  return std::all_of(fans_.begin(), fans_.end(), [&](const auto& fan) {
    double angle = 0;
    for (const auto& t : fan) {
      const Point at = x.segment<2>(2 * t[0]);
      const Point a = x.segment<2>(2 * t[1]) - at, b = x.segment<2>(2 * t[2]) - at;
      angle += std::atan2(cross(a, b), a.dot(b));
    }
    return angle < 2 * std::numbers::pi;
  });
}

double UnbendObjective::value(const Eigen::VectorXd& x) const {
  double sum = 0;
  for (const auto* list : {&elements, &scaffold})
    for (const DomainElement& e : *list) {
      sum += e.weight * element_value(e, columns_at(e, x), 1, 0);
      if (!std::isfinite(sum)) return std::numeric_limits<double>::infinity();
    }
  if (!wound_once(x)) return std::numeric_limits<double>::infinity();
  for (const Spring& spring : springs) {
    const Point r = residue_of(spring, x);
    sum += spring.multiplier.dot(r) +
           0.5 * stiffness * spring.stiffness / spring.length2 * r.squaredNorm();
  }
  return sum;
}

double UnbendObjective::derivatives(const Eigen::VectorXd& x, Eigen::VectorXd& gradient,
                                    SparseMatrix& hessian) const {
  gradient.setZero(x.size());
  Terms terms{gradient, {}};
  terms.hessian.reserve(24 * (elements.size() + scaffold.size() + springs.size()));
  double sum = 0;
  for (const auto* list : {&elements, &scaffold})
    for (const DomainElement& e : *list) sum += terms.add(e, x);
  for (const Spring& spring : springs)
    sum += terms.add(spring, stiffness * spring.stiffness / spring.length2, x);
  hessian.resize(x.size(), x.size());
  hessian.setFromTriplets(terms.hessian.begin(), terms.hessian.end());
  return sum;
}

double UnbendObjective::step_limit(const Eigen::VectorXd& x,
                                   const Eigen::VectorXd& direction) const {
  double limit = 1;
  for (const auto* list : {&elements, &scaffold})
    for (const DomainElement& e : *list) {
      const Eigen::Matrix2d D = columns_at(e, x), S = columns_at(e, direction);
      const double linear = cross(D.col(0), S.col(1)) + cross(S.col(0), D.col(1));
      limit =
          std::min(limit, first_root(cross(D.col(0), D.col(1)), linear, cross(S.col(0), S.col(1))));
    }
  return limit < 1 ? 0.9 * limit : 1;
}

}  // namespace c1mesh
