// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/balance/detail/stable_region.hpp>
#include <hexagait/balance/stance_pose.hpp>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/math/quadratic_program.hpp>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/model/kinematics.hpp>

namespace hexagait {
namespace {

using Vector6 = PoseProgram::Vector;

constexpr int kMaxIterations = 16;   // per descent
constexpr int kMaxDescents = 4;      // each without one more leg
constexpr double kConverged = 1e-6;  // size of the last step [m], [rad]
constexpr double kMaxTurn = 0.5;     // rotation in one step [rad]
constexpr double kDamping = 1e-7;    // of H: keeps what the feet do not determine
constexpr double kNearAngle = 0.15;  // limits of joints farther away are left out [rad]
constexpr double kNearReach = 0.25;  // ends of the reach farther away are left out, of the reach

/// The pose of the base, by its centre of mass M. Origin: the base before the search; axes of odom.
struct Iterate {
  Vector3 c;  ///< position of M [m]
  Matrix3 R;  ///< R_OB
};

template <class F>
void for_each(LegSet legs, F f) {
  for (LegId i = 0; i < kMaxLegs; ++i)
    if (legs.contains(i)) f(i);
}

struct Stance {
  const RobotModel& model;
  LegSet reach;
  LegArray<Vector3> p_F;   ///< feet; origin and axes as in Iterate [m]
  LegArray<Vector3> p_MN;  ///< nominal feet relative to M, axes of the base [m]
  StableRegion region;

