// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <algorithm>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/model/detail/turned.hpp>
#include <hexagait/model/serial_leg.hpp>

namespace hexagait {
namespace {

constexpr double kReached = 1e-9;     // distance at which the foot counts as at its target [m]
constexpr double kSettled = 1e-11;    // distance below which no step is needed to approach [m]
constexpr double kAtRest = 1e-8;      // steps smaller than this change nothing [rad]
constexpr double kLargestStep = 0.5;  // [rad]
constexpr double kLeastRoom = 0.25;   // a joint at its limit in the stance moves yet [rad]
constexpr double kSlack = 1e-3;       // foot motion allowed to null-space steps, of max_reach
constexpr double kNoise = 1e-14;      // rounding of J Jᵀ, of max_reach²

/// Calls f(i, â_i, p̂_i) for each joint (leg 2).
/// @returns the displacement of the last link from its pose with all joints at zero
template <class F>
Pose for_each_joint(const LegModel& leg, const LegTrig& trig, F f) {
  Pose X;  // X_1 … X_{i−1}
  for (int i = 0; i < leg.num_joints(); ++i) {
    const Vector3 &a = leg.axis_B0[i], &p = leg.p_BJ0[i];
    f(i, Vector3(X.R * a), Vector3(X * p));
    Matrix3 R;
    for (int k = 0; k < 3; ++k)
      R.col(k) = detail::turned(Vector3::Unit(k), a, trig.c[i], trig.s[i]);
    X = X * rotation_about(p, R);
  }
  return X;
}

struct Foot {
  Vector3 p;
  LegJacobian J = LegJacobian::Zero();
};

Foot foot_of(const LegModel& leg, const LegTrig& trig) {
  Foot foot;
  LegJacobian axes, points;
  const Pose X = for_each_joint(leg, trig, [&](int i, const Vector3& axis, const Vector3& point) {
    axes.col(i) = axis;
    points.col(i) = point;
  });
  foot.p = X * leg.p_BF0;
  for (int i = 0; i < leg.num_joints(); ++i) {
    const Vector3 axis = axes.col(i), arm = foot.p - points.col(i);
    foot.J.col(i) = axis.cross(arm);
  }
  return foot;
}

LegJoints clamped(const LegModel& leg, const LegJoints& q) {
  LegJoints inside = LegJoints::Zero();
  for (int i = 0; i < leg.num_joints(); ++i)
    inside[i] = std::clamp(q[i], leg.limits[i].lower, leg.limits[i].upper);
  return inside;
}

/// The state of a search, copied from step to step.
struct Search {
  LegJoints q;
  LegTrig trig;
  Foot foot;
  Vector3 e;                ///< target − foot [m]
  double damping = 0.1;     ///< μ
  double null_space = 1.0;  ///< γ
};

void evaluate(const LegModel& leg, const Vector3& target, Search& at) {
  at.trig = SerialLeg::leg_trig(leg, at.q);
  at.foot = foot_of(leg, at.trig);
  at.e = target - at.foot.p;
}

/// s of (leg 3): the room of each joint about the nominal stance. 1 for legs of three joints.
LegJoints room_of(const LegModel& leg) {
  LegJoints room = LegJoints::Ones();
  if (leg.num_joints() == 3) return room;
  for (int i = 0; i < leg.num_joints(); ++i) {
    const double below = leg.q_nominal[i] - leg.limits[i].lower;
    const double above = leg.limits[i].upper - leg.q_nominal[i];
    room[i] = std::clamp(std::min(below, above), kLeastRoom, 1.0);
  }
  return room;
}

/// (leg 3) with some joints fixed: `fixed` holds their steps, `free` is 1 for the others.
/// @param room  room_of(leg)
LegJoints damped_step(const LegModel& leg, const LegJoints& room, const Search& at,
                      const LegJoints& fixed, const LegJoints& free) {
  const double noise = kNoise * leg.max_reach * leg.max_reach;
  const double damping = at.damping * at.e.squaredNorm() + noise;
  const LegJacobian J = at.foot.J * free.cwiseProduct(room).asDiagonal();
  const Vector3 e = at.e - at.foot.J * fixed;
  const Matrix3 JJ = J * J.transpose(), I = Matrix3::Identity();
  LegJoints step = J.transpose() * Matrix3(JJ + damping * I).ldlt().solve(e);
  if (leg.num_joints() > 3) {
    const LegJoints rest = (leg.q_nominal - at.q).cwiseQuotient(room);
    const LegJoints r = at.null_space * free.cwiseProduct(rest);
    step += r - J.transpose() * Matrix3(JJ + noise * I).ldlt().solve(J * r);
  }
  return fixed + step.cwiseProduct(room);
}

/// (leg 3), with the joints that reach their limits fixed one after the other, the worst first.
LegJoints step_of(const LegModel& leg, const LegJoints& room, const Search& at) {
  LegJoints fixed = LegJoints::Zero(), free = LegJoints::Ones(), step = LegJoints::Zero();
  for (int round = 0; round <= leg.num_joints(); ++round) {
    step = damped_step(leg, room, at, fixed, free);
    int worst = -1;
    double most = 0.0, limit = 0.0;
    for (int i = 0; i < leg.num_joints(); ++i) {
      const double wanted = at.q[i] + step[i];
      const double inside = std::clamp(wanted, leg.limits[i].lower, leg.limits[i].upper);
      if (free[i] == 0.0 || std::abs(wanted - inside) <= most) continue;
      worst = i, most = std::abs(wanted - inside), limit = inside;
    }
    if (worst < 0) break;
    fixed[worst] = limit - at.q[worst];
    free[worst] = 0.0;
  }
  const double largest = step.cwiseAbs().maxCoeff();
  return largest > kLargestStep ? LegJoints(step * (kLargestStep / largest)) : step;
}

/// The end of a search from `from`.
/// @param null_space  false: γ = 0 from the start; true: only in the second half of the iterations
Search search(const LegModel& leg, const Vector3& target, const LegJoints& from, bool null_space) {
  const LegJoints room = room_of(leg);
  Search best;
  best.q = clamped(leg, from);
  evaluate(leg, target, best);
  double slack = leg.num_joints() > 3 ? kSlack * leg.max_reach : 0.0;
  for (int k = 0; k < SerialLeg::kMaxIterations; ++k) {
    if (!null_space || k > SerialLeg::kMaxIterations / 2) best.null_space = slack = 0.0;
    const LegJoints step = step_of(leg, room, best);
    const double size = step.cwiseAbs().maxCoeff();
    if (size < kAtRest && (best.e.norm() < kSettled || size == 0.0)) break;

    Search next = best;
    next.q = clamped(leg, best.q + step);
    evaluate(leg, target, next);
    if (next.e.norm() < std::max(best.e.norm(), slack) || next.e.norm() < kSettled) {
      next.damping = std::max(0.2 * best.damping, 1e-3);
      next.null_space = std::min(2.0 * best.null_space, 1.0);
      best = next;
    } else if (size < kAtRest) {
      break;
    } else {
      best.damping *= 10.0;
      best.null_space *= 0.25;
    }
  }
  return best;
}

/// The target, moved towards or away from the hip into [min_reach, max_reach].
Vector3 within_reach(const LegModel& leg, const Vector3& p_BF) {
  const Vector3 v = (p_BF - leg.X_BH.p).cwiseMax(-kFarAway).cwiseMin(kFarAway);
  const double asked = v.norm(), d = std::clamp(asked, leg.min_reach, leg.max_reach);
  if (d == asked) return p_BF;
  const Vector3 way = asked > 0.0 ? Vector3(v / asked) : Vector3(-leg.X_BH.R.col(2));
  return leg.X_BH.p + d * way;
}

}  // namespace

LegTrig SerialLeg::leg_trig(const LegModel& leg, const LegJoints& q) noexcept {
  LegTrig trig;
  for (int i = 0; i < leg.num_joints(); ++i) {
    const auto [s, c] = portable::sincos(q[i]);
    trig.c[i] = c;
    trig.s[i] = s;
  }
  return trig;
}

Vector3 SerialLeg::foot_position(const LegModel& leg, const LegTrig& trig) noexcept {
  Vector3 p = leg.p_BF0;
  for (int i = leg.num_joints() - 1; i >= 0; --i)
    p = leg.p_BJ0[i] + detail::turned(p - leg.p_BJ0[i], leg.axis_B0[i], trig.c[i], trig.s[i]);
  return p;
}

LegJacobian SerialLeg::foot_jacobian(const LegModel& leg, const LegTrig& trig) noexcept {
  return foot_of(leg, trig).J;
}

LegJoints SerialLeg::foot_effort(const LegModel& leg, const LegTrig& trig,
                                 const Vector3& force_B) noexcept {
  return foot_of(leg, trig).J.transpose() * force_B;
}

Matrix3 SerialLeg::tibia_rotation(const LegModel& leg, const LegTrig& trig) noexcept {
  return for_each_joint(leg, trig, [](int, const Vector3&, const Vector3&) {}).R;
}

Vector3 SerialLeg::tibia_turn(const LegModel& leg, const LegTrig& trig,
                              const LegJoints& dq) noexcept {
  Vector3 sum = Vector3::Zero();
  for_each_joint(leg, trig, [&](int i, const Vector3& axis, const Vector3&) {
    const Vector3 turn = axis * dq[i];
    sum += turn + 0.5 * sum.cross(turn);
  });
  return sum;
}

LegSolution SerialLeg::inverse_kinematics(const LegModel& leg, const Vector3& p_BF,
                                          const LegJoints& near) noexcept {
  assert(0.0 < leg.min_reach && leg.min_reach <= leg.max_reach);
  const Vector3 target = within_reach(leg, p_BF);
  Search found = search(leg, target, near, true);
  if (found.e.norm() > kReached && leg.num_joints() > 3) {
    const Search again = search(leg, target, near, false);
    if (again.e.norm() < found.e.norm()) found = again;
  }
  if (found.e.norm() > kReached && near != leg.q_nominal) {
    const Search again = search(leg, target, leg.q_nominal, false);
    if (again.e.norm() < std::min(found.e.norm(), kReached)) found = again;
  }
  return {found.q, found.trig, (p_BF - found.foot.p).norm() < kReached};
}

}  // namespace hexagait
