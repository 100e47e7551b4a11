// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/phases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "domain/apart.h"
#include "domain/start.h"
#include "mesh/topology.h"
#include "optimise/stages.h"

namespace c1mesh {
namespace {

class PaperMethod {
 public:
  PaperMethod(const CurvedMesh& initial, const Joints& joints, const Options& options, int region,
              const Checkpoint& checkpoint, const Trace& trace)
      : initial_(initial),
        joints_(joints),
        options_(options),
        region_(region),
        checkpoint_(checkpoint),
        trace_(trace) {
    const auto box = extent_of(initial.control);
    extent_ = box;
    out_.state = {domain_points(initial), initial.control};
    for (double g : distortion_bounds(initial, out_.state.domain, initial.control))
      mips_bound_ = std::max(mips_bound_, g);
    mips_bound_ = std::max(mips_bound_, options.mips_bound);
  }

  PaperSolution run() {
    // Branch points of features are exceptional from the start.
    out_.exceptional.assign(initial_.vertex_count(), 0);
    for (const auto& path : joints_)
      for (const Joint& j : path)
        if (j.branch) out_.exceptional[j.vertex] = 1;
    for (int pass = 1; pass <= options_.repeat; ++pass) {
      phase_one(pass);
      determine_exceptional(pass);
      phase_two(pass);
    }
    find_relaxed();
    return std::move(out_);
  }

 private:
  static double extent_of(const std::vector<Point>& points) {
    Point low = points.front(), high = low;
    for (const Point& p : points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    return (high - low).maxCoeff();
  }

  // E_s + lambda_reg E_reg + rho E_g in units of which `extent` make the shape's, divided by the
  // length of such a unit in the normalised frame.
  PaperWeights weights_of(int phase, double bound) const {
    const PaperOptions& p = options_.paper;
    const double unit = p.extent / extent_;
    PaperWeights w;
    w.regularisation = p.regularisation[phase] * unit;
    w.hard_penalty = p.hard_penalty[phase];
    w.barrier = p.barrier / unit;
    w.bound = bound;
    return w;
  }

  void record(const PaperObjective& objective, const Eigen::VectorXd& x, const char* stage,
              int pass, int iteration, double step, int exceptional) const {
    if (!trace_) return;
    const PaperTerms terms = objective.terms(x);
    trace_({region_, pass, stage, iteration, terms.soft + terms.hard, terms.regulariser, terms.g,
            step, exceptional});
  }

  // Newton while the norms' smoothing falls tenfold.
  void minimise(PaperObjective& objective, int phase, const char* stage, int pass,
                int exceptional) {
    const PaperOptions& p = options_.paper;
    Eigen::VectorXd x = objective.pack(out_.state);
    SparseSolver solver;
    int left = p.iterations[phase], iteration = 0;
    const double levels = std::log10(p.smoothing[0] / p.smoothing[1]);
    const int per_level = std::max(1, static_cast<int>(left / (std::floor(levels + 0.5) + 1)));
    for (double epsilon = p.smoothing[0]; left > 0; epsilon *= 0.1) {
      const bool last = epsilon <= p.smoothing[1] * 1.0001;
      objective.weights.smoothing = std::max(epsilon, p.smoothing[1]) * extent_;
      for (int k = last ? left : std::min(left, per_level); k > 0; --k, --left) {
        checkpoint_();
        double value, step;
        const double decrease = newton_step(objective, solver, x, value, step);
        record(objective, x, stage, pass, ++iteration, step, exceptional);
        if (!(decrease > 1e-4 * std::abs(value))) break;
      }
      if (last) break;
    }
    out_.state = objective.unpack(x);
  }

  void phase_one(int pass) {
    const double bound = options_.alpha * mips_bound_;
    PaperObjective objective(initial_, classify_edges(initial_, branch_points()), out_.state, true);
    objective.weights = weights_of(0, bound);
    // In a repetition the state comes from under the lifted bound.
    const double start = objective.largest_distortion(objective.pack(out_.state));
    objective.weights.bound = std::max(bound, 1.05 * start);
    minimise(objective, 0, "phase one", pass, -1);
  }

  std::vector<char> branch_points() const {
    std::vector<char> out(initial_.vertex_count(), 0);
    for (const auto& path : joints_)
      for (const Joint& j : path)
        if (j.branch) out[j.vertex] = 1;
    return out;
  }

  void determine_exceptional(int pass) {
    // g_p of the barrier exceeds g by this factor at most.
    const JacobianTables& tables = JacobianTables::of(initial_.degree);
    const double slack = std::pow(tables.det_size, 2 / DistortionBarrier(initial_.degree).exponent);
    out_.bound = options_.paper.alpha_lift * options_.alpha * mips_bound_;
    const Straightened s =
        straighten(initial_, joints_, out_.state, out_.bound / slack, options_.paper.straightening);
    out_.state.domain = s.domain;
    out_.exceptional = exceptional_corners(initial_, joints_, s);
    out_.notes.push_back(
        fmt::format("pass {}: straightening moved a domain vertex by {:.1e}, {} undone", pass,
                    s.largest_move, s.restored));
  }

  void phase_two(int pass) {
    const auto count = std::count(out_.exceptional.begin(), out_.exceptional.end(), 1);
    PaperObjective objective(initial_, classify_edges(initial_, out_.exceptional), out_.state,
                             false);
    objective.weights = weights_of(1, out_.bound);
    minimise(objective, 1, "phase two", pass, static_cast<int>(count));
  }

  void find_relaxed() {
    const MeshTopology topology(initial_);
    const std::vector<char> feature = feature_flags(initial_, topology);
    for (std::size_t i = 0; i < topology.edges.size(); ++i) {
      const MeshEdge& e = topology.edges[i];
      if (e.triangle[1] < 0) continue;
      const bool soft = initial_.warped[e.triangle[0]] || initial_.warped[e.triangle[1]];
      if (feature[i] || (soft && (out_.exceptional[e.a] || out_.exceptional[e.b])))
        out_.relaxed.push_back({e.a, e.b});
    }
  }

  const CurvedMesh& initial_;
  const Joints& joints_;
  const Options& options_;
  int region_;
  const Checkpoint& checkpoint_;
  const Trace& trace_;
  double extent_ = 1, mips_bound_ = 0;
  PaperSolution out_;
};

}  // namespace

AskedEdges classify_edges(const CurvedMesh& initial, const std::vector<char>& exceptional) {
  AskedEdges out;
  const MeshTopology topology(initial);
  const std::vector<char> feature = feature_flags(initial, topology);
  std::vector<C1Edge> edges = c1_edges(initial);  // in the topology's order
  std::size_t next = 0;
  for (std::size_t i = 0; i < topology.edges.size(); ++i) {
    const MeshEdge& e = topology.edges[i];
    if (e.triangle[1] < 0 || feature[i]) continue;
    C1Edge& edge = edges[next++];
    if (!initial.warped[e.triangle[0]] && !initial.warped[e.triangle[1]])
      out.hard.push_back(std::move(edge));
    else if (!exceptional[e.a] && !exceptional[e.b])
      out.soft.push_back(std::move(edge));
  }
  return out;
}

PaperSolution run_paper_method(const CurvedMesh& initial, const Joints& joints,
                               const Options& options, int region, const Checkpoint& checkpoint,
                               const Trace& trace) {
  return PaperMethod(initial, joints, options, region, checkpoint, trace).run();
}

}  // namespace c1mesh
