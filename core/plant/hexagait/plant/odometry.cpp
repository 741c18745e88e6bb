// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/params/params_for.hpp>
#include <hexagait/plant/odometry.hpp>
#include <limits>

namespace hexagait {
namespace {

// exp(turn) R, to second order and then made orthonormal: turn is some 1e-3 rad per tick.
Matrix3 turned(const Matrix3& R, const Vector3& turn) {
  Matrix3 result;
  for (int k = 0; k < 3; ++k) {
    const Vector3 v = R.col(k);
    result.col(k) = v + turn.cross(v + 0.5 * turn.cross(v));
  }
  return orthonormalised(result);
}

// (odometry 8). Least squares, but for turns about axes that all feet are within in_a_row of.
Vector3 turn_of_spread_feet(const Matrix3& inertia, const Vector3& moment, double in_a_row) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> axes(inertia);
  Vector3 turn = Vector3::Zero();
  for (int k = 0; k < 3; ++k) {
    const Vector3 axis = axes.eigenvectors().col(k);
    const double spread2 = axes.eigenvalues()[k];
    if (spread2 > in_a_row * in_a_row) turn += axis * (axis.dot(moment) / spread2);
  }
  return turn;
}

// One Gauss-Newton step of (odometry 1) from X: accurate to second order in the motion of one tick;
// the next tick corrects the remainder.
// in_a_row² keeps the rotation defined when fewer than three feet stand; negligible with three. Feet that slide
// tell of no turn about a row of them: sliding_in_a_row is 0 if they don't [m].
Pose registered(const Pose& X, const LegArray<Vector3>& p_BF, const LegArray<Vector3>& anchor_O,
                const LegArray<double>& load, double in_a_row, double sliding_in_a_row) {
  double weight = 0.0;
  Vector3 centroid = Vector3::Zero(), residual = Vector3::Zero();
  LegArray<Vector3> p_OF(p_BF.size());
  for (LegId i = 0; i < p_BF.size(); ++i) {
    if (load[i] <= 0.0) continue;
    p_OF[i] = X * p_BF[i];
    weight += load[i];
    centroid += load[i] * p_OF[i];
    residual += load[i] * (anchor_O[i] - p_OF[i]);
  }
  if (weight <= 0.0) return X;
  centroid /= weight;
  residual /= weight;

  Vector3 squares = Vector3::Zero(), products = Vector3::Zero();  // xx yy zz, yz zx xy
  Vector3 moment = Vector3::Zero();
  for (LegId i = 0; i < p_BF.size(); ++i) {
    if (load[i] <= 0.0) continue;
    const Vector3 arm = p_OF[i] - centroid, loaded = load[i] * arm;
    squares += loaded.cwiseProduct(arm);
    products += Vector3(loaded.y() * arm.z(), loaded.z() * arm.x(), loaded.x() * arm.y());
    moment += loaded.cross(anchor_O[i] - p_OF[i]);
  }
  const double sum = squares.sum() + in_a_row * in_a_row;
  Matrix3 inertia;
  inertia << sum - squares.x(), -products.z(), -products.y(),  //
      -products.z(), sum - squares.y(), -products.x(),         //
      -products.y(), -products.x(), sum - squares.z();
  const Vector3 turn = sliding_in_a_row > 0.0
                           ? turn_of_spread_feet(inertia, moment, sliding_in_a_row)
                           : Vector3(inertia.inverse() * moment);

  const Matrix3 R = turned(X.R, turn);
  return {R, centroid + residual + R * (X.R.transpose() * (X.p - centroid))};
}

// Of so many standard deviations of what noise alone makes, no foot slides.
constexpr double kNoiseFactor = 5.0;

// The noise is the mean over some so many samples.
constexpr double kNoiseShare = 0.01;

// A foot in the body, and where it touched down in odom: a row each, computed together [m].
using NowAndThen = Eigen::Array<double, 2, 3>;

// Squared change of the distance between two feet since they touched down [m²].
double change2(const NowAndThen& a, const NowAndThen& b) {
  const NowAndThen way2 = (a - b).square();
  const Eigen::Array2d distance2 = way2.col(0) + way2.col(1) + way2.col(2);
  const double change = distance2[0] - distance2[1];  // ≈ 2 · distance · change of distance
  return change * change / (4.0 * distance2[1]);
}

// The k smallest of the values that were added, in order.
class SmallestChanges {
 public:
  void keep(std::size_t k) {
    k_ = k;
    std::fill_n(values_.begin(), k, std::numeric_limits<double>::infinity());
  }
  void add(double value) {
    if (!(value < largest())) return;
    std::size_t at = k_ - 1;
    for (; at > 0 && value < values_[at - 1]; --at) values_[at] = values_[at - 1];
    values_[at] = value;
  }
  [[nodiscard]] double largest() const { return values_[k_ - 1]; }

