// SPDX-License-Identifier: GPL-3.0-or-later
// How an element of a picture looks: the part of CSS and of SVG's attributes that our pictures use.
// What is not known here is an error, so that no picture can look other in pixels than as SVG.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace c1mesh {

struct Paint {
  bool none = false;
  std::array<double, 3> rgb{0, 0, 0};  ///< 0 to 1
  double opacity = 1;
};

enum class Anchor { start, middle, end };

/// Everything is inherited, as all of what our pictures use is in SVG.
struct Look {
  Paint fill, stroke{true, {0, 0, 0}, 1};
  bool even_odd = false;
  double stroke_width = 1;
  bool round_caps = false, round_joins = false, stroke_first = false;
  std::vector<double> dashes;
  double font_size = 16;
  bool bold = false;
  Anchor anchor = Anchor::start;
};

/// Sets one property; false if it is none of a look. Throws std::invalid_argument for a value that
/// is not known.
bool set_property(Look& look, std::string_view property, std::string_view value);

/// Sets the properties of `a:b;c:d`. Throws std::invalid_argument for an unknown property.
void set_declarations(Look& look, std::string_view declarations);

/// An element as rules see it.
struct Tagged {
  std::string_view tag;
  std::vector<std::string_view> classes;
};

/// The rules of `<style>`: selectors of tags and classes, of an element or of its ancestors.
class StyleSheet {
 public:
  explicit StyleSheet(std::string_view text);
  /// Applies the rules for the last element of the path from the root, in order of specificity.
  void apply(Look& look, const std::vector<Tagged>& path) const;

 private:
  struct Rule {
    std::vector<std::string> selector;  ///< ".class" or "tag", ancestors first
    int specificity;
    std::string declarations;
  };
  static bool matches(const Rule& rule, const std::vector<Tagged>& path);
  std::vector<Rule> rules_;  ///< in order of application
};

/// The trimmed pieces of `text` between separators, empty ones left out.
std::vector<std::string_view> pieces_of(std::string_view text, std::string_view separators);

/// The number that `text` begins with; "px" may follow. Throws std::invalid_argument.
double number_of(std::string_view text);

}  // namespace c1mesh
