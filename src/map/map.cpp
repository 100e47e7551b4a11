// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/map.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "bernstein/triangle_jet.h"
#include "c1mesh/error.h"
#include "map/box_tree.h"
#include "map/invert.h"

namespace c1mesh {
namespace {

constexpr double kTolerance = 0x1p-46;  // of the largest coordinate: 64 units in the last place
constexpr double kTooLarge = 1e100;     // products of four coordinates must not overflow

[[noreturn]] void refuse(DefectKind kind, const std::string& message,
                         std::vector<Point> where = {}) {
  throw InputError({{kind, {}, std::move(where), message, "", false}});
}

Box box_of(const std::vector<Point>& points) {
  Box box{points.front(), points.front()};
  for (const Point& p : points) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

Box grown(const Box& box, double by) {
  return {box.low - Point::Constant(by), box.high + Point::Constant(by)};
}

double largest_coordinate(const Box& box) {
  return std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
}

bool finite(double a, double b) {
  return std::isfinite(a) && std::isfinite(b);
}

void check_points(const std::vector<Point>& points, const char* what) {
  if (points.empty()) refuse(DefectKind::empty, fmt::format("the result has no {}", what));
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!finite(points[k].x(), points[k].y()) || points[k].cwiseAbs().maxCoeff() > kTooLarge)
      refuse(DefectKind::non_finite,
             fmt::format("number {} of the {} is not finite, or beyond {:g}", k, what, kTooLarge));
}

void check_ids(int triangle, const int* ids, std::size_t count, std::size_t limit) {
  for (std::size_t k = 0; k < count; ++k)
    if (ids[k] < 0 || static_cast<std::size_t>(ids[k]) >= limit)
      refuse(DefectKind::malformed,
             fmt::format("triangle {} has the index {} of {}", triangle, ids[k], limit));
}

void check_structure(const Result& result) {
  check_points(result.domain_vertices, "domain vertices");
  check_points(result.control_points, "control points");
  if (result.triangles.empty()) refuse(DefectKind::empty, "the result has no triangles");
  if (result.degree < 1 || result.triangle_control_points.size() != result.triangles.size())
    refuse(DefectKind::malformed, "the result has no net of control points for every triangle");
  const std::size_t n = result.degree, net = (n + 1) * (n + 2) / 2;
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    const std::vector<int>& ids = result.triangle_control_points[t];
    const int id = static_cast<int>(t);
    if (ids.size() != net)
      refuse(DefectKind::malformed,
             fmt::format("triangle {} has {} control points, not {}", t, ids.size(), net));
    check_ids(id, result.triangles[t].data(), 3, result.domain_vertices.size());
    check_ids(id, ids.data(), ids.size(), result.control_points.size());
  }
}

/// A triangle of the domain.
struct Straight {
  std::array<Point, 3> corner;
  Eigen::Matrix2d inverse;       ///< of [corner 1 - corner 0, corner 2 - corner 0]
  std::array<double, 3> height;  ///< over the edge opposite to each corner

  Straight(int id, const std::array<Point, 3>& corners) : corner(corners) {
    Eigen::Matrix2d frame;
    frame << corner[1] - corner[0], corner[2] - corner[0];
    const double area = frame.determinant();
    if (area == 0)
      refuse(DefectKind::unsupported, fmt::format("triangle {} of the domain has no area", id),
             {corner[0], corner[1], corner[2]});
    inverse << frame(1, 1) / area, -frame(0, 1) / area, -frame(1, 0) / area, frame(0, 0) / area;
    for (int k = 0; k < 3; ++k)
      height[k] = std::abs(area) / (corner[(k + 2) % 3] - corner[(k + 1) % 3]).norm();
  }

  Barycentric barycentric(const Point& p) const {
    const Point st = inverse * (p - corner[0]);
    return {1 - st.x() - st.y(), st.x(), st.y()};
  }

  bool contains(const Barycentric& at, double tolerance) const {
    for (int k = 0; k < 3; ++k)
      if (at[k] * height[k] < -tolerance) return false;
    return true;
  }
};

}  // namespace

OutsideDomain::OutsideDomain(const Point& uv)
    : std::domain_error(finite(uv.x(), uv.y())
                            ? fmt::format("({}, {}) is not in the domain", uv.x(), uv.y())
                            : "what is not finite is not in the domain"),
      uv_(uv) {}

struct Map::Data {
  int degree;
  std::vector<Straight> straight;
  std::vector<Net> nets;
  Box domain_box, shape_box;
  double domain_tolerance, shape_tolerance;
  BoxTree domain_tree, shape_tree;

