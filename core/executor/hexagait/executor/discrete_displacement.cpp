// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/executor/discrete_displacement.hpp>

namespace hexagait {
namespace {

// Length of the leg beyond joint k, which no posture changes [m].
double length_beyond(const LegModel& leg, int k) {
  double length = (leg.p_BF0 - leg.p_BJ0[leg.num_joints() - 1]).norm();
  for (int j = k + 1; j < leg.num_joints(); ++j) length += (leg.p_BJ0[j] - leg.p_BJ0[j - 1]).norm();
  return length;
}

}  // namespace

int displacement_ticks(double period, double dt) noexcept {
  return std::max(1, static_cast<int>(std::lround(period / dt)));
}

// The integral of the rotation by its series: the next term is below 1e-8 of the way for 0.05 rad.
Pose displacement(const Twist& V_B, double time) noexcept {
  const Vector3 turn = time * V_B.w, way = time * V_B.v;
  const Vector3 bent = turn.cross(way);
  return {rotation(turn), way + 0.5 * bent + turn.cross(bent) / 6.0};
}

LegSolution joints_after(const LegModel& leg, const Vector3& p_BF, const LegJoints& q,
                         const LegTrig& trig, const Twist& V_B, double time,
                         const Vector3& roll_arm) noexcept {
  const Vector3 carried = displacement(V_B, time).inverse() * p_BF;
  const LegSolution solution = inverse_kinematics(leg, carried, q, trig);
  if (roll_arm.isZero()) return solution;
  // A foot rolls as its last link turns over the ground; that shifts it little, so once is enough.
  const Vector3 turn = time * V_B.w + tibia_turn(leg, trig, solution.q - q);
  return inverse_kinematics(leg, carried + turn.cross(roll_arm), solution.q, solution.trig);
}

double speed_share(const LegModel& leg, const LegJoints& q, const LegJoints& q_end,
                   double time) noexcept {
  double share = 0.0;
  for (int k = 0; k < leg.num_joints(); ++k)
    share = std::max(share, std::abs(q_end[k] - q[k]) / (leg.limits[k].velocity * time));
  return share;
}

double most_slip(const LegModel& leg, const Vector3& p_BF, const LegJoints& q,
                 const LegJoints& q_end, const Twist& V_B, double time) noexcept {
  double bend = 0.0;
  for (int j = 0; j < leg.num_joints(); ++j)
    for (int k = 0; k < leg.num_joints(); ++k)
      bend += length_beyond(leg, std::max(j, k)) * std::abs(q_end[j] - q[j]) *
              std::abs(q_end[k] - q[k]);
  // The foot's distance from the axis of V does not change, nor does its speed.
  const double speed = (V_B.v + V_B.w.cross(p_BF)).norm();
  return (bend + V_B.w.norm() * speed * time * time) / 8.0;
}

}  // namespace hexagait
