// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <hexagait/rough/tally.hpp>

namespace hexagait::experiments {
namespace {

// "1.2", or nothing.
std::string number(const RoughMean& mean, double unit, int decimals) {
  return std::isnan(mean.value) ? "–" : fmt::format("{:.{}f}", mean.value / unit, decimals);
}

std::string how_others_ended(const RoughPoint& p) {
  const int other = p.arrived.trials - p.arrived.count - p.fell - p.stuck - p.late;
  std::string text;
  for (const auto& [number, word] : {std::pair(p.fell, "fell"), std::pair(p.stuck, "stuck"),
                                     std::pair(p.late, "late"), std::pair(other, "fault")})
    if (number > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", number, word);
  return text;
}

std::string row(const RoughPoint& p, double reach, const RoughPoint* flat) {
  const std::string of_flat = flat == nullptr ? "–" : number(p.speed, 0.01 * flat->speed.value, 0);
  return fmt::format(
      "| {:g} | {:.2f} | `{}` | {} of {} ({:.0f}–{:.0f} %) | {} | {} | {} | {} | {} | {} | {} | {} "
      "|\n",
      100.0 * p.height, p.height / reach, p.controller, p.arrived.count, p.arrived.trials,
      100.0 * p.arrived.lower, 100.0 * p.arrived.upper, how_others_ended(p),
      number(p.speed, 1.0, 3), of_flat, number(p.off_path, 0.01, 1), number(p.slip, 0.01, 1),
      number(p.touchdown, 1.0, 2), number(p.cost, 1.0, 2), number(p.margin, 0.01, 0));
}

constexpr const char* kHeader =
    "| boxes up to [cm] | of leg reach | controller | arrive (95 %) | the others | m/s | % of flat "
    "| off path [cm] | slip [cm] | touchdowns [m/s] | cost | margin [cm] "
    "|\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";

}  // namespace

std::string page(std::span<const RoughPoint> points, double reach) {
  std::string text;
  for (const RoughPoint& first : points) {
    if (text.find(fmt::format("Plant `{}`", first.plant)) != std::string::npos) continue;
    text += fmt::format("{}Plant `{}`:\n\n{}", text.empty() ? "" : "\n", first.plant, kHeader);
    for (const RoughPoint& p : points)
      if (p.plant == first.plant) text += row(p, reach, point(points, p.plant, p.controller, 0.0));
  }
  return text;
}

}  // namespace hexagait::experiments
