// SPDX-License-Identifier: GPL-3.0-or-later
// Bernstein algebra of the verification, over any number type: doubles measure, intervals certify,
// rationals decide. Nothing here is shared with the code that makes results.
#pragma once

#include <array>
#include <utility>
#include <vector>

namespace c1mesh::verification {

template <class Number>
using Vec = std::array<Number, 2>;

/// Position of the coefficient with exponents (n-i-j, i, j) at corners (0, 1, 2) of degree n.
constexpr int net_index(int n, int i, int j) {
  return j * (n + 1) - j * (j - 1) / 2 + i;
}

/// Position of the coefficient of degree n with exponents (n-second-third, second, third) at the
/// corners (k, k+1, k+2) of the triangle, indices modulo 3.
inline int turned_index(int n, int k, int second, int third) {
  std::array<int, 3> exponent;
  exponent[k] = n - second - third;
  exponent[(k + 1) % 3] = second;
  exponent[(k + 2) % 3] = third;
  return net_index(n, exponent[1], exponent[2]);
}

/// n! / (i! j! (n-i-j)!), an exact double for n <= 28.
inline double multinomial(int n, int i, int j) {
  const auto binomial = [](int a, int b) {
    double c = 1;
    for (int s = 1; s <= b; ++s) c = c * (a - b + s) / s;  // exact: each is a binomial coefficient
    return c;
  };
  return binomial(n, i) * binomial(n - i, j);
}

/// For each pair of Bernstein polynomials of degree m: where their product goes among those of
/// degree 2m, and its weight B_a B_b = (factor[a] factor[b] / divisor[target]) B_target.
struct ProductRule {
  explicit ProductRule(int m) : degree(m) {
    std::vector<std::pair<int, int>> index;
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= m - j; ++i) {
        index.emplace_back(i, j);
        factor.push_back(multinomial(m, i, j));
      }
    for (int j = 0; j <= 2 * m; ++j)
      for (int i = 0; i <= 2 * m - j; ++i) divisor.push_back(multinomial(2 * m, i, j));
    for (const auto& a : index)
      for (const auto& b : index)
        target.push_back(net_index(2 * m, a.first + b.first, a.second + b.second));
  }

  int degree;
  std::vector<double> factor, divisor;
  std::vector<int> target;  ///< [a * factor.size() + b]
};

/// The control vectors p_(i+1)j - p_ij and p_i(j+1) - p_ij of a net of degree n, each times n: the
/// Bernstein coefficients of the two columns of the derivative over the unit triangle.
template <class Number>
std::array<std::vector<Vec<Number>>, 2> derivative_forms(int n,
                                                         const std::vector<Vec<Number>>& net) {
  std::array<std::vector<Vec<Number>>, 2> out;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n - j; ++i) {
      const Vec<Number>& from = net[net_index(n, i, j)];
      const Vec<Number>& u = net[net_index(n, i + 1, j)];
      const Vec<Number>& v = net[net_index(n, i, j + 1)];
      out[0].push_back({Number(n) * (u[0] - from[0]), Number(n) * (u[1] - from[1])});
      out[1].push_back({Number(n) * (v[0] - from[0]), Number(n) * (v[1] - from[1])});
    }
  return out;
}

/// The Bernstein coefficients, of degree 2m, of sum_ab value(a, b) B_a B_b.
template <class Number, class Value>
std::vector<Number> product_form(const ProductRule& rule, const Value& value) {
  std::vector<Number> sum(rule.divisor.size(), Number(0));
  const std::size_t size = rule.factor.size();
  for (std::size_t a = 0; a < size; ++a)
    for (std::size_t b = 0; b < size; ++b)
      sum[rule.target[a * size + b]] +=
          Number(rule.factor[a]) * Number(rule.factor[b]) * value(a, b);
  for (std::size_t c = 0; c < sum.size(); ++c) sum[c] /= Number(rule.divisor[c]);
  return sum;
}

/// det of the derivative over the unit triangle: (2n-1) n coefficients of degree 2n-2.
template <class Number>
std::vector<Number> det_form(const ProductRule& rule, const std::vector<Vec<Number>>& net) {
  const auto d = derivative_forms(rule.degree + 1, net);
  return product_form<Number>(rule, [&](std::size_t a, std::size_t b) {
    return Number(d[0][a][0] * d[1][b][1] - d[0][a][1] * d[1][b][0]);
  });
}

/// A triangle's form halved at the middle of its edge 01: with m that point, the forms over
/// (2, 0, m) and (1, 2, m). Their edges 01 are the old edges 20 and 12, so halving again and again
/// halves all edges in turn and the triangles shrink in every direction.
template <class Number>
std::array<std::vector<Number>, 2> halves(int n, const std::vector<Number>& form) {
  std::array<std::vector<Number>, 2> out{form, form};
  for (int j = 0; j <= n; ++j) {
    // Row j is a univariate form of degree n-j along the edge: de Casteljau at 1/2. After `level`
    // steps its first value belongs to (0^(n-j-level) m^level), its last to (m^level 1^...).
    std::vector<Number> row(form.begin() + net_index(n, 0, j),
                            form.begin() + net_index(n, 0, j) + n - j + 1);
    for (int level = 0; level <= n - j; ++level) {
      const int rest = n - j - level;
      out[0][net_index(n, rest, level)] = row[0];  // corners (2, 0, m): exponents (j, rest, level)
      out[1][net_index(n, j, level)] = row[rest];  // corners (1, 2, m): exponents (rest, j, level)
      for (int i = 0; i < rest; ++i) row[i] = (row[i] + row[i + 1]) / Number(2);
    }
  }
  return out;
}

}  // namespace c1mesh::verification
