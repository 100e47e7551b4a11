// SPDX-License-Identifier: GPL-3.0-or-later
// poisson RESULT.c1.json: finite elements on a mapped domain. Solves -(u_xx + u_yy) = f in the
// shape, u given on its boundary, for a solution that is known, and prints the error as the
// elements get smaller.
#include <c1mesh/c1mesh.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "quadrature.h"

namespace {

using c1mesh::Barycentric;
using c1mesh::Point;

// 1. The problem: a solution that no polynomial is, and what it asks for.
struct Problem {
  Point centre;
  double k;  // waves over the size of the shape

  explicit Problem(const c1mesh::Box& box)
      : centre((box.low + box.high) / 2), k(std::numbers::pi / (box.high - box.low).maxCoeff()) {}
  double solution(const Point& p) const {
    const Point q = p - centre;
    return std::sin(k * q.x() + 0.3) * std::cos(k * q.y() - 0.2);
  }
  double f(const Point& p) const { return 2 * k * k * solution(p); }
};

// 2. The basis: the Bernstein polynomials of degree n on a triangle, in the order of a net.
struct Basis {
  std::vector<double> value;
  std::vector<std::array<double, 3>> slope;  // by the barycentric coordinates
};

double bernstein(int n, const std::array<int, 3>& power, const Barycentric& at) {
  double out = 1;
  int factor = n;
  for (int k = 0; k < 3; ++k) {
    if (power[k] < 0) return 0;
    for (int m = 1; m <= power[k]; ++m) out *= at[k] * factor-- / m;
  }
  return out;
}

Basis basis_at(int n, const Barycentric& at) {
  Basis basis;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n - j; ++i) {
      const std::array<int, 3> power = {n - i - j, i, j};
      basis.value.push_back(bernstein(n, power, at));
      std::array<double, 3> slope;
      for (int k = 0; k < 3; ++k) {
        std::array<int, 3> lower = power;
        --lower[k];
        slope[k] = n * bernstein(n - 1, lower, at);
      }
      basis.slope.push_back(slope);
    }
  return basis;
}

// 3. The elements: every triangle of the result cut into pieces^2, in the domain, where triangles
// are straight. The map stays as it is. An unknown is a point of the lattice (a, b, c) / (n pieces)
// of a triangle; triangles that share an edge share the lattice on it, so the functions are
// continuous.
struct Element {
  int triangle;                       // of the result
  std::array<Barycentric, 3> corner;  // in that triangle
  std::vector<int> unknowns;          // in the order of a net
};

using Weights = std::array<int, 3>;

class Space {
 public:
  Space(const c1mesh::Result& result, int pieces)
      : result_(result), n_(result.degree), pieces_(pieces) {
    for (int t = 0; t < static_cast<int>(result.triangles.size()); ++t)
      for (int j = 0; j < pieces; ++j)
        for (int i = 0; i < pieces - j; ++i) {
          add(t, {i, j}, {i + 1, j}, {i, j + 1});
          if (i + j + 2 <= pieces) add(t, {i + 1, j + 1}, {i, j + 1}, {i + 1, j});
        }
  }

  const std::vector<Element>& elements() const { return elements_; }
  int unknowns() const { return static_cast<int>(ids_.size()); }
  int degree() const { return n_; }
  int pieces() const { return pieces_; }

  /// The unknown at these weights (sum n pieces) of three vertices of the domain mesh.
  int unknown(const std::array<int, 3>& vertices, const Weights& weights) {
    std::map<int, int> where;
    for (int k = 0; k < 3; ++k)
      if (weights[k] > 0) where[vertices[k]] = weights[k];
    return ids_.emplace(where, unknowns()).first->second;
  }

 private:
  void add(int t, std::array<int, 2> a, std::array<int, 2> b, std::array<int, 2> c) {
    Element element{t, {}, {}};
    std::array<Weights, 3> corner;
    const std::array<std::array<int, 2>, 3> places = {a, b, c};
    for (int k = 0; k < 3; ++k) {
      const auto& [i, j] = places[k];
      corner[k] = {pieces_ - i - j, i, j};
      element.corner[k] = Barycentric(corner[k][0], corner[k][1], corner[k][2]) / pieces_;
    }
    for (int j = 0; j <= n_; ++j)
      for (int i = 0; i <= n_ - j; ++i) {
        Weights w;
        for (int k = 0; k < 3; ++k)
          w[k] = (n_ - i - j) * corner[0][k] + i * corner[1][k] + j * corner[2][k];
        element.unknowns.push_back(unknown(result_.triangles[t], w));
      }
    elements_.push_back(std::move(element));
  }

  const c1mesh::Result& result_;
  const int n_, pieces_;
  std::vector<Element> elements_;
  std::map<std::map<int, int>, int> ids_;  // vertex -> weight of a lattice point
};

// 4. A quadrature point of an element: where it is, what it weighs, and the gradients of the basis
// in the shape: those by (u, v) times the inverse of the Jacobian.
struct Sample {
  Point xy;
  double weight;
  std::vector<double> value;
  std::vector<Point> gradient;
};

std::vector<Sample> samples_of(const c1mesh::Map& map, const Element& element, int n) {
  std::array<Point, 3> uv;
  for (int k = 0; k < 3; ++k) uv[k] = map.at(element.triangle, element.corner[k]).uv;
  Eigen::Matrix2d frame;  // (s, t) -> (u, v)
  frame << uv[1] - uv[0], uv[2] - uv[0];
  std::vector<Sample> out;
  for (const TrianglePoint& p : gauss_triangle(n + 2)) {
    Barycentric at = Barycentric::Zero();
    for (int k = 0; k < 3; ++k) at += p.at[k] * element.corner[k];
    const c1mesh::Jet jet = map.jet(map.at(element.triangle, at));
    const Eigen::Matrix2d local = jet.jacobian * frame;  // d(x, y) / d(s, t)
    const Eigen::Matrix2d back = local.inverse().transpose();
    Basis basis = basis_at(n, p.at);
    Sample sample{jet.value, p.weight * local.determinant(), std::move(basis.value), {}};
    for (const auto& slope : basis.slope)
      sample.gradient.push_back(back * Point(slope[1] - slope[0], slope[2] - slope[0]));
    out.push_back(std::move(sample));
  }
  return out;
}

