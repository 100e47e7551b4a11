// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/minimise.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace c1mesh {

Eigen::VectorXd flatten(const PointMatrix& points) {
  return Eigen::Map<const Eigen::VectorXd>(points.data(), points.size());
}

PointMatrix unflatten(const Eigen::VectorXd& x) {
  return Eigen::Map<const PointMatrix>(x.data(), x.size() / 2, 2);
}

Dependence dependence_of(const DomainElement& element, const DomainLayout::Matrix& layout) {
  Dependence out;
  for (int k = 0; k < 3; ++k)
    for (DomainLayout::Matrix::InnerIterator it(layout, element.points[k]); it; ++it) {
      const auto found = std::find(out.unknown.begin(), out.unknown.end(), it.col());
      const std::size_t place = found - out.unknown.begin();
      if (found == out.unknown.end()) {
        out.unknown.push_back(static_cast<int>(it.col()));
        out.coefficient.emplace_back(0, 0);
      }
      out.coefficient[place] += it.value() * element.columns.row(k);
    }
  return out;
}

DomainObjective::DomainObjective(const DomainLayout& layout, std::vector<DomainElement> elements)
    : elements_(std::move(elements)) {
  for (const DomainElement& element : elements_) {
    exact_.push_back(dependence_of(element, layout.exact));
    sparse_.push_back(dependence_of(element, layout.sparse));
  }
}

Eigen::Matrix2d DomainObjective::matrix_of(std::size_t element,
                                           const Eigen::VectorXd& unknowns) const {
  Eigen::Matrix2d D = Eigen::Matrix2d::Zero();
  const Dependence& on = exact_[element];
  for (std::size_t k = 0; k < on.unknown.size(); ++k)
    D += unknowns.segment<2>(2 * on.unknown[k]) * on.coefficient[k];
  return D;
}

double DomainObjective::value(const Eigen::VectorXd& unknowns) const {
  double sum = 0;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    sum += elements_[e].weight *
           element_value(elements_[e], matrix_of(e, unknowns), exponent, epsilon);
    if (!std::isfinite(sum)) return std::numeric_limits<double>::infinity();
  }
  return sum;
}

double DomainObjective::derivatives(const Eigen::VectorXd& unknowns, Eigen::VectorXd& gradient,
                                    SparseMatrix& hessian) const {
  gradient.setZero(unknowns.size());
  std::vector<Eigen::Triplet<double>> triplets;
  double sum = 0;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    ElementTerms terms = evaluate_element(elements_[e], matrix_of(e, unknowns), exponent, epsilon);
    project_to_semidefinite(terms.hessian);
    const double weight = elements_[e].weight;
    sum += weight * terms.value;
    const Dependence& on = exact_[e];
    for (std::size_t k = 0; k < on.unknown.size(); ++k)
      gradient.segment<2>(2 * on.unknown[k]) +=
          weight * (on.coefficient[k][0] * terms.gradient.head<2>() +
                    on.coefficient[k][1] * terms.gradient.tail<2>());
    const Dependence& near = sparse_[e];
    for (std::size_t k = 0; k < near.unknown.size(); ++k)
      for (std::size_t l = 0; l < near.unknown.size(); ++l) {
        if (near.unknown[k] < near.unknown[l]) continue;
        Eigen::Matrix2d block = Eigen::Matrix2d::Zero();
        for (int a = 0; a < 2; ++a)
          for (int b = 0; b < 2; ++b)
            block += near.coefficient[k][a] * near.coefficient[l][b] *
                     terms.hessian.block<2, 2>(2 * a, 2 * b);
        for (int i = 0; i < 2; ++i)
          for (int j = 0; j < 2; ++j) {
            const int row = 2 * near.unknown[k] + i, column = 2 * near.unknown[l] + j;
            if (row >= column) triplets.emplace_back(row, column, weight * block(i, j));
          }
      }
  }
  hessian.resize(unknowns.size(), unknowns.size());
  hessian.setFromTriplets(triplets.begin(), triplets.end());
  return sum;
}

double DomainObjective::least_determinant(const Eigen::VectorXd& unknowns) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const Eigen::Matrix2d D = matrix_of(e, unknowns);
    least = std::min(least, (D(0, 0) * D(1, 1) - D(1, 0) * D(0, 1)) / elements_[e].area);
  }
  return least;
}

NewtonReport untangle_domain(DomainObjective& objective, Eigen::VectorXd& unknowns,
                             int max_iterations, const Checkpoint& checkpoint) {
  // A barely positive determinant is as good as none for the barrier that follows.
  constexpr double kEnough = 1e-3;
  NewtonReport report;
  SparseSolver solver;
  double least = objective.least_determinant(unknowns);
  double& epsilon = objective.epsilon;
  epsilon = std::sqrt(1e-4 + 0.04 * least * least);
  for (; report.iterations < max_iterations && least < kEnough; ++report.iterations) {
    if (checkpoint) checkpoint();
    const double before = objective.value(unknowns);
    newton_step(objective, solver, unknowns, report.value, report.last_step);
    if (checkpoint.observe) checkpoint.observe(unknowns, report.last_step);
    least = objective.least_determinant(unknowns);
    const double sigma = std::max(0.1, 1 - report.value / before);
    const double root = std::hypot(epsilon, least);
    const double chi = least >= 0 ? 0.5 * (least + root) : 0.5 * epsilon * epsilon / (root - least);
    const double mu = (1 - sigma) * chi;
    epsilon = std::max(1e-10, least < mu ? 2 * std::sqrt(mu * (mu - least)) : 0);
  }
  epsilon = 0;
  report.converged = least > 0;
  return report;
}

}  // namespace c1mesh
