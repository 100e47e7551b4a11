// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimise/map_objective.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "domain/joints.h"

namespace c1mesh {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

Eigen::Matrix2d triangle_matrix(const PointMatrix& domain, const std::array<int, 3>& t) {
  Eigen::Matrix2d D;
  D.col(0) = (domain.row(t[1]) - domain.row(t[0])).transpose();
  D.col(1) = (domain.row(t[2]) - domain.row(t[0])).transpose();
  return D;
}

std::array<Point, 4> edge_points(const C1Edge& e, const PointMatrix& domain) {
  std::array<Point, 4> v;
  for (int k = 0; k < 4; ++k) v[k] = domain.row(e.vertex[k]).transpose();
  return v;
}

}  // namespace

std::vector<char> fixed_control(const CurvedMesh& mesh, std::size_t count) {
  std::vector<char> fixed(count, 0);
  for (const auto& loop : boundary_control(mesh))
    for (const auto& edge : loop)
      for (int id : edge) fixed[id] = 1;
  std::fill(fixed.begin() + static_cast<std::ptrdiff_t>(mesh.control.size()), fixed.end(), 1);
  return fixed;
}

MapObjective::MapObjective(const CurvedMesh& mesh, const DomainLayout& layout,
                           std::vector<C1Edge> asked, std::vector<DomainElement> extras,
                           const MapState& state, bool domain_free)
    : mesh_(mesh),
      layout_(layout),
      energy_(mesh.degree),
      edges_(std::move(asked)),
      extras_(std::move(extras)),
      fixed_(fixed_control(mesh, state.control.size())),
      variable_(state.control.size(), -1),
      frozen_control_(state.control),
      frozen_domain_(layout.exact * state.unknowns) {
  first_equation_.push_back(0);
  for (const C1Edge& e : edges_) first_equation_.push_back(first_equation_.back() + e.equations());
  domain_variables_ = domain_free ? 2 * layout.unknowns() : 0;
  variables_ = domain_variables_;
  for (std::size_t k = 0; k < variable_.size(); ++k)
    if (!fixed_[k]) {
      variable_[k] = variables_;
      variables_ += 2;
    }
  if (domain_free) {
    for (const auto& t : mesh.triangles) {
      DomainElement element;
      element.points = t;
      triangle_exact_.push_back(dependence_of(element, layout.exact));
      triangle_sparse_.push_back(dependence_of(element, layout.sparse));
    }
    for (const DomainElement& e : extras_) {
      extra_exact_.push_back(dependence_of(e, layout.exact));
      extra_sparse_.push_back(dependence_of(e, layout.sparse));
    }
  } else {
    extras_.clear();
  }
  set_weights(state);
}

// Triangles: half by area of the shape, half uniform. Equations: d_ei is the jump of the normal
// derivative times the height of v3 over the edge (over n); measuring it by the edge's length makes
// it symmetric in the two triangles, and relative to the size of the triangles there.
void MapObjective::set_weights(const MapState& state) {
  const int count = mesh_.triangle_count();
  double total = 0;
  std::vector<double> area, around(state.control.size(), 1e300);
  for (int t = 0; t < count; ++t) {
    Net net(energy_.tables().net_size);
    const int* ids = &mesh_.nets[t * energy_.tables().net_size];
    for (int k = 0; k < energy_.tables().net_size; ++k) net[k] = state.control[ids[k]];
    area.push_back(det_coefficients(energy_.tables(), net).mean());
    total += area.back();
    for (int k = 0; k < energy_.tables().net_size; ++k)
      around[ids[k]] = std::min(around[ids[k]], area.back());
  }
  for (double a : area) triangle_weight_.push_back(0.5 * a / total + 0.5 / count);
  for (const C1Edge& e : edges_) {
    const auto v = edge_points(e, frozen_domain_);
    const double length = (v[1] - v[0]).squaredNorm();
    const double height = std::abs(cross(v[1] - v[0], v[3] - v[0]));
    const double shape = std::clamp(length * length / (height * height), 1e-2, 1e4);
    const double local = std::min(around[e.outer[0]], around[e.edge[0]]);
    edge_weight_.push_back(shape * (0.5 / total + 0.5 / (count * local)));
  }
}

