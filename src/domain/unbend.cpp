// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/unbend.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "c1mesh/cost.h"
#include "domain/apart.h"
#include "domain/minimise.h"
#include "domain/start.h"
#include "domain/unbend_objective.h"

namespace c1mesh {
namespace {

using Complex = std::complex<double>;

// What a boundary vertex's edges do on the way from the initial domain to the layout: e1 = ratio
// e0.
struct Turn {
  std::array<int, 3> points{};  // previous, vertex, next
  Complex start;                // e1 / e0 of the initial domain
  Complex target;               // what the layout asks
  int wedge = -1;               // stands in for this wedge until that is on its right side
  Point multiplier = Point::Zero();
};

Point along(const Eigen::VectorXd& x, int from, int to) {
  return x.segment<2>(2 * to) - x.segment<2>(2 * from);
}

Turn turn_at(const Joint& joint, const Eigen::VectorXd& x) {
  Turn turn;
  turn.points = {joint.previous, joint.vertex, joint.next};
  const Point e0 = along(x, turn.points[0], turn.points[1]);
  const Point e1 = along(x, turn.points[1], turn.points[2]);
  turn.start = Complex(e1.x(), e1.y()) / Complex(e0.x(), e0.y());
  return turn;
}

// The layout's ratio at a vertex within a chain or at a mild anchor. What a bent joint's free
// vector would be is e0 turned by 90 degrees here, the optimum of its wedge.
Complex asked_ratio(const Joint& joint, Role role) {
  return {joint.ratio, role == Role::flat ? 0 : joint.kappa};
}

// The turn at which a corner's wedge is lowest. It compares e1 and -e0, convex ones in this order.
Complex optimum_of(const DomainElement& wedge, const Turn& turn) {
  // metric_of([a, b]) = [b.b, -a.b; -a.b, a.a] / det: the cotangent of the angle from a to b.
  const Eigen::Matrix2d& G = wedge.metric;
  const double angle = std::atan2(1.0, -G(0, 1));
  const double lengths = std::sqrt(G(1, 1) / G(0, 0));  // |a| / |b|
  return wedge.points[1] == turn.points[2] ? std::polar(lengths, std::numbers::pi - angle)
                                           : std::polar(1 / lengths, angle - std::numbers::pi);
}

// The wedge of a mild anchor, on tips in the layout, over its neighbours: w = (e1 - r e0) / kappa.
DomainElement over_neighbours(DomainElement wedge, const Joint& joint, const Turn& turn) {
  wedge.points = turn.points;
  wedge.columns << -1, joint.ratio / joint.kappa, 1, -(1 + joint.ratio) / joint.kappa, 0,
      1 / joint.kappa;
  return wedge;
}

// Vertex k of a chain at start + F_k (end - start), F_k the fraction of the partial sums of
// products of the asked ratios: where the layout puts it.
void add_chain_springs(const std::vector<Joint>& loop, const std::vector<Role>& roles,
                       std::size_t first, std::vector<Spring>& out) {
  const std::size_t m = loop.size();
  std::vector<Complex> sums = {0};
  Complex edge = 1;
  std::size_t last = first;
  do {
    if (last > first) edge *= asked_ratio(loop[last % m], roles[last % m]);
    sums.push_back(sums.back() + edge);
    ++last;
  } while (!ends_chain(roles[last % m]));
  for (std::size_t k = first + 1; k < last; ++k) {
    const Complex fraction = sums[k - first] / sums.back();
    Spring spring;
    spring.points = {loop[first].vertex, loop[k % m].vertex, loop[last % m].vertex};
    spring.factor = {fraction - 1.0, 1, -fraction};
    out.push_back(spring);
  }
}

class Unbending {
 public:
  Unbending(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
            const DomainElements& given, bool apart, const Checkpoint& checkpoint)
      : mesh_(mesh),
        apart_(apart),
        joints_(joints),
        checkpoint_(checkpoint),
        objective_(mesh),
        x_(2 * mesh.vertex_count()) {
    for (int v = 0; v < mesh.vertex_count(); ++v) x_.segment<2>(2 * v) = mesh.domain[v];
    objective_.elements.assign(given.all.begin(), given.all.begin() + given.triangles);
    for (std::size_t l = 0; l < joints.size(); ++l)
      for (std::size_t k = 0; k < joints[l].size(); ++k) {
        if (ends_chain(roles[l][k])) {
          // A chain begins at each of its path's chain ends but an open path's last.
          if (joints[l][k].next >= 0) add_chain_springs(joints[l], roles[l], k, chains_);
          continue;
        }
        turns_.push_back(turn_at(joints[l][k], x_));
        turns_.back().target = asked_ratio(joints[l][k], roles[l][k]);
      }
    add_wedges(roles, given);
  }

