// SPDX-License-Identifier: GPL-3.0-or-later
// A map as a function: its values and derivatives, and its inverse, per point.
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "results.h"

namespace c1mesh {
namespace {

constexpr int kPoints = 4096;

// Random places, uniform over triangles, with their images.
struct Sample {
  std::vector<DomainPoint> places;
  std::vector<Point> images;
};

Sample sample(const Map& map) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> triangle(0, map.triangles() - 1);
  std::exponential_distribution<double> share(1);
  Sample out;
  for (int k = 0; k < kPoints; ++k) {
    Barycentric at(share(random), share(random), share(random));
    at /= at.sum();
    out.places.push_back(map.at(triangle(random), at));
    out.images.push_back(map.evaluate(out.places.back()));
  }
  return out;
}

// `work(k)` for one sample point after the other.
template <class Work>
void over_points(benchmark::State& state, const Map& map, const Work& work) {
  int k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(work(k = (k + 1) % kPoints));
  state.SetItemsProcessed(state.iterations());
  state.counters["triangles"] = map.triangles();
}

void evaluate(benchmark::State& state) {
  const Map map(benchmarks::puzzle_map(static_cast<int>(state.range(0))));
  const Sample points = sample(map);
  over_points(state, map, [&](int k) { return map.evaluate(points.places[k]); });
}

void jet(benchmark::State& state) {
  const Map map(benchmarks::puzzle_map(static_cast<int>(state.range(0))));
  const Sample points = sample(map);
  over_points(state, map, [&](int k) { return map.jet(points.places[k]); });
}

void find(benchmark::State& state) {
  const Map map(benchmarks::puzzle_map(static_cast<int>(state.range(0))));
  const Sample points = sample(map);
  over_points(state, map,
              [&](int k) { return map.find(points.places[k].uv.x(), points.places[k].uv.y()); });
}

void locate(benchmark::State& state) {
  const Map map(benchmarks::puzzle_map(static_cast<int>(state.range(0))));
  const Sample points = sample(map);
  over_points(state, map,
              [&](int k) { return map.locate(points.images[k].x(), points.images[k].y()); });
}

// Points of the shape's box: most of what is outside of the shape is so only just.
void locate_in_box(benchmark::State& state) {
  const Map map(benchmarks::puzzle_map(static_cast<int>(state.range(0))));
  const Box& box = map.shape_box();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(box.low.x(), box.high.x());
  std::uniform_real_distribution<double> y(box.low.y(), box.high.y());
  std::vector<Point> points;
  for (int k = 0; k < kPoints; ++k) points.emplace_back(x(random), y(random));
  over_points(state, map, [&](int k) { return map.locate(points[k].x(), points[k].y()); });
}

void make_map(benchmark::State& state) {
  const Result& result = benchmarks::puzzle_map(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(Map(result));
  state.counters["triangles"] = static_cast<double>(result.triangles.size());
}

}  // namespace

#define C1MESH_SIZES ->Arg(100)->Arg(1000)->Arg(10000)
BENCHMARK(make_map) C1MESH_SIZES->Unit(benchmark::kMicrosecond);
BENCHMARK(evaluate) C1MESH_SIZES;
BENCHMARK(jet) C1MESH_SIZES;
BENCHMARK(find) C1MESH_SIZES;
BENCHMARK(locate) C1MESH_SIZES;
BENCHMARK(locate_in_box) C1MESH_SIZES;
#undef C1MESH_SIZES

}  // namespace c1mesh
