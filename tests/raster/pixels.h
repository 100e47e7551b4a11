// SPDX-License-Identifier: GPL-3.0-or-later
// A PNG file's pixels, read by libpng: another library than the one that painted them.
#pragma once

#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace c1mesh::testing_pixels {

using Rgba = std::array<int, 4>;

struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;  ///< red, green, blue, opacity, row by row
  Rgba at(int x, int y) const {
    const std::size_t first = 4 * (static_cast<std::size_t>(y) * width + x);
    return {bytes.at(first), bytes.at(first + 1), bytes.at(first + 2), bytes.at(first + 3)};
  }
  /// Sum of 1 - green: how much black there is on white, in pixels.
  double ink() const {
    double sum = 0;
    for (std::size_t k = 1; k < bytes.size(); k += 4) sum += 1 - bytes[k] / 255.0;
    return sum;
  }
};

inline Pixels pixels_of(const std::string& png) {
  Pixels out;
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&image, png.data(), png.size())) << image.message;
  image.format = PNG_FORMAT_RGBA;
  out.width = static_cast<int>(image.width);
  out.height = static_cast<int>(image.height);
  out.bytes.resize(PNG_IMAGE_SIZE(image));
  EXPECT_TRUE(png_image_finish_read(&image, nullptr, out.bytes.data(), 0, nullptr))
      << image.message;
  return out;
}

}  // namespace c1mesh::testing_pixels
