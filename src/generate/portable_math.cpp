// SPDX-License-Identifier: GPL-3.0-or-later
#include "generate/portable_math.h"

#include <cmath>
#include <numbers>

namespace c1mesh::generate_detail {
namespace {

// Taylor series, by Horner from the last term that counts in a double.
double sine(double x) {  // |x| <= pi / 4
  double sum = 1;
  for (int k = 20; k >= 2; k -= 2) sum = 1 - x * x / (k * (k + 1)) * sum;
  return x * sum;
}

double cosine(double x) {
  double sum = 1;
  for (int k = 19; k >= 1; k -= 2) sum = 1 - x * x / (k * (k + 1)) * sum;
  return sum;
}

double exponential(double x) {
  const double n = std::floor(x / std::numbers::ln2 + 0.5), r = x - n * std::numbers::ln2;
  double sum = 1;
  for (int k = 20; k >= 1; --k) sum = 1 + r / k * sum;
  return std::ldexp(sum, static_cast<int>(n));
}

// ln x = e ln 2 + 2 artanh((m - 1) / (m + 1)) with x = m 2^e and m near 1.
double logarithm(double x) {
  int e;
  double m = std::frexp(x, &e);
  if (m < std::numbers::sqrt2 / 2) m *= 2, --e;
  const double z = (m - 1) / (m + 1);
  double sum = 0;
  for (int k = 27; k >= 1; k -= 2) sum = 1.0 / k + z * z * sum;
  return e * std::numbers::ln2 + 2 * z * sum;
}

}  // namespace

Point unit_at(double degrees) {
  const double quarter = std::floor(degrees / 90 + 0.5);
  const double x = (degrees - 90 * quarter) * (std::numbers::pi / 180);
  const double c = cosine(x), s = sine(x);
  switch (static_cast<int>(quarter - 4 * std::floor(quarter / 4))) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

double in_equal_ratios(double first, double last, double t) {
  if (t <= 0) return first;
  if (t >= 1) return last;
  return first * exponential(t * logarithm(last / first));
}

double length(const Point& v) {
  return std::sqrt(v.x() * v.x() + v.y() * v.y());
}

}  // namespace c1mesh::generate_detail