Point MapObjective::control_at(int id, const Eigen::VectorXd& x) const {
  return variable_[id] < 0 ? frozen_control_[id] : Point(x.segment<2>(variable_[id]));
}

Net MapObjective::net_at(int triangle, const Eigen::VectorXd& x) const {
  const int size = mesh_.net_size();
  Net net(size);
  for (int k = 0; k < size; ++k) net[k] = control_at(mesh_.nets[triangle * size + k], x);
  return net;
}

PointMatrix MapObjective::domain_points(const Eigen::VectorXd& x) const {
  if (domain_variables_ == 0) return frozen_domain_;
  return layout_.exact * unflatten(x.head(domain_variables_));
}

Eigen::VectorXd MapObjective::pack(const MapState& state) const {
  Eigen::VectorXd x(variables_);
  if (domain_variables_) x.head(domain_variables_) = flatten(state.unknowns);
  for (std::size_t k = 0; k < variable_.size(); ++k)
    if (variable_[k] >= 0) x.segment<2>(variable_[k]) = state.control[k];
  return x;
}

MapState MapObjective::unpack(const Eigen::VectorXd& x) const {
  MapState state;
  if (domain_variables_) state.unknowns = unflatten(x.head(domain_variables_));
  for (std::size_t k = 0; k < variable_.size(); ++k)
    state.control.push_back(control_at(static_cast<int>(k), x));
  return state;
}

double MapObjective::penalty(const Eigen::VectorXd& x, const PointMatrix& domain) const {
  double sum = 0;
  std::size_t equation = 0;
  std::vector<Point> local(frozen_control_.size());
  for (std::size_t k = 0; k < local.size(); ++k) local[k] = control_at(static_cast<int>(k), x);
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const auto v = edge_points(edges_[k], domain);
    const Eigen::Vector3d g = barycentric(v[0], v[1], v[2], v[3]);
    for (int i = 0; i < edges_[k].equations(); ++i, ++equation) {
      const Point d = c1_residue(edges_[k], i, g, local);
      double term = 0.5 * rho * d.squaredNorm();
      if (!multipliers.empty()) term += multipliers[equation].dot(d);
      sum += edge_weight_[k] * term;
    }
  }
  return sum;
}

void MapObjective::update_multipliers(const Eigen::VectorXd& x) {
  multipliers.resize(first_equation_.back(), Point::Zero());
  const PointMatrix domain = domain_points(x);
  const MapState state = unpack(x);
  std::size_t equation = 0;
  for (const C1Edge& e : edges_) {
    const auto v = edge_points(e, domain);
    const Eigen::Vector3d g = barycentric(v[0], v[1], v[2], v[3]);
    for (int i = 0; i < e.equations(); ++i, ++equation)
      multipliers[equation] += rho * c1_residue(e, i, g, state.control);
  }
}

double MapObjective::value(const Eigen::VectorXd& x) const {
  const PointMatrix domain = domain_points(x);
  std::vector<double> parts(mesh_.triangle_count());
  parallel_for(parts.size(), [&](std::size_t t) {
    const double f =
        energy_.value(net_at(static_cast<int>(t), x), triangle_matrix(domain, mesh_.triangles[t]));
    parts[t] =
        triangle_weight_[t] * (exponent == 1 ? f : reference * std::pow(f / reference, exponent));
  });
  double sum = 0;
  for (double part : parts) sum += part;
  if (!std::isfinite(sum)) return kInfinite;
  PointMatrix points;
  if (!extras_.empty()) points = layout_.exact * unflatten(x.head(domain_variables_));
  for (const DomainElement& e : extras_) {
    sum += e.weight * element_value(e, columns_of(e, points), 1, 0);
  }
  if (!std::isfinite(sum)) return kInfinite;
  return sum + penalty(x, domain);
}

double MapObjective::largest(const Eigen::VectorXd& x) const {
  const PointMatrix domain = domain_points(x);
  std::vector<double> f(mesh_.triangle_count());
  parallel_for(f.size(), [&](std::size_t t) {
    f[t] =
        energy_.value(net_at(static_cast<int>(t), x), triangle_matrix(domain, mesh_.triangles[t]));
  });
  return *std::max_element(f.begin(), f.end());
}

