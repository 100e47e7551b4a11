// SPDX-License-Identifier: GPL-3.0-or-later
// Rows and columns of histograms on one SVG sheet.
#pragma once

#include <string>
#include <vector>

#include "evaluate/axes.h"

namespace c1mesh::charts {

/// One sample in a panel: heights of its bars by bin of the row's axis, and the share of each bin's
/// width that a bar takes.
struct Layer {
  std::vector<double> heights;
  std::string style;  ///< CSS class: one of Legend's
  double from = 0, to = 1;
};

struct Panel {
  std::vector<Layer> layers;  ///< the first one is drawn first
  std::string note;           ///< instead of bars, where there is nothing to draw
};

struct LegendEntry {
  std::string style, words;
};

struct Row {
  std::string title;     ///< "(a) …"
  std::string vertical;  ///< what the heights are: "shapes", "% of …"
  std::vector<LegendEntry> legend;
  Axis axis;
  std::vector<Panel> panels;  ///< one per column
};

/// What stands above a column.
struct Head {
  std::string title, subtitle;
};

/// Pixels of a panel's plot when there are so many columns.
double panel_width(std::size_t columns);

std::string sheet(const std::string& title, const std::string& subtitle,
                  const std::vector<Head>& heads, const std::vector<Row>& rows);

}  // namespace c1mesh::charts
