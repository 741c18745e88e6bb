// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/action/action.hpp>
#include <hexagait/params/robot_params.hpp>

namespace hexagait {

/// Sets the rates, times, heights and margins of commands that are kDerived to the robot's.
void fill_in(std::vector<action::Step>& steps, const ScriptParams& params);

}  // namespace hexagait