  explicit Data(const Result& result) : degree(result.degree) {
    check_structure(result);
    domain_box = box_of(result.domain_vertices);
    shape_box = box_of(result.control_points);
    domain_tolerance = kTolerance * largest_coordinate(domain_box);
    shape_tolerance = kTolerance * largest_coordinate(shape_box);
    std::vector<Box> domain_boxes, shape_boxes;
    for (std::size_t t = 0; t < result.triangles.size(); ++t) {
      std::array<Point, 3> corners;
      for (int k = 0; k < 3; ++k) corners[k] = result.domain_vertices[result.triangles[t][k]];
      straight.emplace_back(static_cast<int>(t), corners);
      Net net;
      for (const int id : result.triangle_control_points[t])
        net.push_back(result.control_points[id]);
      domain_boxes.push_back(grown(box_of({corners.begin(), corners.end()}), domain_tolerance));
      shape_boxes.push_back(grown(box_of(net), shape_tolerance));
      nets.push_back(std::move(net));
    }
    domain_tree = BoxTree(domain_boxes);
    shape_tree = BoxTree(shape_boxes);
  }

  std::size_t index(int triangle) const {
    if (triangle < 0 || static_cast<std::size_t>(triangle) >= straight.size())
      throw std::out_of_range(
          fmt::format("there is no triangle {}, only {}", triangle, straight.size()));
    return static_cast<std::size_t>(triangle);
  }

  Point uv(int triangle, const Barycentric& at) const {
    const std::array<Point, 3>& corner = straight[triangle].corner;
    return at[0] * corner[0] + at[1] * corner[1] + at[2] * corner[2];
  }
};

Map::Map(const Result& result) : data_(std::make_shared<const Data>(result)) {}

int Map::degree() const {
  return data_->degree;
}
int Map::triangles() const {
  return static_cast<int>(data_->straight.size());
}
const Box& Map::domain_box() const {
  return data_->domain_box;
}
const Box& Map::shape_box() const {
  return data_->shape_box;
}
double Map::domain_tolerance() const {
  return data_->domain_tolerance;
}
double Map::shape_tolerance() const {
  return data_->shape_tolerance;
}

std::optional<DomainPoint> Map::find(double u, double v) const {
  if (!finite(u, v)) return std::nullopt;
  const Point uv(u, v);
  for (const int t : data_->domain_tree.containing(uv)) {
    const Barycentric at = data_->straight[t].barycentric(uv);
    if (data_->straight[t].contains(at, data_->domain_tolerance)) return DomainPoint{t, at, uv};
  }
  return std::nullopt;
}

DomainPoint Map::at(int triangle, const Barycentric& barycentric) const {
  data_->index(triangle);
  return {triangle, barycentric, data_->uv(triangle, barycentric)};
}

DomainPoint Map::at(int triangle, const Point& uv) const {
  return {triangle, data_->straight[data_->index(triangle)].barycentric(uv), uv};
}

// With (s, t) = F^-1 ((u, v) - corner 0) the derivatives over the unit triangle become
// J = [d/ds, d/dt] F^-1, and those of second order F^-T [d²/ds², d²/dsdt; d²/dsdt, d²/dt²] F^-1.
Jet Map::jet(const DomainPoint& place) const {
  const std::size_t t = data_->index(place.triangle);
  const TriangleJet unit = jet_of(data_->nets[t], data_->degree, place.barycentric);
  const Eigen::Matrix2d& inverse = data_->straight[t].inverse;
  Jet out;
  out.value = unit.value;
  Eigen::Matrix2d first;
  first << unit.first[0], unit.first[1];
  out.jacobian = first * inverse;
  for (int axis = 0; axis < 2; ++axis) {
    Eigen::Matrix2d second;
    second << unit.second[0][axis], unit.second[1][axis], unit.second[1][axis],
        unit.second[2][axis];
    out.hessian[axis] = inverse.transpose() * second * inverse;
    // To rounding it is; users may rely on it bit for bit.
    out.hessian[axis](1, 0) = out.hessian[axis](0, 1);
  }
  return out;
}

Point Map::evaluate(const DomainPoint& place) const {
  return c1mesh::evaluate(data_->nets[data_->index(place.triangle)], data_->degree,
                          place.barycentric);
}

Eigen::Matrix2d Map::jacobian(const DomainPoint& place) const {
  return jet(place).jacobian;
}

Hessians Map::hessian(const DomainPoint& place) const {
  return jet(place).hessian;
}

namespace {

DomainPoint found_or_throw(const Map& map, double u, double v) {
  if (const std::optional<DomainPoint> place = map.find(u, v)) return *place;
  throw OutsideDomain(Point(u, v));
}

}  // namespace

Point Map::evaluate(double u, double v) const {
  return evaluate(found_or_throw(*this, u, v));
}

Eigen::Matrix2d Map::jacobian(double u, double v) const {
  return jacobian(found_or_throw(*this, u, v));
}

Hessians Map::hessian(double u, double v) const {
  return hessian(found_or_throw(*this, u, v));
}

std::optional<DomainPoint> Map::locate(double x, double y) const {
  if (!finite(x, y)) return std::nullopt;
  const Point xy(x, y);
  for (const int t : data_->shape_tree.containing(xy))
    if (const std::optional<Barycentric> at =
            invert(data_->nets[t], data_->degree, xy, data_->shape_tolerance))
      return DomainPoint{t, *at, data_->uv(t, *at)};
  return std::nullopt;
}

}  // namespace c1mesh
