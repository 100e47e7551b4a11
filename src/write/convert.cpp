// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "c1mesh/error.h"
#include "c1mesh/png.h"
#include "c1mesh/write.h"

namespace c1mesh {

std::vector<std::string> convertible_extensions() {
  return {".vtu", ".msh", ".mesh", ".obj", ".svg", ".png", ".html", ".json"};
}

std::string convert(const Result& result, const std::string& path, const ConvertOptions& options) {
  const auto ends_with = [&](const std::string& ending) { return path.ends_with(ending); };
  const auto domain = [&](const std::string& ending) { return ends_with(".domain" + ending); };
  if (ends_with(".vtu")) return format_vtu(result, domain(".vtu"), options.cells);
  if (ends_with(".msh")) return format_msh(result, domain(".msh"));
  if (ends_with(".mesh")) return format_mfem(result, domain(".mesh"));
  if (ends_with(".obj")) return format_obj(result, options.tessellation);
  if (ends_with(".svg")) return draw_svg(result);
  if (ends_with(".png")) return png_of(draw_svg(result));
  if (ends_with(".html")) return format_html(result);
  if (ends_with(".json")) return format_result(result);
  Defect defect;
  defect.kind = DefectKind::unsupported;
  defect.message = "cannot write " + path + ": no format has this extension";
  defect.remedy = fmt::format("use {}", fmt::join(convertible_extensions(), ", "));
  throw InputError({defect});
}

}  // namespace c1mesh
