// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/executor/check_params.hpp>
#include <hexagait/footstep_gen/walker_params.hpp>

namespace hexagait::footstep_gen {

void check_stepping(Violations& violations, const gait_state::StepperParams& stepper) {
  require(violations, "duty_factor", stepper.duty_factor,
          stepper.duty_factor >= 0.5 && stepper.duty_factor < 1.0, "at least 0.5 and less than 1");
}

WalkerParams checked(const WalkerParams& params) {
  Violations violations("walker");
  check_controller(violations, params.control_dt, params.late_limit, params.executor);
  check_stepping(violations, params.stepper);
  const StepParams& step = params.step;
  const NamedNumber not_negative[] = {
      {"stroke [m]", step.stroke},
      {"height [m]", step.height},
      {"roughness_gain", step.roughness_gain},
      {"max_height [m]", step.max_height},
      {"urgent_share", step.urgent_share},
      {"stability_margin [m]", step.stability_margin},
      {"lift_margin [m]", step.lift_margin},
      {"tie_tolerance [m]", params.gait.tie_tolerance},
  };
  require_not_negative(violations, not_negative);
  require(violations, "haste", step.haste, step.haste >= 1.0 && std::isfinite(step.haste),
          "at least 1");
  require(violations, "descent", step.descent, step.descent >= 1.0 && std::isfinite(step.descent),
          "at least 1");
  require(violations, "touchdown", step.touchdown,
          step.touchdown >= 1.0 && std::isfinite(step.touchdown), "at least 1");
  require(violations, "level_height", step.level_height,
          step.level_height > 0.0 && step.level_height <= 1.0, "greater than 0 and at most 1");
  violations.throw_if_any();
  return params;
}

WalkerParams completed(WalkerParams params, const RobotModel& model) {
  RobotParams all = none_derived();
  all.step = params.step;
  all.tolerance = params.tolerance;
  all.tolerance.tie = params.gait.tie_tolerance;
  all = hexagait::completed(all, model);
  params.step = all.step;
  params.executor = hexagait::completed(params.executor, model);
  params.tolerance = all.tolerance;
  params.gait.tie_tolerance = all.tolerance.tie;
  return params;
}

}  // namespace hexagait::footstep_gen
