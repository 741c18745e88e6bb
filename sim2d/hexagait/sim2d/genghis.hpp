// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <hexagait/gait_state/gait_choice.hpp>
#include <hexagait/sim2d/genghis_controller.hpp>
#include <hexagait/sim2d/genghis_world.hpp>
#include <hexagait/sim2d/terrain2d.hpp>
#include <limits>
#include <optional>

namespace hexagait::sim2d {

/// A walk of Genghis in the side view, as a value: everything that decides how it goes.
struct GenghisTrial {
  TerrainSpec2d terrain;
  gait_state::GaitChoice gait;
  std::uint64_t seed = 1;                                     ///< of terrain and posture
  double seconds = 40.0;                                      ///< how long, at most [s]
  double distance = std::numeric_limits<double>::infinity();  ///< how far, at most [m]
  double random_posture = 0.0;  ///< feet start displaced fore or aft by up to this [m]
  bool backward = false;
  double physics_dt = 0.0025;  ///< [s]
  double control_dt = 0.005;   ///< a whole number of physics steps [s]
  GenghisParams controller;    ///< its gait, direction and period are those above
};

/// How it went, by ground truth.
struct GenghisSummary {
  double seconds = 0.0;   ///< walked [s]
  double distance = 0.0;  ///< of the middle of the body, along the command [m]
  double speed = 0.0;     ///< distance / seconds [m/s]

  int steps = 0;                          ///< lifts commanded
  std::optional<int> tripod_after_steps;  ///< see gait_state::first_tripod_gait()
  int rule1_violations = 0;               ///< lifts commanded while a neighbour was not in support
  double neighbour_flight = 0.0;  ///< time in which two neighbours were in fact off the ground [s]
  int contact_losses = 0;         ///< times that a leg in support lost its hold
  int blocked = 0;                ///< times that an advance ran into something
  int searches = 0;               ///< times that no ground was found within reach

  double slip_mean = 0.0;          ///< path that a foot slid, per step [m]
  double pitch_max = 0.0;          ///< absolute [rad]
  double height_min = 0.0;         ///< of the line of hips above z = 0 [m]
  double height_max = 0.0;         ///< [m]
  double body_contact_time = 0.0;  ///< in which the body touched the ground: allowed [s]
  bool fell = false;               ///< pitched by more than 60°, or the physics blew up
  bool stuck = false;              ///< no 2 cm of progress in 30 s
  bool arrived = false;            ///< the distance asked for was reached
  double real_time_factor = 0.0;   ///< simulated seconds per second of processor time
  std::uint64_t state_hash = 0;    ///< of true pose and joints at every tick (FNV-1a)

  /// Walked to the end as asked.
  [[nodiscard]] bool ok() const { return !fell && !stuck; }
};

/// Called after every tick: what the controller computed, and the truth.
using GenghisObserver = std::function<void(const GenghisRecord&, const GenghisTruth&)>;

/// Walks: same trial and binary, same bits (real_time_factor apart).
/// @param stop  once true, the walk ends
/// @throws InvalidInput  if a number is out of range
[[nodiscard]] GenghisSummary run_genghis(const GenghisTrial& trial,
                                         const GenghisObserver& observer = {},
                                         const std::atomic<bool>* stop = nullptr);

}  // namespace hexagait::sim2d
