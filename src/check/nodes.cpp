// SPDX-License-Identifier: GPL-3.0-or-later
// Curve ends: where they coincide, and gaps between them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "check/stages.h"

namespace c1mesh::detail {
namespace {

// A gap is closed only if it is small against the curves it would bend.
constexpr double kLargestGapOfCurve = 0.25;
// "Unique nearest partner": the next candidate is at least this much farther.
constexpr double kAmbiguity = 2;

const Point& point_of(const Arrangement& arrangement, const CurveEnd& end) {
  const BezierCurve& curve = arrangement.curves[end.curve];
  return end.at_end ? curve.end() : curve.start();
}

// Dangling ends in buckets of the tolerance's size: neighbours are in the 3 x 3 buckets around.
class NearestEnds {
 public:
  NearestEnds(const Arrangement& arrangement, std::vector<CurveEnd> ends, double radius)
      : arrangement_(arrangement), ends_(std::move(ends)), radius_(radius) {
    for (std::size_t i = 0; i < ends_.size(); ++i) buckets_[cell(i)].push_back(static_cast<int>(i));
  }

  const std::vector<CurveEnd>& ends() const { return ends_; }
  double distance(int a, int b) const {
    return (point_of(arrangement_, ends_[a]) - point_of(arrangement_, ends_[b])).norm();
  }

  // The one end within the radius that is clearly nearest; -1 if there is none.
  int partner(int a) const {
    int best = -1;
    double nearest = radius_, second = INFINITY;
    const auto [x, y] = cell(a);
    for (long long dx = -1; dx <= 1; ++dx)
      for (long long dy = -1; dy <= 1; ++dy) {
        const auto bucket = buckets_.find({x + dx, y + dy});
        if (bucket == buckets_.end()) continue;
        for (const int b : bucket->second) {
          if (a == b) continue;
          const double d = distance(a, b);
          if (d > nearest) {
            second = std::min(second, d);
          } else {
            if (best >= 0) second = nearest;
            nearest = d;
            best = b;
          }
        }
      }
    return best >= 0 && second < kAmbiguity * nearest ? -1 : best;
  }

 private:
  std::pair<long long, long long> cell(std::size_t i) const {
    const Point d = point_of(arrangement_, ends_[i]) - arrangement_.frame.origin;
    return {static_cast<long long>(std::floor(d.x() / radius_)),
            static_cast<long long>(std::floor(d.y() / radius_))};
  }

