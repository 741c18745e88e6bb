// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <hexagait/executor/gravity_sense.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/leg_weight.hpp>

namespace hexagait {
namespace {

constexpr double kForgets = 10.0;  // λ and σ², in times of τ
constexpr double kKnown = 1.25;  // λ is known once r has varied for so long as much as it is, of τ
constexpr double kNoise = 0.3;   // σ₀ [rad]
constexpr double kAmiss = 0.15;         // ρ₀
constexpr double kMost = 0.6;           // more in one tick is an impact [rad]
constexpr double kTrusted = 0.04;       // odometry is, within this [rad]
constexpr double kTrustedLost = 0.015;  // the same once a leg is lost: the robot may have tipped
constexpr double kLate = 1.4;           // times what motion changes within the lag
constexpr int kSteady = 3;              // feet

// Efforts as a force on the foot, J⁻ᵀ τ.
class FootForce {
 public:
  FootForce(const LegModel& leg, const LegTrig& trig) : J_(foot_jacobian(leg, trig)) {
    if (leg.num_joints() == 3) {
      const Vector3 a = J_.col(0), b = J_.col(1), c = J_.col(2);
      const Vector3 bc = b.cross(c);
      inverse_ << bc, c.cross(a), a.cross(b);
      inverse_ *= 1.0 / a.dot(bc);
    } else {  // redundant joints: the force that explains the efforts best
      inverse_ = (J_ * J_.transpose()).inverse();
      redundant_ = true;
    }
  }

  Vector3 of(const LegJoints& effort) const {
    return redundant_ ? Vector3(inverse_ * (J_ * effort)) : Vector3(inverse_ * effort.head<3>());
  }

 private:
  LegJacobian J_;
  Matrix3 inverse_;
  bool redundant_ = false;
};

}  // namespace

double GravitySense::lag() const noexcept { return rr_ > 0.0 ? std::max(0.0, rs_ / rr_) : 0.0; }

Vector3 GravitySense::update(const RobotModel& model, const RobotState& state,
                             const JointTargets& targets, LegSet lost, int stand, double dt,
                             const ToleranceParams& tolerance) noexcept {
  const int n = model.num_legs();
  // What was learnt with a leg that did not answer is wrong.
  if (lost != lost_ || own_.size() != n) {
    *this = {};
    lost_ = lost;
    own_ = LegArray<Vector3>(n, Vector3::Zero());
  }
  if (stand < kSteady || !(tolerance.servo_stiffness > 0.0)) return Vector3::Zero();
  const Vector3 up_B = state.X_OB.R.row(2);
  // The weight of one leg a tick: it is felt as a mean over much longer than a round takes.
  next_ = (next_ + 1) % n;
  Vector3 s = Vector3::Zero(), r = Vector3::Zero();
  for (LegId i = 0; i < n; ++i) {
    if (lost.contains(i)) continue;  // it carries nothing, however far it is off its targets
    const LegModel& leg = model.legs[i];
    const FootForce force(leg, state.trig[i]);
    s -= tolerance.servo_stiffness * force.of(targets.q[i] - state.q[i]);
    r -= tolerance.servo_stiffness * force.of(targets.qd[i]);
    if (i == next_) own_[i] = force.of(leg_weight(leg, state.q[i], up_B).effort) / model.mass;
    s += own_[i];
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

  Vector3 off = s - lag() * r;
  const double amiss = (up_B + off).norm() - 1.0;
  off -= off.dot(up_B) * up_B;
  if (const double size = off.norm(); size > kMost) off *= kMost / size;
  mean_ += fast * (off - mean_);
  noise2_ += slow * ((off - mean_).squaredNorm() - noise2_);
  amiss2_ += slow * (amiss * amiss - amiss2_);
  const double mean = mean_.norm();
  const double late = kLate * lag() * lag() / tau;
  const double least = lost.empty() ? kTrusted : kTrustedLost;
  const double trusted = std::sqrt(least * least + late * late * rr_);
  if (mean <= trusted) return Vector3::Zero();
  const double doubt = noise2_ / (kNoise * kNoise) + amiss2_ / (kAmiss * kAmiss);
  return fast * (1.0 - trusted / mean) / (1.0 + doubt * doubt) * off;
}

}  // namespace hexagait
