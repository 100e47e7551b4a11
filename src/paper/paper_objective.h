// SPDX-License-Identifier: GPL-3.0-or-later
// The objective of problem (4.6) with its constraints as penalty and barrier (paper, section 5.1).
#pragma once

#include <vector>

#include "domain/energy.h"
#include "linear/newton.h"
#include "mesh/curved_mesh.h"
#include "optimise/c1_system.h"
#include "paper/distortion_barrier.h"
#include "paper/regulariser.h"

namespace c1mesh {

/// The two halves of the pair (T, T^) as points.
struct Pair {
  PointMatrix domain;          ///< one vertex a row
  std::vector<Point> control;  ///< of the mesh
};

/// Interior edges across which C1 is asked.
struct AskedEdges {
  std::vector<C1Edge> soft;  ///< beside a warped triangle
  std::vector<C1Edge> hard;  ///< between triangles whose map is the identity at first
};

/// Factors in the normalised frame.
struct PaperWeights {
  double regularisation = 1e-6;  ///< lambda_reg
  double hard_penalty = 100;     ///< lambda_h
  double barrier = 1e-4;         ///< rho
  double bound = 1000;           ///< alpha mu
  double smoothing = 1e-6;       ///< epsilon of the norms
};

/// The un-weighted terms, the norms not smoothed.
struct PaperTerms {
  double soft = 0;         ///< E_s, eq. (4.2)
  double hard = 0;         ///< E_h / lambda_h
  double regulariser = 0;  ///< E_reg, eq. (4.3)
  double g = 0;            ///< the largest g(t), eq. (4.5)
};

/// E_s + lambda_h E_h + lambda_reg E_reg + rho E_g + `scaffold`. Variables: the domain's vertices
/// (if free), then the control points that are not on curves.
class PaperObjective : public Objective {
 public:
  /// `initial`: the pair before the optimisation, kept by reference. `scaffold`: elements over the
  /// domain's vertices, used only if the domain is free.
  PaperObjective(const CurvedMesh& initial, AskedEdges asked, const Pair& state, bool domain_free,
                 std::vector<DomainElement> scaffold = {});

  PaperWeights weights;

  double value(const Eigen::VectorXd& x) const override;
  double derivatives(const Eigen::VectorXd& x, Eigen::VectorXd& gradient,
                     SparseMatrix& hessian) const override;
  PaperTerms terms(const Eigen::VectorXd& x) const;
  Eigen::VectorXd pack(const Pair& state) const;
  Pair unpack(const Eigen::VectorXd& x) const;
  /// The largest g_p(t) of the barrier.
  double largest_distortion(const Eigen::VectorXd& x) const;

 private:
  // A term with the points it depends on: x index of each point, -1 where it cannot move.
  struct Local {
    std::vector<int> at;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd hessian;
    double value = 0;
  };
  Net net_at(int triangle, const Pair& state) const;
  Eigen::Matrix2d edges_of(int triangle, const Pair& state) const;
  double triangle_value(int triangle, const Pair& state) const;
  Local triangle_terms(int triangle, const Pair& state) const;
  double edge_value(const C1Edge& edge, const Pair& state) const;
  Local edge_terms(const C1Edge& edge, double weight, const Pair& state) const;
  Local scaffold_terms(const DomainElement& element, const Pair& state) const;
  void scatter(const Local& local, Eigen::VectorXd& gradient) const;

  const CurvedMesh& initial_;
  AskedEdges asked_;
  Pair start_;
  std::vector<DomainElement> scaffold_;
  DistortionBarrier barrier_;
  std::vector<Regulariser> regularisers_;
  std::vector<int> vertex_at_, control_at_;  // x index, or -1
  int variables_ = 0;
  mutable Assembler assembler_;
};

}  // namespace c1mesh
