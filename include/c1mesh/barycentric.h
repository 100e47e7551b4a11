// SPDX-License-Identifier: GPL-3.0-or-later
// Places in a triangle.
#pragma once

#include <Eigen/Core>

namespace c1mesh {

/// Barycentric coordinates with respect to the corners 0, 1, 2 of a triangle, in its order; their
/// sum is 1, and none is negative inside. Dimensionless.
using Barycentric = Eigen::Vector3d;

}  // namespace c1mesh
