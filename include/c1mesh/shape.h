// SPDX-License-Identifier: GPL-3.0-or-later
// From a file to a checked shape: Drawing (as read), Shape (as meshed).
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "c1mesh/error.h"
#include "c1mesh/types.h"

namespace c1mesh {

/// A curve as the file gives it; `id` is the file's own name for it.
struct InputCurve {
  std::string id;        ///< unique within a drawing or not, as the file has it
  BezierCurve curve;     ///< input units
  bool feature = false;  ///< marked as a feature: bounds nothing, even where it could
};

/// How the inside of a set of loops is told: SVG's fill-rule. JSON arrangements use even_odd.
enum class FillRule {
  even_odd,  ///< inside where a ray crosses an odd number of loops
  nonzero    ///< inside where the loops wind around
};

/// One arrangement of curves to be meshed as one result: a JSON file, or one filled SVG element.
struct Drawing {
  std::string name;                         ///< result name without directory or extension
  std::vector<InputCurve> curves;           ///< in file order; nothing is checked yet except syntax
  FillRule fill_rule = FillRule::even_odd;  ///< what is inside
  std::vector<Defect> notes;  ///< conversions made while reading (arc error, closed subpaths)
};

/// How to read, and limits that bound what a reader takes of memory and time. Beyond them:
/// InputError (limit).
struct ReadOptions {
  bool together = false;  ///< SVG: the whole drawing as one arrangement, unfilled lines as features
  std::size_t max_bytes = 200'000'000;  ///< of a file
  std::size_t max_curves = 1'000'000;   ///< of a file
  std::size_t max_characters = 10'000;  ///< of a text to be set in a font
  int max_depth = 256;                  ///< nesting of elements or arrays
};

/// The file's bytes ("-": standard input). Throws InputError (limit) if there are more than
/// `max_bytes`, FileError if it cannot be read.
std::string read_bytes(const std::string& path, std::size_t max_bytes);

/// Reads JSON (a list of curves with `poles`, or an object with it under "curves") or SVG, told
/// apart by content, from `path` ("-": standard input). Throws InputError for content that cannot
/// be used, FileError if the file cannot be opened.
std::vector<Drawing> read_drawings(const std::string& path, const ReadOptions& options = {});

/// As above, from text already in memory; `name` names the drawings.
std::vector<Drawing> read_drawings_from(const std::string& text, const std::string& name,
                                        const ReadOptions& options = {});

/// An input curve as a loop uses it: with the interior on its left.
struct CurveUse {
  int curve = -1;         ///< index into Shape::curves
  bool reversed = false;  ///< run against its direction
};
/// Curves that follow one another, the last one back to the first.
using Loop = std::vector<CurveUse>;

/// Feature curves that follow one another: between two ends, each a branch point (three or more
/// curves of boundary and features meet) or a dangling end, or closed and without branch points.
struct FeaturePath {
  std::vector<CurveUse> curves;  ///< each begins where the one before ends
  bool closed = false;           ///< a loop without ends
};

/// One connected piece of the shape: counter-clockwise outer loop, clockwise holes, and the feature
/// curves inside, which meet each other and the loops in end points only.
struct Region {
  Loop outer;                         ///< counter-clockwise
  std::vector<Loop> holes;            ///< clockwise
  std::vector<FeaturePath> features;  ///< curves inside that bound nothing
};

/// normalised = (input - origin) * 2^-exponent; the larger side of the bounding box becomes a
/// length in (0.5, 1]. A power of two, so that scaling the input by one changes nothing.
struct Frame {
  Point origin = Point::Zero();  ///< input units
  int exponent = 0;              ///< of the power of two

  /// From input units to the normalised frame, rounded once.
  Point normalise(const Point& p) const;
  /// Back to input units, rounded once.
  Point restore(const Point& p) const;
  /// 2^exponent: input units per normalised unit.
  double extent() const;
};

/// A checked arrangement: every region simple, loops closed bit for bit (a curve's end point equals
/// the next one's start point exactly), oriented.
struct Shape {
  std::string name;                    ///< the drawing's
  std::vector<BezierCurve> curves;     ///< input units and degree, after repairs, direction as read
  std::vector<std::string> curve_ids;  ///< per curve
  std::vector<Region> regions;         ///< connected pieces
  std::vector<Defect> notes;           ///< repairs and notes of reading and checking
  Frame frame;                         ///< in which it is worked on

  /// Of all curves.
  int highest_degree() const;
};

/// What a check lets pass.
struct CheckOptions {
  double gap_tolerance = 2e-3;  ///< relative to the extent: gaps up to this are closed, and said
};

/// What a check found.
struct CheckReport {
  std::vector<Defect> defects;  ///< everything found; repaired ones have `repaired` set
  /// Is there no defect that is not repaired?
  bool usable() const;
};

/// Finds every defect of a drawing; never throws for bad geometry.
CheckReport check(const Drawing& drawing, const CheckOptions& options = {});

/// Joins, repairs what is safe, orients, nests. Throws InputError with all defects if unusable.
Shape make_shape(const Drawing& drawing, const CheckOptions& options = {});

}  // namespace c1mesh
