// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

namespace hexagait {

/// What an inclinometer reads: roll and pitch of the base against the vertical [rad]. NaN: it does not
/// measure this one.
struct Inclination {
  double roll = std::numeric_limits<double>::quiet_NaN();
  double pitch = std::numeric_limits<double>::quiet_NaN();  ///< > 0: nose down
};

}  // namespace hexagait
