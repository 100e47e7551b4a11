// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates: what they say is true, and each single falsehood in one is found.
#include "c1mesh/certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "c1mesh/error.h"
#include "c1mesh/verify.h"
#include "result/example_results.h"

namespace c1mesh {
namespace {

Verdict certificate_verdict(const VerifyReport& report) {
  for (const VerifyItem& item : report.items)
    if (item.name == "certificate") return item.verdict;
  return Verdict::undecided;
}

template <class Change>
void expect_refused(const Result& result, const Certificate& good, const Change& change,
                    const char* what) {
  Certificate bad = good;
  change(bad);
  const VerifyReport report = recheck(result, bad);
  EXPECT_EQ(certificate_verdict(report), Verdict::invalid) << what << "\n" << report_text(report);
  EXPECT_FALSE(report.valid()) << what;
}

int control_id(const Result& r, int t, int i, int j) {
  return r.triangle_control_points[t][j * (r.degree + 1) - j * (j - 1) / 2 + i];
}

/// A square whose first triangle's coefficients of det J are not all positive, though det J is.
Result needs_a_split() {
  Result result = example::square();
  for (double shift = 0; shift < 1; shift += 0.01) {
    Result next = example::square();
    next.control_points[control_id(next, 0, 1, 1)] += Point(shift, -shift);
    const VerifyReport report = verify(next);
    if (!report.regular()) break;
    if (report.certificate.triangles[0].depth > 0) return next;
  }
  ADD_FAILURE() << "no shift needs a split";
  return result;
}

TEST(Certificate, OfTheIdentityIsKnown) {
  const Result square = example::square();
  const Certificate c = verify(square).certificate;
  ASSERT_EQ(c.triangles.size(), 2u);
  for (const TriangleProof& proof : c.triangles) {
    EXPECT_EQ(proof.depth, 0);
    EXPECT_EQ(proof.marks, "");
    EXPECT_FALSE(proof.rational);
    EXPECT_LE(proof.det, 1 + 1e-15);
    EXPECT_GE(proof.det, 1 - 1e-14);
    EXPECT_GE(proof.g, 2 - 1e-15);
    EXPECT_LE(proof.g, 2 + 1e-14);
  }
  EXPECT_EQ(c.edges.size(), 1u);        // the diagonal
  EXPECT_EQ(c.curve_edges.size(), 4u);  // the sides
  EXPECT_EQ(c.conformance, 0);
  EXPECT_TRUE(recheck(square, c).valid());
}

// det J at random points is never below the bound, nor |J|^2 / det J above it.
TEST(Certificate, BoundsHoldAtRandomPoints) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const int degree : {3, 4, 5}) {
    const Result result = example::grid(2, degree, example::cubic_map());
    const Certificate c = verify(result).certificate;
    for (std::size_t t = 0; t < result.triangles.size(); ++t)
      for (int sample = 0; sample < 50; ++sample) {
        double s = uniform(random), r = uniform(random);
        if (s + r > 1) s = 1 - s, r = 1 - r;
        const auto at = [&](int k) { return result.domain_vertices[result.triangles[t][k]]; };
        const Point p = at(0) + s * (at(1) - at(0)) + r * (at(2) - at(0));
        const double h = 1e-5;
        const auto f = [&](double x, double y) {
          return example::evaluate(example::cubic_map(), Point(x, y));
        };
        const Point dx = (f(p.x() + h, p.y()) - f(p.x() - h, p.y())) / (2 * h);
        const Point dy = (f(p.x(), p.y() + h) - f(p.x(), p.y() - h)) / (2 * h);
        const double det = dx.x() * dy.y() - dx.y() * dy.x();
        EXPECT_GE(det, c.triangles[t].det - 1e-8);
        EXPECT_LE((dx.squaredNorm() + dy.squaredNorm()) / det, c.triangles[t].g + 1e-8);
      }
  }
}

TEST(Certificate, SurvivesItsFileBitForBit) {
  const Result result = needs_a_split();
  const Certificate made = verify(result).certificate;
  const std::string text = format_certificate(made);
  const Certificate read = parse_certificate(text);
  EXPECT_EQ(format_certificate(read), text);
  ASSERT_EQ(read.triangles.size(), made.triangles.size());
  for (std::size_t t = 0; t < made.triangles.size(); ++t) {
    EXPECT_EQ(read.triangles[t].det, made.triangles[t].det);
    EXPECT_EQ(read.triangles[t].g, made.triangles[t].g);
    EXPECT_EQ(read.triangles[t].marks, made.triangles[t].marks);
  }
  const VerifyReport report = recheck(result, read);
  EXPECT_EQ(certificate_verdict(report), Verdict::valid) << report_text(report);
}

