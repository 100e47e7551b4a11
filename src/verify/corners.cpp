// SPDX-License-Identifier: GPL-3.0-or-later
// Corners of the shape, what they ask of the domain, and the vertices where C1 is given up.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "verify/checks.h"
#include "verify/curve_pairs.h"
#include "verify/faces.h"

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

/// How many corners a polygon lacks, of the kind it needs and of any kind, and where it runs.
struct Demand {
  int missing = 0, missing_of_any = 0;
  std::set<int> vertices;
};

/// The domain polygon of a closed run of edges with a face on its left needs three corners: convex
/// ones if the face lies inside, else three that are reflex seen from the face. A C1 corner of the
/// shape lies over a domain corner of its own kind; a branch point is not C1 and may be any.
Demand demand_of(const Subject& subject, const std::vector<int>& loop, bool inside,
                 const std::vector<int>& branches) {
  const double limit = corner_angle(subject.result) * kDegree;
  Demand out{3, 3, {loop.begin(), loop.end()}};
  for (const Joint& joint : joints_of(subject, loop)) {
    const bool branch = std::binary_search(branches.begin(), branches.end(), joint.vertex);
    const double turn = inside ? joint.shape_turn : -joint.shape_turn;
    if (branch || turn > limit) --out.missing;
    if (branch || std::abs(turn) > limit) --out.missing_of_any;
  }
  out.missing = std::max(0, out.missing);
  out.missing_of_any = std::max(0, out.missing_of_any);
  return out;
}

bool turns_left(const Subject& subject, const std::vector<int>& loop) {
  std::vector<std::vector<Point>> curves;
  for (const BoundaryRow& row : rows_of(subject, loop)) curves.push_back(row.poles);
  return curves.empty() || area_sign(curves) >= 0;
}

/// Branch points, and what the polygons lack (docs/vocabulary.md). No vertex serves two of the
/// demands `apart`: it is convex for one face at most, and a hole's corners are reflex for faces.
/// The rim of several faces together, `rims`, may be served by the corners of those it touches.
void count_minimum(const Subject& subject, Metrics& metrics) {
  const std::vector<int> branches = branch_points(subject);
  std::vector<Demand> apart, rims;
  for (const auto& loop : subject.surface.loops) {
    const bool outer = turns_left(subject, loop);
    // Without features the outer loop goes around its one face.
    (outer && !subject.result.feature_edges.empty() ? rims : apart)
        .push_back(demand_of(subject, loop, outer, branches));
  }
  if (!subject.result.feature_edges.empty())
    for (const auto& cycle : face_cycles(subject)) {
      const bool inside = turns_left(subject, cycle);
      (inside ? apart : rims).push_back(demand_of(subject, cycle, inside, branches));
    }
  metrics.exceptional_minimum = metrics.exceptional_minimum_paper =
      static_cast<int>(branches.size());
  for (const Demand& demand : apart) {
    metrics.exceptional_minimum += demand.missing;
    metrics.exceptional_minimum_paper += demand.missing_of_any;
  }
  std::map<int, std::vector<int>> demands_at;  // vertex -> of `apart`
  for (std::size_t k = 0; k < apart.size(); ++k)
    for (const int v : apart[k].vertices) demands_at[v].push_back(static_cast<int>(k));
  for (const Demand& rim : rims) {
    std::set<int> touched;
    for (const int v : rim.vertices)
      if (const auto found = demands_at.find(v); found != demands_at.end())
        touched.insert(found->second.begin(), found->second.end());
    int served = 0, served_by_any = 0;
    for (const int k : touched) {
      served += apart[k].missing;
      served_by_any += apart[k].missing_of_any;
    }
    metrics.exceptional_minimum += std::max(0, rim.missing - served);
    metrics.exceptional_minimum_paper += std::max(0, rim.missing_of_any - served_by_any);
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
  for (const int v : branch_points(subject))
    if (!exceptional.count(v))
      faults.add(fmt::format("three curves meet in vertex {}, but it is not exceptional", v));
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
