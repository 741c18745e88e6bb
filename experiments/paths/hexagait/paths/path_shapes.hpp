// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/path_following/path.hpp>

namespace hexagait::experiments {

/// The paths of paths/, which a library can't open: closed, from the origin, straight ahead.
/// @param size  of the robot [m]
[[nodiscard]] path_following::Path figure_eight(double size);
[[nodiscard]] path_following::Path square(double size);

}  // namespace hexagait::experiments
