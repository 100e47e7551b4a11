// SPDX-License-Identifier: GPL-3.0-or-later
// The road, and parts of it that can be run alone.
#include <benchmark/benchmark.h>

#include "results.h"

namespace c1mesh {
namespace {

void run(benchmark::State& state, const char* name) {
  const Shape shape = benchmarks::example(name);
  Options options;
  options.threads = 1;
  for (auto _ : state) benchmark::DoNotOptimize(parametrize(shape, options));
}

void verify_puzzle(benchmark::State& state) {
  const Result& result = benchmarks::puzzle_map(static_cast<int>(state.range(0)));
  const Shape shape = benchmarks::example("puzzle.svg");
  for (auto _ : state) benchmark::DoNotOptimize(verify(result, shape));
  state.counters["triangles"] = static_cast<double>(result.triangles.size());
}

void format(benchmark::State& state) {
  const Result& result = benchmarks::puzzle_map(static_cast<int>(state.range(0)));
  std::size_t bytes = 0;
  for (auto _ : state) bytes += format_result(result).size();
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
}

void parse(benchmark::State& state) {
  const std::string text = format_result(benchmarks::puzzle_map(static_cast<int>(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(parse_result(text, "puzzle"));
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * text.size()));
}

}  // namespace

#define C1MESH_IN_MS ->Unit(benchmark::kMillisecond)
BENCHMARK_CAPTURE(run, blob, "blob.svg") C1MESH_IN_MS;
BENCHMARK_CAPTURE(run, puzzle, "puzzle.svg") C1MESH_IN_MS;
BENCHMARK_CAPTURE(run, annulus, "annulus.svg") C1MESH_IN_MS;
BENCHMARK(verify_puzzle)->Arg(100)->Arg(1000)->Arg(10000) C1MESH_IN_MS;
BENCHMARK(format)->Arg(1000)->Arg(10000) C1MESH_IN_MS;
BENCHMARK(parse)->Arg(1000)->Arg(10000) C1MESH_IN_MS;
#undef C1MESH_IN_MS

}  // namespace c1mesh