 private:
  std::array<double, kMaxLegs> values_;
  std::size_t k_ = 1;
};

// (odometry 3). A foot is judged by the k-th smallest change of its distances to the others, k =
// m/2 of m feet on the ground, so half of them must agree with it. The smallest change alone proves
// nothing: legs stand in rows, and a slide across a row changes no distance within the row. Up to
// m/2 − 1 sliding feet leave the weights of the standing feet as they are.
LegArray<double> without_sliding(const LegArray<double>& footing, const LegArray<Vector3>& p_BF,
                                 const LegArray<Vector3>& anchor_O, double tolerance2) {
  std::array<LegId, kMaxLegs> standing{};
  std::array<NowAndThen, kMaxLegs> place;
  std::size_t m = 0;
  for (LegId i = 0; i < p_BF.size(); ++i) {
    if (footing[i] <= 0.0) continue;
    place[m].row(0) = p_BF[i];
    place[m].row(1) = anchor_O[i];
    standing[m++] = i;
  }
  if (m < 2) return footing;

  std::array<SmallestChanges, kMaxLegs> change;  // of each foot to the others
  for (std::size_t a = 0; a < m; ++a) change[a].keep(m / 2);
  for (std::size_t a = 0; a < m; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const double both = change2(place[a], place[b]);
      change[a].add(both);
      change[b].add(both);
    }
  }
  LegArray<double> trust = footing;
  for (std::size_t a = 0; a < m; ++a) {
    const double ratio2 = change[a].largest() / tolerance2;
    trust[standing[a]] /= 1.0 + ratio2 * ratio2;
  }
  return trust;
}

// The least slope s with the least |Σ arm (arm · s − height)|: 0 across feet that stand in a row.
Vector2 slope_of(const Eigen::Matrix2d& spread, const Vector2& rise, double in_a_row) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  Vector2 slope = Vector2::Zero();
  for (int k = 0; k < 2; ++k) {
    const Vector2 axis = axes.eigenvectors().col(k);
    const double width2 = axes.eigenvalues()[k];
    if (width2 > in_a_row * in_a_row) slope += axis * (axis.dot(rise) / width2);
  }
  return slope;
}

// That turns the unit vector a into b on the shortest way [rad].
Vector3 rotation_between(const Vector3& a, const Vector3& b) {
  const Vector3 axis = a.cross(b);
  const double sine = axis.norm(), cosine = a.dot(b);
  return sine > 0.0 ? Vector3(axis * (portable::atan2(sine, cosine) / sine)) : Vector3::Zero();
}

// Twist that takes the body from X_OB to Y_OB in dt, in the body frame.
Twist twist_between(const Pose& X_OB, const Pose& Y_OB, double dt) {
  const Matrix3 R = X_OB.R.transpose() * Y_OB.R;
  return {X_OB.R.transpose() * (Y_OB.p - X_OB.p) / dt,
          Vector3(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)) / (2.0 * dt)};
}

}  // namespace

