// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/model/robot_model.hpp>
#include <string>

namespace hexagait {

/// Loads a robot from a URDF file.
/// Recognised: a root link with an even number (4 to 12) of serial chains of 3 to 6 revolute or
/// continuous joints about any axes, ending in a spherical foot: the collision sphere of the last
/// link that is farthest from the last joint. All feet have one radius. Links on fixed joints are
/// merged into what they are fixed to; a merged link needs mass and inertia. Collision meshes are
/// left out. Legs are put in LegId order by where their hips are, as many left as right.
/// @throws InvalidInput  if the file is missing, not XML or not such a robot, if a number is none
/// or
///                       a limit or a mass impossible, or if the nominal stance is out of limits
[[nodiscard]] RobotModel load_urdf(const std::string& path);

/// The same from the text of a URDF; `source` names it in messages.
[[nodiscard]] RobotModel parse_urdf(const std::string& xml, const std::string& source);

}  // namespace hexagait