// 5. Values on the boundary: on each piece of an edge the polynomial that agrees with the solution
// at n + 1 points.
std::map<int, double> boundary_values(const c1mesh::Result& result, const c1mesh::Map& map,
                                      Space& space, const Problem& problem) {
  std::map<std::pair<int, int>, std::pair<int, int>> corner_of;  // edge -> triangle, its corner
  for (int t = 0; t < map.triangles(); ++t)
    for (int k = 0; k < 3; ++k)
      corner_of[{result.triangles[t][k], result.triangles[t][(k + 1) % 3]}] = {t, k};
  const int n = space.degree(), pieces = space.pieces();
  Eigen::MatrixXd collocation(n + 1, n + 1);
  for (int row = 0; row <= n; ++row)
    for (int i = 0; i <= n; ++i) {
      const double s = static_cast<double>(row) / n;
      collocation(row, i) = bernstein(n, {n - i, i, 0}, Barycentric(1 - s, s, 0));
    }
  const Eigen::PartialPivLU<Eigen::MatrixXd> factors(collocation);
  std::map<int, double> values;
  for (const c1mesh::CurveEdge& edge : result.boundary_edges) {
    const auto [t, k] = corner_of.at({edge.a, edge.b});
    for (int piece = 0; piece < pieces; ++piece) {
      Eigen::VectorXd g(n + 1);
      for (int m = 0; m <= n; ++m) {
        const double s = (piece + static_cast<double>(m) / n) / pieces;
        Barycentric at = Barycentric::Zero();
        at[k] = 1 - s;
        at[(k + 1) % 3] = s;
        g[m] = problem.solution(map.evaluate(map.at(t, at)));
      }
      const Eigen::VectorXd c = factors.solve(g);
      for (int m = 0; m <= n; ++m) {
        const int w = piece * n + m;
        values[space.unknown({edge.a, edge.b, edge.a}, {n * pieces - w, w, 0})] = c[m];
      }
    }
  }
  return values;
}

// 6. Assembly and solution: the sum over test functions v inside of grad u . grad v = f v.
Eigen::VectorXd solve(const c1mesh::Map& map, const Space& space, const Problem& problem,
                      const std::map<int, double>& given) {
  std::vector<int> row(space.unknowns(), -1);
  int rows = 0;
  Eigen::VectorXd u(space.unknowns());
  for (int id = 0; id < space.unknowns(); ++id) {
    const auto found = given.find(id);
    if (found == given.end())
      row[id] = rows++;
    else
      u[id] = found->second;
  }
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(rows);
  for (const Element& element : space.elements())
    for (const Sample& sample : samples_of(map, element, space.degree()))
      for (std::size_t i = 0; i < element.unknowns.size(); ++i) {
        const int r = row[element.unknowns[i]];
        if (r < 0) continue;
        right[r] += sample.weight * problem.f(sample.xy) * sample.value[i];
        for (std::size_t j = 0; j < element.unknowns.size(); ++j) {
          const double entry = sample.weight * sample.gradient[i].dot(sample.gradient[j]);
          const int id = element.unknowns[j];
          if (row[id] < 0)
            right[r] -= entry * u[id];
          else
            entries.emplace_back(r, row[id], entry);
        }
      }
  Eigen::SparseMatrix<double> matrix(rows, rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  const Eigen::VectorXd inside = factors.solve(right);
  for (int id = 0; id < space.unknowns(); ++id)
    if (row[id] >= 0) u[id] = inside[row[id]];
  return u;
}

// 7. The error: the root of the integral of (u_h - u)^2, relative to that of u^2.
double relative_error(const c1mesh::Map& map, const Space& space, const Problem& problem,
                      const Eigen::VectorXd& u) {
  double error = 0, size = 0;
  for (const Element& element : space.elements())
    for (const Sample& sample : samples_of(map, element, space.degree())) {
      double value = 0;
      for (std::size_t i = 0; i < element.unknowns.size(); ++i)
        value += u[element.unknowns[i]] * sample.value[i];
      const double exact = problem.solution(sample.xy);
      error += sample.weight * (value - exact) * (value - exact);
      size += sample.weight * exact * exact;
    }
  return std::sqrt(error / size);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: poisson RESULT.c1.json\n";
    return 2;
  }
  const c1mesh::Result result = c1mesh::read_result(argv[1]);
  const c1mesh::Map map(result);
  const Problem problem(map.shape_box());
  double last = 0, order = 0;
  for (const int pieces : {1, 2, 4}) {
    Space space(result, pieces);
    const std::map<int, double> given = boundary_values(result, map, space, problem);
    const Eigen::VectorXd u = solve(map, space, problem, given);
    const double error = relative_error(map, space, problem, u);
    std::cout << "elements " << space.elements().size() << ", unknowns " << space.unknowns()
              << ", relative error " << error;
    if (last > 0) {
      order = std::log2(last / error);
      std::cout << ", order " << order;
    }
    std::cout << '\n';
    last = error;
  }
  // Polynomials of degree n promise order n + 1.
  return order > map.degree() + 0.5 ? 0 : 1;
}