  const Arrangement& arrangement_;
  std::vector<CurveEnd> ends_;
  double radius_;
  std::map<std::pair<long long, long long>, std::vector<int>> buckets_;
};

bool straight(const BezierCurve& curve) {
  const Point chord = curve.end() - curve.start();
  for (const Point& p : curve.poles)
    if (std::abs(cross(chord, p - curve.start())) > kResolution * chord.squaredNorm()) return false;
  return true;
}

bool small_against_curves(const Arrangement& arrangement, const CurveEnd& a, const CurveEnd& b,
                          double gap) {
  return gap <= kLargestGapOfCurve * size_of(arrangement.curves[a.curve]) &&
         gap <= kLargestGapOfCurve * size_of(arrangement.curves[b.curve]);
}

struct Gap {
  CurveEnd first, second;
  double width = 0;
};

std::vector<Gap> find_gaps(const Arrangement& arrangement, double tolerance) {
  const Nodes nodes = find_nodes(arrangement);
  std::vector<CurveEnd> dangling;
  for (const auto& ends : nodes.ends)
    if (ends.size() == 1) dangling.push_back(ends[0]);
  const NearestEnds near(arrangement, dangling,
                         std::max(tolerance, kResolution) * arrangement.extent);
  std::vector<Gap> gaps;
  for (int a = 0; a < static_cast<int>(dangling.size()); ++a) {
    const int b = near.partner(a);
    if (b <= a || near.partner(b) != a) continue;
    const double width = near.distance(a, b);
    if (small_against_curves(arrangement, dangling[a], dangling[b], width))
      gaps.push_back({dangling[a], dangling[b], width});
  }
  return gaps;
}

// Does the curve join, at both ends, curves that are longer by far?
bool between_long_ones(const Arrangement& arrangement, const Nodes& nodes, int curve) {
  const double size = size_of(arrangement.curves[curve]);
  for (const int node : nodes.of_curve[curve])
    for (const CurveEnd& end : nodes.ends[node])
      if (end.curve != curve && kLargestGapOfCurve * size_of(arrangement.curves[end.curve]) < size)
        return false;
  return true;
}

}  // namespace

void move_end(BezierCurve& curve, bool at_end, const Point& target) {
  const int n = curve.degree(), end = at_end ? n : 0;
  const Point shift = target - curve.poles[end];
  if (straight(curve)) {
    for (int i = 1; i < n; ++i) curve.poles[i] += (at_end ? i : n - i) * shift / n;
  } else if (n > 2) {
    curve.poles[at_end ? n - 1 : 1] += shift;
  }
  // A quadratic's handle belongs to both ends and stays where it is.
  curve.poles[end] = target;
}

void note_short(Arrangement& arrangement, const Nodes& nodes, double tolerance) {
  std::vector<int> about;
  std::vector<Point> where;
  for (int i = 0; i < arrangement.size(); ++i) {
    const BezierCurve& curve = arrangement.curves[i];
    if (curve.degree() > 1 || size_of(curve) >= tolerance * arrangement.extent ||
        !between_long_ones(arrangement, nodes, i))
      continue;
    about.push_back(i);
    where.push_back(curve.start());
  }
  if (about.empty()) return;
  arrangement.mend(
      DefectKind::note, about, where,
      fmt::format(
          "{} line{} shorter than {:.3g} ({:.2g} of the extent), perhaps a gap closed by the "
          "drawing program; kept as drawn",
          about.size(), about.size() == 1 ? " is" : "s are", tolerance * arrangement.extent,
          tolerance));
}

Nodes find_nodes(const Arrangement& arrangement) {
  std::vector<CurveEnd> ends;
  for (int i = 0; i < arrangement.size(); ++i) {
    ends.push_back({i, false});
    ends.push_back({i, true});
  }
  const auto key = [&](const CurveEnd& end) {
    const Point& p = point_of(arrangement, end);
    return std::array<double, 2>{p.x(), p.y()};
  };
  std::stable_sort(ends.begin(), ends.end(),
                   [&](const CurveEnd& a, const CurveEnd& b) { return key(a) < key(b); });
  Nodes nodes;
  nodes.of_curve.resize(arrangement.curves.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (i == 0 || key(ends[i - 1]) != key(ends[i])) nodes.ends.emplace_back();
    nodes.ends.back().push_back(ends[i]);
    nodes.of_curve[ends[i].curve][ends[i].at_end] = static_cast<int>(nodes.ends.size()) - 1;
  }
  return nodes;
}

void close_gaps(Arrangement& arrangement, double tolerance) {
  int snapped = 0;
  double widest = 0;
  for (const Gap& gap : find_gaps(arrangement, tolerance)) {
    BezierCurve& first = arrangement.curves[gap.first.curve];
    BezierCurve& second = arrangement.curves[gap.second.curve];
    const Point p = point_of(arrangement, gap.first), q = point_of(arrangement, gap.second);
    const Point middle = p + (q - p) / 2;
    move_end(first, gap.first.at_end, middle);
    move_end(second, gap.second.at_end, middle);
    if (gap.width <= kResolution * arrangement.extent) {
      ++snapped;
      widest = std::max(widest, gap.width);
      continue;
    }
    std::vector<int> about = {gap.first.curve};
    if (gap.second.curve != gap.first.curve) about.push_back(gap.second.curve);
    arrangement.mend(DefectKind::gap, about, {p, q},
                     fmt::format("a gap of {:.3g} ({:.2g} of the extent) was closed", gap.width,
                                 gap.width / arrangement.extent));
  }
  if (snapped > 0)
    arrangement.mend(DefectKind::note, {}, {},
                     fmt::format("{} joints whose ends differed by rounding (at most {:.2g}) were "
                                 "made exact",
                                 snapped, widest));
}

}  // namespace c1mesh::detail
