// SPDX-License-Identifier: GPL-3.0-or-later
// Bernstein coefficients in intervals, bisection where one of det J is not positive, rationals as
// the last word (Johnen, Remacle, Geuzaine 2013).
#include "verify/triangle_proofs.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "base/float_traps.h"
#include "verify/exact.h"
#include "verify/interval.h"
#include "verify/proof_tree.h"
#include "verify/rounding.h"

namespace c1mesh::verification {
namespace {

constexpr int kMostPieces = 4096;  // of one triangle, per number type
constexpr double kInfinity = std::numeric_limits<double>::infinity();

int sign_of(const Interval& x) {
  return certainly_positive(x) ? 1 : x.sup() <= 0 ? -1 : 0;
}
int sign_of(const Rational& x) {
  return sgn(x) > 0 ? 1 : -1;
}

/// May be negative: a bound from below whatever the sign.
double lower(const Interval& x) {
  return x.inf();
}
double lower(const Rational& x) {
  return sgn(x) >= 0 ? below(x) : -magnitude_above(x);
}

Interval larger(const Interval& x, const Interval& y) {
  return {std::max(x.inf(), y.inf()), std::max(x.sup(), y.sup())};
}
Rational larger(const Rational& x, const Rational& y) {
  return x < y ? y : x;
}
Interval smaller(const Interval& x, const Interval& y) {
  return {std::min(x.inf(), y.inf()), std::min(x.sup(), y.sup())};
}
Rational smaller(const Rational& x, const Rational& y) {
  return x < y ? x : y;
}

template <class Number>
Vec<Number> number(const Point& p) {
  return {Number(p.x()), Number(p.y())};
}

/// With F the domain triangle's edge vectors (p1-p0, p2-p0) and C the derivative over the unit
/// triangle, J = C F^-1 = C adj(F) / frame: det J = det / frame and |J|^2 = norm / frame^2.
template <class Number>
struct Forms {
  std::vector<Number> det, norm;  ///< Bernstein coefficients of det C and |C adj(F)|^2
  Number frame;                   ///< det F

