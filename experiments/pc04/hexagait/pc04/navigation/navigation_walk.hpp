// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <hexagait/navigation/navigator.hpp>
#include <hexagait/recording/simulation.hpp>
#include <hexagait/sim3d/simulated_senses.hpp>
#include <vector>

namespace hexagait::experiments {

/// Standard deviations of white noise, bell-shaped and never more than 3.5 times as much.
struct SenseNoise {
  double range = 0.0;  ///< of what a beam measures, as a share of it
  double pitch = 0.0;  ///< of the inclinometer [rad]
};

/// A walk of a robot that finds its way by whiskers, infrared and inclination.
struct NavigationWalk {
  /// Where the base is, twice a second.
  struct Sample {
    double time = 0.0;               ///< [s]
    Vector3 p_WB = Vector3::Zero();  ///< [m]
    double yaw = 0.0, pitch = 0.0;   ///< [rad]
    navigation::Act act = navigation::Act::ahead;
  };
  /// Where it met something.
  struct Meeting {
    double time = 0.0;               ///< [s]
    Vector3 p_WB = Vector3::Zero();  ///< [m]
    navigation::Reason reason = navigation::Reason::wander;
  };

  recording::Simulation simulation;  ///< terrain, seed, seconds
  walk::Summary summary = {};
  std::vector<Sample> trace = {};
  std::vector<Meeting> meetings = {};
  double path = 0.0;    ///< of the base, forwards and back [m]
  double turned = 0.0;  ///< to either side [rad]
  double area = 0.0;    ///< of the squares of 0.3 m above which the base has been [m²]
  /// How often the controller of the legs took the robot over anew, since it got nowhere.
  int restarts = 0;
  double deepest = 0.0;  ///< how far a foot got below the floor [m]

  [[nodiscard]] double asked() const { return simulation.trial.seconds; }  ///< [s]
  [[nodiscard]] long met(navigation::Reason reason) const;
};

/// Walks it: what its sensors sense decides on its heading, nothing else does.
/// @param noise     of the sensors; drawn, as the turns are, by the simulation's seed
/// @param progress  called every half a second with the time walked [s]
/// @param observer  called after every tick; may be empty
[[nodiscard]] NavigationWalk navigate(const RobotModel& robot,
                                      const recording::Simulation& simulation,
                                      const SenseNoise& noise,
                                      const std::function<void(double)>& progress,
                                      const std::atomic<bool>* stop,
                                      const recording::WorldObserver& observer = {});

}  // namespace hexagait::experiments
