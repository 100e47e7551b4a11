// SPDX-License-Identifier: GPL-3.0-or-later
// det J > 0 on every closed triangle, proven: Bernstein coefficients in intervals, bisection where
// one is not positive, rationals as the last word (Johnen, Remacle, Geuzaine 2013).
#include <utility>

#include "verify/checks.h"
#include "verify/exact.h"
#include "verify/interval.h"

namespace c1mesh::verification {
namespace {

constexpr int kMostPieces = 4096;  // of one triangle, per number type

int sign_of(const Interval& x) {
  return certainly_positive(x) ? 1 : x.sup() <= 0 ? -1 : 0;
}
int sign_of(const Rational& x) {
  return sgn(x) > 0 ? 1 : -1;
}

/// Is the form positive on its whole triangle? `sign_of` is -1 where a value is proven not positive
/// and 0 where it is not known; coefficients at corners are values of the form.
template <class Number>
Verdict positive(int degree, std::vector<Number> form, int max_depth) {
  std::vector<std::pair<std::vector<Number>, int>> pending;
  pending.emplace_back(std::move(form), 0);
  int pieces = 0;
  while (!pending.empty()) {
    const auto [now, depth] = std::move(pending.back());
    pending.pop_back();
    bool all = true;
    for (const Number& c : now) all = all && sign_of(c) > 0;
    if (all) continue;
    for (const int corner : {0, degree, static_cast<int>(now.size()) - 1}) {
      if (sign_of(now[corner]) < 0) return Verdict::invalid;
      // Bisection would not sharpen the value at a corner.
      if (sign_of(now[corner]) == 0) return Verdict::undecided;
    }
    if (depth >= max_depth || ++pieces > kMostPieces) return Verdict::undecided;
    for (auto& half : halves(degree, now)) pending.emplace_back(std::move(half), depth + 1);
  }
  return Verdict::valid;
}

template <class Number>
std::vector<Vec<Number>> net_of(const Result& result, int t) {
  std::vector<Vec<Number>> net;
  for (const int id : result.triangle_control_points[t]) {
    const Point& p = result.control_points[id];
    net.push_back({Number(p.x()), Number(p.y())});
  }
  return net;
}

Verdict certify(const Result& result, const ProductRule& rule, int t, int max_depth) {
  const int degree = 2 * rule.degree;
  {
    const RoundOutward rounding;
    const Verdict verdict =
        positive(degree, det_form(rule, net_of<Interval>(result, t)), max_depth);
    if (verdict != Verdict::undecided) return verdict;
  }
  return positive(degree, det_form(rule, net_of<Rational>(result, t)), max_depth);
}

}  // namespace

VerifyItem check_regularity(const Subject& subject) {
  const ProductRule rule(subject.degree() - 1);
  std::vector<int> invalid, undecided;
  for (int t = 0; t < static_cast<int>(subject.result.triangles.size()); ++t) {
    const Verdict verdict = certify(subject.result, rule, t, subject.options.max_subdivision);
    if (verdict == Verdict::invalid) invalid.push_back(t);
    if (verdict == Verdict::undecided) undecided.push_back(t);
  }
  const std::string name = "regularity";
  if (!invalid.empty())
    return {
        name, Verdict::invalid,
        fmt::format("det J is not positive in {} triangles: {}", invalid.size(), id_text(invalid))};
  if (!undecided.empty())
    return {name, Verdict::undecided,
            fmt::format("not decided in {} triangles: {}", undecided.size(), id_text(undecided))};
  return {name, Verdict::valid, "det J is positive on every triangle, proven"};
}

}  // namespace c1mesh::verification
