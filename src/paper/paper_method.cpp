// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/paper_method.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/extent.h"
#include "domain/start.h"
#include "mesh/topology.h"
#include "optimise/stages.h"
#include "paper/phase.h"

namespace c1mesh {
namespace {

constexpr double kRepetition = 1e-3;  // of the first smoothing, in repetitions
constexpr double kRoom = 1.05;        // of a bound above what it bounds at first
constexpr int kReleases = 3;          // rounds of giving up what phase two misses

std::vector<char> branch_points(const CurvedMesh& initial, const Joints& joints) {
  std::vector<char> out(initial.vertex_count(), 0);
  for (const auto& path : joints)
    for (const Joint& j : path)
      if (j.branch) out[j.vertex] = 1;
  return out;
}

// The largest d_ei of an edge, from whichever side it is larger: they differ by the factor gamma_2.
double largest_deviation(const C1Edge& e, const Pair& state) {
  const Eigen::Vector3d gamma = edge_barycentric(e, state.domain);
  double largest = 0;
  for (int i = 0; i < e.equations(); ++i)
    largest = std::max(largest, c1_residue(e, i, gamma, state.control).norm());
  return largest / std::min(1.0, std::abs(gamma[2]));
}

class PaperMethod {
 public:
  PaperMethod(const CurvedMesh& initial, const Joints& joints, const Options& options,
              const Checkpoint& checkpoint)
      : initial_(initial),
        joints_(joints),
        options_(options),
        checkpoint_(checkpoint),
        extent_(extent_of(initial.control)),
        mips_bound_(options.mips_bound) {
    out_.state = {domain_points(initial), initial.control};
    for (double g : distortion_bounds(initial, out_.state.domain, initial.control))
      mips_bound_ = std::max(mips_bound_, g);
  }

  PaperSolution run() {
    // Branch points of features are exceptional from the start (paper, section 5.2).
    out_.exceptional = branch_points(initial_, joints_);
    const PaperStage last = options_.paper.last_stage;
    if (last == PaperStage::initial) return claim_nothing();
    for (pass_ = 1; pass_ <= options_.repeat && !out_.interrupted; ++pass_) {
      phase_one();
      if (last == PaperStage::phase_one && pass_ == options_.repeat) return claim_nothing();
      determine_exceptional();
      if (!out_.interrupted) phase_two();
    }
    find_relaxed();
    return std::move(out_);
  }

 private:
  double lifted_bound() const { return options_.paper.alpha_lift * options_.alpha * mips_bound_; }

  // The barrier's smooth bound of g, with some room above it.
  double bound_with_room() const {
    const PaperObjective state(initial_, {}, out_.state, false);
    return kRoom * state.largest_distortion(state.pack(out_.state));
  }

  // E_s + lambda_reg E_reg + rho E_g in units of which `extent` make the shape's, divided by the
  // length of such a unit in the normalised frame.
  PhaseOptions phase_options(int phase) const {
    const PaperOptions& p = options_.paper;
    const double unit = p.extent / extent_;
    PhaseOptions out;
    out.weights.regularisation = p.regularisation[phase] * unit;
    out.weights.hard_penalty = p.hard_penalty[phase];
    out.weights.barrier = p.barrier / unit;
    // A repetition starts near a minimum: as smooth norms as at first would lead away from it.
    const double first = pass_ > 1 ? kRepetition * p.smoothing[0] : p.smoothing[0];
    out.smoothing[0] = std::max(first, p.smoothing[1]) * extent_;
    out.smoothing[1] = p.smoothing[1] * extent_;
    out.iterations = p.iterations[phase];
    out.domain_free = phase == 0;
    out.no_overlap = options_.no_overlap;
    return out;
  }

  void optimise(const char* stage, const AskedEdges& asked, const PhaseOptions& options) {
    const auto observer = [&](const PaperObjective& objective, const Eigen::VectorXd& x,
                              double step) {
      const PaperTerms terms = objective.terms(x);
      TraceRecord record;
      record.pass = pass_;
      record.stage = stage;
      record.e_s = terms.soft + terms.hard;
      record.e_reg = terms.regulariser;
      record.g = terms.g;
      record.step = step;
      if (!options.domain_free)
        record.exceptional =
            static_cast<int>(std::count(out_.exceptional.begin(), out_.exceptional.end(), 1));
      checkpoint_.trace(record);
    };
    try {
      run_phase(initial_, asked, options, out_.state, checkpoint_,
                checkpoint_.trace ? PhaseObserver(observer) : PhaseObserver());
    } catch (const TimeLimitReached&) {
      out_.interrupted = true;
    }
  }

