// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/heading_control/twist.hpp>
#include <hexagait/math/planar.hpp>
#include <hexagait/params/params_for.hpp>
#include <hexagait/path_following/path.hpp>

namespace hexagait::path_following {

/// Where the body faces while it follows a path.
enum class Facing : std::uint8_t {
  along,   ///< along the path, turned by FacingRule::angle
  fixed,   ///< at FacingRule::angle from x of the path's frame; 0 keeps the facing of the start
  points,  ///< as the path's waypoints say
  car,     ///< where it goes: it never crabs, as a car; for legs of two joints, which can't
};

struct FacingRule {
  Facing kind = Facing::along;
  double angle = 0.0;  ///< [rad]
};

/// The look-ahead of a robot of this stroke, 1.25 strokes [m]. Shorter: it returns to the path sooner, with
/// turns that its feet can't follow within a step. Longer: it cuts corners, by 0.27 of it at 90°.
[[nodiscard]] double look_ahead_for(const StepParams& step) noexcept;

/// A path that is to be followed.
struct PathTask {
  Path path;
  FacingRule facing = {};
  int laps = 1;             ///< of a closed path
  double look_ahead = 0.0;  ///< L, more than 0 [m]

  [[nodiscard]] double end() const { return path.closed() ? laps * path.length() : path.length(); }
};

/// All that pursuit remembers.
struct PathProgress {
  double s = 0.0;        ///< on the path [m]
  bool on_path = false;  ///< it has been at the first point
  bool arrived = false;  ///< at the end: it stops
  heading_control::Heading heading = heading_control::Heading::stop();  ///< the last command
};

/// What a controller of legs is to do, and what came of it.
struct Pursuit {
  heading_control::HeadingCommand command;
  PathProgress progress;
  Vector2 goal_P = Vector2::Zero();  ///< the point that it makes for [m]
};

/// One tick of the outer loop: from where the robot is to a path (r, α). With the place s of the path
/// nearest to the base, the goal g at s + L, the direction τ of the path there, and the direction β from
/// the base to g, the base sets off along
///
///     χ = τ + clamp(2 (β − τ), ±λ),    λ = max(π/2, |τ(s) − τ|)                             (path 2)
///
/// the tangent of the circle through the base that touches the path at g. Where β is off τ by more than
/// λ, as where the path is far away, it goes straight to g. On the way to g, of length d, it turns to where
/// it is to face there, ψ_g:
///
///     α = χ − ψ,    1/r = (ψ_g − ψ) / d                                                      (path 3)
///
/// As a car (Facing::car) it keeps α = 0, and 1/r = 2 y / |g|² with g = (x, y) in its frame: pure pursuit
/// as of Coulter 1992; a goal beside or behind it first makes it turn in place.
///
/// Until it has been at the first point (within L/4) that is the goal. Within `coast` of the end it
/// stops, for good. Neither throws nor allocates; where the pose is no number it stops until it is one.
/// @param X_PB   of the base, in the path's frame
/// @param coast  way that the base still goes after a stop [m]
[[nodiscard]] Pursuit pursue(const PathProgress& before, const PathTask& task,
                             const PlanarPose& X_PB, double coast) noexcept;

/// Where the body is to face at a place of the path, from x of P, in (−π, π] [rad].
[[nodiscard]] double facing_at(const PathTask& task, double s) noexcept;

}  // namespace hexagait::path_following
