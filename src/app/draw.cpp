// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh draw: pictures of results.
#include <map>
#include <memory>

#include "app/command.h"
#include "c1mesh/write.h"

namespace c1mesh::app {
namespace {

struct DrawArguments {
  std::string result, output;
  bool no_mesh = false;
  DrawOptions options;
};

}  // namespace

Command add_draw(CLI::App& app) {
  static const std::map<std::string, Colour> kColours = {{"none", Colour::none},
                                                         {"distortion", Colour::distortion},
                                                         {"c1-deviation", Colour::c1_deviation}};
  auto arguments = std::make_shared<DrawArguments>();
  DrawOptions& options = arguments->options;
  CLI::App* cli = app.add_subcommand("draw", "Draw a result: shape and domain with iso-curves");
  cli->add_option("RESULT", arguments->result, "NAME.c1.json")->required();
  cli->add_option("-o,--output", arguments->output, "SVG file, - for standard output")->required();
  cli->add_option("--width", options.width, "Width of the picture in pixels")
      ->capture_default_str()
      ->check(CLI::Range(64, 100000));
  cli->add_option("--grid", options.grid_lines, "Iso-curves along the longer side, 0 for none")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000));
  cli->add_option("--colour", options.colour, "Fill triangles by none, distortion or c1-deviation")
      ->transform(CLI::CheckedTransformer(kColours).description(""));
  cli->add_flag("--no-mesh", arguments->no_mesh, "Leave the triangles' edges out");
  cli->add_flag("--control-net", options.show_control_net, "Show the control points");
  return {cli, [arguments](Console& console) {
            return guarded(console, arguments->result, [&] {
              const Result result = read_result(arguments->result);
              DrawOptions chosen = arguments->options;
              chosen.show_mesh = !arguments->no_mesh;
              deliver(arguments->output, draw_svg(result, chosen));
              return Status::ok;
            });
          }};
}

}  // namespace c1mesh::app
