// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <hexagait/recording/plant_setup.hpp>
#include <hexagait/recording/version.hpp>
#include <hexagait/sensitivity/costs.hpp>

namespace hexagait::experiments {
namespace {

std::string number(double value, double unit, int decimals) {
  return std::isnan(value) ? "–" : fmt::format("{:.{}f}", value / unit, decimals);
}

std::string cells(const Cost& cost, const Cost& ideal) {
  const statistics::Proportion& p = cost.arrived;
  return fmt::format("{} of {} ({:.0f}–{:.0f} %) | {} | {} | {} | {:.2f} ({:.2f})", p.count,
                     p.trials, 100.0 * p.lower, 100.0 * p.upper, number(cost.speed, 1.0, 3),
                     number(cost.speed / ideal.speed, 0.01, 0), number(cost.off_path, 0.01, 1),
                     cost.losses, cost.real_losses);
}

// Of "imu:on+rate_bias:0.05": 0.05.
std::string size_of(const std::string& plant) {
  const std::size_t colon = plant.rfind(':');
  return colon == std::string::npos ? plant : plant.substr(colon + 1);
}

std::string summary(const Ladder& ladder, const std::vector<PlantCost>& costs) {
  const std::string broken = breaks_at(ladder, costs);
  return broken.empty() ? fmt::format("still walks at {}", size_of(ladder.plants.back()))
                        : fmt::format("**{}**", size_of(broken));
}

constexpr const char* kIntro = R"(# What imperfections cost

`hexagait experiment sensitivity --out results` makes this page, as `results/sensitivity/sensitivity.md`;
no number is typed by hand. {}: argos walks {:g} m straight ahead in at most {:g} s, on flat ground with {}
seeds and over `boxes:0.10` with {}; the seeds are the same for all plants. What is not ideal, and its
numbers, are explained in [world.md](world.md#imperfect-plants); a plant of this page walks by
`hexagait walk --plant joint_noise:2mrad --terrain boxes:0.10`.
{}
- **arrived**: with the 95 % interval of the share after Wilson.
- **m/s**, **%**: mean speed of the walks that neither fell nor got stuck, and its share of that with an
  ideal plant.
- **off**: their mean distance from the path [cm].
- **lost**: contacts that a standing foot lost, per step, of all walks; in brackets the real ones, longer
  than 20 ms or by more than 5 mm. The others are bounces.

## Where it breaks

The first size in the table below with which fewer than four of five arrive, or which leaves less than four
fifths of the speed, on either terrain.

| imperfection | meaning | breaks at |
|---|---|---|
)";

constexpr const char* kTable = R"(
## What each costs

| plant | flat: arrived | m/s | % | off | lost (real) | boxes:0.10: arrived | m/s | % | off | lost (real) |
|---|---|---|---|---|---|---|---|---|---|---|
)";

std::string meaning(const std::string& fault) {
  for (const recording::PlantNumber& number : recording::plant_numbers())
    if (fault == number.name) return number.meaning;
  for (const recording::PlantSwitch& one : recording::plant_switches())
    if (fault == one.name) return one.meaning;
  return "";
}

}  // namespace

std::string page(const PageHead& head, const std::vector<Ladder>& ladders,
                 const std::vector<PlantCost>& costs) {
  std::string text =
      fmt::format(fmt::runtime(kIntro),
                  fmt::format("hexagait {} ({})", recording::kVersion, recording::kRevision),
                  head.distance, head.seconds, head.flat_seeds, head.boxes_seeds,
                  head.short_form ? "\n**A short form: not the figures of the full one.**\n" : "");
  for (const Ladder& ladder : ladders)
    if (!ladder.fault.empty())
      text += fmt::format("| `{}` | {} | {} |\n", ladder.fault, meaning(ladder.fault),
                          summary(ladder, costs));
  text += kTable;
  const PlantCost& ideal = cost_of("ideal", costs);
  for (const PlantCost& cost : costs)
    text += fmt::format("| `{}` | {} | {} |\n", cost.plant, cells(cost.flat, ideal.flat),
                        cells(cost.boxes, ideal.boxes));
  return text;
}

}  // namespace hexagait::experiments
