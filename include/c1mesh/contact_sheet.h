// SPDX-License-Identifier: GPL-3.0-or-later
// Many results on one page, each small.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "c1mesh/write.h"

namespace c1mesh {

/// What a cell says of its result's certificate.
enum class SheetMark {
  none,           ///< nobody looked
  certified,      ///< verify() found every item valid
  not_certified,  ///< it did not
};

/// A grid of cells, in the order in which they are added: a small picture, below it the name, the
/// mark, the numbers of exceptional vertices and of triangles, and g. A result is drawn when it is
/// added and not needed afterwards, so a sheet of hundreds takes the memory of one result and of
/// the text. Colours mean the same on every sheet: distortion runs from 2 to 1000, the C1 deviation
/// from 1e-17 to 1e-3.
class ContactSheet {
 public:
  /// For `count` cells. Of the options `columns` counts (0: as many as make the page about square
  /// while names can still be read), `width`, `parts`, `grid_lines`, `show_mesh`,
  /// `show_control_net`, `colour`, `show_key` and `transparent`.
  ContactSheet(std::size_t count, const DrawOptions& options);
  ~ContactSheet();
  /// Takes the other sheet's cells.
  ContactSheet(ContactSheet&&) noexcept;
  /// Takes the other sheet's cells.
  ContactSheet& operator=(ContactSheet&&) noexcept;

  /// `metrics` give g; those of the result itself or of its verification.
  void add(const Result& result, const std::string& name, const Metrics& metrics, SheetMark mark);
  /// A cell that says what is wrong with a file.
  void add_unreadable(const std::string& name, const std::string& reason);

  /// The page as SVG; png_of() makes pixels of it.
  std::string svg() const;

 private:
  class Page;
  std::unique_ptr<Page> page_;
};

}  // namespace c1mesh
