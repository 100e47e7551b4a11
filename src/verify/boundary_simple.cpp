// SPDX-License-Identifier: GPL-3.0-or-later
// The image of the boundary is made of simple loops that keep apart. With det J > 0 everywhere and
// one counter-clockwise loop per piece, degree theory makes the map of each piece injective: every
// point has as many preimages as the boundary winds around it, and no pre-image counts negative.
#include <algorithm>
#include <array>
#include <map>

#include "verify/boxes.h"
#include "verify/checks.h"
#include "verify/curve_pairs.h"

namespace c1mesh::verification {
namespace {

struct Findings {
  Faults crossing;
  Faults unknown;
};

void note(Meeting meeting, const std::string& what, Findings& findings) {
  if (meeting == Meeting::meet) findings.crossing.add(what);
  if (meeting == Meeting::unknown) findings.unknown.add(what);
}

std::vector<Point> backward(std::vector<Point> poles) {
  std::reverse(poles.begin(), poles.end());
  return poles;
}

Meeting compare(const BoundaryRow& r, const BoundaryRow& s, ProofTree& tree) {
  if (r.a == s.b && r.b == s.a)
    return curves_meet(r.poles, backward(s.poles), Shared::both_ends, tree);
  if (r.b == s.a) return curves_meet(backward(r.poles), s.poles, Shared::start, tree);
  if (r.a == s.b) return curves_meet(r.poles, backward(s.poles), Shared::start, tree);
  for (const Point& p : {r.poles.front(), r.poles.back()})
    for (const Point& q : {s.poles.front(), s.poles.back()})
      if (p == q) return Meeting::meet;
  return curves_meet(r.poles, s.poles, Shared::none, tree);
}

/// Proofs for pairs of rows, searched for or followed, and those that have splits.
class PairProofs {
 public:
  PairProofs(const Subject& subject, Certificate& certificate, Faults& record)
      : depth_(subject.options.max_subdivision), made_(certificate), record_(record) {
    if (!subject.given) return;
    follows_ = true;
    for (const PairProof& proof : subject.given->boundary) given_[proof.edges] = proof.marks;
  }

  /// `look` compares the pair with the tree it is given.
  template <class Look>
  Meeting prove(const BoundaryRow& r, const BoundaryRow& s, const Look& look) {
    const std::array<int, 4> edges{r.a, r.b, s.a, s.b};
    ProofTree tree = comparison_tree(depth_);
    if (follows_) follow(edges, tree);
    const Meeting meeting = look(tree);
    if (follows_ && (meeting != Meeting::apart || !tree.complete()))
      record_.add(fmt::format("the proof of the edges ({}, {}) and ({}, {}) does not hold",
                              edges[0], edges[1], edges[2], edges[3]));
    if (!tree.marks().empty()) made_.boundary.push_back({edges, tree.marks()});
    return meeting;
  }

  /// What was given and never used.
  void note_unused() {
    for (const auto& [edges, marks] : given_)
      record_.add(fmt::format("the edges ({}, {}) and ({}, {}) need no proof", edges[0], edges[1],
                              edges[2], edges[3]));
  }

 private:
  void follow(const std::array<int, 4>& edges, ProofTree& tree) {
    const auto found = given_.find(edges);
    tree.follow(found == given_.end() ? ProofMarks() : found->second);
    if (found != given_.end()) given_.erase(found);
  }

