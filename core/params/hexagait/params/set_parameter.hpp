// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/params/params_for.hpp>
#include <hexagait/text/quantity.hpp>
#include <string>
#include <string_view>

namespace hexagait {

/// How the values of a parameter are written: lengths and times have units.
[[nodiscard]] Dimension dimension_of(const Parameter& parameter);

/// Is 0 a value of this parameter? It switches off what the parameter is about; of all others it would
/// be a mistake.
[[nodiscard]] bool may_be_zero(const Parameter& parameter);

/// The parameter of this name. @throws InvalidInput  naming the one that was probably meant
[[nodiscard]] const Parameter& parameter_named(std::string_view name);

/// Sets a parameter as users write it: "step.height=4cm".
/// @throws InvalidInput  if there is no such parameter, or the value is not greater than 0 and no 0
///                       that switches it off
void set_parameter(RobotParams& params, std::string_view text);

}  // namespace hexagait
