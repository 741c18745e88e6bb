// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/script/fill_in.hpp>

namespace hexagait {
namespace {

void fill(double& value, double with) {
  if (is_derived(value)) value = with;
}

void fill_in(action::LegCommand& command, const ScriptParams& params) {
  if (auto* step = std::get_if<action::Footstep>(&command.motion)) {
    fill(step->profile_height, params.profile_height);
    fill(step->average_velocity, params.footstep_speed);
  } else if (auto* foot = std::get_if<action::EndEffectorTarget>(&command.motion)) {
    fill(foot->average_velocity, params.foot_speed);
  } else if (auto* joints = std::get_if<action::JointTarget>(&command.motion)) {
    fill(joints->average_velocity, params.joint_speed);
  } else if (auto* mode = std::get_if<action::LegMode>(&command.motion)) {
    fill(mode->duration, params.leg_mode_time);
  }
}

void fill_in(action::BaseCommand& command, const ScriptParams& params) {
  if (auto* automatic = std::get_if<action::BaseAuto>(&command.motion)) {
    fill(automatic->average_linear_velocity, params.auto_speed);
    fill(automatic->average_angular_velocity, params.auto_turn);
    fill(automatic->support_margin, params.support_margin);
  } else if (auto* target = std::get_if<action::BaseTarget>(&command.motion)) {
    fill(target->average_linear_velocity, params.base_speed);
    fill(target->average_angular_velocity, params.base_turn);
  }
}

}  // namespace

void fill_in(std::vector<action::Step>& steps, const ScriptParams& params) {
  for (action::Step& step : steps) {
    for (action::LegCommand& command : step.legs) fill_in(command, params);
    if (step.base) fill_in(*step.base, params);
  }
}

}  // namespace hexagait
