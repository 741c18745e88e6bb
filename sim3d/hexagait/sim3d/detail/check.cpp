// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <hexagait/sim3d/detail/check.hpp>
#include <hexagait/sim3d/detail/robot.hpp>
#include <hexagait/text/violations.hpp>

namespace hexagait::sim3d::detail {
namespace {

constexpr double kFarthestStart = 1e5;  // [m]
constexpr double kSlack = 1e-9;         // of rounding [rad], and of a ratio of periods

void check_number(Violations& violations, const char* name, double value, bool right,
                  const char* bound) {
  if (right && std::isfinite(value)) return;
  violations.add(name, in_words(value) + " must be finite and " + bound);
}

void check_params(Violations& violations, const WorldParams& p) {
  const auto positive = [&](const char* name, double value) {
    check_number(violations, name, value, value > 0.0, "positive");
  };
  const auto not_negative = [&](const char* name, double value) {
    check_number(violations, name, value, value >= 0.0, "not negative");
  };
  const auto fraction = [&](const char* name, double value) {
    check_number(violations, name, value, 0.0 < value && value <= 1.0, "in (0, 1]");
  };
  positive("physics_dt [s]", p.physics_dt);
  positive("control_dt [s]", p.control_dt);
  const double steps = p.control_dt / p.physics_dt;
  if (steps < 1.0 - kSlack || std::abs(steps - std::round(steps)) > kSlack * steps) {
    violations.add("control_dt [s]", in_words(p.control_dt) +
                                         " must be a whole multiple of physics_dt " +
                                         in_words(p.physics_dt));
  }
  not_negative("gravity [m/s²]", p.gravity);
  not_negative("servo_kp [N m/rad]", p.servo_kp);
  positive("servo_kd [N m s/rad]", p.servo_kd);
  positive("servo_kv [N m s/rad]", p.servo_kv);
  positive("servo_friction [N m s/rad]", p.servo_friction);
  check_ranges(violations, imperfections(), p);
  fraction("contact_erp", p.contact_erp);
  not_negative("contact_cfm [m/(N s)]", p.contact_cfm);
  positive("contact_correcting_speed [m/s]", p.contact_correcting_speed);
  fraction("hinge_erp", p.hinge_erp);
  not_negative("hinge_cfm", p.hinge_cfm);
  not_negative("start_clearance [m]", p.start_clearance);
  if (!(p.start_height < kFarthestStart))
    violations.add("start_height [m]", in_words(p.start_height) + " must be less than 100 km");
  for (const Block& block : p.blocks) {
    if (block.centre.allFinite() && block.size.allFinite() && block.size.minCoeff() > 0.0) continue;
    violations.add("blocks [m]", "must be finite, with edges that are positive");
  }
  if (!(p.start.shift.norm() < kFarthestStart) || !std::isfinite(p.start.angle)) {
    violations.add("start", "must be finite and within 100 km of the origin");
  }
}

void check_link(Violations& violations, const LinkModel& link) {
  if (!(link.mass > 0.0)) {
    violations.add(link.name, "mass " + in_words(link.mass) + " kg must be positive");
  }
  if (Eigen::LLT<Matrix3>(link.inertia_M_L).info() != Eigen::Success) {
    violations.add(link.name, "the inertia must be positive definite");
  }
}

void check_leg(Violations& violations, const LegModel& leg, const WorldParams& params,
               const LegJoints& q) {
  for (const LinkModel& link : leg.links) check_link(violations, link);
  const auto is_its_foot = [&leg](const Shape& shape) { return is_foot(shape, leg); };
  if (std::ranges::none_of(leg.links.back().shapes, is_its_foot)) {
    violations.add(leg.name, "needs a sphere at the foot's centre, on the last link");
  }

  for (int k = 0; k < leg.num_joints(); ++k) {
    const JointLimits& limits = leg.limits[k];
    const double value = q[k];
    if (!(limits.effort > 0.0)) {
      violations.add(leg.joint_names[k],
                     "effort limit " + in_words(limits.effort) + " N m must be positive");
    }
    if (params.velocity_limits && !(limits.velocity > 0.0)) {
      violations.add(leg.joint_names[k],
                     "velocity limit " + in_words(limits.velocity) + " rad/s must be positive");
    }
    if (!(limits.lower - kSlack <= value && value <= limits.upper + kSlack)) {
      violations.add(leg.joint_names[k], "initial position " + in_words(value) +
                                             " rad must be in [" + in_words(limits.lower) + ", " +
                                             in_words(limits.upper) + "]");
    }
  }
}

}  // namespace

void check(const RobotModel& robot, const WorldParams& params, const LegArray<LegJoints>& q) {
  Violations violations("world of " + robot.name);
  check_params(violations, params);
  check_link(violations, robot.base);
  if (q.size() != robot.num_legs()) {
    violations.add("initial joint positions",
                   std::to_string(q.size()) + " legs must be " + std::to_string(robot.num_legs()));
  }
  for (LegId leg = 0; leg < std::min(q.size(), robot.num_legs()); ++leg) {
    check_leg(violations, robot.legs[leg], params, q[leg]);
  }
  violations.throw_if_any();
}

}  // namespace hexagait::sim3d::detail