  // The most that the turns of one chain add up to, from the initial domain to the layout.
  double largest_turn(const Roles& roles) const {
    std::vector<double> turn_of(mesh_.vertex_count(), 0);
    for (const Turn& turn : turns_)
      if (turn.wedge < 0) turn_of[turn.points[1]] = std::arg(turn.start / turn.target);
    double largest = 0;
    for (std::size_t l = 0; l < joints_.size(); ++l) {
      const std::size_t m = joints_[l].size();
      double sum = 0;
      // Twice around: the chain over the loop's first vertex is whole the second time.
      for (std::size_t k = 0; k < 2 * m; ++k) {
        sum = ends_chain(roles[l][k % m]) ? 0 : sum + turn_of[joints_[l][k % m].vertex];
        largest = std::max(largest, std::abs(sum));
      }
    }
    return largest;
  }

  // Newton with the turns at `left` (1: the initial ones, 0: the layout's) of their way.
  void turn(double left, double stiffness, int iterations) {
    objective_.springs = turn_springs(left);
    relax(stiffness, iterations);
  }

  // Newton with the chains' vertices drawn to their positions. The turns stay, without multipliers:
  // at the layout's positions they ask for nothing.
  void straighten(double stiffness, double turn_stiffness, int iterations) {
    const std::vector<double> lengths = local_lengths();
    for (Spring& spring : chains_) spring.length2 = lengths[spring.points[1]];
    objective_.springs = turn_springs(0);
    for (Spring& spring : objective_.springs) spring.stiffness = turn_stiffness / stiffness;
    objective_.springs.insert(objective_.springs.end(), chains_.begin(), chains_.end());
    relax(stiffness, iterations);
  }

  // After `straighten`: the chains' springs, and those that turn a wedge to its right side.
  void update_multipliers(double stiffness, double turn_stiffness) {
    const double unit = 1.0 / mesh_.triangle_count();
    for (Spring& spring : chains_)
      spring.multiplier += unit * stiffness / spring.length2 * residue_of(spring, x_);
    const std::vector<Spring> springs = turn_springs(0);
    for (std::size_t k = 0; k < turns_.size(); ++k)
      if (turns_[k].wedge >= 0)
        turns_[k].multiplier +=
            unit * turn_stiffness / springs[k].length2 * residue_of(springs[k], x_);
  }

  double residue() const {
    double largest = 0;
    for (const Spring& spring : chains_)
      largest = std::max(largest, residue_of(spring, x_).norm() / std::sqrt(spring.length2));
    return largest;
  }

  PointMatrix positions() const { return unflatten(x_); }

  // Are the layout's positions valid, and all between?
  bool reaches(const DomainElements& given, const PointMatrix& points) const {
    const bool positive =
        std::all_of(given.all.begin(), given.all.end(),
                    [&](const DomainElement& e) { return determinant_of(e, points) > 0; });
    if (!positive) return false;
    const Eigen::VectorXd step = flatten(points).head(x_.size()) - x_;
    return objective_.step_limit(x_, step) == 1 && std::isfinite(objective_.value(x_ + step));
  }

  int iterations() const { return iterations_; }

 private:
  // Wedges on their right side are elements from the start; for the others a spring turns the
  // vertex first. Bent joints have none: their turn is asked exactly.
  void add_wedges(const Roles& roles, const DomainElements& given) {
    std::vector<std::vector<const Joint*>> joints_at(mesh_.vertex_count());
    for (const auto& path : joints_)
      for (const Joint& joint : path)
        if (joint.kind != JointKind::end) joints_at[joint.vertex].push_back(&joint);
    for (std::size_t e = given.triangles; e < given.all.size(); ++e) {
      // Several paths meet in a branch point; elsewhere there is one joint.
      const auto& choice = joints_at[given.all[e].points[0]];
      const auto match = std::find_if(choice.begin(), choice.end(), [&](const Joint* joint) {
        const auto& points = given.all[e].points;
        return std::count(points.begin(), points.end(), joint->previous) > 0 &&
               std::count(points.begin(), points.end(), joint->next) > 0;
      });
      const Joint& joint = match == choice.end() ? *choice.front() : **match;
      const Role role = roles[joint.loop][joint.position];
      if (role == Role::bent) continue;
      Turn turn = turn_at(joint, x_);
      const bool on_tips = role == Role::anchor && joint.kind == JointKind::mild;
      const DomainElement wedge =
          on_tips ? over_neighbours(given.all[e], joint, turn) : given.all[e];
      if (right_side(wedge)) {
        objective_.elements.push_back(wedge);
        continue;
      }
      turn.target = on_tips ? asked_ratio(joint, role) : optimum_of(wedge, turn);
      turn.wedge = static_cast<int>(waiting_.size());
      waiting_.push_back(wedge);
      turns_.push_back(turn);
    }
  }

