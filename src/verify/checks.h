// SPDX-License-Identifier: GPL-3.0-or-later
// The single checks of verify(); each looks at one thing and may add to the metrics and to the
// certificate. Where a certificate is followed, `record` collects what it says in vain.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "c1mesh/result.h"
#include "c1mesh/shape.h"
#include "c1mesh/verify.h"
#include "verify/bernstein_forms.h"
#include "verify/spread.h"
#include "verify/surface.h"

namespace c1mesh::verification {

/// Counts faults and keeps the first few messages.
class Faults {
 public:
  void add(std::string message) {
    if (++count_ <= 5) messages_.push_back(std::move(message));
  }
  std::size_t count() const { return count_; }
  std::string text() const {
    std::string out;
    for (const std::string& message : messages_) out += (out.empty() ? "" : "; ") + message;
    if (count_ > messages_.size()) out += fmt::format("; and {} more", count_ - messages_.size());
    return out;
  }
  /// Invalid if there are any; otherwise valid with `good` as the message.
  VerifyItem item(const std::string& name, const std::string& good) const {
    if (count_ > 0) return {name, Verdict::invalid, text()};
    return {name, Verdict::valid, good};
  }

 private:
  std::size_t count_ = 0;
  std::vector<std::string> messages_;
};

/// What all checks look at. Everything in `result` is in range and finite (check_structure).
struct Subject {
  const Result& result;
  const VerifyOptions& options;
  Surface surface;
  double extent = 1;                   ///< larger side of the bounding box of all poles of `curves`
  const Certificate* given = nullptr;  ///< its proofs are followed; null: they are searched for

  int degree() const { return result.degree; }
  /// Control point of triangle t, exponents (n-second-third, second, third) at corners k, k+1, k+2.
  int control_id(int t, int k, int second, int third) const {
    return result.triangle_control_points[t][turned_index(degree(), k, second, third)];
  }
  const Point& control(int t, int k, int second, int third) const {
    return result.control_points[control_id(t, k, second, third)];
  }
};

/// A boundary edge of the mesh with its control points in loop order (interior on the left).
struct BoundaryRow {
  int a = -1, b = -1;
  std::vector<Point> poles;
};
/// The rows of a loop, one per vertex: row i runs from vertex i to vertex i+1.
std::vector<BoundaryRow> rows_of(const Subject& subject, const std::vector<int>& loop);

VerifyItem check_structure(const Result& result);
VerifyItem check_topology(const Subject& subject);
VerifyItem check_coverage(const Subject& subject);
VerifyItem check_conformance(const Subject& subject, Metrics& metrics, Samples& samples,
                             Certificate& certificate);
VerifyItem check_input_curves(const Subject& subject, const Shape& shape);
VerifyItem check_boundary_simple(const Subject& subject, Certificate& certificate, Faults& record);
VerifyItem check_domain_orientation(const Subject& subject);
VerifyItem check_winding(const Subject& subject);
bool domain_overlaps(const Subject& subject);
/// Regularity, and with it g and the least coefficient of det J.
VerifyItem check_regularity(const Subject& subject, Metrics& metrics, Certificate& certificate,
                            Faults& record);
VerifyItem check_c1(const Subject& subject, Metrics& metrics, Samples& samples,
                    Certificate& certificate);
VerifyItem check_boundary_vertices(const Subject& subject);
VerifyItem check_exceptional(const Subject& subject, Metrics& metrics);
void measure_flatness(const Subject& subject, Metrics& metrics);
void measure_gradients(const Subject& subject, Metrics& metrics, Samples& samples);

/// Is `given` a certificate of this result, by its counts and its extent? Else adds to `record`.
bool certificate_fits(const Subject& subject, const Certificate& given, Faults& record);

/// Every bound of `given` must be at least what was found now (`made`), and none be missing.
void compare_bounds(const Certificate& given, const Certificate& made, Faults& record);

/// The interior edges across which C1 is asked: neither relaxed nor feature edges.
std::vector<int> smooth_edges(const Subject& subject);

/// "3, 7, 9, …": the first ids of a list.
inline std::string id_text(const std::vector<int>& ids) {
  std::string out;
  for (std::size_t i = 0; i < ids.size() && i < 10; ++i)
    out += fmt::format("{}{}", i ? ", " : "", ids[i]);
  return ids.size() > 10 ? out + ", …" : out;
}

}  // namespace c1mesh::verification
