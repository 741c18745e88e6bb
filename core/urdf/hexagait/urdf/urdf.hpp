// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/stance.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hexagait {

/// What overrules the recognition of a robot. What is not given is found.
struct UrdfOptions {
  std::optional<double> front = {};  ///< --front: direction of the front, from the file's x [rad]
  std::optional<Vector3> up = {};    ///< --up: in the file's root frame, along an axis
  double scale = 1.0;                ///< --scale: times all lengths of the file
  std::vector<std::string> legs =
      {};  ///< --legs: the first joint of each leg; empty: all there are
  std::optional<double> foot_radius = {};  ///< --foot-radius [m]
  /// --foot: of links that end a leg the foot's centre, in the frame of that link [m].
  std::map<std::string, Vector3> feet = {};
  std::optional<double> mass = {};          ///< --mass: of the whole robot [kg]
  double density = 1000.0;                  ///< --density: where a mass is substituted [kg/m³]
  std::optional<double> joint_speed = {};   ///< --joint-speed: where it is substituted [rad/s]
  std::optional<double> joint_effort = {};  ///< --joint-effort: where it is substituted [N m]
  std::optional<double> joint_range = {};   ///< --joint-range: ± where limits are missing [rad]
  std::vector<std::string> packages =
      {};                     ///< --package: directories in which package:// is looked for
  StanceRequest stance = {};  ///< --body-height, --splay: a stance other than the best one
};

/// Loads a robot from a URDF file. What is a leg, where the front is and where the feet are is found
/// by geometry, names mean nothing: docs/your_robot.md has the rules. What the file does not say, or
/// what can't be so, is replaced, and listed in the model's substitutions.
/// @throws InvalidInput  with all that is wrong, each with its line and what overrides it
[[nodiscard]] RobotModel load_urdf(const std::string& path, const UrdfOptions& options = {});

/// The same from the text of a URDF; `source` names it in messages, and relative names of meshes
/// begin in its directory.
[[nodiscard]] RobotModel parse_urdf(const std::string& xml, const std::string& source,
                                    const UrdfOptions& options = {});

}  // namespace hexagait
