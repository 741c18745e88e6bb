// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <hexagait/gallery/random_robot.hpp>
#include <hexagait/heading_control/heading.hpp>
#include <hexagait/recording/simulation.hpp>
#include <string>
#include <vector>

/// Walks of robots of any size: what to walk, for how long, and how it went, in the robots' own
/// lengths and times.
namespace hexagait::experiments {

/// A heading and how far to follow it.
struct RobotHeading {
  std::string name;
  heading_control::Heading heading = heading_control::Heading::stop();
  double distance = 0.0;  ///< [m]
  double turn = 0.0;      ///< of a spin, whose distance is 0 [rad]
};

/// 5 L straight on.
[[nodiscard]] RobotHeading straight_on(const RobotScale& scale);
/// A quarter of a circle of radius 2 L, to the left.
[[nodiscard]] RobotHeading along_an_arc(const RobotScale& scale);
/// A quarter of a turn or more, to the right.
[[nodiscard]] RobotHeading in_place();
/// 3 L at 45°.
[[nodiscard]] RobotHeading sideways(const RobotScale& scale);

/// The walk, with the time that it may take: as long as a pace of 0.06 ℓ/T needs, a fifth of what six
/// legs walk at, or of 0.03 ℓ/T with four legs, half of what they crawl at; for a turn in place, twice
/// that pace.
[[nodiscard]] recording::Simulation walk_of(const RobotHeading& heading, const RobotScale& scale);

/// How a walk ended.
struct WalkEnd {
  std::string outcome;         ///< "walked", "fell", "stuck", "fault" or "too slow"
  double seconds = 0.0;        ///< [s]
  double way = 0.0;            ///< walked, of a spin by the outermost foot [m]
  double off_path = 0.0;       ///< mean distance from the path, as a share of the way
  std::string hindrance = {};  ///< of a walk that got stuck

  [[nodiscard]] bool walked() const { return outcome == "walked"; }
};
[[nodiscard]] WalkEnd end_of(const walk::Summary& summary, const RobotHeading& heading,
                             const RobotModel& robot);

/// What a random robot did.
struct RobotTrial {
  std::uint64_t seed = 0;
  int legs = 0;
  std::string layout;          ///< "yaw-pitch-pitch, round"
  double size = 0.0;           ///< L [m]; 0: no robot
  double mass = 0.0;           ///< [kg]
  double pace = 0.0;           ///< ℓ/T [m/s]
  std::string cannot_stand;    ///< why; empty: it can
  std::vector<WalkEnd> walks;  ///< straight on, arc, spin; none if it can't stand

  [[nodiscard]] bool stands() const { return cannot_stand.empty(); }
  [[nodiscard]] bool fell() const;
  [[nodiscard]] bool walks_all() const;
  /// The most of its walks.
  [[nodiscard]] double off_path() const;
};

/// Walks it on flat ground, if it can stand.
[[nodiscard]] RobotTrial try_robot(const RandomRobot& random, const std::atomic<bool>* stop);

/// A line, and back. @throws std::exception  if it is none
[[nodiscard]] std::string to_line(const WalkEnd& end);
[[nodiscard]] WalkEnd parse_end(const std::string& line);
[[nodiscard]] std::string to_line(const RobotTrial& trial);
[[nodiscard]] RobotTrial parse_trial(const std::string& line);

}  // namespace hexagait::experiments
