// SPDX-License-Identifier: GPL-3.0-or-later
#include <c1mesh/c1mesh.h>

#include <iostream>

int main() {
  const c1mesh::Shape shape = c1mesh::make_shape(c1mesh::generate('A', 1, 1).front());
  const c1mesh::Outcome outcome = c1mesh::parametrize(shape);
  std::cout << c1mesh::version() << ": " << outcome.result.triangles.size() << " triangles\n";
  return outcome.report.regular() && outcome.report.conforming() ? 0 : 1;
}
