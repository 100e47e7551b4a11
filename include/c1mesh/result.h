// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a run: the map Phi as data (docs/format.md), and reading and writing it.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "c1mesh/types.h"

namespace c1mesh {

/// Domain edge from a to b (interior on its left for boundaries), mapped to `curve` over t0 -> t1.
struct CurveEdge {
  int a = -1, b = -1, curve = -1;  ///< domain vertices; index into Result::curves
  double t0 = 0, t1 = 1;           ///< the curve's parameter at a and at b; t0 > t1: against it
};

/// What the shape's boundary does at a vertex of the mesh.
struct BoundaryVertex {
  int vertex = -1;      ///< index into Result::domain_vertices
  bool corner = false;  ///< false: the shape's boundary is tangent-continuous there
};

/// Median, 99th percentile and maximum of a sample.
struct Spread {
  double median = 0, p99 = 0, max = 0;  ///< by nearest rank
};

/// What the program measured; lengths relative to the larger side of the bounding box.
struct Metrics {
  int triangles = 0;  ///< how many
  Spread d_ei;        ///< over the edges where C1 is asked
  /// Between both triangles of such an edge: angle of the gradients in degrees, relative difference
  /// of their lengths.
  Spread gradient_angle_deg, gradient_magnitude;
  double mips_bound_max = 0;          ///< max over triangles of g(t) = max n_i / min d_i (eq. 4.5)
  double min_det_coefficient = 0;     ///< least Bernstein coefficient of det J
  double conformance_max = 0;         ///< boundary control points from the exact curves
  int exceptional = 0;                ///< vertices where C1 is given up
  int exceptional_minimum = 0;        ///< by convex and reflex corners (docs/vocabulary.md)
  int exceptional_minimum_paper = 0;  ///< max(0, 3 - corners) per loop, the paper's count
  int surplus = 0;                    ///< exceptional - exceptional_minimum
  double flatness_ratio = 1;     ///< smooth boundary vertices that are flat, of all smooth ones
  bool domain_overlaps = false;  ///< the domain covers some place of the plane twice
  std::vector<std::pair<std::string, double>> seconds;  ///< by stage
};

/// What a parameter may be.
using ParameterValue = std::variant<bool, long long, double, std::string>;
/// Everything a run depended on, by name.
using Parameters = std::vector<std::pair<std::string, ParameterValue>>;

/// Everything that defines the map Phi from the domain mesh to the shape mesh.
struct Result {
  std::string name;                                       ///< without extension
  int degree = 3;                                         ///< of every triangle
  std::vector<Point> domain_vertices;                     ///< domain units
  std::vector<std::array<int, 3>> triangles;              ///< of domain vertices, counter-clockwise
  std::vector<Point> control_points;                      ///< shape space, input units
  std::vector<std::vector<int>> triangle_control_points;  ///< for j: for i: p_ij (docs/format.md)
  std::vector<BezierCurve> curves;                        ///< the input's, in its units and degrees
  std::vector<CurveEdge> boundary_edges, feature_edges;   ///< which edges lie on them
  std::vector<BoundaryVertex> boundary_vertices;          ///< each once
  std::vector<int> exceptional_vertices;                  ///< where C1 is given up
  std::vector<std::array<int, 2>> relaxed_edges;  ///< interior edges without C1, by vertices
  Parameters parameters;                          ///< everything the run depended on
  Metrics metrics;                                ///< what was measured of it
};

/// Reads `NAME.c1.json`. Throws FileError or InputError (malformed; limit: more than `max_bytes`);
/// never yields bad indices.
Result read_result(const std::string& path, std::size_t max_bytes = 200'000'000);
/// As above, from the file's text. Throws InputError (malformed).
Result parse_result(const std::string& text, const std::string& name);

/// The file's text; doubles read back bit for bit (docs/format.md).
std::string format_result(const Result& result);

/// Writes `text` to `path` whole or not at all (temporary file in the same folder, then renamed).
/// A link leads to its file; a device or a pipe is written as it is. Throws FileError; a file of
/// this name is then as it was.
void write_file(const std::string& path, const std::string& text);

/// A file to be written: where, and its bytes.
struct FileText {
  std::string path, text;  ///< the file's name; all of what it is to hold
};

/// The same for files that belong together: none has its name before all are on the disk, so that
/// a full disk leaves what was there. (A process killed between two renames leaves some new files
/// and some old ones, each whole.)
void write_files(const std::vector<FileText>& files);

/// Removes what write_file has not finished yet. For a signal handler that is about to end the
/// process: async-signal-safe, and from then on nothing more is written.
void discard_unfinished_files() noexcept;

}  // namespace c1mesh
