// SPDX-License-Identifier: GPL-3.0-or-later
// Projected Newton over the domain's unknowns, and the untangling that precedes it.
#pragma once

#include <vector>

#include "domain/energy.h"
#include "domain/layout.h"
#include "linear/newton.h"

namespace c1mesh {

/// D = sum_k unknown[k] coefficient[k]: how an element's matrix depends on the layout's unknowns.
struct Dependence {
  std::vector<int> unknown;
  std::vector<Eigen::RowVector2d> coefficient;
};
Dependence dependence_of(const DomainElement& element, const DomainLayout::Matrix& layout);

/// sum over elements of weight f^exponent, as a function of the unknowns (x and y interleaved).
class DomainObjective : public Objective {
 public:
  DomainObjective(const DomainLayout& layout, std::vector<DomainElement> elements);

  double exponent = 1;
  double epsilon = 0;  ///< regularisation of 1/det (see InverseDeterminant); 0: the true energy

  double value(const Eigen::VectorXd& unknowns) const override;
  double derivatives(const Eigen::VectorXd& unknowns, Eigen::VectorXd& gradient,
                     SparseMatrix& hessian) const override;
  double least_determinant(const Eigen::VectorXd& unknowns) const;

 private:
  Eigen::Matrix2d matrix_of(std::size_t element, const Eigen::VectorXd& unknowns) const;

  std::vector<DomainElement> elements_;
  std::vector<Dependence> exact_, sparse_;
};

/// Makes all determinants positive if it can: the regularised energy with falling epsilon
/// (Garanzha et al. 2021). Success: `converged`; the objective's epsilon is 0 afterwards.
NewtonReport untangle_domain(DomainObjective& objective, Eigen::VectorXd& unknowns,
                             int max_iterations, const Checkpoint& checkpoint);

Eigen::VectorXd flatten(const PointMatrix& points);
PointMatrix unflatten(const Eigen::VectorXd& x);

}  // namespace c1mesh
