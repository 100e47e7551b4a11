// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/net_blossom.h"

namespace c1mesh {

void reduce_net(Net& net, int n, const Barycentric& argument) {
  // The shorter net never overtakes what is still to be read of the longer one.
  int to = 0, row = 0;
  for (int j = 0; j < n; ++j) {
    const int above = row + n + 1 - j;
    for (int i = 0; i < n - j; ++i, ++to)
      net[to] = argument[0] * net[row + i] + argument[1] * net[row + i + 1] +
                argument[2] * net[above + i];
    row = above;
  }
}

Point blossom(Net net, int degree, const std::vector<Barycentric>& arguments) {
  for (int n = degree; n > 0; --n) reduce_net(net, n, arguments[degree - n]);
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
