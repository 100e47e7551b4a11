// SPDX-License-Identifier: GPL-3.0-or-later
// What one more exceptional vertex buys: the curve of their number against the distortion bound g.
#pragma once

#include <string>
#include <vector>

#include "c1mesh/options.h"
#include "c1mesh/progress.h"
#include "c1mesh/result.h"
#include "c1mesh/shape.h"

namespace c1mesh {

/// One map of the shape, as verified.
struct TradeOffPoint {
  int asked = 0;        ///< exceptional vertices asked for
  int exceptional = 0;  ///< there are; more than asked where the search had to give up more
  int surplus = 0;      ///< exceptional - minimum
  double g = 0;         ///< max over triangles of g(t) (eq. 4.5); dimensionless, at least 2
  double g_median = 0;  ///< over the triangles
  int triangles = 0;    ///< how many
  double d_ei_max = 0;  ///< largest C1 deviation where C1 is asked, relative to the extent
  bool regular = false, c1 = false;  ///< as VerifyReport has it
  bool dominated = false;  ///< another point has no more exceptional vertices and no larger g
};

/// Why the curve ends where it does.
enum class TradeOffEnd {
  flat,       ///< g fell by less than 5 % with each of the last two vertices
  most,       ///< twelve vertices more than the minimum
  time_limit  ///< the point that was being computed is left out
};

/// The curve of one shape.
struct TradeOff {
  std::string name;       ///< the shape's
  Parameters parameters;  ///< what the curve depends on
  double bound = 0;       ///< alpha * mips_bound; it is drawn, the search does not use it
  int minimum = 0;        ///< exceptional_minimum of the metrics
  std::vector<TradeOffPoint> points;  ///< by increasing `asked`; none if the time limit was too low
  TradeOffEnd end = TradeOffEnd::flat;  ///< why it ends
};

/// Asks for the minimum of exceptional vertices, then for one more, and so on until g stops
/// falling; of several regions the one with the largest g gets the next. Each point is the first C1
/// map the search finds, whatever its g (`alpha` and `exceptional` are not used for it), and is not
/// refined unless `refine` asks for it, so that a run's result, which is, may have a lower g with
/// more triangles. Throws Interrupted if `progress` says so, std::invalid_argument for options out
/// of range.
TradeOff trade_off(const Shape& shape, const Options& options = {}, const Progress& progress = {});

/// `NAME.tradeoff.json` (docs/format.md).
std::string format_trade_off(const TradeOff& curve);

/// An SVG picture: g on a logarithmic axis over the number of exceptional vertices, the points not
/// dominated joined by steps, the bound as a dashed line. `width` in pixels, at least 300.
std::string draw_trade_off(const TradeOff& curve, double width = 600);

}  // namespace c1mesh