void MapObjective::add_triangle(int t, const Local& local, Eigen::VectorXd& gradient) const {
  const int size = mesh_.net_size(), P = 2 * size;
  const int* ids = &mesh_.nets[t * size];
  for (int k = 0; k < size; ++k) {
    const int row = variable_[ids[k]];
    if (row < 0) continue;
    gradient.segment<2>(row) += local.gradient.segment<2>(2 * k);
    for (int l = 0; l < size; ++l) {
      const int column = variable_[ids[l]];
      if (column < 0) continue;
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          assembler_.add(row + i, column + j, local.hessian(2 * k + i, 2 * l + j));
    }
  }
  if (!domain_variables_) return;
  const Dependence& on = triangle_exact_[t];
  for (std::size_t u = 0; u < on.unknown.size(); ++u)
    gradient.segment<2>(2 * on.unknown[u]) +=
        on.coefficient[u][0] * local.gradient.segment<2>(P) +
        on.coefficient[u][1] * local.gradient.segment<2>(P + 2);
  const Dependence& near = triangle_sparse_[t];
  for (std::size_t u = 0; u < near.unknown.size(); ++u) {
    const Eigen::MatrixXd columns = near.coefficient[u][0] * local.hessian.middleCols(P, 2) +
                                    near.coefficient[u][1] * local.hessian.middleCols(P + 2, 2);
    const int column = 2 * near.unknown[u];
    for (int k = 0; k < size; ++k) {
      const int row = variable_[ids[k]];  // control variables come after the domain's
      if (row < 0) continue;
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) assembler_.add(row + i, column + j, columns(2 * k + i, j));
    }
    for (std::size_t v = 0; v < near.unknown.size(); ++v)
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          assembler_.add(2 * near.unknown[v] + i, column + j,
                         near.coefficient[v][0] * columns(P + i, j) +
                             near.coefficient[v][1] * columns(P + 2 + i, j));
  }
}

void MapObjective::add_extra(std::size_t index, const ElementTerms& terms, double weight,
                             Eigen::VectorXd& gradient) const {
  const Dependence& on = extra_exact_[index];
  for (std::size_t u = 0; u < on.unknown.size(); ++u)
    gradient.segment<2>(2 * on.unknown[u]) +=
        weight * (on.coefficient[u][0] * terms.gradient.head<2>() +
                  on.coefficient[u][1] * terms.gradient.tail<2>());
  const Dependence& near = extra_sparse_[index];
  for (std::size_t u = 0; u < near.unknown.size(); ++u)
    for (std::size_t v = 0; v < near.unknown.size(); ++v) {
      Eigen::Matrix2d block = Eigen::Matrix2d::Zero();
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b)
          block += near.coefficient[u][a] * near.coefficient[v][b] *
                   terms.hessian.block<2, 2>(2 * a, 2 * b);
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          assembler_.add(2 * near.unknown[u] + i, 2 * near.unknown[v] + j, weight * block(i, j));
    }
}

