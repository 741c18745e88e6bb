// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/walk/start_posture.hpp>
#include <hexagait/walk/trial.hpp>

namespace hexagait::walk {
namespace {

constexpr double kClearance = 0.0015;  // of legs above the ground, of their reach
constexpr int kMaxDraws = 10'000;      // per leg

// How far a shape, rotated by R, reaches below its centre [m].
double reach_down(const Shape& shape, const Matrix3& R) {
  const Vector3& size = shape.size;
  switch (shape.kind) {
    case Shape::Kind::box:
      return 0.5 * R.row(2).cwiseAbs().dot(size);
    case Shape::Kind::sphere:
      return size.x();
    case Shape::Kind::cylinder: {
      const double along = std::abs(R(2, 2));
      return size.x() * std::sqrt(std::max(0.0, 1.0 - along * along)) + 0.5 * size.y() * along;
    }
  }
  return 0.0;
}

// Height of the lowest point of a link at X_BL, in the base frame [m].
double lowest(const LinkModel& link, const Pose& X_BL) {
  double z = std::numeric_limits<double>::infinity();
  for (const Shape& shape : link.shapes) {
    const Pose X_BS = X_BL * shape.X_LS;
    z = std::min(z, X_BS.p.z() - reach_down(shape, X_BS.R));
  }
  return z;
}

double lowest(const LegModel& leg, const LegJoints& q, int links) {
  double z = std::numeric_limits<double>::infinity();
  for (int k = 0; k < links; ++k) z = std::min(z, lowest(leg.links[k], link_pose(leg, k, q)));
  return z;
}

[[noreturn]] void refuse(const RobotModel& model, const LegModel& leg) {
  throw InvalidInput(model.name + " can't lie on its belly: leg " + leg.name + " is in the way");
}

double clearance(const LegModel& leg) { return kClearance * leg.max_reach; }

LegJoints sitting(const RobotModel& model, const LegModel& leg, double depth) {
  const Vector3 p_BF(leg.p_BC.x(), leg.p_BC.y(), model.foot_radius - depth);
  const LegSolution solution = inverse_kinematics(leg, p_BF);
  if (!solution.reachable || lowest(leg, solution.q, leg.num_joints() - 1) < clearance(leg) - depth)
    refuse(model, leg);
  return solution.q;
}

LegJoints lying(const RobotModel& model, const LegModel& leg, double depth,
                RandomSequence& random) {
  for (int draw = 0; draw < kMaxDraws; ++draw) {
    LegJoints q = LegJoints::Zero();
    for (int k = 0; k < leg.num_joints(); ++k)
      q[k] = random.uniform(leg.limits[k].lower, leg.limits[k].upper);
    if (lowest(leg, q, leg.num_joints()) > clearance(leg) - depth) return q;
  }
  refuse(model, leg);
}

}  // namespace

double belly_depth(const RobotModel& model) { return -lowest(model.base, model.base.X_BL0); }

StartPosture start_posture(const RobotModel& model, StartKind kind, std::uint64_t seed) {
  StartPosture posture{nominal_posture(model)};
  if (kind == StartKind::standing) return posture;

  const double depth = belly_depth(model);
  posture.height = depth;
  if (kind == StartKind::lying) posture.rests_on = RestsOn::belly;
  RandomSequence random{.seed = seed, .stream = RandomStream::posture};
  for (LegId i = 0; i < model.num_legs(); ++i) {
    const LegModel& leg = model.legs[i];
    posture.q[i] =
        kind == StartKind::sitting ? sitting(model, leg, depth) : lying(model, leg, depth, random);
  }
  return posture;
}

}  // namespace hexagait::walk
