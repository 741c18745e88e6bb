// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/recording/detail/walk_json.hpp>
#include <hexagait/recording/provenance.hpp>

namespace hexagait::recording {

/// version, revision, compiler, libraries, and where there are any: robots, physics, controller.
[[nodiscard]] Json json(const Provenance& provenance);

}  // namespace hexagait::recording
