// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/command.h"
#include "app/interrupt.h"
#include "c1mesh/contact_sheet.h"
#include "c1mesh/png.h"
#include "c1mesh/verify.h"

namespace c1mesh::app {
namespace {

// The file's name without folder and without what every result's name ends in.
std::string name_of(const std::string& path) {
  const std::string file = path.substr(path.find_last_of('/') + 1);
  for (const std::string ending : {".c1.json", ".json"})
    if (file.size() > ending.size() && file.ends_with(ending))
      return file.substr(0, file.size() - ending.size());
  return file;
}

// A reason for a cell: the path is no news there.
std::string without_path(std::string text, const std::string& path) {
  const std::size_t at = text.find(path);
  if (at == std::string::npos) return text;
  const std::size_t begin = at > 0 && text[at - 1] == ' ' ? at - 1 : at;
  text.erase(begin, at + path.size() - begin);
  if (begin == 0) text.erase(0, std::min(text.find_first_not_of(": "), text.size()));
  return text;
}

void add_result(ContactSheet& sheet, const SheetArguments& arguments, const std::string& path) {
  const Result result = read_result(path, arguments.max_bytes);
  if (arguments.no_verify) return sheet.add(result, name_of(path), result.metrics, SheetMark::none);
  const VerifyReport report = verify(result, claimed_bounds(result));
  sheet.add(result, name_of(path), report.metrics,
            report.valid() ? SheetMark::certified : SheetMark::not_certified);
}

// Only what is wrong with a file becomes a cell; what is wrong otherwise ends the sheet.
Status add_file(Console& console, ContactSheet& sheet, const SheetArguments& arguments,
                const std::string& path) {
  return guarded(console, path, [&] {
    try {
      add_result(sheet, arguments, path);
      return Status::ok;
    } catch (const InputError& e) {
      const std::string reason = e.defects().empty() ? "" : e.defects().front().message;
      sheet.add_unreadable(name_of(path), without_path(reason, path));
      throw;
    } catch (const FileError& e) {
      sheet.add_unreadable(name_of(path), without_path(e.what(), path));
      throw;
    }
  });
}

// NAME.png, or NAME-2.png where there are several pages.
std::string page_name(const std::string& output, std::size_t page, std::size_t pages) {
  if (pages == 1) return output;
  const std::size_t slash = output.find_last_of('/');
  const std::size_t begin = slash == std::string::npos ? 0 : slash + 1;
  const std::size_t dot = output.find_last_of('.');
  const std::size_t stem = dot == std::string::npos || dot <= begin ? output.size() : dot;
  return fmt::format("{}-{}{}", output.substr(0, stem), page + 1, output.substr(stem));
}

Status draw_page(Console& console, const SheetArguments& arguments,
                 const std::vector<std::string>& paths, const std::string& output) {
  ContactSheet sheet(paths.size(), arguments.options);
  Status status = Status::ok;
  for (const std::string& path : paths) {
    if (interrupted()) return worse(status, Status::limit);
    const Status added = add_file(console, sheet, arguments, path);
    status = worse(status, added);
    if (added != Status::ok && added != Status::input) return status;
  }
  return worse(status, guarded(console, output, [&] {
                 const std::string svg = sheet.svg();
                 deliver(output,
                         is_png(output) ? png_of(svg, {arguments.options.transparent}) : svg);
                 return Status::ok;
               }));
}

}  // namespace

bool is_png(const std::string& path) {
  return path.ends_with(".png");
}

Status draw_sheets(Console& console, const SheetArguments& arguments) {
  catch_signals();
  const std::size_t count = arguments.inputs.size();
  const std::size_t most =
      arguments.per_page > 0 ? static_cast<std::size_t>(arguments.per_page) : count;
  const std::size_t pages = (count + most - 1) / most;
  if (pages > 1 && arguments.output == "-") {
    console.error("several pages cannot go to standard output; name a file with -o");
    return Status::usage;
  }
  Status status = Status::ok;
  for (std::size_t page = 0; page < pages; ++page) {
    const auto first = arguments.inputs.begin() + static_cast<std::ptrdiff_t>(page * most);
    const auto last =
        arguments.inputs.begin() + static_cast<std::ptrdiff_t>(std::min(count, (page + 1) * most));
    status = worse(status, draw_page(console, arguments, std::vector<std::string>(first, last),
                                     page_name(arguments.output, page, pages)));
    if (interrupted() || status == Status::internal) break;
  }
  return status;
}

}  // namespace c1mesh::app
