// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/xml.h"

#include <gtest/gtest.h>

namespace c1mesh {
namespace {

TEST(Xml, EscapesMarkupAndDropsControlCharacters) {
  EXPECT_EQ(xml_escaped("a <b> & \"c\"\x01\n\t"), "a &lt;b&gt; &amp; &quot;c&quot;\t");
  EXPECT_EQ(xml_escaped("Bézier 中 😀"), "Bézier 中 😀");
}

TEST(Xml, ReplacesWhatIsNoUtf8) {
  const std::string bad = "\xEF\xBF\xBD";
  EXPECT_EQ(xml_escaped("a\xFF"
                        "b"),
            "a" + bad + "b");
  EXPECT_EQ(xml_escaped("\xC3<"), bad + "&lt;");            // cut short: the markup stays escaped
  EXPECT_EQ(xml_escaped("\xC0\xBC"), bad + bad);            // an overlong '<'
  EXPECT_EQ(xml_escaped("\xED\xA0\x80"), bad + bad + bad);  // a surrogate
  EXPECT_EQ(xml_escaped("\xEF\xBF\xBF"), bad + bad + bad);  // U+FFFF
  EXPECT_EQ(xml_escaped("\xF4\x90\x80\x80"), bad + bad + bad + bad);
}

}  // namespace
}  // namespace c1mesh
