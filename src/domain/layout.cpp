// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/layout.h"

#include <cmath>
#include <map>
#include <stdexcept>

#include "c1mesh/cost.h"

namespace c1mesh {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

// Edge k of a chain is rho e_0 + sum_j bends[j] w_j, with j an unknown's index.
struct EdgeForm {
  double rho = 1;
  std::map<int, double> bends;
};

struct Chain {
  int loop, first, last;  // positions; last may exceed the loop's size (it wraps)
};

// The forms of the chain's edges, first to last (docs/method.md: e1 = r e0 + kappa w at a bent
// joint).
std::vector<EdgeForm> edge_forms(const Chain& chain, const Joints& joints, const Roles& roles,
                                 const DomainLayout& layout) {
  const auto& loop = joints[chain.loop];
  const int m = static_cast<int>(loop.size());
  std::vector<EdgeForm> forms(1);
  for (int k = chain.first + 1; k < chain.last; ++k) {
    const Joint& joint = loop[k % m];
    EdgeForm form = forms.back();
    form.rho *= joint.ratio;
    for (auto& [unknown, factor] : form.bends) factor *= joint.ratio;
    if (roles[chain.loop][k % m] == Role::bent)
      form.bends[layout.bend_unknown[chain.loop][k % m]] += joint.kappa;
    forms.push_back(form);
  }
  return forms;
}

// Position of vertex k: P_s + (R_k/R)(P_e - P_s) + sum_j (C_kj - (R_k/R) C_j) w_j, where R_k and
// C_kj are the partial sums of rho and of the bends up to edge k.
void place_chain(const Chain& chain, const std::vector<EdgeForm>& forms, const Joints& joints,
                 const DomainLayout& layout, Triplets& exact, Triplets& sparse) {
  const auto& loop = joints[chain.loop];
  const int m = static_cast<int>(loop.size());
  double total = 0;
  std::map<int, double> bend_total;
  for (const EdgeForm& form : forms) {
    total += form.rho;
    for (const auto& [unknown, factor] : form.bends) bend_total[unknown] += factor;
  }
  const int start = layout.unknown_of_row[loop[chain.first % m].vertex];
  const int end = layout.unknown_of_row[loop[chain.last % m].vertex];
  double sum = 0;
  std::map<int, double> bend_sum;
  for (int k = chain.first + 1; k < chain.last; ++k) {
    const EdgeForm& form = forms[k - chain.first - 1];
    sum += form.rho;
    for (const auto& [unknown, factor] : form.bends) bend_sum[unknown] += factor;
    const double f = sum / total;
    const int row = loop[k % m].vertex;
    for (Triplets* out : {&exact, &sparse}) {
      out->emplace_back(row, start, 1 - f);
      out->emplace_back(row, end, f);
    }
    for (const auto& [unknown, whole] : bend_total) {
      const auto part = bend_sum.find(unknown);
      const double factor = (part == bend_sum.end() ? 0 : part->second) - f * whole;
      exact.emplace_back(row, unknown, factor);
      if (std::abs(factor) > 1e-3) sparse.emplace_back(row, unknown, factor);
    }
  }
}

std::vector<Chain> chains_of(const Joints& joints, const Roles& roles) {
  std::vector<Chain> chains;
  for (std::size_t l = 0; l < roles.size(); ++l) {
    const int m = static_cast<int>(roles[l].size());
    const bool open = joints[l].front().kind == JointKind::end;
    int first = 0;
    while (first < m && !ends_chain(roles[l][first])) ++first;
    if (first == m) throw std::logic_error("a loop without chain ends");
    for (int k = first; k < (open ? m - 1 : first + m);) {
      int next = k + 1;
      while (!ends_chain(roles[l][next % m])) ++next;
      chains.push_back({static_cast<int>(l), k, next});
      k = next;
    }
  }
  return chains;
}

// Numbers the unknowns: vertices that no chain determines, then the vectors w.
int number_unknowns(const Joints& joints, const Roles& roles, int vertices, DomainLayout& layout) {
  layout.unknown_of_row.assign(vertices, 0);
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k)
      if (!ends_chain(roles[l][k])) layout.unknown_of_row[joints[l][k].vertex] = -1;
  int unknowns = 0;
  for (int& unknown : layout.unknown_of_row)
    if (unknown == 0) unknown = unknowns++;
  for (const auto& loop : roles) {
    layout.bend_unknown.emplace_back();
    for (const Role role : loop)
      layout.bend_unknown.back().push_back(role == Role::bent ? unknowns++ : -1);
  }
  return unknowns;
}

