// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/navigation/senses.hpp>

namespace hexagait::navigation {
namespace {

// Of the foot circle's radius; see SenseLayout.
constexpr double kLooksAhead = 1.75, kLooksAside = 1.25;
constexpr double kWhiskerAhead = 1.3, kWhiskerAside = 1.1;
constexpr double kMast = 0.5;  // height over the floor, of the way that a beam looks ahead

// Foremost hips of both sides: how far ahead, and how far aside.
Vector2 foremost_hip(const RobotModel& model) {
  Vector2 hip = model.legs[0].X_BH.p.head<2>();
  for (LegId i = 1; i < model.num_legs(); ++i)
    if (model.legs[i].X_BH.p.x() > hip.x()) hip = model.legs[i].X_BH.p.head<2>();
  return hip.cwiseAbs();
}

}  // namespace

SenseLayout sense_layout_for(const RobotModel& model) {
  const RobotScale scale = scale_of(model);
  const double R = scale.outer + 0.5 * scale.reach;
  const Vector2 hip = foremost_hip(model);
  const double height =
      scale.hip_height + model.foot_radius;  // of the body's origin, above the floor
  const double ahead = kLooksAhead * R, mast = std::max(height, kMast * (ahead - hip.x()));

  SenseLayout layout{.whiskers = {}, .beams = {}, .foot_circle = R};
  for (std::size_t k = 0; k < kBeams; ++k) {
    const double aside = kLooksAside * R * (1.0 - 2.0 * static_cast<double>(k) / (kBeams - 1));
    const Vector3 from(hip.x(), 0.0, mast - height), to(ahead, aside, -height);
    layout.beams[k] = {from, (to - from).normalized(), (to - from).norm()};
  }
  for (std::size_t k = 0; k < kWhiskers; ++k) {
    const double side = k == 0 ? 1.0 : -1.0;
    layout.whiskers[k] = {{hip.x(), side * hip.y(), 0.0},
                          {kWhiskerAhead * R, side * kWhiskerAside * R, 0.0}};
  }
  return layout;
}

Senses on_the_floor(const SenseLayout& layout) {
  Senses senses;
  for (std::size_t k = 0; k < kBeams; ++k) senses.range[k] = layout.beams[k].to_floor;
  return senses;
}

}  // namespace hexagait::navigation
