// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/triangle_jet.h"

namespace c1mesh {

// After n - 2 steps the net q_ij of degree 2 is the blossom with n - 2 arguments fixed, and
// derivatives are differences of the others: d²/ds² = n (n-1) (q_20 - 2 q_10 + q_00), and so on.
// One step further d/ds = n (q_10 - q_00).
TriangleJet jet_of(Net net, int n, const Barycentric& at) {
  TriangleJet out;
  for (Point& p : out.second) p = Point::Zero();
  int left = n;
  for (; left > 2; --left) reduce_net(net, left, at);
  if (left == 2) {
    const auto q = [&](int i, int j) -> const Point& { return net[net_index(2, i, j)]; };
    const double factor = static_cast<double>(n) * (n - 1);
    out.second = {factor * (q(2, 0) - 2 * q(1, 0) + q(0, 0)),
                  factor * (q(1, 1) - q(1, 0) - q(0, 1) + q(0, 0)),
                  factor * (q(0, 2) - 2 * q(0, 1) + q(0, 0))};
    reduce_net(net, left--, at);
  }
  out.first = {n * (net[1] - net[0]), n * (net[2] - net[0])};
  reduce_net(net, left, at);
  out.value = net[0];
  return out;
}

}  // namespace c1mesh