  void phase_one() {
    PhaseOptions options = phase_options(0);
    // In a repetition the state comes from under the lifted bound; and the barrier's smooth bound
    // exceeds g, which matters where alpha is near one.
    options.weights.bound = std::max(options_.alpha * mips_bound_, bound_with_room());
    optimise("phase one", classify_edges(initial_, branch_points(initial_, joints_)), options);
  }

  void determine_exceptional() {
    // So that the barrier's smooth bound is under the lifted bound where g is.
    const JacobianTables& tables = JacobianTables::of(initial_.degree);
    const double slack = std::pow(tables.det_size, 2 / DistortionBarrier(initial_.degree).exponent);
    const Straightened s =
        straighten(initial_, joints_, out_.state,
                   {lifted_bound() / slack, options_.paper.straightening, options_.no_overlap});
    out_.state.domain = s.domain;
    out_.exceptional = exceptional_corners(initial_, joints_, s);
    out_.notes.push_back(fmt::format(
        "pass {}: straightening moved a domain vertex by {:.1e} of the extent, undone {} times",
        pass_, s.largest_move, s.restored));
  }

  void phase_two() {
    PhaseOptions options = phase_options(1);
    // Phase one may have been given more room than the lifted bound, where that is tight.
    const double room = bound_with_room();
    options.weights.bound = room < kRoom * lifted_bound() ? lifted_bound() : room;
    optimise("phase two", classify_edges(initial_, out_.exceptional), options);
    for (int round = 0; round < kReleases && !out_.interrupted && release(); ++round)
      optimise("phase two", classify_edges(initial_, out_.exceptional), options);
  }

  // Vertices on curves where C1 was not reached as asked are given up as well, so that they do not
  // spoil their surroundings: corners of the shape that the domain does not let be C1, and vertices
  // that straightening has put far from where phase one had them.
  bool release() {
    const AskedEdges asked = classify_edges(initial_, out_.exceptional);
    const std::vector<char> on_curve = on_curves(initial_);
    int released = 0;
    for (const auto* edges : {&asked.soft, &asked.hard})
      for (const C1Edge& e : *edges) {
        if (largest_deviation(e, out_.state) <= c1_asked(options_) * extent_) continue;
        for (int v : {e.vertex[0], e.vertex[1]})
          if (on_curve[v] && !out_.exceptional[v]) {
            out_.exceptional[v] = 1;
            ++released;
          }
      }
    if (released > 0)
      out_.notes.push_back(fmt::format("pass {}: C1 given up at {} more where phase two missed it",
                                       pass_, released));
    return released > 0;
  }

  PaperSolution claim_nothing() {
    out_.exceptional.assign(initial_.vertex_count(), 1);
    find_relaxed();
    return std::move(out_);
  }

  void find_relaxed() {
    const MeshTopology topology(initial_);
    const std::vector<char> feature = feature_flags(initial_, topology);
    for (std::size_t i = 0; i < topology.edges.size(); ++i) {
      const MeshEdge& e = topology.edges[i];
      if (e.triangle[1] < 0) continue;
      if (feature[i] || out_.exceptional[e.a] || out_.exceptional[e.b])
        out_.relaxed.push_back({e.a, e.b});
    }
  }

  const CurvedMesh& initial_;
  const Joints& joints_;
  const Options& options_;
  int pass_ = 1;
  const Checkpoint& checkpoint_;
  double extent_, mips_bound_;
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
    if (exceptional[e.a] || exceptional[e.b]) continue;
    const bool soft = initial.warped[e.triangle[0]] || initial.warped[e.triangle[1]];
    (soft ? out.soft : out.hard).push_back(std::move(edge));
  }
  return out;
}

PaperSolution run_paper_method(const CurvedMesh& initial, const Joints& joints,
                               const Options& options, const Checkpoint& checkpoint) {
  return PaperMethod(initial, joints, options, checkpoint).run();
}

}  // namespace c1mesh
