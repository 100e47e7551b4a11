// SPDX-License-Identifier: GPL-3.0-or-later
// The whole road, from the text of a few curves to a map that verify certifies, or a typed error.
#include <optional>

#include "c1mesh/generate.h"
#include "c1mesh/parametrize.h"
#include "fuzz/target.h"
#include "fuzz/targets/soup.h"

namespace {

using namespace c1mesh;

// Small: the map need not be good, but what is claimed of it must be true.
Options small_budget() {
  Options options;
  options.threads = 1;
  options.refine = 1;
  options.time_limit = 1;
  return options;
}

// The same text that a user's file would hold. Nothing if it is refused.
std::optional<Shape> shape_of(const std::string& text) {
  std::optional<Shape> shape;
  fuzz::accepted([&] {
    const std::vector<Drawing> drawings = read_drawings_from(text, "soup");
    const bool usable = check(drawings.at(0)).usable();
    const bool made = fuzz::accepted([&] { shape = make_shape(drawings[0]); });
    fuzz::require(usable == made, "check and make_shape disagree");
  });
  return shape;
}

// From the text of the file, as a stranger would.
void certify(const Outcome& outcome, const Shape& shape) {
  const Result read = parse_result(format_result(outcome.result), outcome.result.name);
  const VerifyReport report = verify(read, shape, claimed_bounds(read));
  if (!report.regular() || !report.conforming())
    fuzz::finding("an uncertified result\n" + report_text(report));
  fuzz::require(report.valid() == outcome.report.valid(), "the file's verdict is another one");
  if (outcome.within_bounds && !report.valid())
    fuzz::finding("a result claimed as valid\n" + report_text(report));
  fuzz::require(report.valid() || outcome.gave_up || outcome.time_limit_hit,
                "an invalid result that nobody speaks of");
}

}  // namespace

C1MESH_FUZZ_TARGET(road) {
  const std::optional<Shape> shape = shape_of(drawing_json(fuzz::soup(bytes)));
  if (!shape) return;
  fuzz::accepted([&] { certify(parametrize(*shape, small_budget()), *shape); });
}
