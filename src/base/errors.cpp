// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "c1mesh/error.h"

namespace c1mesh {

const char* name_of(DefectKind kind) {
  switch (kind) {
    case DefectKind::malformed:
      return "malformed";
    case DefectKind::unsupported:
      return "unsupported";
    case DefectKind::limit:
      return "limit";
    case DefectKind::non_finite:
      return "non-finite";
    case DefectKind::empty:
      return "empty";
    case DefectKind::zero_length:
      return "zero-length";
    case DefectKind::vanishing_derivative:
      return "vanishing-derivative";
    case DefectKind::cusp:
      return "cusp";
    case DefectKind::open_loop:
      return "open-loop";
    case DefectKind::gap:
      return "gap";
    case DefectKind::branching:
      return "branching";
    case DefectKind::duplicate:
      return "duplicate";
    case DefectKind::self_intersection:
      return "self-intersection";
    case DefectKind::crossing:
      return "crossing";
    case DefectKind::touching:
      return "touching";
    case DefectKind::handle:
      return "handle";
    case DefectKind::note:
      return "note";
  }
  return "unknown";
}

std::string describe(const Defect& defect) {
  std::string out = fmt::format("{}{}: {}", name_of(defect.kind),
                                defect.repaired ? " (repaired)" : "", defect.message);
  std::string place;
  if (!defect.curves.empty()) {
    place += defect.curves.size() == 1 ? "curve" : "curves";
    for (std::size_t i = 0; i < defect.curves.size(); ++i)
      place += (i ? ", " : " ") + defect.curves[i];
  }
  for (const Point& p : defect.where)
    place += fmt::format("{}({:.9g}, {:.9g})", place.empty() ? "at " : ", at ", p.x(), p.y());
  if (!place.empty()) out += " [" + place + "]";
  if (!defect.remedy.empty()) out += "; " + defect.remedy;
  return out;
}

InputError::InputError(std::vector<Defect> found)
    : std::runtime_error(found.empty() ? "invalid input" : describe(found.front())),
      defects_(std::move(found)) {}

}  // namespace c1mesh
