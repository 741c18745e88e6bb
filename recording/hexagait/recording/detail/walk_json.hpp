// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <hexagait/recording/json.hpp>
#include <hexagait/recording/provenance.hpp>
#include <nlohmann/json.hpp>
#include <string>

namespace hexagait::recording {

using Json = nlohmann::ordered_json;

/// JSON has no infinity and no NaN: such a number is null.
[[nodiscard]] inline Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}
/// An empty optional is null.
template <class T>
[[nodiscard]] Json json_of(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// Its name, and all its numbers with their units.
[[nodiscard]] Json json(const PlantSetup& plant);

/// What decides how a walk goes; how it went; how long that took.
[[nodiscard]] Json configuration(const WalkReport& report);
[[nodiscard]] Json results(const WalkReport& report);
[[nodiscard]] Json results(const walk::Summary& summary);
[[nodiscard]] Json timing(const walk::Summary& summary);

/// version, revision, compiler, libraries, and where there are any: robots, physics, controller.
[[nodiscard]] Json json(const Provenance& provenance);

[[nodiscard]] inline std::string hex(std::uint64_t value) { return fmt::format("{:016x}", value); }

}  // namespace hexagait::recording
