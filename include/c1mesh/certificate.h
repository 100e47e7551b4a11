// SPDX-License-Identifier: GPL-3.0-or-later
// What verify() proved, written down so that it can be checked again without any search
// (docs/certificate.md).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "c1mesh/result.h"

namespace c1mesh {

/// What was found of one claim.
enum class Verdict {
  valid,     ///< proven
  invalid,   ///< disproven
  undecided  ///< neither, within the depth that was allowed
};

/// "valid", "invalid", "undecided".
const char* name_of(Verdict verdict);

/// One thing that was looked at.
struct VerifyItem {
  std::string name;  ///< "topology", "coverage", "conformance", "boundary simple",
                     ///< "domain orientation", "regularity", "C1", "exceptional vertices", …
  Verdict verdict = Verdict::undecided;  ///< what was found
  std::string message;                   ///< what was found, with ids
};

/// Where a proof splits, in preorder: '1' a piece that is split, '0' one that is proven as it is.
using ProofMarks = std::string;

/// det J > 0 on one closed triangle; J is the derivative of the map from the domain.
struct TriangleProof {
  int depth = 0;          ///< of the bisection
  double det = 0;         ///< det J is at least this; shape units squared per domain unit squared
  double g = 0;           ///< |J|^2 / det J is at most this; infinite where nothing is proven
  ProofMarks marks;       ///< empty: no split
  bool rational = false;  ///< intervals did not decide
};

/// What holds of one edge of the mesh, relative to the extent.
struct EdgeBound {
  int a = -1, b = -1;  ///< vertex ids
  double bound = 0;    ///< every d_ei, or every control point's distance from the input curve
};

/// Why two boundary edges (a, b) and (c, d) meet only where they share an end, or, where both are
/// one edge, why it does not meet itself. Pairs that need no split are left out.
struct PairProof {
  std::array<int, 4> edges{};  ///< a, b, c, d
  ProofMarks marks;            ///< of the comparisons of both edges' pieces
};

/// All that verify() proved of a result.
struct Certificate {
  std::string name;                      ///< of the result
  int degree = 3;                        ///< of the result
  double extent = 1;                     ///< larger side of the bounding box of the curves' poles
  std::vector<VerifyItem> items;         ///< verdicts
  double c1 = 0, conformance = 0;        ///< the largest bounds of `edges` and `curve_edges`
  double det = 0, g = 0;                 ///< the least and the largest of the triangles'
  std::vector<TriangleProof> triangles;  ///< in the result's order
  std::vector<EdgeBound> edges;          ///< across which C1 is claimed, by (least, other) vertex
  std::vector<EdgeBound> curve_edges;    ///< boundary edges, then feature edges, the result's order
  std::vector<PairProof> boundary;       ///< pairs of boundary edges that needed a split
};

/// The text of docs/certificate.md. Numbers read back bit for bit.
std::string format_certificate(const Certificate& certificate);

/// Throws InputError if the text is no certificate.
Certificate parse_certificate(const std::string& text);

/// Throws FileError too, and InputError (limit) if the file is larger than `max_bytes`.
Certificate read_certificate(const std::string& path, std::size_t max_bytes = 200'000'000);

}  // namespace c1mesh
