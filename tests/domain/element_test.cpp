// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/element.h"

#include <Eigen/LU>
#include <random>

#include "finite_differences.h"

namespace c1mesh {
namespace {

using testing_tools::gradient_error;
using testing_tools::hessian_error;

DomainElement random_element(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  Eigen::Matrix2d S;
  S << 1 + 0.4 * number(random), 0.4 * number(random), 0.4 * number(random),
      1 + 0.4 * number(random);
  DomainElement element;
  element.metric = metric_of(S);
  element.area = S.determinant();
  element.balance = 0.3;
  return element;
}

Eigen::Matrix2d matrix(const Eigen::VectorXd& d) {
  Eigen::Matrix2d D;
  D << d[0], d[2], d[1], d[3];
  return D;
}

struct Case {
  double exponent, epsilon;
  bool inverted;
};

class Element : public testing::TestWithParam<Case> {};

TEST_P(Element, DerivativesMatchDifferencesAndHessianIsSymmetric) {
  const Case& c = GetParam();
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const DomainElement element = random_element(seed);
    Eigen::VectorXd d(4);
    d << 0.9, 0.2, -0.3, c.inverted ? -0.4 : 1.1;
    const auto value = [&](const Eigen::VectorXd& x) {
      return element_value(element, matrix(x), c.exponent, c.epsilon);
    };
    const auto gradient = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
      return evaluate_element(element, matrix(x), c.exponent, c.epsilon).gradient;
    };
    const ElementTerms terms = evaluate_element(element, matrix(d), c.exponent, c.epsilon);
    EXPECT_NEAR(terms.value, value(d), 1e-12 * terms.value);
    EXPECT_LT(gradient_error(value, terms.gradient, d, 1e-6), 1e-7);
    EXPECT_LT(hessian_error(gradient, terms.hessian, d, 1e-6), 1e-7);
    EXPECT_LE((terms.hessian - terms.hessian.transpose()).norm(), 1e-14 * terms.hessian.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Element,
                         testing::Values(Case{1, 0, false}, Case{2, 0, false}, Case{4, 0, false},
                                         Case{1, 0.3, false}, Case{1, 0.3, true},
                                         Case{1, 0.05, true}));

// MIPS of a similarity is 2, of diag(a, b) it is a/b + b/a.
TEST(ElementMetric, ValuesInClosedForm) {
  DomainElement element;
  element.metric = metric_of(Eigen::Matrix2d::Identity());
  Eigen::Matrix2d turn;
  turn << 0.6, -0.8, 0.8, 0.6;
  EXPECT_NEAR(element_value(element, 3 * turn, 1, 0), 2, 1e-14);
  const Eigen::Matrix2d stretch = Eigen::Vector2d(2, 5).asDiagonal();
  EXPECT_NEAR(element_value(element, stretch, 1, 0), 0.4 + 2.5, 1e-14);
  const Eigen::Matrix2d flipped = Eigen::Vector2d(2, -5).asDiagonal();
  EXPECT_EQ(element_value(element, flipped, 1, 0), std::numeric_limits<double>::infinity());
}

TEST(ElementMetric, ProjectionKeepsPositiveAndRemovesNegativeCurvature) {
  Eigen::Matrix4d H = Eigen::Vector4d(3, -2, 1, 0).asDiagonal();
  project_to_semidefinite(H);
  EXPECT_LT((H - Eigen::Matrix4d(Eigen::Vector4d(3, 0, 1, 0).asDiagonal())).norm(), 1e-14);
}

}  // namespace
}  // namespace c1mesh
