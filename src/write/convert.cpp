// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/error.h"
#include "c1mesh/write.h"

namespace c1mesh {

std::string convert(const Result& result, const std::string& path) {
  const auto ends_with = [&](const std::string& ending) { return path.ends_with(ending); };
  if (ends_with(".domain.vtu")) return format_vtu(result, true);
  if (ends_with(".vtu")) return format_vtu(result, false);
  if (ends_with(".svg")) return draw_svg(result);
  if (ends_with(".json")) return format_result(result);
  Defect defect;
  defect.kind = DefectKind::unsupported;
  defect.message = "cannot write " + path + ": no format has this extension";
  defect.remedy = "use .vtu, .domain.vtu, .svg or .json";
  throw InputError({defect});
}

}  // namespace c1mesh
