// SPDX-License-Identifier: GPL-3.0-or-later
// Where the bins of a histogram stand: axes that all panels of a row share, in pixels from the
// panel's left edge.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "c1mesh/evaluate.h"

namespace c1mesh::charts {

struct Bin {
  double left = 0, right = 0;
};

struct Tick {
  double at = 0;
  std::string name;    ///< without markup; "10" with `power`; empty: a line only
  std::string power;   ///< shown raised after the name
  bool stroke = true;  ///< between bins, so with a little line; else under the middle of a bin
};

struct Axis {
  std::vector<Bin> bins;
  std::vector<Tick> ticks;
};

/// Decades from the least value to the largest of all the histograms of a row; a bin labelled 0 at
/// the left and one labelled with the sign of infinity at the right where they are needed.
class LogAxis {
 public:
  LogAxis(const std::vector<const LogHistogram*>& row, double width);
  const Axis& axis() const { return axis_; }
  /// Counts by bin of this axis; their sum is the histogram's total.
  std::vector<double> counts(const LogHistogram& histogram) const;

 private:
  void place(double width);
  /// Is a tick so near to the bin of 0 that their names would touch?
  bool beside_zero(double from_left) const;

  int low_ = 0, high_ = 1;  // decades
  int merged_ = 1;          // bins of a LogHistogram to one of the axis
  bool any_ = false;        // is there a value between 0 and infinity
  bool zeros_ = false, infinite_ = false;
  Axis axis_;
};

/// Whole numbers from the least to the largest of a row, several to a bin where they are many.
class WholeAxis {
 public:
  WholeAxis(const std::vector<const ValueCounts*>& row, double width);
  const Axis& axis() const { return axis_; }
  std::vector<double> counts(const ValueCounts& values) const;

 private:
  int low_ = 0, step_ = 1;
  Axis axis_;
};

/// Shares from a round number below the least of a row up to 1, which belongs to the last bin.
class ShareAxis {
 public:
  ShareAxis(double least, double width);
  const Axis& axis() const { return axis_; }
  std::vector<double> counts(const std::vector<double>& sample) const;

 private:
  int low_ = 0;  // in hundredths
  int step_ = 1;
  Axis axis_;
};

}  // namespace c1mesh::charts
