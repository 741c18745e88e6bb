// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/stance.hpp>
#include <hexagait/model/workspace.hpp>
#include <hexagait/params/best_stance.hpp>
#include <hexagait/text/violations.hpp>

namespace hexagait {
namespace {

constexpr double kMostEffort = 0.8;   // of the joints' limits, in a stance to be chosen
constexpr double kEnoughRoom = 0.75;  // λ with which the nominal stance is kept

// The foot `out` of coxa + femur from its yaw axis, and `down` of femur + tibia below the hip.
bool place(LegModel& leg, double out, double down) {
  const double reach = leg.femur + leg.tibia;
  leg.p_BC = leg.X_BH * Vector3(out * (leg.coxa + leg.femur), 0.0, -down * reach);
  const LegSolution solution = inverse_kinematics(leg, leg.p_BC);
  if (!solution.reachable) return false;
  leg.q_nominal = solution.q;
  leg.workspace_radius = reachable_radius(leg);
  return leg.workspace_radius > 0.0;
}

// The speed of walking grows with it; 0 if the joints can't carry the robot.
double merit(const RobotModel& robot) {
  if (standing_effort(robot).share > kMostEffort) return 0.0;
  const RobotScale scale = scale_of(robot);
  return scale.sideways > 0.0 ? pace_of(scale) : 0.0;
}

bool all_pitch_legs(const RobotModel& robot) {
  return std::ranges::all_of(
      robot.legs, [](const LegModel& leg) { return leg.kind == LegKind::yaw_pitch_pitch; });
}

}  // namespace

StandingEffort standing_effort(const RobotModel& robot, double gravity) {
  const double load = standing_load(robot, gravity);
  StandingEffort most;
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    const LegModel& leg = robot.legs[i];
    const LegSolution stance = inverse_kinematics(leg, leg.p_BC);
    const LegJoints effort = standing_effort(leg, stance, load, gravity);
    for (int k = 0; k < leg.num_joints(); ++k) {
      const double share = std::abs(effort[k]) / leg.limits[k].effort;
      if (share > most.share) most = {share, i, k, std::abs(effort[k])};
    }
  }
  return most;
}

RobotModel in_best_stance(const RobotModel& robot) {
  if (!all_pitch_legs(robot)) return robot;
  const bool strong = standing_effort(robot).share <= kMostEffort;
  if (strong && scale_of(robot).room >= kEnoughRoom) return robot;
  RobotModel best = robot;
  double best_merit = merit(robot);
  for (const double out : {0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2}) {
    for (const double down : {0.25, 0.35, 0.45, 0.55, 0.65, 0.75}) {
      RobotModel other = robot;
      bool placed = true;
      for (LegModel& leg : other.legs) placed = placed && place(leg, out, down);
      if (!placed) continue;
      weigh(other);
      const double other_merit = merit(other);
      if (other_merit > best_merit) {
        best = other;
        best_merit = other_merit;
      }
    }
  }
  return best;
}

std::string why_it_cannot_walk(const RobotModel& robot) {
  const StandingEffort effort = standing_effort(robot);
  const LegModel& leg = robot.legs[effort.leg];
  if (effort.share > 1.0)
    return "joint " + leg.joint_names[effort.joint] + " needs " + in_words(effort.effort) +
           " N m to stand on every other leg, and has " +
           in_words(leg.limits[effort.joint].effort) + " N m";
  const RobotScale scale = scale_of(robot);
  if (scale.sideways > 0.0) return "";
  return "no leg has room for a step of " + in_words(scale.reach) +
         " m about its foot: the legs are too short for their stance, the limits of their "
         "joints too narrow, or their efforts too small to carry the robot there";
}

}  // namespace hexagait