Odometry::Odometry(const RobotModel& model, const ToleranceParams& tolerance) : model_(&model) {
  RobotParams all = none_derived();
  all.tolerance = tolerance;
  tolerance_ = completed(all, model).tolerance;
}

void Odometry::reset(RobotState& state, RestsOn rests_on) {
  const int n = model_->num_legs();
  state.X_OB = rests_on == RestsOn::belly ? Pose{} : pose_over_feet(state);
  state.V_B = {};
  state.p_OF = LegArray<Vector3>(n);
  for (LegId i = 0; i < n; ++i) state.p_OF[i] = state.X_OB * state.p_BF[i];
  state.print_O = state.p_OF;
  state.slide_O = LegArray<Vector3>(n, Vector3::Zero());
  anchor_O_ = state.p_OF;
  off_anchor_O_ = LegArray<Vector3>(n, Vector3::Zero());
  q_before_ = state.q;
  trig_before_ = state.trig;
  p_before_ = state.p_BF;
  step_before_ = LegArray<Vector3>(n, Vector3::Zero());
  noise2_ = 0.0;
  noise_samples_ = -n;  // the first tick has no difference to one before
  X_OB_ = state.X_OB;
}

Pose Odometry::pose_over_feet(const RobotState& state) const {
  // Least-squares plane through the feet, z − z̄ = slope · ((x, y) − (x̄, ȳ)).
  const int n = model_->num_legs();
  Vector3 centre = Vector3::Zero();
  for (const Vector3& p_BF : state.p_BF) centre += p_BF / n;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Vector2 rise = Vector2::Zero();
  for (const Vector3& p_BF : state.p_BF) {
    const Vector3 arm = p_BF - centre;
    spread += arm.head<2>() * arm.head<2>().transpose();
    rise += arm.head<2>() * arm.z();
  }
  const Vector2 slope = slope_of(spread, rise, tolerance_.in_a_row);
  const Vector3 up_B = Vector3(-slope.x(), -slope.y(), 1.0).normalized();

  // z of odom is the normal of the plane, x the body's forward direction projected into it.
  const Vector3 forward_B = (Vector3::UnitX() - up_B.x() * up_B).normalized();
  Pose X_OB;
  X_OB.R.row(0) = forward_B;
  X_OB.R.row(1) = up_B.cross(forward_B);
  X_OB.R.row(2) = up_B;
  X_OB.p = Vector3(0.0, 0.0, model_->foot_radius - up_B.dot(centre));
  return X_OB;
}

void Odometry::update(RobotState& state, const LegArray<double>& footing, double dt) noexcept {
  const int n = model_->num_legs();
  const Vector3 rotation_B = state.V_B.w * dt;
  for (LegId i = 0; i < n; ++i)
    if (footing[i] > 0.0) roll(state, i, rotation_B);

  measure_noise(state, footing);
  // Feet of legs of two joints all slide: none is worse than others for it.
  const bool all_slide = model_->legs[0].has_two_joints();
  const LegArray<double> trust =
      all_slide ? footing : without_sliding(footing, state.p_BF, anchor_O_, slide_tolerance2());
  const Pose X_OB = registered(X_OB_, state.p_BF, anchor_O_, trust, tolerance_.in_a_row,
                               all_slide ? tolerance_.sliding_in_a_row : 0.0);
  state.V_B = twist_between(X_OB_, X_OB, dt);
  state.X_OB = X_OB_ = X_OB;

  // The foothold of a foot that still takes load, or slides, follows the foot.
  for (LegId i = 0; i < n; ++i) {
    state.p_OF[i] = X_OB * state.p_BF[i];
    const Vector3 off = state.p_OF[i] - anchor_O_[i];
    if (footing[i] > 0.0) state.slide_O[i] += off - off_anchor_O_[i];
    anchor_O_[i] = trust[i] * anchor_O_[i] + (1.0 - trust[i]) * state.p_OF[i];
    off_anchor_O_[i] = state.p_OF[i] - anchor_O_[i];
    if (footing[i] > 0.0) state.print_O[i] = anchor_O_[i];
  }
  lean(state, dt);
  for (LegId i = 0; i < q_before_.size(); ++i) {
    q_before_[i] = state.q[i];
    trig_before_[i] = state.trig[i];
  }
}

