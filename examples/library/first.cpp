// SPDX-License-Identifier: GPL-3.0-or-later
// first DRAWING.svg RESULT.c1.json: reads a shape, parametrizes it, verifies it, writes the result.
#include <c1mesh/c1mesh.h>

#include <csignal>
#include <iostream>

namespace {

volatile std::sig_atomic_t stop = 0;

/// Called often; returning false ends the work. Says each stage once.
bool progress(const std::string& stage, double fraction) {
  static std::string last;
  if (stage != last) std::cerr << static_cast<int>(100 * fraction) << " % " << stage << '\n';
  last = stage;
  return stop == 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: first DRAWING.svg RESULT.c1.json\n";
    return 2;
  }
  std::signal(SIGINT, [](int) { stop = 1; });
  try {
    // A file may hold several drawings: every filled element of an SVG is one.
    const c1mesh::Drawing drawing = c1mesh::read_drawings(argv[1]).at(0);
    const c1mesh::Shape shape = c1mesh::make_shape(drawing);
    for (const c1mesh::Defect& note : shape.notes) std::cerr << describe(note) << '\n';

    c1mesh::Options options;
    options.degree = 3;
    const c1mesh::Outcome outcome = c1mesh::parametrize(shape, options, progress);
    const c1mesh::Metrics& metrics = outcome.report.metrics;
    std::cout << "triangles " << metrics.triangles << ", exceptional vertices "
              << metrics.exceptional << ", g at most " << metrics.mips_bound_max << '\n';

    // parametrize has verified it already. This is how a result that was read is verified, against
    // the shape it claims to be of.
    const c1mesh::VerifyReport report = c1mesh::verify(outcome.result, shape);
    std::cout << "regular " << report.regular() << ", conforming " << report.conforming() << ", C1 "
              << report.c1() << '\n';
    if (!report.valid()) return 4;
    c1mesh::write_file(argv[2], c1mesh::format_result(outcome.result));
    return outcome.within_bounds ? 0 : 4;
  } catch (const c1mesh::InputError& error) {
    for (const c1mesh::Defect& defect : error.defects()) std::cerr << describe(defect) << '\n';
    return 3;
  } catch (const c1mesh::FileError& error) {
    std::cerr << error.what() << '\n';
    return 3;
  } catch (const c1mesh::Interrupted& error) {
    std::cerr << error.what() << '\n';
    return 5;
  }
}
