// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/leg_weight.hpp>
#include <hexagait/params/detail/step_shape.hpp>
#include <hexagait/params/robot_scale.hpp>

namespace hexagait {
namespace {

using namespace detail;
using enum ScaleOf;

constexpr double kRisePeak = 1.875;  // minimum jerk: peak over mean speed
constexpr double kDisc = 0.55;       // radius of the swing's volume, of the stroke
constexpr double kDip = 0.3;         // its depth below the ground, of the height
constexpr double kSpeedShare = 0.9;  // of the joints' greatest speeds

struct FootSpeed {
  double sideways = std::numeric_limits<double>::infinity();  // [m/s]
  double upwards = std::numeric_limits<double>::infinity();   // [m/s]
};

// Speeds of the foot, in any direction of the plane and upwards, that no joint is too slow for.
FootSpeed foot_speed(const LegModel& leg, const LegTrig& trig) {
  const LegJacobian J = foot_jacobian(leg, trig);
  const Matrix3 JJt = J * J.transpose();
  if (!(std::abs(JJt.determinant()) > 0.0)) return {0.0, 0.0};
  const Eigen::Matrix<double, kMaxLegJoints, 3> inverse = J.transpose() * JJt.inverse();
  FootSpeed speed;
  for (int k = 0; k < leg.num_joints(); ++k) {
    const double limit = leg.limits[k].velocity;
    const double across = inverse.row(k).head<2>().norm(), up = std::abs(inverse(k, 2));
    if (across > 0.0) speed.sideways = std::min(speed.sideways, limit / across);
    if (up > 0.0) speed.upwards = std::min(speed.upwards, limit / up);
  }
  return speed;
}

// Of a leg of two joints: fore and aft, and upwards. What is across follows, and is no choice.
FootSpeed foot_speed_of_two(const LegModel& leg, const LegTrig& trig) {
  const Eigen::Matrix2d J = (leg.X_BH.R.transpose() * foot_jacobian(leg, trig)).block<2, 2>(1, 0);
  if (!(std::abs(J.determinant()) > 0.0)) return {0.0, 0.0};
  const Eigen::Matrix2d inverse = J.inverse();
  FootSpeed speed;
  for (int k = 0; k < 2; ++k) {
    const double limit = leg.limits[k].velocity;
    speed.sideways = std::min(speed.sideways, limit / std::abs(inverse(k, 0)));
    speed.upwards = std::min(speed.upwards, limit / std::abs(inverse(k, 1)));
  }
  return speed;
}

FootSpeed speed_at(const LegModel& leg, const LegSolution& solution) {
  return leg.has_two_joints() ? foot_speed_of_two(leg, solution.trig)
                              : foot_speed(leg, solution.trig);
}

bool carries(const LegModel& leg, const LegSolution& solution, double load, double gravity) {
  const LegJoints effort = standing_effort(leg, solution, load, gravity);
  for (int k = 0; k < leg.num_joints(); ++k)
    if (std::abs(effort[k]) > leg.limits[k].effort) return false;
  return true;
}

// The speeds throughout the volume of a swing of reach ℓ; 0 if a part of it is out of reach, or the leg can't
// carry its load [N] all along its stroke.
FootSpeed speed_in_volume(const LegModel& leg, double reach, double load, double gravity) {
  constexpr int kDirections = 8;
  const double height = kHeight * reach, radius = kDisc * kStroke * reach;
  FootSpeed least;
  for (const double z : {-kDip * height, 0.0, height}) {
    for (int k = 0; k <= kDirections; ++k) {
      Vector3 offset(0.0, 0.0, z);
      if (k > 0) offset.head<2>() = radius * unit_vector(2.0 * std::numbers::pi * k / kDirections);
      const LegSolution solution = inverse_kinematics(leg, leg.p_BC + offset);
      if (!solution.reachable) return {0.0, 0.0};
      if (z == 0.0 && !carries(leg, solution, load, gravity)) return {0.0, 0.0};
      const FootSpeed speed = speed_at(leg, solution);
      least.sideways = std::min(least.sideways, speed.sideways);
      least.upwards = std::min(least.upwards, speed.upwards);
    }
  }
  return least;
}

FootSpeed speed_in_volumes(const RobotModel& model, double reach, double gravity) {
  FootSpeed least;
  const double load = standing_load(model, gravity);
  for (const LegModel& leg : model.legs) {
    const FootSpeed speed = speed_in_volume(leg, reach, load, gravity);
    least = {std::min(least.sideways, speed.sideways), std::min(least.upwards, speed.upwards)};
  }
  return least;
}

// Sideways over the workspaces' centres, from the ground to the apex.
double crossing_speed(const RobotModel& model, double height) {
  double least = std::numeric_limits<double>::infinity();
  for (const LegModel& leg : model.legs) {
    for (const double z : {0.0, height}) {
      const LegSolution solution = inverse_kinematics(leg, leg.p_BC + Vector3(0.0, 0.0, z));
      least = std::min(least, solution.reachable ? speed_at(leg, solution).sideways : 0.0);
    }
  }
  return least;
}

double size_of(const RobotModel& model) {
  Vector2 least = model.legs[0].p_BC.head<2>(), most = least;
  for (const LegModel& leg : model.legs) {
    least = least.cwiseMin(leg.p_BC.head<2>());
    most = most.cwiseMax(leg.p_BC.head<2>());
  }
  return 0.5 * (most - least).sum();
}

// ℓ of λ = 1: within the workspaces, small against the stance, and clear of the neighbours' discs.
double longest_reach(const RobotModel& model, double size) {
  double reach = 0.22 * size;
  for (LegId i = 0; i < model.num_legs(); ++i) {
    reach = std::min(reach, model.legs[i].workspace_radius);
    for (LegId j = 0; j < i; ++j)
      reach = std::min(reach, 0.45 * (model.legs[i].p_BC - model.legs[j].p_BC).head<2>().norm());
  }
  return reach;
}

// s: the least factor of √(L/g) with which the joints move the feet at these speeds [ℓ/T].
double stretch(const RobotScale& scale, double across, double up) {
  if (!(scale.sideways > 0.0)) return 1.0;
  const double unit = scale.reach / scale.free_time;
  return std::max({1.0, across * unit / (kSpeedShare * scale.sideways),
                   up * unit / (kSpeedShare * scale.upwards)});
}

}  // namespace

RobotScale scale_of(const RobotModel& model, double gravity) {
  RobotScale scale;
  scale.legs = model.num_legs();
  scale.gravity = gravity;
  scale.weight = model.mass * gravity;
  scale.size = size_of(model);
  scale.free_time = std::sqrt(scale.size / gravity);

  // In steps of 5 %; a leg without any volume around its foot has a tenth.
  constexpr int kSteps = 20, kLeast = 2;
  const double longest = longest_reach(model, scale.size);
  FootSpeed speed;
  for (int k = kSteps; k >= kLeast; --k) {
    scale.room = static_cast<double>(k) / kSteps;
    scale.reach = scale.room * longest;
    speed = speed_in_volumes(model, scale.reach, gravity);
    if (speed.sideways > 0.0) break;
  }
  scale.sideways = speed.sideways;
  scale.upwards = speed.upwards;
  scale.crossing = crossing_speed(model, kHeight * scale.reach);

  const double across = kRisePeak * kStroke / kTransferTime - kBodySpeed;
  scale.time = stretch(scale, across, kDescentSpeed) * scale.free_time;

  for (const LegModel& leg : model.legs) {
    scale.outer = std::max(scale.outer, leg.p_BC.head<2>().norm());
    scale.hip_height -= leg.p_BC.z() / model.num_legs();
  }
  return scale;
}

double pace_of(const RobotScale& scale) {
  const double across = kSidewaysSpeed - kBodySpeed, up = kRisePeak * kHeight / kLiftTime;
  return scale.reach / (stretch(scale, across, up) * scale.free_time);
}

double measure(ScaleOf of, const RobotScale& s) {
  switch (of) {
    case none:
      return 1.0;
    case size:
      return s.size;
    case height:
      return s.hip_height;
    case reach:
      return s.reach;
    case time:
      return s.time;
    case speed:
      return s.reach / s.time;
    case acceleration:
      return s.reach / (s.time * s.time);
    case rate:
      return 1.0 / s.time;
    case tipping:
      return s.gravity * s.size / s.hip_height;
    case outer:
      return s.outer + 0.5 * s.reach;
    case step_time:
      return s.free_time;
    case step_rate:
      return 1.0 / s.free_time;
    case foot_load:
      return s.weight / s.legs;
    case stiffness:
      return s.weight * s.size;
    case damping:
      return s.weight * s.size * s.free_time;
    case mobility:
      return s.size / s.free_time / s.weight;
    case free_speed:
      return s.size / s.free_time;
    case joint_rise:
      return s.upwards;
    case swing_speed:
      return std::min(kSidewaysSpeed * (s.reach / s.time),
                      kSpeedShare * s.sideways + kBodySpeed * (s.reach / s.time));
    case hasty_speed:
      return std::min(kHaste * kSidewaysSpeed * (s.reach / s.time),
                      kSpeedShare * s.crossing + kHaste * kBodySpeed * (s.reach / s.time));
  }
  return 1.0;
}

const char* symbol(ScaleOf of) {
  switch (of) {
    case none:
      return "";
    case size:
      return "L";
    case height:
      return "h";
    case reach:
      return "ℓ";
    case time:
      return "T";
    case speed:
      return "ℓ/T";
    case acceleration:
      return "ℓ/T²";
    case rate:
      return "1/T";
    case tipping:
      return "g L/h";
    case outer:
      return "(c + ℓ/2)";
    case step_time:
      return "√(L/g)";
    case step_rate:
      return "√(g/L)";
    case foot_load:
      return "m g/n";
    case stiffness:
      return "m g L";
    case damping:
      return "m g L √(L/g)";
    case mobility:
      return "√(g L)/(m g)";
    case free_speed:
      return "√(g L)";
    case joint_rise:
      return "v↑";
    case swing_speed:
      return "min(2.93 ℓ/T, 0.9 v→ + 0.33 ℓ/T)";
    case hasty_speed:
      return "min(4.10 ℓ/T, 0.9 v⇒ + 0.46 ℓ/T)";
  }
  return "";
}

double standing_load(const RobotModel& model, double gravity) {
  return model.mass * gravity / std::max(2, model.num_legs() / 2 - 1);
}

LegJoints standing_effort(const LegModel& leg, const LegSolution& solution, double load,
                          double gravity) {
  return leg_weight(leg, solution.q, {0.0, 0.0, gravity}).effort -
         foot_jacobian(leg, solution.trig).transpose() * Vector3(0.0, 0.0, load);
}

}  // namespace hexagait
