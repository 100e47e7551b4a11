// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/net_blossom.h"

namespace c1mesh {

Point blossom(Net net, int degree, const std::vector<Barycentric>& arguments) {
  // In place: the reduced net of degree m is written over the front of the one of degree m + 1.
  for (int m = degree - 1; m >= 0; --m) {
    const Barycentric& w = arguments[degree - 1 - m];
    int to = 0, row = 0;
    for (int j = 0; j <= m; ++j) {
      const int above = row + m + 2 - j;
      for (int i = 0; i <= m - j; ++i, ++to)
        net[to] = w[0] * net[row + i] + w[1] * net[row + i + 1] + w[2] * net[above + i];
      row = above;
    }
  }
  return net[0];
}

Point evaluate(const Net& net, int degree, const Barycentric& where) {
  return blossom(net, degree, std::vector<Barycentric>(degree, where));
}

Net restrict_net(const Net& net, int degree, const Barycentric& a, const Barycentric& b,
                 const Barycentric& c) {
  Net out;
  for (int j = 0; j <= degree; ++j)
    for (int i = 0; i <= degree - j; ++i) {
      std::vector<Barycentric> arguments(degree, a);
      for (int k = 0; k < i; ++k) arguments[k] = b;
      for (int k = 0; k < j; ++k) arguments[i + k] = c;
      out.push_back(blossom(net, degree, arguments));
    }
  return out;
}

std::vector<Point> restrict_net_to_line(const Net& net, int degree, const Barycentric& a,
                                        const Barycentric& b) {
  std::vector<Point> out;
  for (int i = 0; i <= degree; ++i) {
    std::vector<Barycentric> arguments(degree, a);
    for (int k = 0; k < i; ++k) arguments[k] = b;
    out.push_back(blossom(net, degree, arguments));
  }
  return out;
}

}  // namespace c1mesh
