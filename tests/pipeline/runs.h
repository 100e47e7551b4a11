// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes to run, and what every finished run must be.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "c1mesh/parametrize.h"
#include "c1mesh/shape.h"

namespace c1mesh::testing_pipeline {

/// Largest d_ei and conformance error a run may leave, relative to the extent: rounding alone.
inline constexpr double kExactlyC1 = 1e-12;
inline constexpr double kConforming = 1e-13;

/// The first drawing of a file, checked.
Shape shape_at(const std::string& path);

/// "blob" stands for examples/blob.svg.
Shape example(const std::string& name);

/// A file of tests/data.
Shape data(const std::string& name);

/// Straight sides from each point to the next and back to the first.
Shape polygon(const std::vector<Point>& corners);

/// Loops of four cubics near circles about the origin; every joint smooth in exact arithmetic.
Shape concentric(const std::vector<double>& radii);

/// Certified, boundary as given, C1 to rounding everywhere but across the relaxed edges.
void expect_valid_and_c1(const Outcome& outcome);

/// Connected pieces of the mesh, by shared vertices.
int components(const Result& result);

/// Vertices - edges + triangles: pieces - holes.
int euler_characteristic(const Result& result);

}  // namespace c1mesh::testing_pipeline
