// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cassert>
#include <hexagait/sensitivity/costs.hpp>

namespace hexagait::experiments {
namespace {

constexpr double kFourFifths = 0.8;

Ladder ladder(const std::string& fault, const std::vector<std::string>& sizes) {
  Ladder result{fault, {}};
  for (const std::string& size : sizes) result.plants.push_back(fault + ":" + size);
  return result;
}

// Of a fault of the inertial measurement unit, for a robot that has one.
Ladder imu_ladder(const std::string& fault, const std::vector<std::string>& sizes) {
  Ladder result = ladder(fault, sizes);
  for (std::string& plant : result.plants) plant = "imu:on+" + plant;
  return result;
}

}  // namespace

std::vector<Ladder> ladders(bool short_form) {
  if (short_form) return {{"", {"ideal", "real"}}, ladder("joint_noise", {"2mrad"})};
  return {{"", {"ideal", "real"}},
          ladder("friction", {"0.6", "0.4", "0.3"}),
          ladder("contact_threshold", {"20N", "40N", "80N"}),
          ladder("servo_lag", {"10ms", "20ms", "40ms"}),
          {"servo", {"servo:position_only"}},
          ladder("drive_friction", {"5Nm", "20Nm"}),
          ladder("backlash", {"2mrad", "5mrad", "10mrad", "20mrad"}),
          ladder("armature", {"0.05kgm2", "0.2kgm2"}),
          ladder("mass_error", {"10%", "20%", "30%"}),
          ladder("joint_noise", {"0.5mrad", "1mrad", "2mrad", "5mrad"}),
          ladder("joint_quantisation", {"12bit", "10bit", "8bit"}),
          ladder("joint_zero_error", {"2mrad", "5mrad", "10mrad", "20mrad"}),
          ladder("contact_bounce", {"4ms", "10ms", "20ms"}),
          ladder("false_contacts", {"0.01%", "0.1%", "1%"}),
          ladder("missed_contacts", {"0.1%", "1%", "10%"}),
          {"imu", {"imu:on"}},
          imu_ladder("acceleration_noise", {"0.05m/s2", "0.5m/s2"}),
          imu_ladder("acceleration_bias", {"0.1m/s2", "0.5m/s2"}),
          imu_ladder("rate_noise", {"0.005", "0.05"}),
          imu_ladder("rate_bias", {"0.01", "0.05"}),
          ladder("sensing_delay", {"4ms", "10ms", "20ms"}),
          ladder("command_delay", {"4ms", "10ms", "20ms"}),
          ladder("late_ticks", {"0.1%", "1%", "5%"})};
}

bool still_walks(const PlantCost& cost, const PlantCost& ideal) {
  const auto walks = [](const Cost& now, const Cost& best) {
    return now.arrived.share() >= kFourFifths && now.speed >= kFourFifths * best.speed;
  };
  return walks(cost.flat, ideal.flat) && walks(cost.boxes, ideal.boxes);
}

std::string breaks_at(const Ladder& ladder, const std::vector<PlantCost>& costs) {
  const PlantCost& ideal = cost_of("ideal", costs);
  for (const std::string& plant : ladder.plants)
    if (!still_walks(cost_of(plant, costs), ideal)) return plant;
  return "";
}

const PlantCost& cost_of(const std::string& plant, const std::vector<PlantCost>& costs) {
  const auto found = std::ranges::find(costs, plant, &PlantCost::plant);
  assert(found != costs.end());
  return *found;
}

}  // namespace hexagait::experiments
