// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/heading_control/heading.hpp>
#include <hexagait/navigation/senses.hpp>

namespace hexagait::navigation {

/// Thresholds and ways of the navigation. Lengths follow from the robot's model.
struct NavigationParams {
  std::array<double, kBeams> to_floor = {};  ///< of the beams, on level ground [m]
  /// A beam that measures more than this times to_floor sees a cliff. Smaller: the swaying of the
  /// body looks like cliffs. Larger: steps down of more than a foot's reach are walked over.
  double cliff = 1.35;
  /// A beam that measures less than this times to_floor sees a wall.
  double wall = 0.6;
  /// A pitch beyond which the robot goes back, nose up or down [rad]. Smaller: its swaying looks like
  /// slopes. Larger: legs of two joints, which slide while they turn in place, slide downhill.
  double steep = 0.26;
  /// It goes back by this, but no farther than it has come straight ahead [m].
  double retreat = kDerived;
  double retreat_from_steep =
      kDerived;  ///< the same from a slope, off which all feet are to be [m]
  double least_turn = 0.8, most_turn = 2.6;  ///< in place, by lot between them [rad]
  double least_run = kDerived,
         most_run = kDerived;  ///< straight on, until it turns by itself [m]
  /// Odometry that shows no progress for so long: something that nothing senses is in the way [s].
  double patience = kDerived;
  double progress = kDerived;     ///< [m]; in a turn, at the farthest foot
  double foot_circle = kDerived;  ///< R [m]
};

/// @pre the robot is in a stance: see scale_of()
[[nodiscard]] NavigationParams navigation_params_for(const RobotModel& model);

/// Why it does not walk straight on, from the most urgent one: a layer each, of which a higher one
/// subsumes all below it.
enum class Reason : std::uint8_t {
  steep,    ///< the inclinometer
  cliff,    ///< a beam sees no floor
  touch,    ///< a whisker bends
  wall,     ///< a beam sees something near
  blocked,  ///< no progress
  wander,   ///< nothing: it has walked straight on for long enough
};
inline constexpr std::size_t kReasons = 6;
[[nodiscard]] const char* to_string(Reason reason) noexcept;

enum class Act : std::uint8_t { ahead, back, turn };

/// All that the navigation remembers.
struct NavigationState {
  Act act = Act::ahead;
  Reason reason = Reason::wander;  ///< of the present retreat or turn, or of the last one
  heading_control::Turn turn = heading_control::Turn::ccw;
  double way = 0.0;           ///< made in this act: [m], in a turn [rad]
  double goal = 0.0;          ///< of this act: [m] or [rad]; 0: none yet
  double ahead = 0.0;         ///< the way straight ahead on which it could go back [m]
  double turn_to_come = 0.0;  ///< after a retreat [rad]
  PlanarPose last;            ///< odometry of the last tick
  double marked_way = 0.0, marked_time = 0.0;  ///< the last progress [m], [s]
  bool started = false;
  std::array<long, kReasons> met = {};  ///< how often, each
};

/// What is in the way.
struct Danger {
  Reason reason = Reason::wander;
  bool any = false, left = false, right = false;
};
[[nodiscard]] Danger danger(const Senses& senses, const NavigationParams& params) noexcept;

/// One tick. Straight on, until something is sensed; then back, if it is a cliff, too steep or a
/// touch, by no more than the way it came; then a turn in place away from it, by an angle by lot and
/// until nothing is sensed ahead. Neither throws nor allocates.
/// @param lot  uniform in [0, 1), a new one at each tick; decides on turns
[[nodiscard]] NavigationState navigate(NavigationState state, const Senses& senses,
                                       const NavigationParams& params, double lot) noexcept;

/// What the legs' controller is to do: straight ahead, straight back, or turn in place.
[[nodiscard]] heading_control::Heading heading_of(const NavigationState& state) noexcept;

}  // namespace hexagait::navigation