TEST(Certificate, ASplitIsRecordedAndFollowed) {
  const Result result = needs_a_split();
  const Certificate c = verify(result).certificate;
  const TriangleProof& proof = c.triangles[0];
  EXPECT_GT(proof.depth, 0);
  // Preorder of a binary tree: one more leaf than there are splits.
  EXPECT_EQ(std::count(proof.marks.begin(), proof.marks.end(), '0'),
            std::count(proof.marks.begin(), proof.marks.end(), '1') + 1);
  EXPECT_GT(proof.det, 0);
  EXPECT_LT(proof.g, 1e6);
  const auto refused = [&](auto change, const char* what) {
    expect_refused(result, c, change, what);
  };
  refused([](Certificate& x) { x.triangles[0].marks = ""; }, "no split");
  refused([](Certificate& x) { x.triangles[0].marks = "100"; }, "another depth");
  refused([](Certificate& x) { x.triangles[0].marks += "0"; }, "marks too many");
  refused([](Certificate& x) { x.triangles[0].marks.pop_back(); }, "marks too few");
  refused([](Certificate& x) { x.triangles[0].marks = std::string(100000, '1'); }, "too deep");
}

TEST(Certificate, EachFalseBoundIsFound) {
  const Result result = example::grid(3, 3, example::cubic_map());
  const Certificate c = verify(result).certificate;
  ASSERT_EQ(certificate_verdict(recheck(result, c)), Verdict::valid);
  const auto refused = [&](auto change, const char* what) {
    expect_refused(result, c, change, what);
  };
  const auto up = [](double x) { return std::nextafter(x, 1e300); };
  const auto down = [](double x) { return std::nextafter(x, -1e300); };
  refused([&](Certificate& x) { x.triangles[1].det *= 1 + 1e-12; }, "det of a triangle");
  refused([&](Certificate& x) { x.triangles[1].g *= 1 - 1e-12; }, "g of a triangle");
  refused([&](Certificate& x) { x.triangles[1].depth = 1; }, "depth");
  refused([&](Certificate& x) { x.edges[0].bound = 0; }, "C1 of an edge");
  refused([&](Certificate& x) { x.edges.pop_back(); }, "an edge is missing");
  refused([&](Certificate& x) { std::swap(x.edges[0], x.edges[1]); }, "order");
  refused([&](Certificate& x) { x.curve_edges.pop_back(); }, "a curve edge is missing");
  refused([&](Certificate& x) { x.det = up(x.det); }, "det of all");
  refused([&](Certificate& x) { x.g = down(x.g); }, "g of all");
  refused([&](Certificate& x) { x.c1 = down(x.c1); }, "c1 of all");
  refused([&](Certificate& x) { x.triangles.pop_back(); }, "another result");
  refused([&](Certificate& x) { x.degree = 4; }, "another degree");
  refused([&](Certificate& x) { x.extent *= 2; }, "another extent");
  refused([&](Certificate& x) { x.boundary.push_back({{0, 1, 0, 1}, "100"}); }, "a pair too many");
}

// A certificate is of one result: that of a map moved by a thousandth does not hold.
TEST(Certificate, OfAnotherResultIsRefused) {
  const Result one = example::grid(3, 3, example::cubic_map());
  Result other = one;
  const Certificate c = verify(one).certificate;
  for (std::size_t id = 0; id < other.control_points.size(); ++id)
    other.control_points[id] *= 1 + 1e-3;
  EXPECT_EQ(certificate_verdict(recheck(other, c)), Verdict::invalid);
}

TEST(Certificate, AClaimOfValidityMustBeTrue) {
  Result bent = example::square();
  const Certificate c = verify(bent).certificate;
  bent.exceptional_vertices = {0, 0};
  const VerifyReport report = recheck(bent, c);
  EXPECT_EQ(certificate_verdict(report), Verdict::invalid);
}

// Slightly weaker bounds than what is found are true as well.
TEST(Certificate, WeakerBoundsHold) {
  const Result result = example::grid(2, 3, example::cubic_map());
  Certificate c = verify(result).certificate;
  for (TriangleProof& proof : c.triangles) {
    proof.det *= 0.5;
    proof.g *= 2;
  }
  for (EdgeBound& edge : c.edges) edge.bound += 1e-3;
  c.c1 = 1;
  c.det = 0;
  c.g = 1e9;
  EXPECT_EQ(certificate_verdict(recheck(result, c)), Verdict::valid);
}

TEST(Certificate, TextThatIsNoneIsRefused) {
  const std::string good = format_certificate(verify(example::square()).certificate);
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    EXPECT_THROW(parse_certificate(text), InputError) << from << " -> " << to;
  };
  EXPECT_THROW(parse_certificate(""), InputError);
  EXPECT_THROW(parse_certificate("[]"), InputError);
  refused("c1mesh-certificate", "c1mesh");
  refused("\"version\":1", "\"version\":2");
  refused("\"valid\"", "\"true\"");
  refused("\"triangles\":[", "\"triangle\":[");
  refused("[0,", "[-1,");
  refused("[0,", "[99999999999,");
  refused("\"degree\":3", "\"degree\":\"3\"");
}

// The bound that is asked is compared without any allowance.
TEST(Certificate, TheC1BoundIsStrict) {
  const Result result = example::grid(3, 3, example::cubic_map());
  const double found = verify(result).certificate.c1;
  ASSERT_GT(found, 0);
  VerifyOptions options;
  options.c1_bound = found;
  EXPECT_TRUE(verify(result, options).c1());
  options.c1_bound = std::nextafter(found, 0);
  EXPECT_FALSE(verify(result, options).c1());
  options.c1_bound = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(verify(result, options).c1());
}

}  // namespace
}  // namespace c1mesh
