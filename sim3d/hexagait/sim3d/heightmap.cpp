// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <bit>
#include <cmath>
#include <hexagait/sim/fnv1a.hpp>
#include <hexagait/sim3d/detail/png.hpp>
#include <hexagait/sim3d/heightmap.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/parse_number.hpp>
#include <hexagait/text/split.hpp>
#include <hexagait/text/text_file.hpp>

namespace hexagait::sim3d {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20U;
constexpr std::size_t kMostPixels = std::size_t{1} << 24U;
constexpr double kGreatest = 1e6;

[[noreturn]] void refuse_heightmap(const std::string& place, const std::string& why) {
  throw InvalidInput(std::string("heightmap '").append(place).append("': ").append(why));
}

// Adds a line of a table.
void add_row(Heightmap& map, const std::string& place, std::string_view line) {
  const std::vector<std::string_view> cells = split(line, ',');
  if (map.rows > 0 && static_cast<int>(cells.size()) != map.columns)
    refuse_heightmap(place, std::string("it has ") + std::to_string(cells.size()) +
                                " numbers, the lines before " + std::to_string(map.columns));
  if (map.levels.size() + cells.size() > kMostPixels)
    refuse_heightmap(place, "it has more than 4096 × 4096 numbers");
  for (std::string_view cell : cells) {
    while (cell.starts_with(' ')) cell.remove_prefix(1);
    while (cell.ends_with(' ')) cell.remove_suffix(1);
    const auto level = parse_number<double>(cell);
    if (!level || !(std::abs(*level) <= kGreatest))
      refuse_heightmap(place,
                       std::string("'") + std::string(cell.substr(0, 40)) +
                           "' is not a number from -1e6 to 1e6; it must be a grey PNG, or lines of "
                           "numbers with commas between them");
    map.levels.push_back(static_cast<float>(*level));
  }
  map.columns = static_cast<int>(cells.size());
  ++map.rows;
}

Heightmap from_table(const std::string& file, std::string_view text) {
  Heightmap map;
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view row = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (row.ends_with('\r')) row.remove_suffix(1);
    if (!row.empty()) add_row(map, file + ":" + std::to_string(line), row);
  }
  return map;
}

}  // namespace

double Heightmap::at(double column, double row) const {
  const double s = std::clamp(column, 0.0, columns - 1.0), t = std::clamp(row, 0.0, rows - 1.0);
  const int i = std::min(static_cast<int>(s), columns - 2),
            j = std::min(static_cast<int>(t), rows - 2);
  const auto level = [&](int a, int b) {
    return static_cast<double>(
        levels[static_cast<std::size_t>(b) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(a)]);
  };
  const double u = s - i, v = t - j;
  return (1.0 - v) * ((1.0 - u) * level(i, j) + u * level(i + 1, j)) +
         v * ((1.0 - u) * level(i, j + 1) + u * level(i + 1, j + 1));
}

double Heightmap::lowest() const { return static_cast<double>(std::ranges::min(levels)); }
double Heightmap::highest() const { return static_cast<double>(std::ranges::max(levels)); }

std::uint64_t Heightmap::hash() const {
  std::uint64_t hash = fnv1a(static_cast<std::uint64_t>(columns), kFnv1aBasis);
  for (const float level : levels)
    hash = fnv1a(std::uint64_t{std::bit_cast<std::uint32_t>(level)}, hash);
  return hash;
}

Heightmap load_heightmap(const std::string& file) {
  const std::string bytes = read_text(file, kMostBytes, "a heightmap");
  constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n";
  Heightmap map;
  if (bytes.starts_with(kPng)) {
    const std::string problem = detail::read_png(bytes, kMostPixels, map);
    if (!problem.empty()) refuse_heightmap(file, problem);
  } else {
    map = from_table(file, bytes);
  }
  if (map.columns < 2 || map.rows < 2)
    refuse_heightmap(file, std::string("it has ") + std::to_string(map.columns) + " × " +
                               std::to_string(map.rows) + " levels; at least 2 × 2 are needed");
  return map;
}

}  // namespace hexagait::sim3d
