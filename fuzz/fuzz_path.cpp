// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <hexagait/params/params_for.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/walk/paths/path_file.hpp>
#include <testing/argos.hpp>

namespace hexagait {
namespace {

// What a pilot counts on, all along the first lap.
bool is_sound(const path_following::Path& path) {
  constexpr int kPlaces = 64;
  for (int k = 0; k <= kPlaces; ++k) {
    const double s = path.length() * k / kPlaces;
    if (!path.at(s).allFinite() || !std::isfinite(path.direction(s)) || !(path.speed(s) > 0.0))
      return false;
    if (path.has_facing() && !std::isfinite(path.facing(s))) return false;
  }
  return path.length() > 0.0 && std::isfinite(path.length());
}

}  // namespace
}  // namespace hexagait

// Whatever the bytes: a path that a robot can follow, or InvalidInput with a message.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hexagait;
  static const RobotModel& model = testing::argos();
  static const StepParams step = params_for(model).step;
  try {
    const std::string text(reinterpret_cast<const char*>(data), size);
    if (!is_sound(walk::parse_path(text, "fuzz.yaml", model, step).path)) std::abort();
  } catch (const InvalidInput& error) {
    if (error.what()[0] == '\0') std::abort();
  }
  return 0;
}
