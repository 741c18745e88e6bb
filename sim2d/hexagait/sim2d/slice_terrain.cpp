// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <charconv>
#include <cmath>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim2d/slice_terrain.hpp>

namespace hexagait::sim2d {
namespace {

constexpr int kFlatDescent = 5;        // [slices], [PC04] 5.1
constexpr int kLongestDescent = 1000;  // [slices]
constexpr std::string_view kDescent = "descent:", kProfile = "profile:";

template <class Number>
std::optional<Number> parse_number(std::string_view text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end) return {};
  return value;
}

std::optional<SliceTerrain> parse_descent(std::string_view range) {
  const std::size_t dash = range.find('-');
  if (dash == std::string_view::npos) return {};
  const auto min = parse_number<int>(range.substr(0, dash));
  const auto max = parse_number<int>(range.substr(dash + 1));
  if (!min || !max || !(1 <= *min && *min <= *max && *max <= kLongestDescent)) return {};
  return SliceTerrain{
      .kind = SliceTerrain::Kind::descent, .descent_min = *min, .descent_max = *max};
}

std::optional<SliceTerrain> parse_profile(std::string_view text) {
  const auto roughness = parse_number<double>(text);
  if (!roughness || !(0.0 <= *roughness && *roughness <= kLongestDescent)) return {};
  return SliceTerrain{.kind = SliceTerrain::Kind::profile, .roughness = *roughness};
}

/// One draw per leg and step, or leg and cell.
double draw(const SliceSeed& seed, LegId leg, std::int64_t index) noexcept {
  const auto number = static_cast<std::uint64_t>(index * kMaxLegs + leg);
  return random_u01(seed.seed, RandomStream::terrain, seed.trial, number);
}

}  // namespace

std::optional<SliceTerrain> parse_slice_terrain(std::string_view text) {
  if (text == "flat") return SliceTerrain{};
  if (text.starts_with(kDescent)) return parse_descent(text.substr(kDescent.size()));
  if (text.starts_with(kProfile)) return parse_profile(text.substr(kProfile.size()));
  return {};
}

std::string to_string(const SliceTerrain& terrain) {
  if (terrain.kind == SliceTerrain::Kind::flat) return "flat";
  if (terrain.kind == SliceTerrain::Kind::descent)
    return std::string(kDescent) + std::to_string(terrain.descent_min) + "-" +
           std::to_string(terrain.descent_max);
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.begin(), digits.end(), terrain.roughness).ptr;
  return std::string(kProfile).append(digits.begin(), end);
}

int descent_of(const SliceTerrain& terrain, const SliceSeed& seed, LegId leg, int step) noexcept {
  if (terrain.kind != SliceTerrain::Kind::descent) return kFlatDescent;
  const int choices = terrain.descent_max - terrain.descent_min + 1;
  return terrain.descent_min + static_cast<int>(choices * draw(seed, leg, step));
}

std::int64_t cell_at(const SliceTerrain& terrain, double x) noexcept {
  return static_cast<std::int64_t>(std::floor(x / terrain.cell));
}

double cell_height(const SliceTerrain& terrain, const SliceSeed& seed, LegId leg,
                   std::int64_t cell) noexcept {
  return terrain.roughness * draw(seed, leg, cell);
}

}  // namespace hexagait::sim2d
