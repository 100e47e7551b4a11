// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/paper_objective.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "domain/minimise.h"
#include "optimise/map_objective.h"
#include "paper/smooth_norm.h"

namespace c1mesh {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double deviation(const C1Edge& e, const Pair& state) {
  const Eigen::Vector3d gamma = edge_barycentric(e, state.domain);
  double sum = 0;
  for (int i = 0; i < e.equations(); ++i) sum += c1_residue(e, i, gamma, state.control).norm();
  return sum;
}

}  // namespace

PaperObjective::PaperObjective(const CurvedMesh& initial, AskedEdges asked, const Pair& state,
                               bool domain_free, std::vector<DomainElement> scaffold)
    : initial_(initial),
      asked_(std::move(asked)),
      start_(state),
      scaffold_(std::move(scaffold)),
      barrier_(initial.degree),
      vertex_at_(initial.vertex_count(), -1),
      control_at_(initial.control.size(), -1) {
  if (domain_free)
    for (int& at : vertex_at_) {
      at = variables_;
      variables_ += 2;
    }
  const std::vector<char> fixed = fixed_control(initial, initial.control.size());
  for (std::size_t k = 0; k < control_at_.size(); ++k)
    if (!fixed[k]) {
      control_at_[k] = variables_;
      variables_ += 2;
    }
  if (!domain_free) scaffold_.clear();
  for (const auto& t : initial.triangles)
    regularisers_.emplace_back(barrier_.tables(), initial.domain[t[1]] - initial.domain[t[0]],
                               initial.domain[t[2]] - initial.domain[t[0]]);
}

Eigen::VectorXd PaperObjective::pack(const Pair& state) const {
  Eigen::VectorXd x(variables_);
  for (std::size_t v = 0; v < vertex_at_.size(); ++v)
    if (vertex_at_[v] >= 0)
      x.segment<2>(vertex_at_[v]) = state.domain.row(static_cast<Eigen::Index>(v)).transpose();
  for (std::size_t k = 0; k < control_at_.size(); ++k)
    if (control_at_[k] >= 0) x.segment<2>(control_at_[k]) = state.control[k];
  return x;
}

Pair PaperObjective::unpack(const Eigen::VectorXd& x) const {
  Pair state = start_;
  for (std::size_t v = 0; v < vertex_at_.size(); ++v)
    if (vertex_at_[v] >= 0)
      state.domain.row(static_cast<Eigen::Index>(v)) = x.segment<2>(vertex_at_[v]).transpose();
  for (std::size_t k = 0; k < control_at_.size(); ++k)
    if (control_at_[k] >= 0) state.control[k] = x.segment<2>(control_at_[k]);
  return state;
}

Net PaperObjective::net_at(int t, const Pair& state) const {
  const int size = initial_.net_size();
  Net net(size);
  for (int k = 0; k < size; ++k) net[k] = state.control[initial_.nets[t * size + k]];
  return net;
}

Eigen::Matrix2d PaperObjective::edges_of(int t, const Pair& state) const {
  const auto& corner = initial_.triangles[t];
  Eigen::Matrix2d D;
  for (int k = 0; k < 2; ++k)
    D.col(k) = (state.domain.row(corner[k + 1]) - state.domain.row(corner[0])).transpose();
  return D;
}

double PaperObjective::triangle_value(int t, const Pair& state) const {
  const Net net = net_at(t, state);
  const double barrier = barrier_.value(net, edges_of(t, state), weights.bound);
  if (!std::isfinite(barrier)) return kInfinite;
  return weights.regularisation * regularisers_[t].value(net) + weights.barrier * barrier;
}

