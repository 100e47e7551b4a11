// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh verify: certifies result files from their data alone.
#include "c1mesh/verify.h"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/command.h"
#include "app/inputs.h"
#include "app/limits.h"
#include "app/summary.h"

namespace c1mesh::app {
namespace {

struct VerifyArguments {
  std::vector<std::string> results;
  InputArguments input;     // one or none
  std::string certificate;  // to be followed; empty: proofs are searched for
  std::string written;      // file for a new certificate, empty: none
  ReadOptions read;
  double memory_limit = 0;
};

// What results are held against besides themselves; not both.
struct Witness {
  std::optional<Certificate> certificate;
  std::optional<std::vector<Drawing>> drawings;
  std::string label;  // what messages call it: what is wrong with it is not the result's fault
};

// Once for all results: an input may be large, or standard input.
Status read_witness(Console& console, const VerifyArguments& arguments, Witness& witness) {
  const std::vector<Input> inputs = inputs_of(arguments.input, arguments.read);
  if (arguments.certificate.empty() && inputs.empty()) return Status::ok;
  witness.label = inputs.empty() ? arguments.certificate : inputs.front().label;
  return guarded(console, witness.label, [&] {
    if (inputs.empty())
      witness.certificate = read_certificate(arguments.certificate, arguments.read.max_bytes);
    else
      witness.drawings = inputs.front().read();
    return Status::ok;
  });
}

// The input's drawing that the result was made of: the only one, or the one of the same name.
Shape input_shape(const Witness& witness, const Result& result) {
  const std::vector<Drawing>& drawings = *witness.drawings;
  if (drawings.size() == 1) return make_shape(drawings.front());
  for (const Drawing& drawing : drawings)
    if (drawing.name == result.name) return make_shape(drawing);
  throw FileError(fmt::format("{} holds {} shapes, none named '{}'", witness.label, drawings.size(),
                              result.name));
}

// Of a result that is not regular there is nothing to certify.
void write_certificate(Console& console, const std::string& path, const VerifyReport& report) {
  if (!report.regular()) {
    console.error("no certificate was written: not every triangle is proven to be regular");
    return;
  }
  create_folder_of(path);
  deliver(path, format_certificate(report.certificate));
  console.say(fmt::format("certificate: {}", printable(path)));
}

Status verify_file(Console& console, const VerifyArguments& arguments, const Witness& witness,
                   const std::string& path) {
  const Result result = read_result(path, arguments.read.max_bytes);
  std::optional<Shape> shape;
  if (witness.drawings) {
    const Status unusable = guarded(console, witness.label, [&] {
      shape = input_shape(witness, result);
      return Status::ok;
    });
    if (unusable != Status::ok) return unusable;
  }
  const VerifyOptions bounds = claimed_bounds(result);
  const VerifyReport report = witness.certificate ? recheck(result, *witness.certificate, bounds)
                              : shape             ? verify(result, *shape, bounds)
                                                  : verify(result, bounds);
  const bool valid = report.valid();
  console.say(fmt::format(
      "{}: {}\n{}", printable(path),
      valid ? console.coloured(Tone::good, "valid") : console.coloured(Tone::bad, "NOT certified"),
      item_lines(console, report)));
  if (!arguments.written.empty()) write_certificate(console, arguments.written, report);
  return valid ? Status::ok : Status::bound_missed;
}

Status verify_files(Console& console, const VerifyArguments& arguments) {
  limit_memory(arguments.memory_limit);
  Witness witness;
  Status status = read_witness(console, arguments, witness);
  if (status != Status::ok) return status;
  for (const std::string& path : arguments.results)
    status = worse(status, guarded(console, path,
                                   [&] { return verify_file(console, arguments, witness, path); }));
  return status;
}

}  // namespace

Command add_verify(CLI::App& app) {
  auto arguments = std::make_shared<VerifyArguments>();
  CLI::App* cli = app.add_subcommand("verify", "Certify result files from their data alone");
  cli->add_option("RESULT", arguments->results, "NAME.c1.json files")->required();
  CLI::Option* input = cli->add_option("--input", arguments->input.files,
                                       "Also compare with the shape they were made of")
                           ->expected(1);
  CLI::Option* font = add_text(*cli, arguments->input);
  CLI::Option* given =
      cli->add_option("--certificate", arguments->certificate,
                      "Check the proofs of this certificate instead of searching for them");
  cli->add_option("--write-certificate", arguments->written,
                  "Also this file: what was proven and how")
      ->excludes(given);
  cli->add_flag("--together", arguments->read.together, "The input was taken as one arrangement");
  input->excludes(font);
  given->excludes(input)->excludes(font);
  add_read_limits(*cli, arguments->read);
  add_memory_limit(*cli, arguments->memory_limit, "");
  cli->final_callback([arguments] {
    const bool certificate = !arguments->certificate.empty() || !arguments->written.empty();
    if (certificate && arguments->results.size() > 1)
      throw CLI::ValidationError("RESULT", "a certificate is of one result: name one");
  });
  return {cli, [arguments](Console& console) { return verify_files(console, *arguments); }};
}

}  // namespace c1mesh::app
