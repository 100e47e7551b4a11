// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/key.h"

#include <fmt/format.h>

#include <vector>

#include "raster/font.h"

namespace c1mesh {
namespace {

constexpr double kSize = 11, kRow = 18, kSample = 24, kGap = 20;  // pixels

struct Entry {
  const char* css;  // of a line; nullptr: a dot
  const char* words;
};

std::vector<Entry> entries_of(const KeyContents& contents) {
  std::vector<Entry> out;
  if (contents.lines) {
    out.push_back({"u", "u constant"});
    out.push_back({"v", "v constant"});
  }
  if (contents.net) out.push_back({"net", "control net"});
  if (contents.features) out.push_back({"feature", "feature"});
  if (contents.exceptional) out.push_back({nullptr, "exceptional vertex"});
  if (contents.relaxed) out.push_back({"relaxed", "C1 not asked across"});
  if (contents.over) out.push_back({"over", "the other domain"});
  return out;
}

}  // namespace

Key key_of(const KeyContents& contents, double left, double top, double width) {
  const std::vector<Entry> entries = entries_of(contents);
  if (entries.empty()) return {};
  Key key{"<g id=\"key\" font-size=\"11\">\n", kRow};
  double x = left;
  for (const Entry& entry : entries) {
    const double room = kSample + 6 + kSize * text_width(entry.words, false);
    if (x > left && x + room > left + width) {
      x = left;
      key.height += kRow;
    }
    const double y = top + key.height - kRow / 2;
    // The dot is a line of length zero with round ends.
    key.svg += entry.css ? fmt::format("<path class=\"{}\" d=\"M{:.1f},{:.1f}h{}\"/>\n", entry.css,
                                       x, y, kSample)
                         : fmt::format(
                               "<path style=\"stroke:#199a4c;stroke-width:8\" "
                               "d=\"M{0:.1f},{1:.1f}L{0:.1f},{1:.1f}\"/>\n",
                               x + kSample / 2, y);
    key.svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x + kSample + 6, y + 4,
                           entry.words);
    x += room + kGap;
  }
  key.svg += "</g>\n";
  return key;
}

}  // namespace c1mesh
