// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/limits.h"

#include <sys/resource.h>

#include <algorithm>
#include <limits>

#include "app/validators.h"

// Of the OpenMP library, if CHOLMOD was built with one.
extern "C" void omp_set_max_active_levels(int) __attribute__((weak));

namespace c1mesh::app {

void add_byte_limit(CLI::App& cli, std::size_t& max_bytes) {
  cli.add_option("--max-bytes", max_bytes, "Larger files are refused")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{1}, std::size_t{100'000'000'000}).description(""));
}

void add_read_limits(CLI::App& cli, ReadOptions& options) {
  // More levels would need more stack than a program has by default.
  constexpr int kDeepest = 1000;
  add_byte_limit(cli, options.max_bytes);
  cli.add_option("--max-curves", options.max_curves, "Drawings of more curves are refused")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{1}, std::size_t{100'000'000}).description(""));
  cli.add_option("--max-depth", options.max_depth, "Files nested deeper are refused")
      ->capture_default_str()
      ->check(CLI::Range(1, kDeepest).description("up to 1000"));
  cli.add_option("--max-characters", options.max_characters, "Texts longer than this are refused")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{1}, std::size_t{100'000'000}).description(""));
}

void add_memory_limit(CLI::App& cli, double& megabytes, const char* whose) {
  cli.add_option("--memory-limit", megabytes, fmt::format("MB of address space{}; 0: none", whose))
      ->capture_default_str()
      ->check(at_least(0));
}

void limit_memory(double megabytes) {
  if (megabytes <= 0) return;
  const double most = static_cast<double>(std::numeric_limits<rlim_t>::max() / 2);
  const auto bytes = static_cast<rlim_t>(std::min(megabytes * 1e6, most));
  const rlimit limit = {bytes, bytes};
  setrlimit(RLIMIT_AS, &limit);  // what a lack of memory then does: surroundings.cpp
  // OpenMP ends the process, with status 1, if there is no memory for the stack of a thread.
  // CHOLMOD asks for numbers of threads; without levels it gets one.
  if (omp_set_max_active_levels != nullptr) omp_set_max_active_levels(0);
}

}  // namespace c1mesh::app