// Gauss-Newton: d is linear in the control points, and in the domain its second derivatives are
// multiplied by d itself, which tends to zero.
double MapObjective::add_edge(std::size_t index, const Eigen::VectorXd& x,
                              const PointMatrix& domain, Eigen::VectorXd& gradient) const {
  struct Entry {
    int variable;
    double dx, dy;  // derivative of d.x and d.y
  };
  const C1Edge& e = edges_[index];
  const auto v = edge_points(e, domain);
  const Eigen::Vector3d g = barycentric(v[0], v[1], v[2], v[3]);
  Eigen::Matrix<double, 2, 8> dg;
  if (domain_variables_) dg = barycentric_derivative(v[0], v[1], v[2], v[3]);
  double sum = 0;
  std::vector<Entry> exact, sparse;
  for (int i = 0; i < e.equations(); ++i) {
    const int ids[4] = {e.outer[i], e.edge[i], e.edge[i + 1], e.inner[i]};
    const double factor[4] = {1, -g[0], -g[1], -g[2]};
    Point p[4], d = Point::Zero();
    exact.clear();
    sparse.clear();
    for (int k = 0; k < 4; ++k) {
      p[k] = control_at(ids[k], x);
      if (k != 1) d += factor[k] * (p[k] - control_at(ids[1], x));
      if (variable_[ids[k]] < 0) continue;
      for (auto* list : {&exact, &sparse}) {
        list->push_back({variable_[ids[k]], factor[k], 0});
        list->push_back({variable_[ids[k]] + 1, 0, factor[k]});
      }
    }
    if (domain_variables_) {
      const Point along = p[2] - p[1], across = p[3] - p[1];
      for (auto [list, layout] : {std::pair(&exact, &layout_.exact), {&sparse, &layout_.sparse}})
        for (int k = 0; k < 4; ++k)
          for (DomainLayout::Matrix::InnerIterator it(*layout, e.vertex[k]); it; ++it)
            for (int c = 0; c < 2; ++c) {
              const Point slope =
                  -it.value() * (along * dg(0, 2 * k + c) + across * dg(1, 2 * k + c));
              list->push_back({2 * static_cast<int>(it.col()) + c, slope.x(), slope.y()});
            }
    }
    const double weight = edge_weight_[index];
    Point pull = rho * d;
    sum += weight * 0.5 * rho * d.squaredNorm();
    if (!multipliers.empty()) {
      const Point& m = multipliers[first_equation_[index] + i];
      sum += weight * m.dot(d);
      pull += m;
    }
    for (const Entry& a : exact)
      gradient[a.variable] += weight * (a.dx * pull.x() + a.dy * pull.y());
    // A variable may appear twice in the list; the products below still add up to J^T J, because
    // the assembler adds both (a, b) and (b, a) when they fall in the lower half.
    for (const Entry& a : sparse)
      for (const Entry& b : sparse)
        assembler_.add(a.variable, b.variable, weight * rho * (a.dx * b.dx + a.dy * b.dy));
  }
  return sum;
}

double MapObjective::derivatives(const Eigen::VectorXd& x, Eigen::VectorXd& gradient,
                                 SparseMatrix& hessian) const {
  const PointMatrix domain = domain_points(x);
  const int P = 2 * mesh_.net_size();
  gradient.setZero(variables_);
  assembler_.start(variables_);
  std::vector<Local> locals(mesh_.triangle_count());
  parallel_for(locals.size(), [&](std::size_t t) {
    Local& local = locals[t];
    energy_.derivatives(net_at(static_cast<int>(t), x), triangle_matrix(domain, mesh_.triangles[t]),
                        local.value, local.gradient, local.hessian);
    if (!domain_variables_) {
      local.gradient.conservativeResize(P);
      local.hessian = local.hessian.topLeftCorner(P, P).eval();
    }
    if (exponent != 1) {
      // r (f/r)^p: slope p (f/r)^(p-1), curvature p (p-1) (f/r)^(p-2) / r.
      const double p = exponent, f = local.value / reference, power = std::pow(f, p - 2);
      local.hessian =
          p * power *
          (f * local.hessian + (p - 1) / reference * local.gradient * local.gradient.transpose());
      local.gradient *= p * power * f;
      local.value = reference * power * f * f;
    }
    project_to_semidefinite(local.hessian);
    local.gradient *= triangle_weight_[t];
    local.hessian *= triangle_weight_[t];
    local.value *= triangle_weight_[t];
  });
  double sum = 0;
  for (int t = 0; t < mesh_.triangle_count(); ++t) {
    sum += locals[t].value;
    add_triangle(t, locals[t], gradient);
  }
  if (domain_variables_) {
    const PointMatrix points = layout_.exact * unflatten(x.head(domain_variables_));
    for (std::size_t k = 0; k < extras_.size(); ++k) {
      ElementTerms terms = evaluate_element(extras_[k], columns_of(extras_[k], points), 1, 0);
      project_to_semidefinite(terms.hessian);
      sum += extras_[k].weight * terms.value;
      add_extra(k, terms, extras_[k].weight, gradient);
    }
  }
  for (std::size_t k = 0; k < edges_.size(); ++k) sum += add_edge(k, x, domain, gradient);
  hessian = assembler_.finish();
  return sum;
}

}  // namespace c1mesh