  /// Foot relative to M, axes of the base [m].
  Vector3 foot(const Iterate& at, LegId leg) const { return at.R.transpose() * (p_F[leg] - at.c); }
};

Stance stance_of(const RobotModel& model, const StanceProblem& problem) {
  const int n = model.num_legs();
  Stance stance{
      model, problem.reach & LegSet::all(n), LegArray<Vector3>(n), LegArray<Vector3>(n), {}};
  for (LegId i = 0; i < n; ++i) {
    const Vector3& p_BC = model.legs[i].p_BC;
    stance.p_F[i] = (problem.p_OF[i] - problem.X_OB.p).cwiseMax(-kFarAway).cwiseMin(kFarAway);
    stance.p_MN[i] = Vector3(p_BC.x(), p_BC.y(), -problem.height) - model.p_BM;
  }
  const LegSet support = problem.support & LegSet::all(n);
  stance.region = stable_region(support_polygon(stance.p_F, support), problem.margin);
  return stance;
}

double yaw_of(const Matrix3& R) { return portable::atan2(R(1, 0), R(0, 0)); }

// Limits the tilt to kMaxTilt.
Matrix3 upright(const Matrix3& R) {
  const Vector3 z = R.col(2);
  if (z.z() >= portable::cos(kMaxTilt)) return R;
  const double s = portable::hypot(z.x(), z.y()), tilt = portable::atan2(s, z.z());
  const Vector3 axis = s > 0.0 ? Vector3(z.y() / s, -z.x() / s, 0.0) : Vector3::UnitX();
  return orthonormalised(rotation(axis * (tilt - kMaxTilt)) * R);
}

// The best level pose, in closed form: it aligns the centroids and the mean direction of the feet.
Iterate level_guess(const Stance& stance, const Pose& X_OB, LegSet given_up) {
  const LegSet legs = without(stance.reach, given_up);
  if (legs.empty()) return {X_OB.R * stance.model.p_BM, upright(X_OB.R)};
  Vector3 mean_F = Vector3::Zero(), mean_N = Vector3::Zero();
  const double share = 1.0 / legs.size();
  for_each(legs, [&](LegId i) {
    mean_F += share * stance.p_F[i];
    mean_N += share * stance.p_MN[i];
  });
  double along = 0.0, across = 0.0, size = 0.0;
  for_each(legs, [&](LegId i) {
    const Vector2 f = (stance.p_F[i] - mean_F).head<2>(), n = (stance.p_MN[i] - mean_N).head<2>();
    along += n.dot(f);
    across += cross(n, f);
    size += n.squaredNorm() + f.squaredNorm();
  });
  const bool open = std::abs(along) + std::abs(across) <= 1e-9 * size;
  const Matrix3 R = rotation_z(open ? yaw_of(X_OB.R) : portable::atan2(across, along));
  return {mean_F - R * mean_N, R};
}

// W e
Vector3 weighted(const Vector3& e) { return {e.x(), e.y(), kHeightWeight * e.z()}; }

double objective(const Stance& stance, const Iterate& at) {
  double sum = 0.0;
  for_each(stance.reach, [&](LegId i) {
    const Vector3 e = stance.foot(at, i) - stance.p_MN[i];
    sum += e.dot(weighted(e));
  });
  return sum;
}

// (stance 1) to second order in a displacement d of M and a rotation θ (axes of the base). f are
// the feet relative to M, e = f − n, g = W e:
//
//     f' = exp(−θ) (f − d) ≈ f − d + f×θ + θ×d + ½ θ×(θ×f)
//     ½ Σ (f' − n)ᵀ W (f' − n) ≈ … − d·Σ g + θ·Σ g×f + ½ Σ (d − f×θ)ᵀ W (d − f×θ)
//                                + Σ d·(g×θ) + ½ Σ θᵀ (½ (g fᵀ + f gᵀ) − g·f) θ
//
// Without the last line it is the Gauss-Newton approximation, which is never concave.
void set_objective(PoseProgram& program, const Stance& stance, const Iterate& at, bool exact) {
  program.g.setZero();
  program.H.setZero();
  const Vector3 w = weighted(Vector3::Ones());
  for_each(stance.reach, [&](LegId i) {
    const Vector3 f = stance.foot(at, i), g = weighted(f - stance.p_MN[i]);
    const Matrix3 F = cross_matrix(f), WF = w.asDiagonal() * F;
    program.g.head<3>() -= g;
    program.g.tail<3>() += g.cross(f);
    program.H.topLeftCorner<3, 3>().diagonal() += w;
    program.H.bottomLeftCorner<3, 3>() += WF.transpose() * -1.0;
    program.H.bottomRightCorner<3, 3>() += F.transpose() * WF;
    if (!exact) return;
    const Matrix3 gf = g * f.transpose();
    program.H.bottomLeftCorner<3, 3>() -= cross_matrix(g);
    program.H.bottomRightCorner<3, 3>() += 0.5 * (gf + gf.transpose());
    program.H.bottomRightCorner<3, 3>().diagonal().array() -= gf.trace();
  });
  const double scale = kDamping * (1.0 + program.H.diagonal().maxCoeff());
  program.H.diagonal().array() += scale;
}

/// The constraints of the program, and the leg whose limit each one is; −1 for the base.
struct Rows {
  PoseProgram& program;
  std::array<LegId, 88> owner{};

  void add(const Vector6& normal, double bound, LegId leg) {
    owner[static_cast<std::size_t>(program.size)] = leg;
    program.add(normal, bound);
  }
  LegSet owners(const QpSolution<6, 6>& contradiction) const {
    LegSet legs;
    for (int k = 0; k < contradiction.num_active; ++k) {
      const int row = contradiction.active[static_cast<std::size_t>(k)];
      const LegId leg = owner[static_cast<std::size_t>(row)];
      if (leg >= 0) legs.insert(leg);
    }
    return legs;
  }
  // Adds gradientᵀ f' ≤ gradientᵀ f + slack for the foot f, unless the limit is not near.
  void add_limit(const Vector3& gradient_B, const Vector3& f, double slack, double near,
                 LegId leg) {
    if (slack > near) return;
    add((Vector6() << -gradient_B, gradient_B.cross(f)).finished(), slack, leg);
  }
};

// (stance 2) and the limit of the tilt.
void add_stability(Rows& rows, const Stance& stance, const Iterate& at) {
  for (int j = 0; j < stance.region.size; ++j) {
    const HalfPlane& edge = stance.region.edges[static_cast<std::size_t>(j)];
    const Vector3 normal_B =
        at.R.row(0).transpose() * edge.normal.x() + at.R.row(1).transpose() * edge.normal.y();
    rows.add((Vector6() << normal_B, Vector3::Zero()).finished(),
             edge.bound - edge.normal.dot(at.c.head<2>()), -1);
  }
  const Vector3 up_B = at.R.row(2);
  const double s = std::sqrt(up_B.x() * up_B.x() + up_B.y() * up_B.y()),
               slack = portable::sin(kMaxTilt) - s;
  if (slack > 0.3 || s == 0.0) return;
  const Vector3 lean_B(up_B.x() / s, up_B.y() / s, 0.0);
  rows.add((Vector6() << Vector3::Zero(), lean_B.cross(up_B)).finished(), slack, -1);
}

/// Legs that were found far from all limits, with the distance that their feet may move before they
/// are checked again. Saves inverse kinematics, which is most of the work.
struct Clear {
  std::array<Vector3, kMaxLegs> f;
  std::array<double, kMaxLegs> radius{};  ///< [m]

