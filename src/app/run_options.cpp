// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run_options.h"

#include <algorithm>

#include "app/limits.h"
#include "app/paper_options.h"
#include "app/validators.h"

namespace c1mesh::app {
namespace {

std::string check_exceptional(const std::string& text) {
  const bool digits =
      !text.empty() && text.size() < 9 &&
      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  return digits || text == "min" ? "" : "must be a number of vertices or 'min'";
}

void add_method_options(CLI::App& cli, Options& options) {
  cli.add_option("--alpha", options.alpha, "Distortion g <= alpha * mips-bound is asked")
      ->capture_default_str()
      ->check(at_least(1));
  cli.add_option("--mips-bound", options.mips_bound, "Distortion bound of the initial mesh")
      ->capture_default_str()
      ->check(above(2));
  cli.add_option("--degree", options.degree, "Least degree of the triangles")
      ->capture_default_str()
      ->check(CLI::Range(3, 20));
  cli.add_option_function<std::string>(
         "--exceptional",
         [&options](const std::string& text) {
           options.exceptional = text == "min" ? -1 : std::stoi(text);
         },
         "How many exceptional vertices are allowed: N, or min (the fewest within the bound)")
      ->default_str("min")
      ->check(check_exceptional);
  cli.add_option("--refine", options.refine,
                 "At most so many times the triangles, for as low a g as that gives (1: none). "
                 "Without it: up to twice, while g exceeds 20")
      ->check(at_least(1));
  cli.add_option("--c1-bound", options.c1_bound,
                 "The certified bound of every d_ei, relative to the larger side of the shape, is "
                 "asked to be at most this. Without it: to rounding, with --method paper 1e-4")
      ->check(above(0));
  cli.add_flag("--no-overlap", options.no_overlap,
               "The domain must not overlap itself in the plane");
  cli.add_option("--corner-angle", options.corner_angle,
                 "Degrees: joints that turn more are corners")
      ->capture_default_str()
      ->check(at_least(0, 180));
  cli.add_option("--threads", options.threads, "0: as many as cores; results do not depend on it")
      ->capture_default_str()
      ->check(CLI::Range(0, 4096));
  cli.add_option("--seed", options.seed, "Seed of every random choice")->capture_default_str();
  cli.add_option("--time-limit", options.time_limit, "Seconds per shape; 0: none")
      ->capture_default_str()
      ->check(at_least(0));
  add_paper_options(cli, options);
}

}  // namespace

bool RunOptions::wants(const std::string& format) const {
  return std::find(formats.begin(), formats.end(), format) != formats.end();
}

void add_together(CLI::App& cli, ReadOptions& options) {
  cli.add_flag("--together", options.together,
               "Take a whole SVG drawing as one arrangement, unfilled lines as features");
}

void add_run_options(CLI::App& cli, RunOptions& options) {
  cli.add_option("--formats", options.formats,
                 "json (always written), svg, png, html, vtu, msh, mesh, obj, cert")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str()
      ->check(CLI::IsMember({"json", "svg", "png", "html", "vtu", "msh", "mesh", "obj", "cert"}));
  add_together(cli, options.read);
  add_read_limits(cli, options.read);
  cli.add_flag("--trade-off", options.trade_off,
               "Also NAME.tradeoff.json and .svg: g against the number of exceptional vertices");
  add_method_options(cli, options.options);
}

// Of every option, also of those that are added some day.
std::map<std::string, std::string> values_of(const CLI::App& cli,
                                             const std::set<std::string>& left_out) {
  std::map<std::string, std::string> values;
  for (const CLI::Option* option : cli.get_options()) {
    const std::string name = option->get_name();
    if (left_out.count(name)) continue;
    std::string value = option->get_default_str();
    if (option->count() > 0) value = CLI::detail::join(option->results(), ",");
    if (value.size() > 1 && value.front() == '[') value = value.substr(1, value.size() - 2);
    values[name] = value;
  }
  return values;
}

}  // namespace c1mesh::app
