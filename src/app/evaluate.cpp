// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh evaluate: the paper's tables and histograms over folders of results.
#include "c1mesh/evaluate.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/command.h"
#include "app/limits.h"

namespace c1mesh::app {
namespace {

struct EvaluateArguments {
  std::vector<std::string> folders, compared, labels;
  std::string output;
  int threads = 0;
  std::size_t max_bytes = ReadOptions().max_bytes;
};

/// The folder's own name, also of "." and of "folder/".
std::string name_of_folder(const std::string& folder) {
  std::error_code ignored;
  std::filesystem::path path = std::filesystem::absolute(folder, ignored).lexically_normal();
  if (path.filename().empty()) path = path.parent_path();
  const std::string name = path.filename().string();
  return name.empty() ? folder : name;
}

void check_counts(const EvaluateArguments& arguments) {
  const std::size_t count = arguments.folders.size();
  if (!arguments.compared.empty() && arguments.compared.size() != count)
    throw std::invalid_argument(
        fmt::format("--compare needs as many folders as there are to evaluate: {}, not {}", count,
                    arguments.compared.size()));
  if (!arguments.labels.empty() && arguments.labels.size() != count)
    throw std::invalid_argument(fmt::format("--labels needs one label per folder: {}, not {}",
                                            count, arguments.labels.size()));
}

/// What could not be read is said, and counts for the status.
Status say_unreadable(Console& console, const std::string& folder, const Series& series) {
  Status status = Status::ok;
  for (const ShapeEvaluation& shape : series.shapes) {
    if (!shape.unreadable) continue;
    console.error(fmt::format("{}/{}.c1.json: {}", folder, shape.name, shape.fault));
    status = Status::input;
  }
  return status;
}

/// All texts exist before the first file does.
void write_all(const std::string& folder, const Evaluation& evaluation, const std::string& table) {
  const std::vector<FileText> files = {
      {folder + "/evaluation.json", format_evaluation(evaluation)},
      {folder + "/evaluation.csv", format_evaluation_csv(evaluation)},
      {folder + "/evaluation.txt", table},
      {folder + "/histograms.svg", draw_histograms(evaluation)},
      {folder + "/projection.svg", draw_projection(evaluation)}};
  create_folder(folder);
  deliver_together(files);
}

Status evaluate_folders(Console& console, const EvaluateArguments& arguments) {
  check_counts(arguments);
  Evaluation evaluation;
  OutputNames labels;
  Status status = Status::ok;
  const auto read = [&](const std::string& folder, const std::string& label) {
    Series series = evaluate_folder(folder, label, arguments.threads, arguments.max_bytes);
    console.detail(fmt::format("{}: {} shapes, {} without a usable result", printable(folder),
                               series.summary.shapes, series.summary.failures()));
    status = worse(status, say_unreadable(console, folder, series));
    return series;
  };
  for (std::size_t i = 0; i < arguments.folders.size(); ++i) {
    const std::string& folder = arguments.folders[i];
    evaluation.series.push_back(read(folder, arguments.labels.empty()
                                                 ? labels.claim(name_of_folder(folder))
                                                 : arguments.labels[i]));
  }
  for (const std::string& folder : arguments.compared)
    evaluation.compared.push_back(read(folder, labels.claim(name_of_folder(folder))));
  const std::string table = evaluation_text(evaluation);
  if (!arguments.output.empty()) write_all(arguments.output, evaluation, table);
  deliver("-", table);
  return status;
}

}  // namespace

Command add_evaluate(CLI::App& app) {
  auto arguments = std::make_shared<EvaluateArguments>();
  CLI::App* cli = app.add_subcommand(
      "evaluate", "Measure folders of results: tables and histograms of the paper's metrics");
  cli->add_option(
         "DIR", arguments->folders,
         "Folders of NAME.c1.json, with NAME.log as docs/battery.sh leaves it, if there is "
         "one: a column each")
      ->required();
  cli->add_option("--compare", arguments->compared,
                  "As many folders again, drawn light behind the others");
  cli->add_option("--labels", arguments->labels,
                  "A,B,…: titles of the columns instead of the folders' names")
      ->delimiter(',')
      ->allow_extra_args(false);
  cli->add_option("-o,--output", arguments->output,
                  "Folder for evaluation.json, evaluation.csv, evaluation.txt, histograms.svg and "
                  "projection.svg; without it only the table is printed");
  cli->add_option("--threads", arguments->threads,
                  "0: as many as cores; results do not depend on it")
      ->capture_default_str()
      ->check(CLI::Range(0, 4096));
  add_byte_limit(*cli, arguments->max_bytes);
  return {cli, [arguments](Console& console) { return evaluate_folders(console, *arguments); }};
}

}  // namespace c1mesh::app
