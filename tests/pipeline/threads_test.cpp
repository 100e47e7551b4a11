// SPDX-License-Identifier: GPL-3.0-or-later
// The library in several threads at a time, each with shapes of its own: the same bytes as in one.
#include <gtest/gtest.h>

#include <barrier>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "c1mesh/c1mesh.h"
#include "pipeline/runs.h"

namespace c1mesh {
namespace {

using Job = std::function<std::string()>;

// The whole road from a file, and what is made of a result afterwards.
std::string road(const std::string& path, const Options& options) {
  const Drawing drawing = read_drawings(path).at(0);
  const Outcome outcome = parametrize(make_shape(drawing), options);
  const std::string text = format_result(outcome.result);
  const Result again = parse_result(text, drawing.name);
  std::string all = text + report_text(verify(again));
  for (const std::string& extension : convertible_extensions())
    all += convert(again, "a" + extension);
  return all;
}

std::string curve_of(const std::string& path) {
  return format_trade_off(trade_off(make_shape(read_drawings(path).at(0))));
}

std::string random_shape(char set, std::uint64_t seed) {
  Options options;
  options.threads = 1;
  return format_result(parametrize(make_shape(generate(set, 1, seed).front()), options).result);
}

// A refused drawing: errors are thrown and caught in each thread.
std::string refusal(const std::string& path) {
  try {
    (void)make_shape(read_drawings(path).at(0));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// What differs between shapes that are done at the same time: degree (tables made at first use),
// number of threads, method, kind of input.
std::vector<Job> jobs() {
  Options quintic, alone, paper;
  quintic.degree = 5;
  alone.threads = 1;
  paper.method = Method::paper;
  paper.paper.iterations[0] = 10;
  paper.paper.iterations[1] = 5;
  return {
      [=] { return road(C1MESH_EXAMPLES "/letter.svg", {}); },
      [=] { return road(C1MESH_EXAMPLES "/blob.svg", quintic); },
      [=] { return road(C1MESH_EXAMPLES "/annulus.svg", alone); },
      [=] { return road(C1MESH_EXAMPLES "/blob.svg", paper); },
      [=] { return curve_of(C1MESH_EXAMPLES "/letter.svg"); },
      [=] { return random_shape('A', 3); },
      [=] { return random_shape('A', 5); },
      [=] { return refusal(C1MESH_TEST_DATA "/nasty/duplicate-curve.json"); },
  };
}

// Not started one after the other: all stand at the barrier first.
std::vector<std::string> side_by_side(const std::vector<Job>& work) {
  std::vector<std::string> out(work.size());
  std::barrier start(static_cast<std::ptrdiff_t>(work.size()));
  std::vector<std::jthread> threads;
  for (std::size_t k = 0; k < work.size(); ++k)
    threads.emplace_back([&, k] {
      start.arrive_and_wait();
      out[k] = work[k]();
    });
  threads.clear();  // joins
  return out;
}

// Side by side first: what is made at first use (tables, static data) is then made in a race.
TEST(Threads, WithShapesOfTheirOwnGiveTheBytesOfOneThread) {
  const std::vector<Job> work = jobs();
  const std::vector<std::string> parallel = side_by_side(work);
  for (std::size_t k = 0; k < work.size(); ++k) {
    EXPECT_FALSE(parallel[k].empty()) << k;
    EXPECT_TRUE(parallel[k] == work[k]()) << "job " << k << " differs";
  }
}

// One shape in all threads: what is const is only read.
TEST(Threads, MayShareAShape) {
  const Shape shape = testing_pipeline::example("blob");
  const Result result = parametrize(shape).result;
  const Job job = [&] {
    return format_result(parametrize(shape).result) + report_text(verify(result, shape)) +
           draw_svg(result);
  };
  const std::string alone = job();
  for (const std::string& text : side_by_side({4, job})) EXPECT_TRUE(text == alone);
}

}  // namespace
}  // namespace c1mesh