  Number least_det() const {
    Number out = det[0];
    for (const Number& c : det) out = smaller(out, c);
    return out;
  }
  Number most_norm() const {
    Number out = norm[0];
    for (const Number& c : norm) out = larger(out, c);
    return out;
  }
  bool positive() const {
    return std::all_of(det.begin(), det.end(), [](const Number& c) { return sign_of(c) > 0; });
  }
  /// Not above det J.
  double det_bound() const {
    return sign_of(frame) > 0 ? lower(Number(least_det() / frame)) : -kInfinity;
  }
  /// Not below |J|^2 / det J.
  double distortion_bound() const {
    const Number least = least_det();
    if (sign_of(frame) <= 0 || sign_of(least) <= 0) return kInfinity;
    return above(Number(most_norm() / (frame * least)));
  }
};

template <class Number>
Forms<Number> forms_of(const Result& result, const ProductRule& rule, int t) {
  std::vector<Vec<Number>> net;
  for (const int id : result.triangle_control_points[t])
    net.push_back(number<Number>(result.control_points[id]));
  std::array<Vec<Number>, 3> corner;
  for (int k = 0; k < 3; ++k)
    corner[k] = number<Number>(result.domain_vertices[result.triangles[t][k]]);
  const Vec<Number> u{corner[1][0] - corner[0][0], corner[1][1] - corner[0][1]};
  const Vec<Number> v{corner[2][0] - corner[0][0], corner[2][1] - corner[0][1]};
  const auto d = derivative_forms(rule.degree + 1, net);
  // Rows of C adj(F): for each coordinate k, (C_k0 v_y - C_k1 u_y, C_k1 u_x - C_k0 v_x).
  std::vector<std::array<Number, 4>> rows;
  for (std::size_t a = 0; a < d[0].size(); ++a) {
    std::array<Number, 4> row;
    for (int k = 0; k < 2; ++k) {
      row[2 * k] = d[0][a][k] * v[1] - d[1][a][k] * u[1];
      row[2 * k + 1] = d[1][a][k] * u[0] - d[0][a][k] * v[0];
    }
    rows.push_back(std::move(row));
  }
  Forms<Number> out;
  out.det = det_form(rule, net);
  out.norm = product_form<Number>(rule, [&](std::size_t a, std::size_t b) {
    return Number(rows[a][0] * rows[b][0] + rows[a][1] * rows[b][1] + rows[a][2] * rows[b][2] +
                  rows[a][3] * rows[b][3]);
  });
  out.frame = u[0] * v[1] - u[1] * v[0];
  return out;
}

/// Is det C positive on the whole triangle? Coefficients at corners are values of the form.
template <class Number>
Verdict prove(int degree, const Forms<Number>& now, int depth, ProofTree& tree,
              TriangleProof& proof) {
  switch (tree.step(depth, [&] { return now.positive(); })) {
    case ProofTree::Step::proven:
      proof.det = std::min(proof.det, now.det_bound());
      proof.g = std::max(proof.g, now.distortion_bound());
      return Verdict::valid;
    case ProofTree::Step::fail:
      return Verdict::undecided;
    case ProofTree::Step::split:
      break;
  }
  for (const int corner : {0, degree, static_cast<int>(now.det.size()) - 1}) {
    if (sign_of(now.det[corner]) < 0) return Verdict::invalid;
    // Bisection would not sharpen the value at a corner.
    if (sign_of(now.det[corner]) == 0) return Verdict::undecided;
  }
  auto dets = halves(degree, now.det), norms = halves(degree, now.norm);
  for (int k = 0; k < 2; ++k) {
    const Forms<Number> half{std::move(dets[k]), std::move(norms[k]), now.frame};
    const Verdict verdict = prove(degree, half, depth + 1, tree, proof);
    if (verdict != Verdict::valid) return verdict;
  }
  return Verdict::valid;
}

template <class Number>
TriangleFinding examine(const Subject& subject, const ProductRule& rule, int t,
                        const TriangleProof* given) {
  const Forms<Number> forms = forms_of<Number>(subject.result, rule, t);
  ProofTree tree(subject.options.max_subdivision, kMostPieces);
  if (given) tree.follow(given->marks);
  TriangleFinding out;
  out.proof.det = kInfinity;
  out.regular = prove(2 * rule.degree, forms, 0, tree, out.proof);
  out.proof.depth = tree.depth();
  out.proof.marks = tree.marks();
  if (out.regular != Verdict::valid) {
    out.proof.det = -kInfinity;
    out.proof.g = kInfinity;
  }
  out.most_distortion = forms.distortion_bound();
  out.least_coefficient = forms.det_bound();
  out.record_holds = !given || (out.regular == Verdict::valid && tree.complete() &&
                                out.proof.depth == given->depth && out.proof.det >= given->det &&
                                out.proof.g <= given->g);
  return out;
}

/// Intervals leave a domain triangle undecided that is nearly flat: then rationals bound it too.
bool settled(const TriangleFinding& finding) {
  const bool finite = finding.proof.g < kInfinity && finding.proof.det > -kInfinity;
  return finding.regular == Verdict::invalid ||
         (finding.regular == Verdict::valid && finite && finding.record_holds);
}

}  // namespace

std::vector<TriangleFinding> examine_triangles(const Subject& subject) {
  // Any file is examined, also one whose numbers are near overflow: unbounded intervals prove
  // nothing.
  const FloatTrapsOff unbounded;
  const ProductRule rule(subject.degree() - 1);
  std::vector<TriangleFinding> out;
  out.reserve(subject.result.triangles.size());
  for (int t = 0; t < static_cast<int>(subject.result.triangles.size()); ++t) {
    const TriangleProof* given = subject.given ? &subject.given->triangles[t] : nullptr;
    {
      const RoundOutward rounding;
      out.push_back(examine<Interval>(subject, rule, t, given));
    }
    if (settled(out.back())) continue;
    out.back() = examine<Rational>(subject, rule, t, given);
    out.back().proof.rational = true;
  }
  return out;
}

}  // namespace c1mesh::verification
