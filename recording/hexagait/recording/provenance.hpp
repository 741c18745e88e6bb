// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/recording/simulation.hpp>
#include <hexagait/sim2d/genghis.hpp>
#include <string>
#include <utility>
#include <vector>

namespace hexagait::recording {

/// What produced a result, beside its configuration: two results of the same configuration are
/// comparable, and shards of one sweep can be merged, if their provenance is equal.
struct Provenance {
  /// Names with their units, such as "step.height_m"; flags are 0 or 1.
  using Parameters = std::vector<std::pair<std::string, double>>;

  std::string version, revision, compiler;  ///< of hexagait
  /// Name and version of each library that takes part in the numbers, as found at run time where
  /// the library says so, else when it was compiled against.
  std::vector<std::pair<std::string, std::string>> libraries;

  struct Robot {
    std::string name;
    std::uint64_t model_hash = 0;  ///< see model_hash()
  };
  std::vector<Robot> robots;  ///< none where nothing but numbers walks
  Parameters physics;         ///< of the simulated world; empty without one
  Parameters controller;      ///< empty without a controller that has any
};

/// Without robot and physics: the program and its libraries.
[[nodiscard]] Provenance provenance();
/// Of a walk in three dimensions.
[[nodiscard]] Provenance provenance(const std::string& name, const RobotModel& robot,
                                    const Simulation& simulation);
/// Of a walk of Genghis in the side view.
[[nodiscard]] Provenance provenance(const sim2d::GenghisTrial& trial);

/// FNV-1a of all names and numbers of a model: equal for models that walk alike, whatever their
/// URDF looks like.
[[nodiscard]] std::uint64_t model_hash(const RobotModel& robot);

}  // namespace hexagait::recording
