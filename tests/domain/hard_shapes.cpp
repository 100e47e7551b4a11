// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/hard_shapes.h"

#include <algorithm>

namespace c1mesh::test {

std::vector<BezierCurve> rounded(const std::vector<Point>& corners, double share) {
  const std::size_t n = corners.size();
  std::vector<Point> before, after;  // where the curve of each corner begins and ends
  for (std::size_t i = 0; i < n; ++i) {
    const Point& p = corners[i];
    const Point in = corners[(i + n - 1) % n] - p, out = corners[(i + 1) % n] - p;
    const double radius = share * std::min(in.norm(), out.norm());
    before.emplace_back(p + radius * in.normalized());
    after.emplace_back(p + radius * out.normalized());
  }
  std::vector<BezierCurve> curves;
  for (std::size_t i = 0; i < n; ++i) {
    const Point& p = corners[i];
    curves.push_back({{before[i], before[i] + 2.0 / 3 * (p - before[i]),
                       after[i] + 2.0 / 3 * (p - after[i]), after[i]}});
    curves.push_back({{after[i], before[(i + 1) % n]}});
  }
  return curves;
}

std::vector<Point> comb(int teeth) {
  std::vector<Point> points = {{0, 0}, {1, 0}};
  const double pitch = 1 / (teeth - 0.5);
  for (int k = teeth - 1; k >= 0; --k) {
    const double left = k * pitch, right = left + 0.5 * pitch;
    if (k < teeth - 1) points.emplace_back(right, 0.2);
    points.emplace_back(right, 0.8);
    points.emplace_back(left, 0.8);
    if (k > 0) points.emplace_back(left, 0.2);
  }
  points[2].x() = 1;  // the spine ends with the last tooth, to the last bit
  return points;
}

std::vector<Point> tree(int levels) {
  std::vector<Point> right = {{0.55, 0}};
  const double pitch = 0.9 / levels, thick = 0.25 * pitch;
  for (int k = 0; k < levels; ++k) {
    const double low = 0.08 + k * pitch, high = low + thick;
    right.insert(right.end(), {{0.55, low},
                               {0.95, low},
                               {0.95, low + 0.75 * pitch},
                               {0.95 - thick, low + 0.75 * pitch},
                               {0.95 - thick, high},
                               {0.55, high}});
  }
  right.emplace_back(0.55, 1);
  std::vector<Point> points = right;
  for (auto p = right.rbegin(); p != right.rend(); ++p) points.emplace_back(1 - p->x(), p->y());
  return points;
}

Stage stage_of(const std::vector<std::vector<BezierCurve>>& loops) {
  Stage out;
  MeshReport report;
  out.mesh = initial_mesh(input_of(loops), {}, report);
  out.joints = find_joints(out.mesh, 8);
  out.roles =
      place_exceptional(out.mesh, out.joints, natural_roles(out.joints), Placement::curvature);
  out.layout = make_layout(out.mesh, out.joints, out.roles);
  out.elements = domain_elements(out.mesh, out.joints, out.roles, out.layout, {});
  return out;
}

}  // namespace c1mesh::test
