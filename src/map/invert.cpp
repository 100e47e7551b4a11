// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/invert.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bernstein/triangle_jet.h"

namespace c1mesh {
namespace {

constexpr int kNewtonSteps = 20;
constexpr double kFlat = 1e-16;  // a determinant relatively below this is rounding
constexpr double kFar = 4;  // barycentric coordinates beyond this: Newton has lost the triangle

struct Preimage {
  Barycentric at;
  double distance;  ///< how far outside of the triangle, about, in the image; not positive inside
};

/// d lambda_k / d(x, y) has the length |grad lambda_k|; a coordinate of -c is about
/// c / |grad lambda_k| away from the triangle's edge in the image.
double distance_outside(const TriangleJet& jet, double det, const Barycentric& at) {
  const Point ds = Point(jet.first[1].y(), -jet.first[1].x()) / det;
  const Point dt = Point(-jet.first[0].y(), jet.first[0].x()) / det;
  const std::array<Point, 3> gradient = {-ds - dt, ds, dt};
  double worst = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double length = gradient[k].norm();
    if (length > 0) worst = std::max(worst, -at[k] / length);
  }
  return worst;
}

/// Newton's method for B(s, t) = x, ended where the residue no longer shrinks. None if it fails or
/// ends at a residue above the tolerance.
std::optional<Preimage> newton(const Net& net, int n, const Point& x, Barycentric at,
                               double tolerance) {
  std::optional<Preimage> best;
  double least = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kNewtonSteps; ++step) {
    const TriangleJet jet = jet_of(net, n, at);
    const Point residue = jet.value - x;
    const double size = residue.norm(), det = cross(jet.first[0], jet.first[1]);
    if (best && size >= least) return best;
    if (!(det > kFlat * jet.first[0].norm() * jet.first[1].norm())) return best;
    if (size <= tolerance && size < least) best = {at, distance_outside(jet, det, at)};
    least = std::min(least, size);
    const double ds = cross(residue, jet.first[1]) / det, dt = cross(jet.first[0], residue) / det;
    at += Barycentric(ds + dt, -ds, -dt);
    if (!(at.cwiseAbs().maxCoeff() < kFar)) return best;
  }
  return best;
}

/// Is x farther than the tolerance from the convex hull of the control points, seen along an axis
/// or across one of the chords of the three edges?
bool excluded(const Net& net, int n, const Point& x, double tolerance) {
  const std::array<Point, 3> corner = {net[net_index(n, 0, 0)], net[net_index(n, n, 0)],
                                       net[net_index(n, 0, n)]};
  std::array<Point, 7> direction = {Point(1, 0), Point(-1, 0), Point(0, 1), Point(0, -1)};
  for (int k = 0; k < 3; ++k) {
    const Point chord = corner[(k + 1) % 3] - corner[k];
    const double length = chord.norm();
    direction[4 + k] = length > 0 ? Point(chord.y() / length, -chord.x() / length) : Point(1, 0);
  }
  for (const Point& d : direction) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Point& p : net) most = std::max(most, d.dot(p - x));
    if (most < -tolerance) return true;
  }
  return false;
}

/// Where x is in the affine triangle of the corners, pulled into it: a start for Newton's method.
Barycentric affine_guess(const Net& net, int n, const Point& x) {
  const Point& a = net[net_index(n, 0, 0)];
  const Point e1 = net[net_index(n, n, 0)] - a, e2 = net[net_index(n, 0, n)] - a;
  const double det = cross(e1, e2);
  if (!(det > 0)) return Barycentric::Constant(1.0 / 3);
  const double s = cross(x - a, e2) / det, t = cross(e1, x - a) / det;
  Barycentric at = Barycentric(1 - s - t, s, t).cwiseMax(0).cwiseMin(1);
  return at / at.sum();
}

/// A part of the triangle: its corners in the whole triangle, and its net.
struct Piece {
  std::array<Barycentric, 3> corner;
  Net net;

  Barycentric in_whole(const Barycentric& at) const {
    return at[0] * corner[0] + at[1] * corner[1] + at[2] * corner[2];
  }
  double size() const {
    double most = 0;
    for (const Point& p : net) most = std::max(most, (p - net[0]).norm());
    return most;
  }
};

class Inversion {
 public:
  Inversion(const Net& net, int degree, const Point& x, double tolerance)
      : net_(net), n_(degree), x_(x), tolerance_(tolerance) {}

  std::optional<Barycentric> in_piece(const Piece& piece) const {
    if (excluded(piece.net, n_, x_, tolerance_)) return std::nullopt;
    // On the whole triangle: a place in it is what is sought, whichever piece led there.
    const Barycentric start = piece.in_whole(affine_guess(piece.net, n_, x_));
    const std::optional<Preimage> found = newton(net_, n_, x_, start, tolerance_);
    if (found && found->distance <= tolerance_) return found->at;
    // All of so small a piece is near x, since the hull, which x is near, is no larger.
    if (piece.size() <= tolerance_) return piece.in_whole(Barycentric::Constant(1.0 / 3));
    for (const std::array<Barycentric, 3>& quarter : quarters(piece.corner))
      if (const auto at =
              in_piece({quarter, restrict_net(net_, n_, quarter[0], quarter[1], quarter[2])}))
        return at;
    return std::nullopt;
  }

 private:
  static std::array<std::array<Barycentric, 3>, 4> quarters(
      const std::array<Barycentric, 3>& corner) {
    const Barycentric a = (corner[1] + corner[2]) / 2, b = (corner[2] + corner[0]) / 2,
                      c = (corner[0] + corner[1]) / 2;
    return {{{corner[0], c, b}, {c, corner[1], a}, {b, a, corner[2]}, {a, b, c}}};
  }

  const Net& net_;
  const int n_;
  const Point x_;
  const double tolerance_;
};

}  // namespace

std::optional<Barycentric> invert(const Net& net, int degree, const Point& x, double tolerance) {
  const std::array<Barycentric, 3> whole = {Barycentric::UnitX(), Barycentric::UnitY(),
                                            Barycentric::UnitZ()};
  return Inversion(net, degree, x, tolerance).in_piece({whole, net});
}

}  // namespace c1mesh