PaperObjective::Local PaperObjective::triangle_terms(int t, const Pair& state) const {
  const int size = initial_.net_size(), P = 2 * size;
  const Net net = net_at(t, state);
  double g;
  Eigen::VectorXd slope;
  Eigen::MatrixXd curvature;
  barrier_.derivatives(net, edges_of(t, state), weights.bound, g, slope, curvature);
  project_to_semidefinite(curvature);
  Local local;
  local.value = weights.barrier * g;
  // From the edge vectors of the domain triangle to its vertices.
  Eigen::Matrix<double, 4, 6> vertices = Eigen::Matrix<double, 4, 6>::Zero();
  for (int k = 0; k < 2; ++k) {
    vertices.block<2, 2>(2 * k, 0) = -Eigen::Matrix2d::Identity();
    vertices.block<2, 2>(2 * k, 2 * k + 2) = Eigen::Matrix2d::Identity();
  }
  local.gradient.resize(P + 6);
  local.gradient << slope.head(P), vertices.transpose() * slope.tail<4>();
  local.gradient *= weights.barrier;
  local.hessian.resize(P + 6, P + 6);
  local.hessian.topLeftCorner(P, P) = curvature.topLeftCorner(P, P);
  local.hessian.topRightCorner(P, 6) = curvature.topRightCorner(P, 4) * vertices;
  local.hessian.bottomLeftCorner(6, P) = local.hessian.topRightCorner(P, 6).transpose();
  local.hessian.bottomRightCorner(6, 6) =
      vertices.transpose() * curvature.bottomRightCorner(4, 4) * vertices;
  local.hessian *= weights.barrier;
  local.value +=
      regularisers_[t].add(net, weights.regularisation, true, local.gradient, local.hessian);
  for (int k = 0; k < size; ++k) local.at.push_back(control_at_[initial_.nets[t * size + k]]);
  for (int v : initial_.triangles[t]) local.at.push_back(vertex_at_[v]);
  return local;
}

double PaperObjective::edge_value(const C1Edge& e, const Pair& state) const {
  const Eigen::Vector3d gamma = edge_barycentric(e, state.domain);
  double sum = 0;
  for (int i = 0; i < e.equations(); ++i)
    sum += SmoothNorm::at(c1_residue(e, i, gamma, state.control), weights.smoothing);
  return sum;
}

// Gauss-Newton: d is linear in the control points, and its second derivatives in the domain are
// left out, so the Hessian is positive semi-definite.
PaperObjective::Local PaperObjective::edge_terms(const C1Edge& e, double weight,
                                                 const Pair& state) const {
  const int n = e.equations(), points = 4 + (n + 1) + 2 * n;
  Local local;
  for (int v : e.vertex) local.at.push_back(vertex_at_[v]);
  for (const auto* ids : {&e.edge, &e.inner, &e.outer})
    for (int id : *ids) local.at.push_back(control_at_[id]);
  local.gradient = Eigen::VectorXd::Zero(2 * points);
  local.hessian = Eigen::MatrixXd::Zero(2 * points, 2 * points);
  const auto v = [&](int k) -> Point { return state.domain.row(e.vertex[k]).transpose(); };
  const Eigen::Vector3d gamma = edge_barycentric(e, state.domain);
  const Eigen::Matrix<double, 2, 8> slope = barycentric_derivative(v(0), v(1), v(2), v(3));
  for (int i = 0; i < n; ++i) {
    const Point base = state.control[e.edge[i]];
    const SmoothNorm norm(c1_residue(e, i, gamma, state.control), weights.smoothing);
    local.value += weight * norm.value;
    // d d: of the vertices, then p_0i, p_0(i+1), p_1i and p'_1(n-i-1).
    Eigen::Matrix<double, 2, 16> d;
    d.leftCols<8>() = -(state.control[e.edge[i + 1]] - base) * slope.row(0) -
                      (state.control[e.inner[i]] - base) * slope.row(1);
    const double factor[4] = {-gamma[0], -gamma[1], -gamma[2], 1};
    for (int k = 0; k < 4; ++k)
      d.middleCols<2>(8 + 2 * k) = factor[k] * Eigen::Matrix2d::Identity();
    const int at[8] = {0, 1, 2, 3, 4 + i, 5 + i, 5 + n + i, 5 + 2 * n + i};
    const Eigen::Matrix<double, 16, 1> gradient = weight * d.transpose() * norm.gradient;
    const Eigen::Matrix<double, 16, 16> hessian = weight * norm.majoriser * d.transpose() * d;
    for (int a = 0; a < 8; ++a) {
      local.gradient.segment<2>(2 * at[a]) += gradient.segment<2>(2 * a);
      for (int b = 0; b < 8; ++b)
        local.hessian.block<2, 2>(2 * at[a], 2 * at[b]) += hessian.block<2, 2>(2 * a, 2 * b);
    }
  }
  return local;
}

