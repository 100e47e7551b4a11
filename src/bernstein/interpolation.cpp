// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/interpolation.h"

#include "bernstein/rounding.h"

namespace c1mesh {

Point lattice_value_exactly(const Net& net, int n, int i, int j) {
  if (i + j == 0) return net.front();
  if (i == n) return net[n];
  if (j == n) return net.back();
  Poles<mpq_class> exact;
  for (const Point& p : net) exact.push_back({mpq_class(p.x()), mpq_class(p.y())});
  mpz_class scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), static_cast<unsigned long>(n), static_cast<unsigned long>(n));
  const std::array<mpq_class, 2> value = scaled_lattice_value(exact, n, i, j);
  return {round_to_double(mpq_class(value[0] / scale)),
          round_to_double(mpq_class(value[1] / scale))};
}

}  // namespace c1mesh
