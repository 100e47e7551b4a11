// SPDX-License-Identifier: GPL-3.0-or-later
// Corners of the shape, what they ask of the domain, and the vertices where C1 is given up.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "verify/checks.h"
#include "verify/curve_pairs.h"

namespace c1mesh::verification {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFlat = 1e-9;             // radians: a smaller turn is none
constexpr double kAngleBand = 1e-6;        // degrees around the limit where either kind is right
constexpr double kDefaultCornerAngle = 8;  // degrees

double corner_angle(const Result& result) {
  for (const auto& [key, value] : result.parameters) {
    if (key != "corner_angle") continue;
    if (const auto* real = std::get_if<double>(&value)) return *real;
    if (const auto* whole = std::get_if<long long>(&value)) return static_cast<double>(*whole);
  }
  return kDefaultCornerAngle;
}

/// First control vector from an end that is not zero: the tangent's direction there.
Point leaving(const std::vector<Point>& poles) {
  for (const Point& p : poles)
    if (p != poles.front()) return p - poles.front();
  return Point::Zero();
}

Point arriving(const std::vector<Point>& poles) {
  for (auto p = poles.rbegin(); p != poles.rend(); ++p)
    if (*p != poles.back()) return poles.back() - *p;
  return Point::Zero();
}

double turn(const Point& in, const Point& out) {
  return std::atan2(cross(in, out), in.dot(out));
}

/// A boundary vertex with the turns there, in radians, to the left positive.
struct Joint {
  int vertex;
  double shape_turn, domain_turn;
};

std::vector<Joint> joints_of(const Subject& subject, const std::vector<int>& loop) {
  std::vector<Joint> joints;
  const std::vector<BoundaryRow> rows = rows_of(subject, loop);
  const auto& domain = subject.result.domain_vertices;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const BoundaryRow &before = rows[(i + rows.size() - 1) % rows.size()], &after = rows[i];
    joints.push_back(
        {after.a, turn(arriving(before.poles), leaving(after.poles)),
         turn(domain[before.b] - domain[before.a], domain[after.b] - domain[after.a])});
  }
  return joints;
}

/// The least number of exceptional vertices a loop asks for: its domain polygon needs three convex
/// corners (a hole's: three that are reflex seen from the interior), and a C1 corner of the shape
/// lies over a domain corner of its own kind.
void count_minimum(const Subject& subject, Metrics& metrics) {
  const double limit = corner_angle(subject.result) * kDegree;
  for (const auto& loop : subject.surface.loops) {
    int left = 0, right = 0;
    for (const Joint& joint : joints_of(subject, loop)) {
      if (joint.shape_turn > limit) ++left;
      if (joint.shape_turn < -limit) ++right;
    }
    std::vector<std::vector<Point>> curves;
    for (const BoundaryRow& row : rows_of(subject, loop)) curves.push_back(row.poles);
    const bool outer = curves.empty() || area_sign(curves) >= 0;
    metrics.exceptional_minimum += std::max(0, 3 - (outer ? left : right));
    metrics.exceptional_minimum_paper += std::max(0, 3 - (left + right));
  }
}

}  // namespace

VerifyItem check_boundary_vertices(const Subject& subject) {
  Faults faults;
  const double limit = corner_angle(subject.result);
  std::map<int, bool> listed;
  for (const BoundaryVertex& v : subject.result.boundary_vertices)
    if (!listed.emplace(v.vertex, v.corner).second)
      faults.add(fmt::format("boundary vertex {} is listed twice", v.vertex));
  std::size_t corners = 0;
  for (const auto& loop : subject.surface.loops)
    for (const Joint& joint : joints_of(subject, loop)) {
      const double angle = std::abs(joint.shape_turn) / kDegree;
      const auto found = listed.find(joint.vertex);
      if (found == listed.end()) {
        faults.add(fmt::format("boundary vertex {} is not listed", joint.vertex));
        continue;
      }
      if (std::abs(angle - limit) > kAngleBand && found->second != (angle > limit))
        faults.add(fmt::format("vertex {} is listed as {} but the boundary turns by {:.6g} degrees",
                               joint.vertex, found->second ? "corner" : "smooth", angle));
      corners += found->second;
      listed.erase(found);
    }
  for (const auto& [vertex, corner] : listed)
    if (!subject.surface.on_boundary[vertex])
      faults.add(fmt::format("vertex {} is listed but not on the boundary", vertex));
  return faults.item("boundary vertices", fmt::format("{} corners", corners));
}

VerifyItem check_exceptional(const Subject& subject, Metrics& metrics) {
  Faults faults;
  const Result& result = subject.result;
  const std::set<int> exceptional(result.exceptional_vertices.begin(),
                                  result.exceptional_vertices.end());
  if (exceptional.size() != result.exceptional_vertices.size())
    faults.add("an exceptional vertex is listed twice");
  std::set<int> features;
  for (const CurveEdge& e : result.feature_edges)
    features.insert(subject.surface.find_edge(e.a, e.b));
  for (const auto& [a, b] : result.relaxed_edges) {
    const int id = subject.surface.find_edge(a, b);
    if (id < 0 || !subject.surface.edges[id].interior())
      faults.add(fmt::format("relaxed edge ({}, {}) is not an interior edge", a, b));
    else if (!exceptional.count(a) && !exceptional.count(b) && !features.count(id))
      faults.add(fmt::format("relaxed edge ({}, {}) without exceptional vertex", a, b));
  }
  metrics.exceptional = static_cast<int>(exceptional.size());
  count_minimum(subject, metrics);
  metrics.surplus = metrics.exceptional - metrics.exceptional_minimum;
  return faults.item(
      "exceptional vertices",
      fmt::format("{}, least possible {} ({} by the paper's count)", metrics.exceptional,
                  metrics.exceptional_minimum, metrics.exceptional_minimum_paper));
}

/// Of the smooth boundary vertices (the boundary turns by at most the corner angle), the share that
/// is flat: the domain's boundary turns there by at most 1e-9 radians, or the vertex is a mild
/// joint (the shape turns by more than 1e-9), is not exceptional, and the domain turns to the same
/// side.
void measure_flatness(const Subject& subject, Metrics& metrics) {
  const double limit = corner_angle(subject.result) * kDegree;
  const std::set<int> exceptional(subject.result.exceptional_vertices.begin(),
                                  subject.result.exceptional_vertices.end());
  std::size_t smooth = 0, flat = 0;
  for (const auto& loop : subject.surface.loops)
    for (const Joint& joint : joints_of(subject, loop)) {
      if (std::abs(joint.shape_turn) > limit) continue;
      ++smooth;
      const bool follows = !exceptional.count(joint.vertex) && std::abs(joint.shape_turn) > kFlat &&
                           (joint.shape_turn > 0) == (joint.domain_turn > 0);
      if (std::abs(joint.domain_turn) <= kFlat || follows) ++flat;
    }
  metrics.flatness_ratio = smooth ? double(flat) / double(smooth) : 1;
}

}  // namespace c1mesh::verification
