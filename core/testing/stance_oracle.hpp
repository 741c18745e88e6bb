// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <hexagait/balance/stance_pose.hpp>
#include <vector>

namespace hexagait::testing {

/// A base, by position [m] and angles [rad].
inline Pose pose(double x, double y, double z, double roll, double pitch, double yaw) {
  return {rotation_z(yaw) * rotation({0.0, pitch, 0.0}) * rotation({roll, 0.0, 0.0}), {x, y, z}};
}

/// (stance 1) and its constraints written down again, over x, y, z and roll, pitch, yaw, by
/// numerical derivatives and sequential least squares. For six legs.
struct StanceOracle {
  const RobotModel& model;
  const StanceProblem& problem;
  double margin;

  static Pose pose_of(const double* x) { return pose(x[0], x[1], x[2], x[3], x[4], x[5]); }

  double objective(const double* x) const {
    const Pose X_BO = pose_of(x).inverse();
    double sum = 0.0;
    for (LegId i = 0; i < model.num_legs(); ++i) {
      const Vector3& c = model.legs[i].p_BC;
      if (!problem.reach.contains(i)) continue;
      const Vector3 p_BF = X_BO * problem.p_OF[i];
      sum += std::pow(p_BF.x() - c.x(), 2) + std::pow(p_BF.y() - c.y(), 2) +
             kHeightWeight * std::pow(p_BF.z() + problem.height, 2);
    }
    return sum;
  }

  // Every one must be ≤ 0. As many whatever the pose is.
  std::vector<double> constraints(const double* x) const {
    const Pose X_OB = pose_of(x), X_BO = X_OB.inverse();
    std::vector<double> g;
    add_polygon(g, (X_OB * model.p_BM).head<2>());
    for (LegId i = 0; i < model.num_legs(); ++i)
      if (problem.reach.contains(i)) add_leg(g, model.legs[i], X_BO * problem.p_OF[i]);
    g.push_back(std::cos(kMaxTilt) - X_OB.R(2, 2));
    return g;
  }

  // A pair of feet with no foot on its right is an edge.
  void add_polygon(std::vector<double>& g, const Vector2& p) const {
    const auto foot = [&](LegId i) { return Vector2(problem.p_OF[i].head<2>()); };
    for (LegId a = 0; a < 6; ++a) {
      for (LegId b = 0; b < 6; ++b) {
        if (a == b || !problem.support.contains(a) || !problem.support.contains(b)) continue;
        const Vector2 edge = (foot(b) - foot(a)).normalized();
        bool is_edge = true;
        for (LegId c = 0; c < 6; ++c)
          is_edge = is_edge && (c == a || c == b || !problem.support.contains(c) ||
                                cross(edge, foot(c) - foot(a)) >= 0.0);
        if (is_edge) g.push_back(margin - cross(edge, p - foot(a)));
      }
    }
  }

  // Yaw, and the triangle hip, knee, foot: the hip angle from the elevation and the law of cosines.
  static void add_leg(std::vector<double>& g, const LegModel& leg, const Vector3& p_BF) {
    const Vector3 p = leg.X_BH.inverse() * p_BF;
    const double yaw = std::atan2(p.y(), p.x());
    const double a = std::hypot(p.x(), p.y()) - leg.coxa, d = std::hypot(a, p.z());
    const double cosine =
        (leg.femur * leg.femur + d * d - leg.tibia * leg.tibia) / (2.0 * leg.femur * d);
    const double hip = std::atan2(-p.z(), a) - std::acos(std::clamp(cosine, -1.0, 1.0));
    g.insert(
        g.end(),
        {d - leg.max_reach + kReachClearance * leg.max_reach,
         leg.min_reach + kReachClearance * leg.max_reach - d,
         yaw - leg.limits[0].upper + kJointClearance, leg.limits[0].lower + kJointClearance - yaw,
         hip - leg.limits[1].upper + kJointClearance, leg.limits[1].lower + kJointClearance - hip});
  }

  // The minimum near a start: x, and by how much it violates a constraint at most.
  struct Minimum {
    double objective, violation;
  };
  Minimum minimum(const Pose& start) const {
    const Vector3 rpy = roll_pitch_yaw(start.R);
    double x[6] = {start.p.x(), start.p.y(), start.p.z(), rpy.x(), rpy.y(), rpy.z()};
    const auto m = static_cast<unsigned>(constraints(x).size());
    nlopt_opt slsqp = nlopt_create(NLOPT_LD_SLSQP, 6);
    nlopt_set_min_objective(slsqp, nlopt_objective, const_cast<StanceOracle*>(this));
    const std::vector<double> tolerance(m, 1e-9);
    nlopt_add_inequality_mconstraint(slsqp, m, nlopt_constraints, const_cast<StanceOracle*>(this),
                                     tolerance.data());
    nlopt_set_xtol_abs1(slsqp, 1e-10);
    nlopt_set_maxeval(slsqp, 200);
    double value = 0.0;
    (void)nlopt_optimize(slsqp, x, &value);
    nlopt_destroy(slsqp);
    const std::vector<double> g = constraints(x);
    return {objective(x), *std::max_element(g.begin(), g.end())};
  }

  // By how much a pose violates a constraint at most.
  double violation(const Pose& X) const {
    const Vector3 rpy = roll_pitch_yaw(X.R);
    const double x[6] = {X.p.x(), X.p.y(), X.p.z(), rpy.x(), rpy.y(), rpy.z()};
    const std::vector<double> g = constraints(x);
    return *std::max_element(g.begin(), g.end());
  }

  static double nlopt_objective(unsigned n, const double* x, double* gradient, void* self) {
    const auto& oracle = *static_cast<const StanceOracle*>(self);
    for (unsigned k = 0; gradient && k < n; ++k) {
      std::vector<double> up(x, x + n), down(x, x + n);
      up[k] += 1e-6, down[k] -= 1e-6;
      gradient[k] = (oracle.objective(up.data()) - oracle.objective(down.data())) / 2e-6;
    }
    return oracle.objective(x);
  }

  static void nlopt_constraints(unsigned m, double* result, unsigned n, const double* x,
                                double* gradient, void* self) {
    const auto& oracle = *static_cast<const StanceOracle*>(self);
    std::ranges::copy(oracle.constraints(x), result);
    for (unsigned k = 0; gradient && k < n; ++k) {
      std::vector<double> up(x, x + n), down(x, x + n);
      up[k] += 1e-6, down[k] -= 1e-6;
      const std::vector<double> high = oracle.constraints(up.data());
      const std::vector<double> low = oracle.constraints(down.data());
      for (unsigned i = 0; i < m; ++i) gradient[i * n + k] = (high[i] - low[i]) / 2e-6;
    }
  }
};

}  // namespace hexagait::testing
