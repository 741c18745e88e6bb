// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/executor/check_params.hpp>
#include <hexagait/plant/control_period.hpp>

namespace hexagait {
namespace {

void check_swing(Violations& violations, const SwingParams& p) {
  const NamedNumber positive[] = {
      {"unload_time [s]", p.unload_time},
      {"load_time [s]", p.load_time},
      {"lift_time [s]", p.lift_time},
      {"transfer_time [s]", p.transfer_time},
      {"max_speed [m/s]", p.max_speed},
      {"hasty_speed [m/s]", p.hasty_speed},
      {"descent_speed [m/s]", p.descent_speed},
      {"touchdown_speed [m/s]", p.touchdown_speed},
      {"search_speed [m/s]", p.search_speed},
      {"vertical_acceleration [m/s²]", p.vertical_acceleration},
      {"retreat_time [s]", p.retreat_time},
      {"blocked_error [m]", p.blocked_error},
      {"search_time [s]", p.search_time},
      {"slide_distance [m]", p.slide_distance},
      {"slide_time [s]", p.slide_time},
      {"slide_patience [s]", p.slide_patience},
  };
  const NamedNumber not_negative[] = {
      {"even_load_rate [1/s]", p.even_load_rate}, {"clearance_share", p.clearance_share},
      {"overlap_time [s]", p.overlap_time},       {"touchdown_margin [m]", p.touchdown_margin},
      {"commit_height [m]", p.commit_height},     {"retreat_back [m]", p.retreat_back},
      {"retreat_up [m]", p.retreat_up},           {"touch_time [s]", p.touch_time},
      {"confirm_time [s]", p.confirm_time},       {"lost_time [s]", p.lost_time},
      {"regain_time [s]", p.regain_time},         {"follow_rate [1/s]", p.follow_rate},
  };
  require_positive(violations, positive);
  require_not_negative(violations, not_negative);
}

void check_base(Violations& violations, const BaseParams& p) {
  const NamedNumber positive[] = {{"acceleration [m/s²]", p.acceleration},
                                  {"braking_distance [m]", p.braking_distance},
                                  {"outer_radius [m]", p.outer_radius}};
  const NamedNumber not_negative[] = {
      {"max_speed [m/s]", p.max_speed},
      {"advance_rate [1/s]", p.advance_rate},
      {"correction_rate [1/s]", p.correction_rate},
      {"correction_speed [m/s]", p.correction_speed},
      {"correction_turn [rad/s]", p.correction_turn},
      {"posture_rate [1/s]", p.posture_rate},
      {"height_speed [m/s]", p.height_speed},
      {"tilt_speed [rad/s]", p.tilt_speed},
      {"displacement_period [s]", p.displacement_period},
  };
  require_positive(violations, positive);
  require_not_negative(violations, not_negative);
}

}  // namespace

void require(Violations& violations, const char* name, double value, bool holds,
             const char* must_be) {
  if (!holds) violations.add(name, "is " + in_words(value) + "; it must be " + must_be);
}

void require_positive(Violations& violations, std::span<const NamedNumber> numbers) {
  for (const auto& [name, value] : numbers)
    require(violations, name, value, std::isfinite(value) && value > 0.0, "greater than 0");
}

void require_not_negative(Violations& violations, std::span<const NamedNumber> numbers) {
  for (const auto& [name, value] : numbers)
    require(violations, name, value, std::isfinite(value) && value >= 0.0, "0 or greater");
}

void check_controller(Violations& violations, double control_dt, double late_limit,
                      const ExecutorParams& params) {
  require(violations, "control_dt [s]", control_dt, is_control_period(control_dt),
          "from 0.001 to 0.02 (1 to 20 ms)");
  require(violations, "late_limit [s]", late_limit, late_limit >= 0.0, "0 or greater");
  const NamedNumber not_negative[] = {{"gravity [m/s²]", params.gravity}};
  require_not_negative(violations, not_negative);
  check_swing(violations, params.swing);
  check_base(violations, params.base);
}

}  // namespace hexagait
