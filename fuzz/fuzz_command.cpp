// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <hexagait/viewer/steering/command.hpp>

namespace hexagait::viewer {
namespace {

bool is_sound(const Drive& drive) {
  const auto& h = drive.heading;
  return drive.limit >= 0.0 && std::isfinite(h.crab_angle()) && h.rho() >= 0.0 &&
         std::abs(h.rho() * h.rho() + h.k() * h.k() - 1.0) < 1e-9;
}
bool is_sound(const DriveTwist& drive) {
  return drive.twist.v.allFinite() && std::isfinite(drive.twist.w) &&
         drive.twist.v.cwiseAbs().maxCoeff() <= 10.0 && std::abs(drive.twist.w) <= 10.0;
}
bool is_sound(const Follow& follow) {
  for (const Vector2& p : follow.points_W)
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() > 1e5) return false;
  return follow.limit >= 0.0 && follow.points_W.size() <= kMostPathPoints &&
         follow.name.empty() == (follow.points_W.size() >= 2) && follow.name.size() <= 64;
}
bool is_sound(const Perform& perform) {
  return !perform.name.empty() && perform.name.size() <= 64 && perform.yaml.size() <= kMaxAction;
}
bool is_sound(const SingleStep& step) { return step.ticks >= 1 && step.ticks <= 500; }
bool is_sound(const SpeedFactor& speed) { return speed.factor >= 0.05 && speed.factor <= 10.0; }
bool is_sound(const Push& push) { return std::abs(push.angle) < 7.0; }
bool is_sound(const ChangeGait& gait) {
  return gait.stepper.duty_factor >= 0.5 && gait.stepper.duty_factor < 1.0;
}
bool is_sound(const Race& race) {
  if (!race.rival) return true;
  const double duty_factor = race.rival->stepper.duty_factor;
  return duty_factor >= 0.5 && duty_factor < 1.0;
}
bool is_sound(const Break& one) {
  const walk::PartFault& f = one.fault;
  return std::isfinite(f.value) && f.place.allFinite() && std::isfinite(f.direction) &&
         f.start <= 0.0 && f.text.size() <= 64;
}
bool is_sound(const ChangePlant& change) { return change.preset != nullptr; }
bool is_sound(const Restart& restart) {
  return (!restart.terrain || restart.terrain->roughness() <= kMaxTerrain) &&
         (!restart.robot || restart.robot->size() <= 64);
}
template <class Plain>
bool is_sound(const Plain& /*plain*/) {
  return true;
}

}  // namespace
}  // namespace hexagait::viewer

// Whatever the bytes: a command within its ranges, or an error with words.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hexagait::viewer;
  const auto result = parse_command({reinterpret_cast<const char*>(data), size});
  if (const auto* error = std::get_if<CommandError>(&result)) {
    if (error->what.empty()) std::abort();
    return 0;
  }
  if (!std::visit([](const auto& one) { return is_sound(one); }, std::get<Command>(result)))
    std::abort();
  return 0;
}
