// SPDX-License-Identifier: GPL-3.0-or-later
// The objective over the whole map: distortion of every curved triangle, C1 as a penalty, wedges
// and domain quality. Variables: the domain's unknowns (optional) and the free control points.
#pragma once

#include <vector>

#include "domain/minimise.h"
#include "mesh/curved_mesh.h"
#include "optimise/c1_system.h"
#include "optimise/triangle_energy.h"

namespace c1mesh {

/// The two halves of a map that the optimisation moves.
struct MapState {
  PointMatrix unknowns;        ///< of the domain's layout
  std::vector<Point> control;  ///< all control points
};

/// Which of `count` control points cannot move: those of boundary edges, and auxiliary ones, which
/// come after the mesh's (see joint_equations).
std::vector<char> fixed_control(const CurvedMesh& mesh, std::size_t count);

/// sum_t weight_t reference (f_t / reference)^exponent + sum of `extras` + sum_e weight_e (rho/2
/// |d_ei|^2 + m_ei . d_ei).
class MapObjective : public Objective {
 public:
  /// `asked`: the edges across which C1 is wanted. `extras`: wedges and the like, over the layout.
  /// With `domain_free` false the domain stays at state.unknowns and the extras are left out.
  MapObjective(const CurvedMesh& mesh, const DomainLayout& layout, std::vector<C1Edge> asked,
               std::vector<DomainElement> extras, const MapState& state, bool domain_free);

  double exponent = 1;
  double reference = 1;  ///< f^exponent is taken as reference (f / reference)^exponent
  double rho = 0;
  std::vector<Point> multipliers;  ///< one per equation, empty: none

  double value(const Eigen::VectorXd& x) const override;
  double derivatives(const Eigen::VectorXd& x, Eigen::VectorXd& gradient,
                     SparseMatrix& hessian) const override;

  Eigen::VectorXd pack(const MapState& state) const;
  MapState unpack(const Eigen::VectorXd& x) const;
  /// m += rho d for every equation: the method of multipliers.
  void update_multipliers(const Eigen::VectorXd& x);
  const std::vector<C1Edge>& edges() const { return edges_; }
  PointMatrix domain_points(const Eigen::VectorXd& x) const;
  const std::vector<char>& fixed() const { return fixed_; }
  /// The largest f_t.
  double largest(const Eigen::VectorXd& x) const;

 private:
  struct Local {
    Eigen::VectorXd gradient;
    Eigen::MatrixXd hessian;
    double value = 0;
  };
  Net net_at(int triangle, const Eigen::VectorXd& x) const;
  Point control_at(int id, const Eigen::VectorXd& x) const;
  double penalty(const Eigen::VectorXd& x, const PointMatrix& domain) const;
  void add_triangle(int triangle, const Local& local, Eigen::VectorXd& gradient) const;
  void add_extra(std::size_t index, const ElementTerms& terms, double weight,
                 Eigen::VectorXd& gradient) const;
  double add_edge(std::size_t index, const Eigen::VectorXd& x, const PointMatrix& domain,
                  Eigen::VectorXd& gradient) const;
  void set_weights(const MapState& state);

  const CurvedMesh& mesh_;
  const DomainLayout& layout_;
  TriangleEnergy energy_;
  std::vector<C1Edge> edges_;
  std::vector<int> first_equation_;  // per edge, and the total at the end
  std::vector<double> edge_weight_, triangle_weight_;
  std::vector<DomainElement> extras_;
  std::vector<Dependence> triangle_exact_, triangle_sparse_, extra_exact_, extra_sparse_;
  std::vector<char> fixed_;    // per control point: on boundary or features
  std::vector<int> variable_;  // per control point: index of its x variable, or -1
  std::vector<Point> frozen_control_;
  PointMatrix frozen_domain_;
  int domain_variables_ = 0, variables_ = 0;
  mutable Assembler assembler_;
};

}  // namespace c1mesh
