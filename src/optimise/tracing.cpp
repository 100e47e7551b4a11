// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimise/tracing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "optimise/stages.h"
#include "optimise/triangle_energy.h"

namespace c1mesh {
namespace {

double or_infinite(double value) {
  return std::isfinite(value) ? value : std::numeric_limits<double>::infinity();
}

double total_deviation(const CurvedMesh& mesh, const std::vector<C1Edge>& asked,
                       const PointMatrix& domain, const std::vector<Point>& control) {
  double sum = 0;
  for (const C1Edge& e : asked) {
    if (e.equations() != mesh.degree) continue;  // of a joint's tips
    Point v[4];
    for (int k = 0; k < 4; ++k) v[k] = domain.row(e.vertex[k]).transpose();
    // A flat triangle gives no coordinates to its neighbour's corner: d_ei is infinite.
    if (cross(v[1] - v[0], v[2] - v[0]) == 0) return std::numeric_limits<double>::infinity();
    const Eigen::Vector3d g = barycentric(v[0], v[1], v[2], v[3]);
    for (int i = 0; i < e.equations(); ++i) sum += c1_residue(e, i, g, control).norm();
  }
  return sum;
}

double mean_energy(const CurvedMesh& mesh, const PointMatrix& domain,
                   const std::vector<Point>& control) {
  const TriangleEnergy energy(mesh.degree);
  double sum = 0;
  Net net(mesh.net_size());
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    for (int k = 0; k < mesh.net_size(); ++k) net[k] = control[mesh.nets[t * mesh.net_size() + k]];
    const auto& corner = mesh.triangles[t];
    Eigen::Matrix2d D;
    D.col(0) = (domain.row(corner[1]) - domain.row(corner[0])).transpose();
    D.col(1) = (domain.row(corner[2]) - domain.row(corner[0])).transpose();
    sum += energy.value(net, D);
  }
  return sum / mesh.triangle_count();
}

}  // namespace

TraceRecord trace_record(const CurvedMesh& mesh, const std::vector<C1Edge>& asked,
                         const PointMatrix& domain, const std::vector<Point>& control) {
  const std::vector<double> g = distortion_bounds(mesh, domain, control);
  TraceRecord record;
  record.e_s = or_infinite(total_deviation(mesh, asked, domain, control));
  record.e_reg = or_infinite(mean_energy(mesh, domain, control));
  // An inverted triangle's bound may also come out as not a number.
  for (const double bound : g) record.g = std::max(record.g, or_infinite(bound));
  return record;
}

Checkpoint traced_domain(const Checkpoint& checkpoint, const std::string& stage,
                         const CurvedMesh& mesh, const Joints& joints, const Roles& roles) {
  if (!checkpoint.trace) return checkpoint;
  return checkpoint.observed_by([stage, &mesh, asked = asked_edges(mesh, joints, roles),
                                 trace = checkpoint.trace](const Eigen::VectorXd& x, double step) {
    TraceRecord record = trace_record(mesh, asked, unflatten(x), mesh.control);
    record.stage = stage;
    record.step = step;
    trace(record);
  });
}

Checkpoint traced_map(const Checkpoint& checkpoint, const std::string& stage,
                      const CurvedMesh& mesh, const MapObjective& objective) {
  if (!checkpoint.trace) return checkpoint;
  return checkpoint.observed_by(
      [stage, &mesh, &objective, trace = checkpoint.trace](const Eigen::VectorXd& x, double step) {
        TraceRecord record = trace_record(mesh, objective.edges(), objective.domain_points(x),
                                          objective.unpack(x).control);
        record.stage = stage;
        record.step = step;
        trace(record);
      });
}

Checkpoint traced_roles(const Checkpoint& checkpoint, const Joints& joints, const Roles& roles) {
  if (!checkpoint.trace) return checkpoint;
  std::set<int> vertices;  // branch points are in several paths
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k)
      if (gives_up_c1(roles[l][k])) vertices.insert(joints[l][k].vertex);
  return checkpoint.marked([count = static_cast<int>(vertices.size())](TraceRecord& record) {
    record.exceptional = count;
  });
}

}  // namespace c1mesh