  bool still(LegId leg, const Vector3& now) const {
    const auto i = static_cast<std::size_t>(leg);
    return radius[i] > 0.0 && (now - f[i]).squaredNorm() < radius[i] * radius[i];
  }
  void note(LegId leg, const Vector3& now, double new_radius) {
    f[static_cast<std::size_t>(leg)] = now;
    radius[static_cast<std::size_t>(leg)] = new_radius;
  }

  /// The end of a serial leg's reach: the foot got to `reached`; `normal` points outwards.
  struct End {
    Vector3 normal = Vector3::Zero(), reached = Vector3::Zero();
  };
  std::array<End, kMaxLegs> ends;
};

double near_reach(const LegModel& leg) { return kNearReach * leg.max_reach; }
double reach_clearance(const LegModel& leg) { return kReachClearance * leg.max_reach; }

// How far a foot whose leg has no limit near may move before it is looked at again [m]: half the way to
// the nearest that there can be, as its gradients hold only here.
// @param rate  by which the joints turn per metre [rad/m]
double clear_radius(const LegModel& leg, double rate) {
  return 0.5 * std::min(near_reach(leg), kNearAngle / rate);
}

// The two ends of a leg's reach, for its foot f at a distance along a unit vector.
void add_reach(Rows& rows, const LegModel& leg, LegId i, const Vector3& f, double distance,
               const Vector3& direction_B) {
  const double near = near_reach(leg), clearance = reach_clearance(leg);
  rows.add_limit(direction_B, f, leg.max_reach - clearance - distance, near, i);
  rows.add_limit(-direction_B, f, distance - leg.min_reach - clearance, near, i);
}

// The limits of a serial leg: its reach and, where inverse kinematics failed to reach the foot, the
// plane across the missing distance. Whatever ends the reach, joint limits or a straight leg, the
// minimum is found from one plane to the next.
void add_serial_leg(Rows& rows, const Stance& stance, const Iterate& at, LegId i, Clear& clear) {
  const LegModel& leg = stance.model.legs[i];
  const Vector3 f = stance.foot(at, i), p_BF = f + stance.model.p_BM;
  const LegSolution solution = inverse_kinematics(leg, p_BF);
  const int rows_before = rows.program.size;

  const double d = (p_BF - leg.X_BH.p).norm();
  if (d > 0.0) add_reach(rows, leg, i, f, d, (p_BF - leg.X_BH.p) / d);
  Clear::End& end = clear.ends[static_cast<std::size_t>(i)];
  const Vector3 reached = foot_position(leg, solution.trig) - stance.model.p_BM;
  if (!solution.reachable) end = {(f - reached).normalized(), reached};
  if (!end.normal.isZero())
    rows.add_limit(end.normal, f, end.normal.dot(end.reached - f) - reach_clearance(leg),
                   near_reach(leg), i);

  // How far the joints may turn, and how fast they do as the foot moves.
  double slack = kNearAngle;
  for (int k = 0; k < leg.num_joints(); ++k)
    slack =
        std::min({slack, solution.q[k] - leg.limits[k].lower, leg.limits[k].upper - solution.q[k]});
  const LegJacobian J = foot_jacobian(leg, solution.trig);
  const Matrix3 JJ = J * J.transpose() + 1e-12 * Matrix3::Identity();
  const double rate = std::sqrt(JJ.inverse().trace());
  const bool is_clear =
      solution.reachable && slack >= kNearAngle && rows.program.size == rows_before;
  clear.note(i, f, is_clear ? clear_radius(leg, rate) : 0.0);
}

// Both limits of a joint of a yaw-pitch-pitch leg, linearised.
// @param turn_H  gradient of the canonical angle with respect to the foot, hip frame [rad/m]
// @param excess  canonical angle still missing where inverse kinematics did not reach the foot
//                [rad]
void add_joint(Rows& rows, const LegModel& leg, LegId i, const Vector3& f, int joint, double q,
               const Vector3& turn_H, double excess) {
  const JointLimits& limits = leg.limits[joint];
  if (limits.upper - limits.lower >= 2.0 * std::numbers::pi - 1e-9) return;
  const double sign = leg.joint_sign[joint], wanted = q + sign * excess;
  const Vector3 turn_B = sign * (leg.X_BH.R * turn_H);
  rows.add_limit(turn_B, f, limits.upper - kJointClearance - wanted, kNearAngle, i);
  rows.add_limit(-turn_B, f, wanted - limits.lower - kJointClearance, kNearAngle, i);
}

// The limits of a yaw-pitch-pitch leg: its reach, and yaw and hip, whose gradients are rows of the
// inverse of foot_jacobian().
void add_yaw_pitch_pitch_leg(Rows& rows, const Stance& stance, const Iterate& at, LegId i,
                             Clear& clear) {
  const LegModel& leg = stance.model.legs[i];
  const Vector3 f = stance.foot(at, i);
  const int rows_before = rows.program.size;
  const LegSolution solution = inverse_kinematics(leg, f + stance.model.p_BM);
  const LegTrig& t = solution.trig;
  const Vector3 p_H = leg.X_BH.R.transpose() * (f + stance.model.p_BM - leg.X_BH.p);

  // The foot in the leg's plane: r from the yaw axis, a from the hip-pitch axis.
  const Vector3 out_H(t.c[0], t.s[0], 0.0), left_H(-t.s[0], t.c[0], 0.0);
  const double r = out_H.dot(p_H), a = r - leg.coxa;
  const double d = std::sqrt(a * a + p_H.z() * p_H.z());
  if (d > 0.0)
    add_reach(rows, leg, i, f, d,
              leg.X_BH.R * ((a / d) * out_H + (p_H.z() / d) * Vector3::UnitZ()));

  if (std::abs(r) > reach_clearance(leg))
    add_joint(rows, leg, i, f, 0, solution.q[0], left_H / r, left_H.dot(p_H) / r);

  const double shin_r = leg.tibia * t.c[2], shin_h = -leg.tibia * t.s[2];
  const double reached_a = leg.femur * t.c[1] + shin_r, reached_h = -leg.femur * t.s[1] + shin_h;
  const double det = shin_h * reached_a - reached_h * shin_r;
  if (std::abs(det) < 1e-9) return;
  const Vector3 turn_H = (-shin_r / det) * out_H + (-shin_h / det) * Vector3::UnitZ();
  add_joint(rows, leg, i, f, 1, solution.q[1], turn_H,
            (-shin_r * (a - reached_a) - shin_h * (p_H.z() - reached_h)) / det);

  const double rate = std::max(1.0 / std::abs(r), leg.tibia / std::abs(det));
  const bool is_clear = solution.reachable && rows.program.size == rows_before;
  clear.note(i, f, is_clear ? clear_radius(leg, rate) : 0.0);
}

void add_leg(Rows& rows, const Stance& stance, const Iterate& at, LegId i, Clear& clear) {
  if (clear.still(i, stance.foot(at, i))) return;
  const bool serial = stance.model.legs[i].kind == LegKind::serial;
  (serial ? add_serial_leg : add_yaw_pitch_pitch_leg)(rows, stance, at, i, clear);
}

// The leg whose foot is farthest from its nominal position; −1 if there are no legs.
LegId farthest(LegSet legs, const Stance& stance, const Iterate& at) {
  LegId found = -1;
  double most = -1.0;
  for_each(legs, [&](LegId i) {
    const double distance = (stance.foot(at, i) - stance.p_MN[i]).squaredNorm();
    if (distance > most) most = distance, found = i;
  });
  return found;
}

// The step to the minimum of the quadratic model, subject to the limits of `legs`. As long as these
// are infeasible, the limits of one leg after the other are left out of this step.
Vector6 newton_step(const Stance& stance, const Iterate& at, LegSet legs, Clear& clear) {
  PoseProgram program;
  Rows rows{program};
  set_objective(program, stance, at, true);
  add_stability(rows, stance, at);
  const int stability = program.size;
  for (int trial = 0; trial <= kMaxLegs; ++trial) {
    program.size = stability;
    for_each(legs, [&](LegId i) { add_leg(rows, stance, at, i, clear); });
    QpSolution<6, 6> solution = solve(program);
    if (solution.status == QpStatus::not_convex) {
      set_objective(program, stance, at, false);
      solution = solve(program);
    }
    if (solution.status == QpStatus::solved) return solution.x;
    const LegId leg = farthest(rows.owners(solution), stance, at);
    if (leg < 0) break;
    legs.erase(leg);
  }
  return Vector6::Zero();
}

// M takes the whole step, so that (stance 2) holds; the rotation is limited.
Iterate stepped(const Iterate& at, const Vector6& step) {
  const Vector3 turn = step.tail<3>();
  const double scale = std::min(1.0, kMaxTurn / std::max(turn.norm(), kMaxTurn));
  return {at.c + at.R * step.head<3>(), upright(orthonormalised(at.R * rotation(scale * turn)))};
}

// Newton's method from a start to the minimum; adds to `iterations`.
Iterate descend(const Stance& stance, Iterate at, LegSet legs, Clear& clear, int& iterations) {
  for (int k = 0; k < kMaxIterations; ++k) {
    const Vector6 step = newton_step(stance, at, legs, clear);
    at = stepped(at, step);
    ++iterations;
    if (step.cwiseAbs().maxCoeff() < kConverged) break;
  }
  return at;
}

LegSet out_of_reach(const Stance& stance, const Iterate& at, const Clear& clear) {
  LegSet out;
  for_each(stance.reach, [&](LegId i) {
    const Vector3 f = stance.foot(at, i);
    const LegModel& leg = stance.model.legs[i];
    out.set(i, !clear.still(i, f) && !inverse_kinematics(leg, f + stance.model.p_BM).reachable);
  });
  return out;
}

}  // namespace

StancePose optimise_stance(const RobotModel& model, const StanceProblem& problem) noexcept {
  const Stance stance = stance_of(model, problem);
  StancePose out;
  LegSet given_up;
  Clear clear;
  Iterate at;

  // With all legs; then, while some cannot reach their feet, without the farthest of these.
  for (int descent = 0; descent < kMaxDescents; ++descent) {
    at = descend(stance, level_guess(stance, problem.X_OB, given_up),
                 without(stance.reach, given_up), clear, out.iterations);
    out.out_of_reach = out_of_reach(stance, at, clear);
    const LegId leg = farthest(without(out.out_of_reach, given_up), stance, at);
    if (leg < 0) break;
    given_up.insert(leg);
  }

  out.X_OB = {at.R, problem.X_OB.p + at.c - at.R * model.p_BM};
  out.margin = stability_margin(stance.region.polygon, at.c.head<2>());
  out.margin_shrunk = stance.region.shrunk;
  out.objective = objective(stance, at);
  return out;
}

}  // namespace hexagait
