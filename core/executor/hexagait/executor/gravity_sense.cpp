// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <hexagait/executor/gravity_sense.hpp>
#include <hexagait/model/kinematics.hpp>

namespace hexagait {
namespace {

constexpr double kForgets = 10.0;  // λ and σ², in times of τ
constexpr double kKnown = 1.25;  // λ is known once r has varied for so long as much as it is, of τ
constexpr double kNoise = 0.3;   // σ₀ [rad]
constexpr double kAmiss = 0.15;    // ρ₀
constexpr double kMost = 0.6;      // more in one tick is an impact [rad]
constexpr double kTrusted = 0.08;  // odometry is, within this [rad]
constexpr int kSteady = 3;         // feet

// J⁻ᵀ e and J⁻ᵀ q̇* of (odometry 6).
struct Forces {
  Vector3 of_deflection, of_speed;
};

Forces forces(const LegModel& leg, const LegTrig& trig, const LegJoints& deflection,
              const LegJoints& speed) {
  const LegJacobian J = foot_jacobian(leg, trig);
  if (leg.num_joints() == 3) {
    const Vector3 a = J.col(0), b = J.col(1), c = J.col(2);
    const Vector3 bc = b.cross(c), ca = c.cross(a), ab = a.cross(b);
    const double scale = 1.0 / a.dot(bc);
    const auto solved = [&](const LegJoints& v) {
      return Vector3(scale * (v[0] * bc + v[1] * ca + v[2] * ab));
    };
    return {solved(deflection), solved(speed)};
  }
  // Redundant joints: the force that explains the efforts best.
  const Matrix3 inverse = (J * J.transpose()).inverse();
  return {inverse * (J * deflection), inverse * (J * speed)};
}

}  // namespace

double GravitySense::lag() const noexcept { return rr_ > 0.0 ? std::max(0.0, rs_ / rr_) : 0.0; }

Vector3 GravitySense::update(const RobotModel& model, const RobotState& state,
                             const JointTargets& targets, LegSet lost, int stand, double dt,
                             const ToleranceParams& tolerance) noexcept {
  // What was learnt with a leg that did not answer is wrong.
  if (lost != lost_) {
    *this = {};
    lost_ = lost;
  }
  if (stand < kSteady || !(tolerance.servo_stiffness > 0.0)) return Vector3::Zero();
  Vector3 s = Vector3::Zero(), r = Vector3::Zero();
  for (LegId i = 0; i < model.num_legs(); ++i) {
    if (lost.contains(i)) continue;  // it carries nothing, however far it is off its targets
    const Forces of =
        forces(model.legs[i], state.trig[i], targets.q[i] - state.q[i], targets.qd[i]);
    s -= tolerance.servo_stiffness * of.of_deflection;
    r -= tolerance.servo_stiffness * of.of_speed;
  }
  if (!s.allFinite() || !r.allFinite()) return Vector3::Zero();  // a leg is stretched

  const double tau = tolerance.gravity_time;
  const double fast = dt / (dt + tau), slow = dt / (dt + kForgets * tau);
  mean_s_ += fast * (s - mean_s_);
  mean_r_ += fast * (r - mean_r_);
  speed2_ += fast * (r.squaredNorm() - speed2_);
  const Vector3 vary = r - mean_r_;
  rs_ += slow * (vary.dot(s - mean_s_) - rs_);
  rr_ += slow * (vary.squaredNorm() - rr_);
  if (kKnown * speed2_ > kForgets * rr_) return Vector3::Zero();

  const Vector3 up_B = state.X_OB.R.row(2);
  Vector3 off = s - lag() * r;
  const double amiss = (up_B + off).norm() - 1.0;
  off -= off.dot(up_B) * up_B;
  if (const double size = off.norm(); size > kMost) off *= kMost / size;
  mean_ += fast * (off - mean_);
  noise2_ += slow * ((off - mean_).squaredNorm() - noise2_);
  amiss2_ += slow * (amiss * amiss - amiss2_);
  const double mean = mean_.norm();
  if (mean <= kTrusted) return Vector3::Zero();
  const double doubt = noise2_ / (kNoise * kNoise) + amiss2_ / (kAmiss * kAmiss);
  return fast * (1.0 - kTrusted / mean) / (1.0 + doubt * doubt) * off;
}

}  // namespace hexagait