int number_tips(const Joints& joints, const Roles& roles, int rows, DomainLayout& layout) {
  for (std::size_t l = 0; l < joints.size(); ++l) {
    layout.tips.emplace_back(joints[l].size());
    for (std::size_t k = 0; k < joints[l].size(); ++k)
      if (joints[l][k].kind == JointKind::mild && !gives_up_c1(roles[l][k])) {
        layout.tips[l][k] = {rows, rows + 1};
        rows += 2;
      }
  }
  return rows;
}

// v + e0 = 2 v - previous; v + w with w the unknown of a bent joint, else (e1 - r e0) / kappa.
void place_tips(const Joints& joints, const Roles& roles, const DomainLayout& layout,
                const DomainLayout::Matrix& positions, Triplets& out) {
  const auto add = [&](int row, int vertex, double factor) {
    for (DomainLayout::Matrix::InnerIterator it(positions, vertex); it; ++it)
      out.emplace_back(row, static_cast<int>(it.col()), factor * it.value());
  };
  for (std::size_t l = 0; l < joints.size(); ++l) {
    for (std::size_t k = 0; k < joints[l].size(); ++k) {
      const Tips tips = layout.tips[l][k];
      if (tips.along < 0) continue;
      const Joint& joint = joints[l][k];
      add(tips.along, joint.vertex, 2);
      add(tips.along, joint.previous, -1);
      if (roles[l][k] == Role::bent) {
        add(tips.across, joint.vertex, 1);
        out.emplace_back(tips.across, layout.bend_unknown[l][k], 1);
      } else {
        add(tips.across, joint.vertex, 1 - (1 + joint.ratio) / joint.kappa);
        add(tips.across, joint.next, 1 / joint.kappa);
        add(tips.across, joint.previous, joint.ratio / joint.kappa);
      }
    }
  }
}

}  // namespace

Roles natural_roles(const Joints& joints, double bent_limit) {
  Roles roles;
  for (const auto& loop : joints) {
    roles.emplace_back();
    for (const Joint& joint : loop) {
      Role role = Role::flat;
      if (joint.kind == JointKind::corner || joint.kind == JointKind::end) role = Role::anchor;
      if (joint.kind == JointKind::mild)
        role = std::abs(joint.kappa) < bent_limit ? Role::bent : Role::anchor;
      roles.back().push_back(joint.branch ? Role::branch : role);
    }
  }
  return roles;
}

Roles roles_on(const Joints& from, const Roles& roles, const Joints& to) {
  std::map<int, Role> by_vertex;
  for (std::size_t l = 0; l < from.size(); ++l)
    for (std::size_t k = 0; k < from[l].size(); ++k) by_vertex[from[l][k].vertex] = roles[l][k];
  Roles out;
  for (const auto& loop : to) {
    out.emplace_back();
    for (const Joint& joint : loop) {
      const auto found = by_vertex.find(joint.vertex);
      out.back().push_back(found == by_vertex.end() ? Role::flat : found->second);
    }
  }
  return out;
}

bool has_c1_corner(const Joints& joints, const Roles& roles) {
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k)
      if (joints[l][k].kind == JointKind::corner && roles[l][k] == Role::anchor) return true;
  return false;
}

DomainLayout make_layout(const CurvedMesh& mesh, const Joints& joints, const Roles& roles) {
  const StageTimer timer("map: layout");
  DomainLayout layout;
  const int vertices = mesh.vertex_count();
  const int unknowns = number_unknowns(joints, roles, vertices, layout);
  const int rows = number_tips(joints, roles, vertices, layout);
  Triplets exact, sparse;
  for (int row = 0; row < vertices; ++row)
    if (layout.unknown_of_row[row] >= 0) {
      exact.emplace_back(row, layout.unknown_of_row[row], 1);
      sparse.emplace_back(row, layout.unknown_of_row[row], 1);
    }
  for (const Chain& chain : chains_of(joints, roles))
    place_chain(chain, edge_forms(chain, joints, roles, layout), joints, layout, exact, sparse);
  for (auto [triplets, matrix] : {std::pair(&exact, &layout.exact), {&sparse, &layout.sparse}}) {
    DomainLayout::Matrix positions(vertices, unknowns);
    positions.setFromTriplets(triplets->begin(), triplets->end());
    place_tips(joints, roles, layout, positions, *triplets);
    matrix->resize(rows, unknowns);
    matrix->setFromTriplets(triplets->begin(), triplets->end());
  }
  return layout;
}

}  // namespace c1mesh
