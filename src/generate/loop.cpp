// SPDX-License-Identifier: GPL-3.0-or-later
#include "generate/loop.h"

#include <algorithm>
#include <cmath>

// Written out by coordinates, for the reason given in tour.cpp.

namespace c1mesh::generate_detail {
namespace {

constexpr int kSamples = 24;          // per curve, where loops are tested
constexpr double kDirection = 128;    // length of a handle's direction vector in grid units
constexpr double kSeparation = 0.2;   // distance asked per distance along the loop
constexpr double kLeastSpeed = 0.15;  // least speed relative to three times the chord

double length(const Point& v) {
  return std::sqrt(v.x() * v.x() + v.y() * v.y());
}

Point unit_vector(const Point& v) {
  const double l = length(v);
  return {v.x() / l, v.y() / l};
}

// Rotation by the angle whose half has the tangent t: rational, so no library cosine is needed.
Point rotate(const Point& v, double t) {
  const double c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

// A direction with integer coordinates, of length about kDirection.
Point quantised(const Point& unit) {
  return {std::floor(unit.x() * kDirection + 0.5), std::floor(unit.y() * kDirection + 0.5)};
}

// How many times the integer direction makes a handle of about the length asked, at least once.
double multiple(double handle, const Point& direction) {
  return std::max(1.0, std::floor(handle / (length(direction) * kUnit) + 0.5));
}

struct Joint {
  Point in, out;  // integer directions of travel before and after the joint
};

// Tangents halfway between the neighbouring chords' directions, turned by up to 20 degrees (half
// angle tangent 0.18); corners turn by a further 20 to 120 degrees to either side, shared unevenly
// between the two handles.
Joint random_joint(Random& random, const Point& before, const Point& here, const Point& after,
                   bool corner) {
  const Point u = unit_vector(here - before), v = unit_vector(after - here);
  const double bisector_x = u.x() + v.x(), bisector_y = u.y() + v.y();
  const double bend = bisector_x * bisector_x + bisector_y * bisector_y;
  // Nearly reversing chords have no bisector worth the name: travel across them instead.
  Point tangent = bend > 0.01 ? unit_vector({bisector_x, bisector_y}) : Point(-u.y(), u.x());
  tangent = rotate(tangent, random.between(-0.12, 0.12));
  if (!corner) return {quantised(tangent), quantised(tangent)};
  const double side = random.coin() ? 1 : -1;
  const double first = random.between(0.0875, 0.5), second = random.between(0.0875, 0.5);
  return {quantised(rotate(tangent, -side * first)), quantised(rotate(tangent, side * second))};
}

Point along(const Point& p, double sign, const Point& direction, double times) {
  return {p.x() + sign * times * direction.x() * kUnit,
          p.y() + sign * times * direction.y() * kUnit};
}

Point at(const BezierCurve& c, double t) {
  const double s = 1 - t;
  const double w[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
  double x = 0, y = 0;
  for (int i = 0; i < 4; ++i) {
    x += w[i] * c.poles[i].x();
    y += w[i] * c.poles[i].y();
  }
  return {x, y};
}

bool runs_evenly(const BezierCurve& c) {
  const double least = 3 * kLeastSpeed * length(c.end() - c.start());
  for (int k = 0; k <= kSamples; ++k) {
    const double t = static_cast<double>(k) / kSamples, s = 1 - t;
    const double w[3] = {3 * s * s, 6 * s * t, 3 * t * t};
    double x = 0, y = 0;
    for (int i = 0; i < 3; ++i) {
      x += w[i] * (c.poles[i + 1].x() - c.poles[i].x());
      y += w[i] * (c.poles[i + 1].y() - c.poles[i].y());
    }
    if (std::sqrt(x * x + y * y) < least) return false;
  }
  return true;
}

}  // namespace

std::vector<BezierCurve> random_handles(Random& random, const std::vector<Point>& tour,
                                        const std::vector<bool>& corners) {
  const std::size_t n = tour.size();
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < n; ++i)
    joints.push_back(
        random_joint(random, tour[(i + n - 1) % n], tour[i], tour[(i + 1) % n], corners[i]));
  std::vector<BezierCurve> loop;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const Point &p = tour[i], &q = tour[j];
    const double chord = length(q - p);
    const double a = multiple(chord * random.between(0.28, 0.46), joints[i].out);
    const double b = multiple(chord * random.between(0.28, 0.46), joints[j].in);
    loop.push_back({{p, along(p, 1, joints[i].out, a), along(q, -1, joints[j].in, b), q}});
  }
  return loop;
}

bool is_sound(const std::vector<BezierCurve>& loop, double clearance) {
  if (!std::all_of(loop.begin(), loop.end(), runs_evenly)) return false;
  std::vector<Point> points;
  std::vector<double> place;  // distance along the loop
  double total = 0;
  for (const BezierCurve& curve : loop)
    for (int k = 0; k < kSamples; ++k) {
      points.push_back(at(curve, static_cast<double>(k) / kSamples));
      if (points.size() > 1) total += length(points.back() - points[points.size() - 2]);
      place.push_back(total);
    }
  total += length(points.front() - points.back());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const double s = std::min(place[j] - place[i], total - (place[j] - place[i]));
      const double least = std::min(clearance, kSeparation * s);
      const double x = points[j].x() - points[i].x(), y = points[j].y() - points[i].y();
      if (x * x + y * y < least * least) return false;
    }
  return true;
}

}  // namespace c1mesh::generate_detail
