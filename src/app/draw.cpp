// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh draw: pictures of results, plots of traces.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/command.h"
#include "app/contact_sheet.h"
#include "app/limits.h"
#include "app/validators.h"
#include "c1mesh/error.h"
#include "c1mesh/png.h"
#include "c1mesh/shape.h"
#include "c1mesh/trace.h"
#include "c1mesh/write.h"

namespace c1mesh::app {
namespace {

struct DrawArguments {
  std::vector<std::string> inputs, titles;
  std::string output, over, zoom;
  bool no_mesh = false, no_key = false;
  bool sheet = false;  // a contact sheet
  SheetArguments sheets;
  std::string shape;  // of a trace; empty: the first
  int region = -1;    // of that shape; -1: the first
  DrawOptions options;
  std::size_t max_bytes = ReadOptions().max_bytes;  // of a file
};

// The text of a trace; nothing if the file is none. What can be read only once is taken by its
// name.
std::optional<std::string> trace_text(const std::string& path, std::size_t max_bytes) {
  std::error_code ignored;
  const bool named = path.ends_with(".jsonl");
  if (!named && !std::filesystem::is_regular_file(path, ignored)) return {};
  const std::string text = read_bytes(path, max_bytes);
  return named || is_trace(text) ? std::optional(text) : std::nullopt;
}

// As pixels where the name says so.
void deliver_picture(const DrawArguments& arguments, const std::string& svg) {
  deliver(arguments.output,
          is_png(arguments.output) ? png_of(svg, {arguments.options.transparent}) : svg);
}

[[noreturn]] void fail(const std::string& message, const std::string& remedy) {
  Defect defect;
  defect.kind = DefectKind::empty;
  defect.message = message;
  defect.remedy = remedy;
  throw InputError({defect});
}

std::string plot(const DrawArguments& arguments, const std::string& text) {
  const std::vector<TraceLine> lines = parse_trace(text);
  if (lines.empty()) fail("the trace holds no iterations", "run a shape that can be meshed");
  const std::string shape = arguments.shape.empty() ? lines[0].shape : arguments.shape;
  int region = arguments.region, regions = 0;
  std::vector<TraceRecord> records;
  for (const TraceLine& line : lines) {
    if (line.shape != shape) continue;
    if (region < 0) region = line.record.region;
    regions = std::max(regions, line.record.region + 1);
    if (line.record.region == region) records.push_back(line.record);
  }
  if (records.empty())
    fail(arguments.region < 0
             ? fmt::format("the trace holds nothing of the shape '{}'", shape)
             : fmt::format("the trace holds nothing of region {} of the shape '{}'",
                           arguments.region, shape),
         "choose another --shape or --region");
  return draw_trace(regions > 1 ? fmt::format("{}, region {}", shape, region) : shape, records,
                    arguments.options.width);
}

// Results are read one by one, so that each failure is said of its own file.
Status draw_results(Console& console, const DrawArguments& arguments) {
  std::vector<std::string> paths = arguments.inputs;
  if (!arguments.over.empty()) paths.push_back(arguments.over);
  std::vector<Result> results;
  for (const std::string& path : paths) {
    const Status status = guarded(console, path, [&] {
      results.push_back(read_result(path, arguments.max_bytes));
      return Status::ok;
    });
    if (status != Status::ok) return status;
  }
  std::vector<Drawn> drawn;
  for (std::size_t k = 0; k < arguments.inputs.size(); ++k)
    drawn.push_back({&results[k], k < arguments.titles.size() ? arguments.titles[k] : "",
                     arguments.over.empty() ? nullptr : &results.back()});
  DrawOptions chosen = arguments.options;
  chosen.show_mesh = !arguments.no_mesh;
  chosen.show_key = !arguments.no_key;
  return guarded(console, arguments.inputs.front(), [&] {
    deliver_picture(arguments, draw_svg(drawn, chosen));
    return Status::ok;
  });
}

Status draw(Console& console, const DrawArguments& arguments) {
  if (arguments.sheet) {
    SheetArguments sheets = arguments.sheets;
    sheets.inputs = arguments.inputs;
    sheets.output = arguments.output;
    sheets.max_bytes = arguments.max_bytes;
    sheets.options = arguments.options;
    sheets.options.show_key = !arguments.no_key;
    return draw_sheets(console, sheets);
  }
  const std::string& first = arguments.inputs.front();
  std::optional<std::string> trace;
  const Status status = guarded(console, first, [&] {
    if (arguments.titles.size() > arguments.inputs.size())
      throw std::invalid_argument("there are more --titles than results");
    if (arguments.inputs.size() == 1) trace = trace_text(first, arguments.max_bytes);
    if (trace)
      deliver_picture(arguments, plot(arguments, *trace));
    else if (!arguments.shape.empty() || arguments.region >= 0)
      throw std::invalid_argument("--shape and --region are for traces; this is none");
    return Status::ok;
  });
  return trace || status != Status::ok ? status : draw_results(console, arguments);
}

// "VERTEX,SIZE"; VERTEX may be "apart".
CLI::Validator zoom_of(DrawOptions& options) {
  return {[&options](const std::string& text) -> std::string {
            const std::size_t comma = text.find(',');
            const std::string vertex = text.substr(0, comma);
            Zoom zoom;
            const bool known = vertex == "apart" ||
                               (CLI::detail::lexical_cast(vertex, zoom.vertex) && zoom.vertex >= 0);
            if (!known || comma == std::string::npos ||
                !CLI::detail::lexical_cast(text.substr(comma + 1), zoom.size) ||
                !(zoom.size > 0 && zoom.size <= 1))
              return "must be a vertex, or apart, and a size above 0 and at most 1, as in 12,0.1";
            options.zoom = zoom;
            return "";
          },
          "VERTEX,SIZE", "zoom"};
}

// What does not go together, before anything is read.
void check_options(const CLI::App& cli, DrawArguments& arguments) {
  if (is_png(arguments.output) && arguments.options.width > kLongestPngSide)
    throw CLI::ValidationError(
        "--width", fmt::format("a PNG picture may be {:.0f} pixels wide; write SVG, which has no "
                               "pixels, or choose less",
                               kLongestPngSide));
  const auto given = [&](const char* option) { return cli.count(option) > 0; };
  if (!arguments.sheet) {
    for (const char* option : {"--per-page", "--no-verify"})
      if (given(option)) throw CLI::ValidationError(option, "is for --contact-sheet only");
    return;
  }
  for (const char* option : {"--titles", "--over", "--zoom", "--shape", "--region", "--no-mesh"})
    if (given(option)) throw CLI::ValidationError(option, "is not for --contact-sheet");
  // Cells are small: by default the shape alone, with few lines.
  DrawOptions& options = arguments.options;
  if (!given("--columns")) options.columns = 0;
  if (!given("--parts")) options.parts = {Part::shape};
  if (!given("--grid")) options.grid_lines = 12;
  options.show_mesh = std::count(options.parts.begin(), options.parts.end(), Part::mesh) > 0;
}

constexpr const char* kDrawFooter = R"(
Examples:
  c1mesh draw a.c1.json -o a.png --width 3000
  c1mesh draw a.c1.json -o a.png --colour distortion --grid 0
  c1mesh draw a.c1.json -o a.svg --parts mesh,shape,domain --control-net
  c1mesh draw a.c1.json b.c1.json --columns 2 --colour checkerboard -o both.png
  c1mesh draw out/*.c1.json --contact-sheet -o sheet.png)";

}  // namespace

Command add_draw(CLI::App& app) {
  static const std::map<std::string, Colour> kColours = {{"none", Colour::none},
                                                         {"distortion", Colour::distortion},
                                                         {"c1-deviation", Colour::c1_deviation},
                                                         {"checkerboard", Colour::checkerboard}};
  static const std::map<std::string, Part> kParts = {{"outline", Part::outline},
                                                     {"mesh", Part::mesh},
                                                     {"shape", Part::shape},
                                                     {"domain", Part::domain}};
  auto arguments = std::make_shared<DrawArguments>();
  DrawOptions& options = arguments->options;
  CLI::App* cli = app.add_subcommand(
      "draw", "Draw a result: shape and domain with iso-curves; or plot a trace");
  cli->add_option("RESULT", arguments->inputs,
                  "NAME.c1.json, several for one picture; or what run --trace wrote")
      ->required();
  cli->add_option("-o,--output", arguments->output,
                  "NAME.svg or NAME.png; -: SVG to standard output")
      ->required();
  cli->add_option("--width", options.width, "Width of the picture in pixels")
      ->capture_default_str()
      ->check(CLI::Range(64, 100000));
  cli->add_option("--parts", options.parts, "Panels of a result; without it shape,domain")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->transform(one_of(kParts));
  cli->add_option("--columns", options.columns, "Results side by side, the others below")
      ->capture_default_str()
      ->check(CLI::Range(1, 100));
  cli->add_option("--titles", arguments->titles, "Of the results, A,B,…, instead of their names")
      ->delimiter(',')
      ->allow_extra_args(false);
  cli->add_option("--over", arguments->over,
                  "Draw the domain's boundary of this result over the domain, in red");
  cli->add_option(
         "--zoom", arguments->zoom,
         "Beside each panel a blow-up around a vertex, of SIZE of the panel's larger side;"
         " VERTEX may be 'apart': where the domains of RESULT and --over are farthest apart")
      ->check(zoom_of(options));
  cli->add_option("--grid", options.grid_lines, "Iso-curves along the longer side, 0 for none")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000));
  cli->add_option("--colour", options.colour,
                  "Fill the triangles; distortion and c1-deviation with a legend")
      ->transform(one_of(kColours));
  cli->add_flag("--no-mesh", arguments->no_mesh, "Leave the triangles' edges out");
  cli->add_flag("--control-net", options.show_control_net, "Show the control points");
  cli->add_flag("--no-key", arguments->no_key, "Leave out what explains lines and dots");
  cli->add_flag("--transparent", options.transparent, "No white ground");
  cli->add_flag("--contact-sheet", arguments->sheet,
                "A grid of small pictures with names and figures, for many results; what cannot be "
                "read has a cell that says so");
  cli->add_option("--per-page", arguments->sheets.per_page,
                  "Of a contact sheet: most cells on a page; NAME-1.png, NAME-2.png, … if they are "
                  "more (0: one page)")
      ->check(CLI::Range(0, 100000));
  cli->add_flag("--no-verify", arguments->sheets.no_verify,
                "Of a contact sheet: g as the files state it, and no marks");
  cli->add_option("--shape", arguments->shape, "Of a trace: this shape instead of the first");
  cli->add_option("--region", arguments->region, "Of a trace: this region, counted from 0")
      ->check(CLI::Range(0, std::numeric_limits<int>::max()).description(""));
  add_byte_limit(*cli, arguments->max_bytes);
  cli->footer(kDrawFooter + app.get_footer());
  cli->final_callback([arguments, cli] { check_options(*cli, *arguments); });
  return {cli, [arguments](Console& console) { return draw(console, *arguments); }};
}

}  // namespace c1mesh::app
