// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/executor/leg_lane.hpp>
#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <hexagait/math/planar.hpp>
#include <hexagait/model/robot_model.hpp>
#include <limits>
#include <string>
#include <string_view>

namespace hexagait::viewer {

/// In place of a LegPhase: the robot does without this leg.
inline constexpr std::uint8_t kLost = static_cast<std::uint8_t>(LegPhase::hold) + 1;

/// One leg in a PoseFrame.
struct LegFrame {
  Vector3 p_WF = Vector3::Zero();  ///< foot centre [m]
  /// Foothold that the controller intends, where it believes it to be relative to the body [m];
  /// NaN while the leg stands.
  Vector3 p_WT = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
  double force = 0.0;      ///< true normal force on the foot [N]
  double lag = 0.0;        ///< δ, behind the workspace centre [m of path]
  std::uint8_t phase = 0;  ///< LegPhase, or kLost
  LegJoints q = LegJoints::Zero();
};

/// What a page shows of one instant of a walk. World frame W, unless said otherwise.
///
/// As bytes (encode()): little-endian, f32 and f64 by IEEE 754, without gaps, in this order.
///
///     u8   version, number of legs, flags, fault        u32  scene, tick, holder
///     f64  time                                         f32  speed factor
///     f32  base: position (3), quaternion x y z w*      f32  velocity vx vy ωz, axes of the body
///     f32  heading: ρ, k, α, moving (0 or 1)            f32  turning centre (2), NaN if straight
///     f32  margin, centre of mass (3), lateral, path, slip speed, power
///     u16  raw, state: bit k set: ring relation k is <  u8   CCN before adjustment, type (0 none, A … D)
///     u16  legs: priority, may step, wait, in contact, support by the controller, urgent
///     per leg: f32 foot (3), foothold (3), force, lag;  u8   phase, joints;  f32 each joint
///     u8   corners of the support polygon;              f32  x, y of each
///
/// * in steps of 2⁻¹⁶
///
/// In a race the frame of the second robot, of the same instant, is behind that of the first.
struct PoseFrame {
  static constexpr std::uint8_t kVersion = 2;
  enum Flag : std::uint8_t {
    paused = 1,
    fell = 2,
    silent = 4,    ///< the holder of the wheel has been silent: the robot was stopped
    wave = 8,      ///< gait: a wave
    tripod = 16,   ///< gait: the tripod that waits
    holding = 32,  ///< the measurement is late: the robot holds still
    follows = 64,  ///< a path on the ground
    refuses = 128  ///< to walk: too few legs are left
  };

  std::uint8_t flags = 0;
  std::uint8_t fault = 0;     ///< Fault
  std::uint32_t scene = 0;    ///< number of the scene: of robot and ground
  std::uint32_t tick = 0;     ///< control periods since the scene began
  std::uint32_t holder = 0;   ///< client that holds the wheel; 0: none
  double time = 0.0;          ///< [s]
  double speed_factor = 1.0;  ///< simulated seconds per second, as measured
  Pose X_WB;
  PlanarTwist velocity;  ///< of the base, smoothed, axes of the body [m/s, rad/s]

  double rho = 1.0, k = 0.0, crab = 0.0;  ///< heading_control::Heading
  bool moving = false;
  Vector2 centre = Vector2::Zero();  ///< turning centre [m]

  double margin = 0.0;            ///< static stability margin [m]
  Vector3 com = Vector3::Zero();  ///< centre of mass [m]
  double lateral = 0.0;     ///< distance from the commanded curve or the path, > 0 to its left [m]
  double path = 0.0;        ///< way of the base since the scene began [m]
  double slip_speed = 0.0;  ///< largest of the feet in contact [m/s]
  double power = 0.0;       ///< mechanical, sum over the joints of |τ q̇|, smoothed [W]

  std::uint16_t raw = 0, state = 0;  ///< gait_state::GaitState::bits
  std::uint8_t ccn = 0, type = 0;
  LegSet priority, may_step, waits, contact, support, urgent;
  SupportPolygon polygon;
  LegArray<LegFrame> legs;
};

/// The number of joints of each leg.
[[nodiscard]] LegArray<int> joint_counts(const RobotModel& robot);

/// @param joints  see joint_counts()
[[nodiscard]] std::string encode(const PoseFrame& frame, const LegArray<int>& joints);

/// The inverse of encode(), to the precision of a float; for tests and for programs that listen.
/// @throws InvalidInput  if the bytes are of another version, too few or too many
[[nodiscard]] PoseFrame decode(std::string_view bytes);

/// The same of a frame with more behind it: `bytes` is then what is left.
[[nodiscard]] PoseFrame decode_front(std::string_view& bytes);

}  // namespace hexagait::viewer
