// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh convert: results in other formats, chosen by the output's extension.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "app/command.h"
#include "app/limits.h"
#include "c1mesh/write.h"

namespace c1mesh::app {
namespace {

struct ConvertArguments {
  std::string result, output;
  bool lagrange = false;
  ConvertOptions options;
  std::size_t max_bytes = ReadOptions().max_bytes;  // of the result
};

// Refused with the command line, before anything is read.
std::string check_extension(const std::string& path) {
  const std::vector<std::string> known = convertible_extensions();
  for (const std::string& extension : known)
    if (path.ends_with(extension)) return "";
  return fmt::format("no format is known by the extension of '{}' ({})", path,
                     fmt::join(known, ", "));
}

// An option that the format does not have is a mistake, not to be passed over.
void check_options(const CLI::App& cli, const std::string& output) {
  if (cli.count("--lagrange") > 0 && !output.ends_with(".vtu"))
    throw CLI::ValidationError("--lagrange", "is for .vtu only");
  if (cli.count("--tessellation") > 0 && !output.ends_with(".obj"))
    throw CLI::ValidationError("--tessellation", "is for .obj only");
}

}  // namespace

Command add_convert(CLI::App& app) {
  auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* cli = app.add_subcommand("convert", "Write a result in another format, by extension");
  cli->add_option("RESULT", arguments->result, "NAME.c1.json")->required();
  cli->add_option(
         "-o,--output", arguments->output,
         "NAME.vtu (VTK), NAME.msh (Gmsh), NAME.mesh (MFEM), NAME.obj, NAME.svg, "
         "NAME.png, NAME.html (a page to explore it) or NAME.json; NAME.domain.vtu, .domain.msh, "
         ".domain.mesh: the domain mesh")
      ->required()
      ->check(check_extension);
  cli->add_flag("--lagrange", arguments->lagrange,
                ".vtu: Lagrange cells with interpolation nodes, not Bezier cells");
  cli->add_option("--tessellation", arguments->options.tessellation,
                  ".obj: straight pieces along each edge")
      ->capture_default_str()
      ->check(CLI::Range(1, 256));
  add_byte_limit(*cli, arguments->max_bytes);
  cli->final_callback([arguments, cli] {
    check_options(*cli, arguments->output);
    if (arguments->lagrange) arguments->options.cells = VtuCells::lagrange;
  });
  return {cli, [arguments](Console& console) {
            return guarded(console, arguments->result, [&] {
              const Result result = read_result(arguments->result, arguments->max_bytes);
              deliver(arguments->output, convert(result, arguments->output, arguments->options));
              return Status::ok;
            });
          }};
}

}  // namespace c1mesh::app
