// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/paper_options.h"

#include <fmt/format.h>

#include <map>
#include <string>
#include <vector>

#include "app/validators.h"

namespace c1mesh::app {
namespace {

constexpr const char* kGroup = "Options of --method paper";

std::vector<std::string> parts_of(const std::string& text) {
  return CLI::detail::split(text, ',');
}

// One word, "A" for both phases or "A,B" for phase one and phase two: as a list it would take an
// input that follows for its second part.
template <class Number>
CLI::Option* add_per_phase(CLI::App& cli, const std::string& name, Number (&values)[2],
                           const std::string& help, const CLI::Validator& range) {
  const auto check = [range](const std::string& text) -> std::string {
    const std::vector<std::string> parts = parts_of(text);
    if (parts.size() > 2) return "must be one number, or two with a comma between them";
    for (std::string part : parts) {
      Number value;
      if (!CLI::detail::lexical_cast(part, value)) return "'" + part + "' is no number";
      const std::string fault = range(part);
      if (!fault.empty()) return fault;
    }
    return "";
  };
  return cli
      .add_option_function<std::string>(
          name,
          [&values](const std::string& text) {
            const std::vector<std::string> parts = parts_of(text);
            CLI::detail::lexical_cast(parts.front(), values[0]);
            CLI::detail::lexical_cast(parts.back(), values[1]);
          },
          help)
      ->type_name("A[,B]")
      ->default_str(fmt::format("{},{}", values[0], values[1]))
      ->group(kGroup)
      ->check(CLI::Validator(check, "", "per_phase"));
}

}  // namespace

void add_paper_options(CLI::App& cli, Options& options) {
  PaperOptions& paper = options.paper;
  cli.add_option("--method", options.method, "exact, or paper: Khanteimouri & Campen's two phases")
      ->transform(one_of<Method>({{"exact", Method::exact}, {"paper", Method::paper}}))
      ->default_str("exact");
  cli.add_option("--repeat", options.repeat, "How often phases one and two are run")
      ->capture_default_str()
      ->group(kGroup)
      ->check(CLI::Range(1, 100));
  cli.add_flag("--project", options.project,
               "Afterwards project the control points, the boundary's too, onto the C1 space")
      ->group(kGroup);
  cli.add_option("--extent", paper.extent,
                 "Larger side of the shape in the units of the weights below")
      ->capture_default_str()
      ->group(kGroup)
      ->check(above(0));
  add_per_phase(cli, "--lambda-reg", paper.regularisation,
                "Weight of E_reg in phase one and phase two", at_least(0));
  add_per_phase(cli, "--lambda-hard", paper.hard_penalty,
                "Penalty of hard edges in phase one and phase two", at_least(0));
  cli.add_option("--rho", paper.barrier, "Weight of the barrier of the distortion bound")
      ->capture_default_str()
      ->group(kGroup)
      ->check(above(0));
  cli.add_option("--alpha-lift", paper.alpha_lift, "Factor on alpha in phase two")
      ->capture_default_str()
      ->group(kGroup)
      ->check(at_least(1));
  add_per_phase(cli, "--smoothing", paper.smoothing,
                "Of the norms in E_s, relative to the shape: from,to, tenfold falling", above(0));
  add_per_phase(cli, "--iterations", paper.iterations, "At most, in phase one and phase two",
                at_least(1, 1e6));
  cli.add_option("--straighten", paper.straightening,
                 "Near-flat vertices are moved orthogonally, or to the fractions C1 asks for")
      ->transform(one_of<Straightening>(
          {{"orthogonal", Straightening::orthogonal}, {"fractions", Straightening::fractions}}))
      ->default_str("orthogonal")
      ->group(kGroup);
  cli.add_option("--last-stage", paper.last_stage,
                 "End earlier, with a result that claims C1 nowhere: initial, one or two")
      ->transform(one_of<PaperStage>({{"initial", PaperStage::initial},
                                      {"one", PaperStage::phase_one},
                                      {"two", PaperStage::phase_two}}))
      ->default_str("two")
      ->group(kGroup);
}

}  // namespace c1mesh::app
