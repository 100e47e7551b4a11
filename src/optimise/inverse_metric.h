// SPDX-License-Identifier: GPL-3.0-or-later
// The metric that a domain triangle contributes to distortion.
#pragma once

#include <Eigen/Core>

#include "c1mesh/types.h"

namespace c1mesh {

/// S(D) = adj(D) adj(D)^T / det D with its derivatives in vec D = (D00, D10, D01, D11). With M the
/// derivative over the unit triangle, |M D^-1|_F^2 det D = S11 |M0|^2 + 2 S12 M0.M1 + S22 |M1|^2.
struct InverseMetric {
  Eigen::Vector3d value;                 ///< S11, S12, S22
  Eigen::Matrix<double, 3, 4> gradient;  ///< rows: entries
};

/// Precondition: det D is not zero.
InverseMetric inverse_metric(const Eigen::Matrix2d& D);

/// The Hessian in vec D of s . S(D) for constant s.
Eigen::Matrix4d inverse_metric_hessian(const Eigen::Vector3d& s, const Eigen::Matrix2d& D);

}  // namespace c1mesh