  void relax(double stiffness, int iterations) {
    const int triangles = mesh_.triangle_count();
    objective_.stiffness = stiffness / triangles;
    const Eigen::VectorXd before = x_;
    for (const Flats flats : {Flats::left_out, Flats::kept}) {
      x_ = before;
      if (apart_)
        objective_.scaffold =
            scaffold_elements(mesh_, positions(), flats, scaffold_weight(triangles));
      iterations_ += newton(objective_, x_, {iterations, 1e-4}, checkpoint_).iterations;
      // Where even the whole scaffold does not help, the unbending goes on without.
      if (objective_.scaffold.empty() || !boundary_meets_itself(mesh_, positions())) break;
    }
    std::erase_if(turns_, [&](const Turn& turn) {
      if (turn.wedge < 0 || !right_side(waiting_[turn.wedge])) return false;
      objective_.elements.push_back(waiting_[turn.wedge]);
      return true;
    });
  }

  // |e0| |e1| at every boundary vertex.
  std::vector<double> local_lengths() const {
    std::vector<double> out(mesh_.vertex_count(), 1);
    for (const auto& path : joints_)
      for (const Joint& joint : path)
        if (joint.kind != JointKind::end)
          out[joint.vertex] = along(x_, joint.previous, joint.vertex).norm() *
                              along(x_, joint.vertex, joint.next).norm();
    return out;
  }

  std::vector<Spring> turn_springs(double left) const {
    const std::vector<double> lengths = local_lengths();
    std::vector<Spring> out;
    for (const Turn& turn : turns_) {
      const Complex ratio = turn.target * std::pow(turn.start / turn.target, left);
      Spring spring;
      spring.points = turn.points;
      spring.factor = {ratio, -1.0 - ratio, 1};
      spring.length2 = lengths[turn.points[1]];
      spring.multiplier = turn.multiplier;
      out.push_back(spring);
    }
    return out;
  }

  // Clearly so: a wedge that only just is would dominate all else.
  bool right_side(const DomainElement& element) const {
    const Eigen::Matrix2d D = columns_at(element, x_);
    return cross(D.col(0), D.col(1)) > 0.05 * D.col(0).norm() * D.col(1).norm();
  }

  const CurvedMesh& mesh_;
  bool apart_;
  const Joints& joints_;
  const Checkpoint& checkpoint_;
  UnbendObjective objective_;
  Eigen::VectorXd x_;
  std::vector<Turn> turns_;
  std::vector<Spring> chains_;
  std::vector<DomainElement> waiting_;
  int iterations_ = 0;
};

}  // namespace

PointMatrix unbend_domain(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                          const DomainLayout& layout, const DomainElements& elements,
                          const UnbendOptions& options, UnbendReport& report,
                          const Checkpoint& checkpoint) {
  const StageTimer timer("map: unbending");
  Unbending unbending(mesh, joints, roles, elements, options.apart, checkpoint);
  const int stages =
      std::max(options.stages,
               static_cast<int>(std::ceil(unbending.largest_turn(roles) / options.stage_turn)));
  for (int stage = 1; stage <= stages; ++stage)
    unbending.turn(1 - static_cast<double>(stage) / stages, options.loose, options.iterations);
  for (double stiffness = 4 * options.loose; stiffness <= options.tight; stiffness *= 4)
    unbending.turn(0, stiffness, options.iterations);
  PointMatrix unknowns;
  double stiffness = options.loose, before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < options.rounds && !report.reached; ++round) {
    unbending.straighten(stiffness, options.tight, options.iterations);
    unknowns = unknowns_near_points(unbending.positions(), joints, layout);
    report.residue = unbending.residue();
    report.reached = unbending.reaches(elements, layout.exact * unknowns);
    unbending.update_multipliers(stiffness, options.tight);
    if (report.residue > 0.5 * before) stiffness = std::min(options.most, 4 * stiffness);
    before = report.residue;
  }
  report.iterations = unbending.iterations();
  return unknowns;
}

}  // namespace c1mesh
