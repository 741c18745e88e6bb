// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <png.h>

#include <hexagait/sim3d/detail/png.hpp>

namespace hexagait::sim3d::detail {
namespace {

// Of libpng's simplified interface: 16 bits are "linear", 8 bits are not; neither is changed here.
template <class Level>
std::string read_levels(png_image& image, double white, Heightmap& map) {
  const auto columns = static_cast<std::size_t>(image.width);
  std::vector<Level> pixels(columns * static_cast<std::size_t>(image.height));
  if (png_image_finish_read(&image, nullptr, pixels.data(), static_cast<png_int_32>(columns),
                            nullptr) == 0)
    return image.message;
  map.columns = static_cast<int>(image.width);
  map.rows = static_cast<int>(image.height);
  map.levels.reserve(pixels.size());
  for (const Level pixel : pixels) map.levels.push_back(static_cast<float>(pixel / white));
  return {};
}

}  // namespace

std::string read_png(const std::string& bytes, std::size_t most_pixels, Heightmap& map) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0)
    return image.message;
  std::string problem;
  if ((image.format & (PNG_FORMAT_FLAG_COLOR | PNG_FORMAT_FLAG_ALPHA | PNG_FORMAT_FLAG_COLORMAP)) !=
      0)
    problem = "it has colours or transparency; it must be grey, of 8 or 16 bits";
  else if (std::size_t{image.width} * image.height > most_pixels)
    problem = "it has more than 4096 × 4096 pixels";
  if (!problem.empty()) {
    png_image_free(&image);
    return problem;
  }
  const bool has_16_bits = (image.format & PNG_FORMAT_FLAG_LINEAR) != 0;
  image.format = has_16_bits ? PNG_FORMAT_LINEAR_Y : PNG_FORMAT_GRAY;
  return has_16_bits ? read_levels<png_uint_16>(image, 65535.0, map)
                     : read_levels<png_byte>(image, 255.0, map);
}

}  // namespace hexagait::sim3d::detail
