// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/serial_stance.hpp>
#include <hexagait/sim/random.hpp>
#include <testing/random_vector.hpp>

/// Serial legs of any shape, and where their feet are by a product of Eigen's rotations.
namespace hexagait::testing {

inline LegJoints random_joints(const LegModel& leg, RandomSequence& random) {
  LegJoints q = LegJoints::Zero();
  for (int i = 0; i < leg.num_joints(); ++i)
    q[i] = random.uniform(leg.limits[i].lower, leg.limits[i].upper);
  return q;
}

/// n joints at any place about any axes, up to 0.4 m apart, with ranges of 2 to 5 rad.
inline LegModel random_leg(int n, RandomSequence& random) {
  LegModel leg;
  leg.kind = LegKind::serial;
  leg.joint_names = JointArray<std::string>(n);
  leg.limits = JointArray<JointLimits>(n);
  leg.links = JointArray<LinkModel>(n);
  leg.p_BJ0 = leg.axis_B0 = JointArray<Vector3>(n);
  Vector3 p = 0.3 * random_vector(random);
  leg.X_BH.p = p;
  for (int i = 0; i < n; ++i) {
    leg.p_BJ0[i] = p;
    leg.axis_B0[i] = random_vector(random).normalized();
    const double middle = random.uniform(-1.0, 1.0), half = random.uniform(1.0, 2.5);
    leg.limits[i] = {middle - half, middle + half, 8.0, 100.0};
    p += 0.25 * random_vector(random);
  }
  leg.p_BF0 = p;
  leg.q_nominal = random_joints(leg, random);
  const Reach reach = serial_reach(leg);
  leg.min_reach = reach.min;
  leg.max_reach = std::max(reach.min, reach.max);
  return leg;
}

inline Pose pose_of_last_link(const LegModel& leg, const LegJoints& q) {
  Eigen::Affine3d X = Eigen::Affine3d::Identity();
  for (int i = 0; i < leg.num_joints(); ++i)
    X = X * Eigen::Translation3d(leg.p_BJ0[i]) * Eigen::AngleAxisd(q[i], leg.axis_B0[i]) *
        Eigen::Translation3d(-leg.p_BJ0[i]);
  return {X.linear(), X.translation()};
}

inline Vector3 foot_by_rotations(const LegModel& leg, const LegJoints& q) {
  return pose_of_last_link(leg, q) * leg.p_BF0;
}

/// By central differences of the above.
inline LegJacobian jacobian_by_differences(const LegModel& leg, const LegJoints& q) {
  constexpr double h = 1e-6;
  LegJacobian J = LegJacobian::Zero();
  for (int i = 0; i < leg.num_joints(); ++i) {
    const LegJoints step = h * LegJoints::Unit(i);
    J.col(i) = (foot_by_rotations(leg, q + step) - foot_by_rotations(leg, q - step)) / (2.0 * h);
  }
  return J;
}

/// How well the foot can be moved in the worst direction, by the longest reach.
inline double dexterity_by_differences(const LegModel& leg, const LegJoints& q) {
  return jacobian_by_differences(leg, q).jacobiSvd().singularValues()[2] / leg.max_reach;
}

inline bool is_within_reach(const LegModel& leg, const Vector3& p_BF) {
  const double d = (p_BF - leg.X_BH.p).norm();
  return leg.min_reach < d && d < leg.max_reach;
}

}  // namespace hexagait::testing
