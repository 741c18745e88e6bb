// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/params/params_for.hpp>
#include <string>

namespace hexagait {

/// Sets the parameters of a YAML file, a map of their groups:
///
///     step: {height: 4cm, stroke: 0.12}
///     swing: {descent_speed: 0.2}
///
/// The others stay.
/// @throws InvalidInput  with file, line and what would be right, for everything that is wrong
void load_params(RobotParams& params, const std::string& path);

/// The file of parameters that belongs to a robot: "spider.params.yaml" beside "spider.urdf"; empty
/// if there is none.
[[nodiscard]] std::string params_beside(const std::string& urdf);

}  // namespace hexagait
