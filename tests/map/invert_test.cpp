// SPDX-License-Identifier: GPL-3.0-or-later
// One triangle's inverse where Newton's method alone goes astray: z -> z^n has n preimages of every
// point, of which one at most lies in the triangle.
#include "map/invert.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "result/example_results.h"

namespace c1mesh {
namespace {

using Complex = std::complex<double>;

example::Polynomial power(int n) {
  // (u + iv)^n = sum of C(n, k) u^(n-k) (iv)^k.
  example::Polynomial map;
  const Point unit[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (int k = 0; k <= n; ++k)
    map.push_back({n - k, k,
                   unit[k % 4] * (example::factorial(n) / example::factorial(k) /
                                  example::factorial(n - k))});
  return map;
}

class Powers : public testing::TestWithParam<int> {
 protected:
  const int n = GetParam();
  // Seen from 0 it spans nine tenths of the angle over which z^n is one-to-one: the image winds
  // nearly around 0.
  const double half = 0.45 * 2 * std::numbers::pi / n;
  const std::array<Complex, 3> corner = {std::polar(0.3, -half), std::polar(1.0, -half),
                                         std::polar(0.5, half)};

  Net net() const {
    const auto point = [](const Complex& z) { return Point(z.real(), z.imag()); };
    const Result result = example::polynomial_result(
        n, power(n), {point(corner[0]), point(corner[1]), point(corner[2])}, {{0, 1, 2}});
    Net out;
    for (const int id : result.triangle_control_points[0]) out.push_back(result.control_points[id]);
    return out;
  }

  Barycentric barycentric(const Complex& z) const {
    const auto times = [](const Complex& a, const Complex& b) {
      return a.real() * b.imag() - a.imag() * b.real();
    };
    const Complex a = corner[1] - corner[0], b = corner[2] - corner[0], p = z - corner[0];
    const double s = times(p, b) / times(a, b), t = times(a, p) / times(a, b);
    return {1 - s - t, s, t};
  }
};

// The image's size is 1, so its rounding is some 1e-16.
constexpr double kTolerance = 0x1p-46;

TEST_P(Powers, EveryPointInsideIsFoundAndNoneOutside) {
  const Net points = net();
  std::mt19937 chance(5);
  const auto number = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(chance()) / 4294967296.0);
  };
  int inside = 0, outside = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    // Anywhere, or the image of a place around the triangle, which may be far from its own image.
    const double s = number(-0.3, 1.3), t = number(-0.3, 1.3);
    const Complex around = (1 - s - t) * corner[0] + s * corner[1] + t * corner[2];
    const Complex image =
        trial % 2 == 0 ? Complex(number(-1.1, 1.1), number(-1.1, 1.1)) : std::pow(around, n);
    const double x = image.real(), y = image.imag();
    const Complex root = std::pow(image, 1.0 / n);
    double best = -1;  // how far inside is the root that is farthest inside
    Barycentric expected = Barycentric::Zero();
    for (int k = 0; k < n; ++k) {
      const Barycentric at = barycentric(root * std::polar(1.0, 2 * std::numbers::pi * k / n));
      if (at.minCoeff() > best) {
        best = at.minCoeff();
        expected = at;
      }
    }
    if (std::abs(best) < 1e-9) continue;
    const std::optional<Barycentric> found = invert(points, n, Point(x, y), kTolerance);
    ASSERT_EQ(found.has_value(), best > 0) << x << ", " << y;
    if (found) {
      EXPECT_LT((*found - expected).norm(), 1e-11);
    }
    (best > 0 ? inside : outside) += 1;
  }
  EXPECT_GT(inside, 300);
  EXPECT_GT(outside, 300);
}

TEST_P(Powers, PlacesOnAndNearTheEdgesComeBack) {
  const Net points = net();
  for (const double off : {0.0, 1e-15, 1e-12, 1e-9, 1e-6})
    for (int k = 0; k < 3; ++k)
      for (int step = 0; step <= 20; ++step) {
        Barycentric at;
        at[k] = off;
        at[(k + 1) % 3] = (1 - off) * step / 20.0;
        at[(k + 2) % 3] = 1 - off - at[(k + 1) % 3];
        const std::optional<Barycentric> found =
            invert(points, n, evaluate(points, n, at), kTolerance);
        ASSERT_TRUE(found) << off << " " << k << " " << step;
        EXPECT_LT((*found - at).norm(), 1e-12);
        EXPECT_GE(found->minCoeff(), -1e-12);
      }
}

INSTANTIATE_TEST_SUITE_P(Degrees, Powers, testing::Values(2, 3, 4, 5, 6));

// Not regular, so not one-to-one: whatever is found is a preimage, and the search ends.
TEST(Invert, AFoldedTriangleGivesSomePreimageOrNone) {
  // (s^2, t): two places over each point but those of s = 0.
  const Net points = {{0.25, 0}, {-0.25, 0}, {0.25, 0}, {0.25, 0.5}, {-0.25, 0.5}, {0.25, 1}};
  int found = 0;
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j) {
      const Point x(0.25 * i / 20, j / 20.0);
      const std::optional<Barycentric> at = invert(points, 2, x, kTolerance);
      if (!at) continue;
      ++found;
      EXPECT_LT((evaluate(points, 2, *at) - x).norm(), 3 * kTolerance);
    }
  EXPECT_GT(found, 50);
  EXPECT_FALSE(invert(points, 2, Point(-0.01, 0.2), kTolerance));
}

}  // namespace
}  // namespace c1mesh
