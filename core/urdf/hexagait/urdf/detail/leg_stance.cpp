// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/serial_stance.hpp>
#include <hexagait/model/stance.hpp>
#include <hexagait/model/workspace.hpp>
#include <hexagait/urdf/detail/leg_stance.hpp>
#include <hexagait/urdf/detail/rounded.hpp>

namespace hexagait {
namespace {

constexpr double kLeastWorkspace = 0.05;  // of the leg's length
constexpr double kSameHeight = 1e-3;      // of the leg's length

double length_of(const LegModel& leg) {
  if (leg.kind != LegKind::serial) return leg.coxa + leg.femur + leg.tibia;
  const SerialLengths lengths = serial_lengths(leg);
  return lengths.coxa + lengths.upper + lengths.rest;
}

/// Which joints would be where beyond their limits with the foot at p_BC; if the limits are not
/// what keeps it from there, that.
std::string what_stops(const LegModel& leg) {
  LegModel free = leg;
  for (JointLimits& limits : free.limits) {
    limits.lower = -std::numbers::pi;
    limits.upper = std::numbers::pi;
  }
  const Reach reach = leg_reach(free);
  free.min_reach = reach.min;
  free.max_reach = reach.max;
  const auto solution = inverse_kinematics(free, leg.p_BC);
  if (!solution.reachable) return "the joint limits must allow it";
  std::string text;
  for (int i = 0; i < leg.num_joints(); ++i) {
    const JointLimits& limits = leg.limits[i];
    const double q = solution.q[i];
    if (limits.lower <= q && q <= limits.upper) continue;
    text += (text.empty() ? "joint " : ", joint ") + leg.joint_names[i] + " would be at " +
            degrees(q) + ", its limits are " + degrees(limits.lower) + " to " +
            degrees(limits.upper);
  }
  return text.empty() ? "the joint limits must allow it" : text;
}

/// Can the foot move from p_BC by the least workspace in four directions? The workspace itself takes
/// a thousand times as long.
bool has_room(const LegModel& leg) {
  const double room = kLeastWorkspace * length_of(leg);
  for (const Vector3& way : {Vector3(room, 0, 0), {-room, 0, 0}, {0, room, 0}, {0, -room, 0}})
    if (!inverse_kinematics(leg, leg.p_BC + way).reachable) return false;
  return true;
}

/// Puts the foot at p_BF if it can stand there.
bool stand_at(LegModel& leg, const Vector3& p_BF) {
  LegModel there = leg;
  if (!put_foot(there, p_BF) || !has_room(there)) return false;
  there.workspace_radius = reachable_radius(there);
  if (there.workspace_radius < kLeastWorkspace * length_of(leg)) return false;
  leg = there;
  return true;
}

/// Places around p_BF, the nearest first: moved outwards and inwards from the hip, `rings` steps up
/// and down, and turned about z at the hip.
std::vector<Vector3> places_around(const LegModel& leg, const Vector3& p_BF, int rings) {
  constexpr double kStep = 0.05;  // of the leg's length
  constexpr double kTurn = 0.15;  // [rad]
  const double step = kStep * length_of(leg);
  const Vector3 p_HF = leg.X_BH.inverse() * p_BF;
  const double out = portable::hypot(p_HF.x(), p_HF.y());
  std::vector<Vector3> all;
  for (int r = -7; r <= 7; ++r)
    for (int z = -rings; z <= rings; ++z)
      for (int turn = -7; turn <= 7; ++turn) {
        if (!(out + r * step > 0.0)) continue;
        const Vector3 p =
            rotation_z(turn * kTurn) * p_HF * ((out + r * step) / std::max(out, 1e-9));
        all.emplace_back(leg.X_BH * Vector3(p.x(), p.y(), p_HF.z() + z * step));
      }
  std::ranges::stable_sort(all, {}, [&](const Vector3& p) { return (p - p_BF).squaredNorm(); });
  return all;
}

/// The first of the places at which the leg can stand.
bool stand_near(LegModel& leg, const Vector3& p_BF, int rings) {
  return std::ranges::any_of(places_around(leg, p_BF, rings),
                             [&](const Vector3& p) { return stand_at(leg, p); });
}

/// Swung to the middle of what is straight out and allowed, and lowered by an eighth of a turn: the
/// foot can rise and fall, and to swing it takes a short arc. Where limits forbid that, as near to it
/// as they let.
void take_stance_of_two_joints(LegModel& leg, Violations& violations) {
  constexpr double kLowered = 0.25 * std::numbers::pi;
  leg.min_reach = leg.max_reach = leg.femur;
  LegJoints q = LegJoints::Zero();
  for (int i = 0; i < 2; ++i)
    q[i] = std::clamp(leg.joint_sign[i] * ((i == 0 ? 0.0 : kLowered) - leg.joint_offset[i]),
                      leg.limits[i].lower, leg.limits[i].upper);
  leg.p_BC = foot_position(leg, q);
  leg.q_nominal = q;
  const double down = (leg.X_BH.inverse() * leg.p_BC).z();
  leg.workspace_radius = down < 0.0 ? reachable_radius(leg) : 0.0;
  if (leg.workspace_radius < kLeastWorkspace * length_of(leg))
    violations.add("leg " + leg.name, "has no room for a step: its foot stands " + metres(-down) +
                                          " below the hip; the joint limits must "
                                          "let it swing fore and aft there");
}

Substitution moved(const LegModel& leg, const std::string& found) {
  const Vector3 p_HC = leg.X_BH.inverse() * leg.p_BC;
  return {Origin::derived,
          "leg " + leg.name,
          0,
          "stance",
          found,
          "foot " + metres(portable::hypot(p_HC.x(), p_HC.y())) + " out, " + metres(-p_HC.z()) +
              " below the hip, yaw " + degrees(portable::atan2(p_HC.y(), p_HC.x())),
          ""};
}

}  // namespace

void derive_stance(LegModel& leg, Violations& violations,
                   std::vector<Substitution>& substitutions) {
  if (leg.kind == LegKind::yaw_pitch) return take_stance_of_two_joints(leg, violations);
  if (leg.num_joints() < 3) {
    violations.add("leg " + leg.name,
                   "has two joints; such a leg must swing about the vertical and then be lowered "
                   "about a level axis, with its foot in the plane of both");
    return;
  }
  if (leg.kind == LegKind::serial) return take_serial_stance(leg, violations);
  const Reach reach = leg_reach(leg);
  if (!(reach.min <= reach.max)) {
    violations.add("joint " + leg.joint_names[2],
                   "limits " + in_words(leg.limits[2].lower) + " to " +
                       in_words(leg.limits[2].upper) +
                       " rad never let the knee bend upwards; they must");
    return;
  }
  leg.min_reach = reach.min;
  leg.max_reach = reach.max;
  leg.p_BC = nominal_foot(leg);
  if (inverse_kinematics(leg, leg.p_BC).reachable) {
    leg.workspace_radius = reachable_radius(leg);
    return;
  }
  const Vector3 p_HC = leg.X_BH.inverse() * leg.p_BC;
  const std::string place = "foot " + in_words(p_HC.x()) + " m out from the yaw axis, " +
                            in_words(-p_HC.z()) + " m below the hip, yaw 0; " + what_stops(leg);
  constexpr int kRings = 5;
  if (stand_near(leg, leg.p_BC, kRings))
    substitutions.push_back(moved(leg, place));
  else
    violations.add("leg " + leg.name, "cannot take its nominal stance: " + place);
}

void share_ground(LegArray<LegModel>& legs, Violations& violations,
                  std::vector<Substitution>& substitutions) {
  std::vector<double> heights;
  for (const LegModel& leg : legs) heights.push_back(leg.p_BC.z());
  std::ranges::sort(heights);
  const double height = heights[heights.size() / 2];
  for (LegModel& leg : legs) {
    if (std::abs(leg.p_BC.z() - height) < kSameHeight * length_of(leg)) continue;
    const std::string found = "foot at z = " + metres(leg.p_BC.z());
    if (stand_near(leg, Vector3(leg.p_BC.x(), leg.p_BC.y(), height), 0))
      substitutions.push_back(moved(leg, found));
    else
      violations.add("leg " + leg.name, "stands best with its " + found +
                                            " and cannot stand at z = " + metres(height) +
                                            ", where the others do; its joint limits, or theirs, "
                                            "must let all reach the ground together");
  }
}

}  // namespace hexagait
