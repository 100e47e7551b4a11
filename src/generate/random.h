// SPDX-License-Identifier: GPL-3.0-or-later
// The same random numbers on every machine: integers only, and doubles made exactly from them.
#pragma once

#include <cstdint>

namespace c1mesh::generate_detail {

/// SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// An integer in [0, n), n > 0; the bias of about n / 2^32 does not matter here.
  int below(int n) {
    return static_cast<int>(((next() >> 32) * static_cast<std::uint64_t>(n)) >> 32);
  }

  /// In [0, 1), a multiple of 2^-32.
  double unit() { return static_cast<double>(next() >> 32) / 4294967296.0; }

  /// In [low, high).
  double between(double low, double high) { return low + (high - low) * unit(); }

  bool coin() { return (next() >> 63) != 0; }

 private:
  std::uint64_t state_;
};

}  // namespace c1mesh::generate_detail