  int depth_;
  bool follows_ = false;
  std::map<std::array<int, 4>, ProofMarks> given_;
  Certificate& made_;
  Faults& record_;
};

void check_pairs(const std::vector<BoundaryRow>& rows, PairProofs& proofs, Findings& findings) {
  std::vector<Box> boxes;
  for (const BoundaryRow& row : rows) boxes.push_back(box_of(row.poles));
  for (const BoundaryRow& row : rows)
    note(proofs.prove(row, row, [&](ProofTree& tree) { return meets_itself(row.poles, tree); }),
         fmt::format("edge ({}, {}) meets itself", row.a, row.b), findings);
  for (const auto& [i, j] : meeting_pairs(boxes))
    note(
        proofs.prove(
            rows[i], rows[j],
            [&, &r = rows[i], &s = rows[j]](ProofTree& tree) { return compare(r, s, tree); }),
        fmt::format("edges ({}, {}) and ({}, {}) meet", rows[i].a, rows[i].b, rows[j].a, rows[j].b),
        findings);
}

using LoopCurves = std::vector<std::vector<Point>>;

/// Each piece needs exactly one counter-clockwise loop.
void check_outer_loops(const Surface& surface, const std::vector<LoopCurves>& loops,
                       std::vector<int>& outer, Findings& findings) {
  outer.assign(surface.components, -1);
  std::vector<int> count(surface.components, 0);
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const int sign = area_sign(loops[l]);
    if (sign == 0) findings.unknown.add(fmt::format("the area inside loop {} may be zero", l));
    if (sign <= 0) continue;
    ++count[surface.loop_component[l]];
    outer[surface.loop_component[l]] = static_cast<int>(l);
  }
  for (int c = 0; c < surface.components; ++c)
    if (count[c] != 1)
      findings.crossing.add(fmt::format("piece {} has {} counter-clockwise loops", c, count[c]));
}

/// No piece lies inside another: the boundary of each winds zero times around the others.
void check_pieces_apart(const Surface& surface, const std::vector<LoopCurves>& loops,
                        const std::vector<int>& outer, int depth, Findings& findings) {
  std::vector<Box> box;
  for (const LoopCurves& loop : loops) {
    std::vector<Point> all;
    for (const auto& poles : loop) all.insert(all.end(), poles.begin(), poles.end());
    box.push_back(box_of(all));
  }
  std::vector<Point> starts;  // one on each piece's outer loop
  std::vector<int> piece;     // whose
  for (int c = 0; c < surface.components; ++c) {
    if (outer[c] < 0) continue;
    starts.push_back(loops[outer[c]][0][0]);
    piece.push_back(c);
  }
  // Outside its box a loop winds zero times.
  std::map<std::pair<int, int>, int> number;  // (piece, other piece)
  for (const auto& [i, l] : containing_pairs(starts, box)) {
    const int c = piece[i], other = surface.loop_component[l];
    if (c == other) continue;
    const Winding winding = winding_around(loops[l], starts[i], depth);
    if (!winding.known) findings.unknown.add(fmt::format("piece {} may lie in piece {}", c, other));
    number[{c, other}] += winding.number;
  }
  for (const auto& [pieces, winding] : number)
    if (winding != 0)
      findings.crossing.add(fmt::format("piece {} lies in piece {}", pieces.first, pieces.second));
}

}  // namespace

VerifyItem check_boundary_simple(const Subject& subject, Certificate& certificate, Faults& record) {
  const std::string name = "boundary simple";
  const Surface& surface = subject.surface;
  const int depth = subject.options.max_subdivision;
  Findings findings;
  std::vector<BoundaryRow> rows;
  std::vector<LoopCurves> loops;
  for (const auto& loop : surface.loops) {
    LoopCurves curves;
    for (BoundaryRow& row : rows_of(subject, loop)) {
      curves.push_back(row.poles);
      rows.push_back(std::move(row));
    }
    if (curves.empty()) return {name, Verdict::undecided, "the mesh has no closed boundary"};
    loops.push_back(std::move(curves));
  }
  PairProofs proofs(subject, certificate, record);
  check_pairs(rows, proofs, findings);
  proofs.note_unused();
  std::vector<int> outer;
  check_outer_loops(surface, loops, outer, findings);
  if (findings.crossing.count() == 0) check_pieces_apart(surface, loops, outer, depth, findings);
  if (findings.crossing.count() > 0) return findings.crossing.item(name, "");
  if (findings.unknown.count() > 0)
    return {name, Verdict::undecided,
            "not proven that these keep apart: " + findings.unknown.text()};
  return {name, Verdict::valid, fmt::format("{} edges meet only at their ends", rows.size())};
}

}  // namespace c1mesh::verification
