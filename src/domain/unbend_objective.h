// SPDX-License-Identifier: GPL-3.0-or-later
// The objective of unbending: elements and springs over all vertices, none bound to a chain.
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "domain/energy.h"
#include "linear/newton.h"

namespace c1mesh {

/// A linear equation sum_k factor[k] point[k] = 0 among three vertices, vectors and factors taken
/// as complex numbers, met softly.
struct Spring {
  std::array<int, 3> points{};
  std::array<std::complex<double>, 3> factor{};
  double length2 = 1;    ///< a local length squared: residues count relative to it
  double stiffness = 1;  ///< relative to the objective's
  Point multiplier = Point::Zero();
};

/// The left-hand side of the spring's equation, x0, y0, x1, y1, … in `x`.
Point residue_of(const Spring& spring, const Eigen::VectorXd& x);

/// sum of weight f over the elements + sum over the springs of m . r + stiffness / 2 |r|^2 / l^2,
/// as a function of all vertex positions. Infinite where a determinant is not positive or a
/// boundary vertex is wound once or more.
class UnbendObjective : public Objective {
 public:
  explicit UnbendObjective(const CurvedMesh& mesh);

  std::vector<DomainElement> elements;
  std::vector<DomainElement> scaffold;  ///< of the plane around the domain (domain/apart.h)
  std::vector<Spring> springs;
  double stiffness = 1;  ///< of all springs

  double value(const Eigen::VectorXd& x) const override;
  double derivatives(const Eigen::VectorXd& x, Eigen::VectorXd& gradient,
                     SparseMatrix& hessian) const override;
  /// Nine tenths of the way to the first determinant that vanishes: no triangle turns over, not
  /// even on the way, so interior vertices stay wound once.
  double step_limit(const Eigen::VectorXd& x, const Eigen::VectorXd& direction) const override;

 private:
  bool wound_once(const Eigen::VectorXd& x) const;

  // The triangles of each boundary vertex, that vertex first.
  std::vector<std::vector<std::array<int, 3>>> fans_;
};

/// D of an element over vertex positions x0, y0, x1, y1, …
Eigen::Matrix2d columns_at(const DomainElement& element, const Eigen::VectorXd& x);

}  // namespace c1mesh
