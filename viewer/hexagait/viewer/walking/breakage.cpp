// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/params/params_for.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/walking/breakage.hpp>

namespace hexagait::viewer {
namespace {

using walk::PartFault;
using walk::PartFaultKind;

[[noreturn]] void refuse(const PartFault& fault, const std::string& problem) {
  throw InvalidInput(fmt::format("fault '{}': {}", fault.text, problem));
}

void check_size(const PartFault& fault, const RobotModel& robot) {
  const double load = kMostLoad * robot.mass, push = kMostPush * robot.mass * falling_speed(robot);
  if (fault.kind == PartFaultKind::load && fault.value > load)
    refuse(fault, fmt::format("too heavy for {}; at most {:.3g} kg", robot.name, load));
  if (fault.kind == PartFaultKind::push && fault.value > push)
    refuse(fault, fmt::format("too hard for {}; at most {:.3g} N s", robot.name, push));
}

}  // namespace

double falling_speed(const RobotModel& robot) {
  const RobotScale scale = scale_of(robot);
  return std::sqrt(scale.gravity * scale.hip_height);
}

PartFault admitted(PartFault fault, std::span<const PartFault> present, const RobotModel& robot) {
  const PartFault part = walk::resolved({std::move(fault)}, robot).front();
  check_size(part, robot);
  if (std::ranges::any_of(present, [&](const PartFault& one) { return one.text == part.text; }))
    refuse(part, "it is there already");
  if (present.size() >= kMostFaults)
    refuse(part, fmt::format("there are {} already; mend them first", present.size()));
  return part;
}

}  // namespace hexagait::viewer
