// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/region_input.h"

#include "bernstein/curve.h"

namespace c1mesh {
namespace {

std::vector<LoopCurve> loop_curves(const Shape& shape, const Loop& loop, int degree) {
  std::vector<LoopCurve> out;
  for (const CurveUse& use : loop) {
    BezierCurve curve = shape.curves[use.curve];
    for (Point& p : curve.poles) p = shape.frame.normalise(p);
    curve = elevate(curve, degree);
    out.push_back({use.reversed ? reversed(curve) : curve, use.curve, use.reversed});
  }
  return out;
}

}  // namespace

MeshInput region_input(const Shape& shape, int index, int degree) {
  const Region& region = shape.regions[index];
  MeshInput input;
  input.degree = degree;
  input.loops.push_back(loop_curves(shape, region.outer, degree));
  for (const Loop& hole : region.holes) input.loops.push_back(loop_curves(shape, hole, degree));
  for (const FeaturePath& path : region.features)
    input.features.push_back({loop_curves(shape, path.curves, degree), path.closed});
  return input;
}

}  // namespace c1mesh
