// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/smooth_norm.h"

#include <random>

#include "finite_differences.h"

namespace c1mesh {
namespace {

constexpr double kEpsilons[] = {1e-1, 1e-3, 1e-6, 1e-9};

// Points of lengths from far below to far above epsilon.
std::vector<Point> points_around(double epsilon, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angle(-3.1, 3.1), decade(-3, 3);
  std::vector<Point> out;
  for (int k = 0; k < 40; ++k) {
    const double a = angle(random), r = epsilon * std::pow(10, decade(random));
    out.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  return out;
}

TEST(SmoothNorm, IsBetweenTheNormLessEpsilonAndTheNorm) {
  for (const double epsilon : kEpsilons)
    for (const Point& d : points_around(epsilon, 1)) {
      const double value = SmoothNorm(d, epsilon).value;
      EXPECT_EQ(value, SmoothNorm::at(d, epsilon));
      EXPECT_LE(value, d.norm() * (1 + 1e-15));
      EXPECT_GE(value, d.norm() - epsilon * (1 + 1e-15));
      EXPECT_GT(value, 0);
    }
  EXPECT_EQ(SmoothNorm(Point::Zero(), 1e-6).value, 0);
}

// Far below epsilon it is |d|^2 / (2 epsilon), to full relative precision; (3, 4, 12) and 13 give a
// closed form.
TEST(SmoothNorm, HasNoCancellation) {
  const Point d(3e-9, -4e-9);
  EXPECT_NEAR(SmoothNorm::at(d, 1) / (25e-18 / 2), 1, 1e-15);
  EXPECT_NEAR(SmoothNorm::at({3, 4}, 12), 1, 1e-15);
}

TEST(SmoothNorm, GradientMatchesDifferences) {
  for (const double epsilon : kEpsilons)
    for (const Point& d : points_around(epsilon, 2)) {
      const SmoothNorm norm(d, epsilon);
      const auto value = [&](const Eigen::VectorXd& x) { return SmoothNorm::at(x, epsilon); };
      EXPECT_LT(testing_tools::gradient_error(value, norm.gradient, d, 1e-5 * (epsilon + d.norm())),
                1e-9);
    }
}

// m(x) = value + gradient.(x - d) + majoriser/2 |x - d|^2 touches at d and is nowhere below: the
// least of m is a point with a lower value. No smaller factor would do: at x = -d they meet again.
TEST(SmoothNorm, QuadraticIsAMajoriserAndTheLeastOne) {
  for (const double epsilon : kEpsilons) {
    const auto to = points_around(epsilon, 4);
    for (const Point& d : points_around(epsilon, 3)) {
      const SmoothNorm norm(d, epsilon);
      const auto model = [&](const Point& x) {
        return norm.value + norm.gradient.dot(x - d) + 0.5 * norm.majoriser * (x - d).squaredNorm();
      };
      EXPECT_EQ(model(d), norm.value);
      for (const Point& x : to)
        EXPECT_GE(model(x), SmoothNorm::at(x, epsilon) - 1e-14 * (x.norm() + d.norm() + epsilon));
      EXPECT_NEAR(model(-d), norm.value, 1e-14 * (d.norm() + epsilon));
    }
  }
}

}  // namespace
}  // namespace c1mesh
