// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/sim2d/terrain2d.hpp>

/// Genghis II seen from its left ([PC04] 5, Fig. 5): x forward, z up, pitch positive nose up.
///
/// Its legs turn about a vertical axis, which moves the foot fore and aft, and about a fore-aft
/// one, which moves it up and down, also above the hip. From the side:
///
///     lift    a slider up and down in the body, the hip on it
///     swing   the leg, of fixed length ℓ, turning about the hip
///
///     foot = hip + (ℓ sin swing, lift − ℓ cos swing)
///
/// With both at zero the leg is vertical and the body as high as it can be.
namespace hexagait::sim2d {

struct GenghisJoints {
  double swing = 0.0;  ///< positive forward [rad], [rad/s] or [N m]
  double lift = 0.0;   ///< positive up [m], [m/s] or, as a load, the force on the foot [N]
};

/// [PC04] gives the lengths of body and leg, and the clearance. The masses are ours: six legs of
/// two hobby servos' weight, and a body with batteries and electronics, 1.6 kg together.
struct GenghisModel {
  double body_length = 0.40;  ///< [m]
  double body_height = 0.05;  ///< [m]
  double belly = 0.02;        ///< of the hips above the underside [m]
  double bevel = 0.025;       ///< cut from the lower corners of nose and tail [m]
  double foot_radius = 0.008;
  double leg_length = 0.092;  ///< ℓ, hip to foot centre: with the foot 10 cm [m]
  double max_lift = 0.16;     ///< the foot 6 cm above the hip: the real leg at 37° [m]
  double max_swing = 0.9;     ///< [rad]
  double body_mass = 1.0, leg_mass = 0.1;  ///< [kg]

  std::array<double, 3> hip_x = {0.16, 0.0, -0.16};  ///< front, middle, rear [m]
  double splay = 0.01;             ///< workspace centres of front and rear legs, outwards [m]
  double stance_height = 0.072;    ///< of the hips above the foot centres, at the centres [m]
  double workspace_radius = 0.05;  ///< fore and aft of the centre [m]

  /// How far hips and feet are to the sides of the middle [m], ours: the physics is plane and knows
  /// nothing of it, but referee and figures see a robot in space.
  double hip_y = 0.05, foot_y = 0.13;

  [[nodiscard]] double mass() const { return body_mass + 6.0 * leg_mass; }
};

inline constexpr int kGenghisLegs = 6;

[[nodiscard]] constexpr Side side_of(LegId leg) { return leg % 2 == 0 ? Side::left : Side::right; }

/// +1 for legs of the left side, −1 for those of the right.
[[nodiscard]] constexpr double sign_of(LegId leg) { return leg % 2 == 0 ? 1.0 : -1.0; }

[[nodiscard]] inline Vector2 hip(const GenghisModel& model, LegId leg) {
  return {model.hip_x[static_cast<std::size_t>(leg / 2)], 0.0};
}

/// Workspace centre in the body frame [m].
[[nodiscard]] inline Vector2 centre(const GenghisModel& model, LegId leg) {
  const int pairs_ahead = 1 - leg / 2;  // of the middle
  return hip(model, leg) + Vector2(model.splay * pairs_ahead, -model.stance_height);
}

/// Foot centre in the body frame [m].
[[nodiscard]] inline Vector2 foot_position(const GenghisModel& model, LegId leg,
                                           const GenghisJoints& q) {
  return hip(model, leg) + Vector2(model.leg_length * portable::sin(q.swing),
                                   q.lift - model.leg_length * portable::cos(q.swing));
}

/// The joints for a foot at p [m], each within its limits: out of reach, the nearest of them.
[[nodiscard]] inline GenghisJoints joints_for(const GenghisModel& model, LegId leg,
                                              const Vector2& p) {
  const Vector2 from_hip = p - hip(model, leg);
  const double reach = model.leg_length * portable::sin(model.max_swing);
  const double swing = portable::asin(std::clamp(from_hip.x(), -reach, reach) / model.leg_length);
  const double lift = from_hip.y() + model.leg_length * portable::cos(swing);
  return {swing, std::clamp(lift, 0.0, model.max_lift)};
}

/// The lowest and the highest that a foot reaches at x [m], in the body frame [m].
[[nodiscard]] inline double lowest(const GenghisModel& model, LegId leg, double x) {
  return foot_position(model, leg, {joints_for(model, leg, {x, 0.0}).swing, 0.0}).y();
}
[[nodiscard]] inline double highest(const GenghisModel& model, LegId leg, double x) {
  return lowest(model, leg, x) + model.max_lift;
}

}  // namespace hexagait::sim2d
