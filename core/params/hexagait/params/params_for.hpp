// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/params/robot_params.hpp>
#include <hexagait/params/robot_scale.hpp>
#include <span>

namespace hexagait {

/// One parameter: factor · measure, unless it is set.
struct Parameter {
  const char* name;  ///< "step.stroke"
  const char* unit;  ///< "m"; "1" for a number
  double factor;
  ScaleOf of;
  double& (*in)(RobotParams& params);
};

/// All parameters that follow from the model.
[[nodiscard]] std::span<const Parameter> parameters();

/// All lengths, times, forces and gains of a robot, by parameters(). A pure function.
[[nodiscard]] RobotParams params_for(const RobotModel& model, double gravity = kStandardGravity);

/// Nothing is kDerived: for completed() of some groups, put into it, that asks nothing of the model if
/// these are complete. The other groups are of no use.
[[nodiscard]] RobotParams none_derived();

/// The parameters that are kDerived are set to params_for(model)'s; the others stay.
[[nodiscard]] RobotParams completed(RobotParams params, const RobotModel& model,
                                    double gravity = kStandardGravity);

}  // namespace hexagait
