// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>

#include "played.hpp"

namespace hexagait {
namespace {

// Some ticks of a stance.
bool stands(const RobotModel& robot) {
  action::Action waits;
  waits.steps.resize(1);
  waits.steps[0].wait.duration = 0.1;
  return fuzz::is_played(waits, robot, 5);
}

// What everything that takes a robot counts on.
bool is_sound(const RobotModel& robot) {
  const int n = robot.num_legs();
  if (n < 4 || n > kMaxLegs || n % 2 != 0 || !(robot.mass > 0.0)) return false;
  for (const LegModel& leg : robot.legs) {
    if (!leg.p_BC.allFinite() || !(leg.workspace_radius > 0.0)) return false;
    for (const JointLimits& limits : leg.limits)
      if (!(limits.lower < limits.upper) || !(limits.velocity > 0.0) || !(limits.effort > 0.0))
        return false;
    for (const LinkModel& link : leg.links)
      if (!(link.mass > 0.0) || !link.p_LM.allFinite() || !(link.inertia_M_L.trace() > 0.0))
        return false;
  }
  if (robot.base.shapes.empty() || !(robot.foot_radius > 0.0)) return false;
  return std::isfinite(robot.mass) && stands(robot);
}

}  // namespace
}  // namespace hexagait

// Whatever the bytes: a robot that is sound, or InvalidInput with a message.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hexagait;
  try {
    const std::string text(reinterpret_cast<const char*>(data), size);
    if (!is_sound(parse_urdf(text, "fuzz.urdf"))) std::abort();
  } catch (const InvalidInput& error) {
    if (error.what()[0] == '\0') std::abort();
  }
  return 0;
}