PaperObjective::Local PaperObjective::scaffold_terms(const DomainElement& element,
                                                     const Pair& state) const {
  ElementTerms terms = evaluate_element(element, columns_of(element, state.domain), 1, 0);
  project_to_semidefinite(terms.hessian);
  Local local;
  local.value = element.weight * terms.value;
  Eigen::Matrix<double, 4, 6> chain = Eigen::Matrix<double, 4, 6>::Zero();
  for (int k = 0; k < 3; ++k) {
    local.at.push_back(vertex_at_[element.points[k]]);
    for (int c = 0; c < 2; ++c)
      chain.block<2, 2>(2 * c, 2 * k) = element.columns(k, c) * Eigen::Matrix2d::Identity();
  }
  local.gradient = element.weight * chain.transpose() * terms.gradient;
  local.hessian = element.weight * chain.transpose() * terms.hessian * chain;
  return local;
}

void PaperObjective::scatter(const Local& local, Eigen::VectorXd& gradient) const {
  for (std::size_t a = 0; a < local.at.size(); ++a) {
    const int row = local.at[a];
    if (row < 0) continue;
    const auto i = static_cast<Eigen::Index>(2 * a);
    gradient.segment<2>(row) += local.gradient.segment<2>(i);
    for (std::size_t b = 0; b < local.at.size(); ++b) {
      const int column = local.at[b];
      if (column < 0) continue;
      const auto j = static_cast<Eigen::Index>(2 * b);
      for (int r = 0; r < 2; ++r)
        for (int c = 0; c < 2; ++c)
          assembler_.add(row + r, column + c, local.hessian(i + r, j + c));
    }
  }
}

double PaperObjective::value(const Eigen::VectorXd& x) const {
  const Pair state = unpack(x);
  std::vector<double> parts(initial_.triangle_count());
  parallel_for(parts.size(),
               [&](std::size_t t) { parts[t] = triangle_value(static_cast<int>(t), state); });
  double sum = 0;
  for (double part : parts) sum += part;
  if (!std::isfinite(sum)) return kInfinite;
  for (const DomainElement& e : scaffold_)
    sum += e.weight * element_value(e, columns_of(e, state.domain), 1, 0);
  if (!std::isfinite(sum)) return kInfinite;
  double soft = 0, hard = 0;
  for (const C1Edge& e : asked_.soft) soft += edge_value(e, state);
  for (const C1Edge& e : asked_.hard) hard += edge_value(e, state);
  return sum + soft + weights.hard_penalty * hard;
}

double PaperObjective::derivatives(const Eigen::VectorXd& x, Eigen::VectorXd& gradient,
                                   SparseMatrix& hessian) const {
  const Pair state = unpack(x);
  const std::size_t triangles = initial_.triangle_count(), soft = asked_.soft.size(),
                    edges = soft + asked_.hard.size();
  std::vector<Local> locals(triangles + edges + scaffold_.size());
  parallel_for(locals.size(), [&](std::size_t k) {
    if (k < triangles) {
      locals[k] = triangle_terms(static_cast<int>(k), state);
    } else if (k < triangles + edges) {
      const std::size_t e = k - triangles;
      locals[k] = e < soft ? edge_terms(asked_.soft[e], 1, state)
                           : edge_terms(asked_.hard[e - soft], weights.hard_penalty, state);
    } else {
      locals[k] = scaffold_terms(scaffold_[k - triangles - edges], state);
    }
  });
  gradient = Eigen::VectorXd::Zero(variables_);
  assembler_.start(variables_);
  double value = 0;
  for (const Local& local : locals) {
    value += local.value;
    scatter(local, gradient);
  }
  hessian = assembler_.finish();
  return value;
}

PaperTerms PaperObjective::terms(const Eigen::VectorXd& x) const {
  const Pair state = unpack(x);
  PaperTerms out;
  for (const C1Edge& e : asked_.soft) out.soft += deviation(e, state);
  for (const C1Edge& e : asked_.hard) out.hard += deviation(e, state);
  for (int t = 0; t < initial_.triangle_count(); ++t) {
    const Net net = net_at(t, state);
    const Eigen::Matrix2d D = edges_of(t, state);
    out.regulariser += regularisers_[t].value(net);
    out.g = std::max(out.g, distortion_bound(barrier_.tables(), net, D.col(0), D.col(1)));
  }
  return out;
}

double PaperObjective::largest_distortion(const Eigen::VectorXd& x) const {
  const Pair state = unpack(x);
  double largest = 0;
  for (int t = 0; t < initial_.triangle_count(); ++t)
    largest = std::max(largest, barrier_.distortion(net_at(t, state), edges_of(t, state)));
  return largest;
}

}  // namespace c1mesh
