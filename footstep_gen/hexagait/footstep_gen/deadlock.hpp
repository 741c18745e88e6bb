// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/executor/commands.hpp>
#include <hexagait/footstep_gen/neighbours_first.hpp>
#include <hexagait/gait_state/latch.hpp>
#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>
#include <hexagait/math/planar.hpp>

namespace hexagait::footstep_gen {

/// What a walker does about a deadlock.
enum class EscapePhase : std::uint8_t {
  none,     ///< there is none
  moves,    ///< the body moves to the posture that fits the standing feet best; no leg lifts
  steps,    ///< the legs step from there, and the body does not go back
  gave_up,  ///< it did not get on after the last try: the robot stands
};

/// The way out of a deadlock, as of this tick.
struct Escape {
  EscapePhase phase = EscapePhase::none;
  int tries = 0;   ///< of this deadlock, the present one included
  LegSet failing;  ///< legs that had not found a foothold when the present try began
  LegSet held;     ///< those of them whose neighbours step first
  PlanarTwist
      way;  ///< displacement of the body of the present try, in the body frame at its begin [m, rad]
  PlanarTwist left;  ///< what is left of it, in the body frame [m, rad]; only while it moves
};

/// What the detection and the resolution of deadlocks take into account.
struct DeadlockInput {
  double time = 0.0;       ///< [s]
  bool walks = false;      ///< the robot is to move
  PlanarTwist path;        ///< of the command, per metre of path
  Pose X_OB;               ///< of the body, by odometry
  LegArray<Vector3> p_BF;  ///< feet, body frame [m]
  LegArray<Vector3> p_BC;  ///< workspace centres, body frame [m]
  LegSet standing;         ///< legs that stand
  LegSet failing;  ///< legs that are off the ground, or whose last step failed in all its tries
  LegSet lost;     ///< legs that are not there
  double progress =
      0.0;  ///< way of the body, or of its outermost foot as it turns, that is progress [m]
  double patience = 0.0;  ///< time without progress after which it is a deadlock [s]
  double arm = 0.0;       ///< distance from the body to its outermost foot [m]
};

/// Detects deadlocks and resolves them ([PC04] 4). A walking robot is in deadlock if its body has not
/// moved by `progress` within `patience`: whichever leg keeps the others waiting has failed in all of its
/// tries by then. The way out has two parts: the body moves, freely and not along its path, to the
/// posture with the least sum of squared distances of the standing feet from their workspace centres,
/// in closed form (posture::free_optimum()); then the legs step from there, to other footholds than
/// before. Legs that are off the ground do not count: the arc's optimum waits for them. Progress ends the
/// escape, and the body goes back to its path as after any other deviation.
///
/// After kTries tries in a row without progress it gives up, until the command changes by more than
/// half of its path (or stops).
///
/// Height and tilt are not part of the way: the walker keeps the body parallel to the plane through the
/// footprints at all times.
class Deadlock {
 public:
  static constexpr int kTries = 3;

  Escape update(const DeadlockInput& in) noexcept;

 private:
  void begin(const DeadlockInput& in) noexcept;
  [[nodiscard]] bool is_there(const DeadlockInput& in) noexcept;
  void wait_from_here(const DeadlockInput& in) noexcept;

  Escape escape_;
  bool walked_ = false;   ///< in the last tick
  double since_ = 0.0;    ///< when the present phase began, or progress was last made [s]
  PlanarPose from_;       ///< where the body was then
  PlanarPose to_;         ///< where the try takes the body
  double nearest_ = 0.0;  ///< what was least left of that way [m]
  double nearer_ = 0.0;   ///< when the body last came nearer [s]
  NeighboursFirst wait_;  ///< of the legs that fail, while legs step
  PlanarTwist gave_up_;   ///< the path on which it gave up
};

/// Gives the legs that are held the lowest priority.
void hold_back(gait_state::GaitInput& legs, LegSet held) noexcept;

/// Keeps the base from its path while it leaves it, and from going back while legs step. One that has
/// given up stays where it is.
void keep_out(BaseAutoCommand& base, const Escape& escape) noexcept;

}  // namespace hexagait::footstep_gen