void Odometry::level(RobotState& state, const Vector3& up_B,
                     const LegArray<double>& footing) noexcept {
  const Vector3 up_O = X_OB_.R * up_B;
  Vector3 middle = Vector3::Zero();
  double weight = 0.0;
  for (LegId i = 0; i < footing.size(); ++i) {
    middle += footing[i] * state.p_OF[i];
    weight += footing[i];
  }
  middle = weight > 0.0 ? Vector3(middle / weight) : X_OB_.p;
  turn(state, rotation_about(middle, rotation(rotation_between(up_O, Vector3::UnitZ()))));
}

// (odometry 5)
void Odometry::lean(RobotState& state, double dt) noexcept {
  const auto& [roll, pitch] = state.inclination;
  if (!std::isfinite(roll) && !std::isfinite(pitch)) return;
  const Vector3 rpy = roll_pitch_yaw(X_OB_.R);
  const Vector3 left(-portable::sin(rpy.z()), portable::cos(rpy.z()), 0.0);
  Vector3 way = Vector3::Zero();
  if (std::isfinite(roll)) way += dt / tolerance_.level_time * (roll - rpy.x()) * X_OB_.R.col(0);
  if (std::isfinite(pitch)) way += dt / tolerance_.level_time * (pitch - rpy.y()) * left;
  turn(state, rotation_about(X_OB_.p, turned(Matrix3::Identity(), way)));
}

// All that is known in odom turns along, or the footholds would pull the body back.
void Odometry::turn(RobotState& state, const Pose& about) noexcept {
  state.X_OB = X_OB_ = {orthonormalised(about.R * X_OB_.R), about * X_OB_.p};
  for (LegId i = 0; i < anchor_O_.size(); ++i) {
    state.p_OF[i] = about * state.p_OF[i];
    state.print_O[i] = about * state.print_O[i];
    state.slide_O[i] = about.R * state.slide_O[i];
    anchor_O_[i] = about * anchor_O_[i];
    off_anchor_O_[i] = about.R * off_anchor_O_[i];
  }
}

// (odometry 4). A standing foot moves smoothly, so its second differences are noise.
void Odometry::measure_noise(const RobotState& state, const LegArray<double>& footing) noexcept {
  for (LegId i = 0; i < state.p_BF.size(); ++i) {
    const Vector3 step = state.p_BF[i] - p_before_[i];
    if (footing[i] >= 1.0 && ++noise_samples_ > 0)
      noise2_ += std::max(kNoiseShare, 1.0 / static_cast<double>(noise_samples_)) *
                 ((step - step_before_[i]).squaredNorm() / 6.0 - noise2_);
    p_before_[i] = state.p_BF[i];
    step_before_[i] = step;
  }
}

// Two feet, each with a third of its variance along the line between them.
double Odometry::slide_tolerance2() const noexcept {
  return tolerance_.slide * tolerance_.slide + kNoiseFactor * kNoiseFactor * 2.0 / 3.0 * noise2_;
}

// (odometry 2), over one tick.
void Odometry::roll(const RobotState& state, LegId leg, const Vector3& rotation_B) noexcept {
  const Vector3 turn_O = X_OB_.R * (rotation_B + tibia_turn(model_->legs[leg], trig_before_[leg],
                                                            state.q[leg] - q_before_[leg]));
  anchor_O_[leg].head<2>() += model_->foot_radius * Vector2(turn_O.y(), -turn_O.x());
}

}  // namespace hexagait
