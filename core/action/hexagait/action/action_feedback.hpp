// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/math/leg.hpp>

namespace hexagait {

enum class ActionStatus : std::uint8_t {
  idle,       ///< no action
  executing,  ///< a step is being executed
  paused,     ///< by pause()
  regaining,  ///< a support leg has lost the ground and searches for it; everything else waits
  stopping,   ///< the action has ended; feet in the air are lowered to the ground
};

enum class Outcome : std::uint8_t { none, succeeded, preempted, failed };

/// Why an action failed.
enum class Cause : std::uint8_t {
  none,
  no_contact,    ///< a foot found no ground within its leg's reach, or in time
  lost_contact,  ///< a support leg lost the ground and did not find it again
  out_of_reach,  ///< a foot or the base should go where the legs cannot reach
  unstable,      ///< the centre of mass would be outside the support polygon of the step
  /// A number of a command, or of the pose of a frame, is not finite, or so large that the motion
  /// would not be.
  not_finite,
  plant,  ///< the plant or the controller has a Fault
};

[[nodiscard]] const char* to_string(ActionStatus status) noexcept;
[[nodiscard]] const char* to_string(Outcome outcome) noexcept;
[[nodiscard]] const char* to_string(Cause cause) noexcept;

/// The progress of an action, every tick. Of fixed size.
struct ActionFeedback {
  std::uint64_t action = 0;  ///< number of the action, counted from 1
  int step = 0;              ///< present step, from 1; 0: none
  int steps = 0;             ///< number of steps of the action
  int queue = 0;             ///< steps after this one
  ActionStatus status = ActionStatus::idle;
  const char* description = "";  ///< status text, for example "Regaining contact"; a literal
  double duration = 0.0;         ///< planned duration of the step [s]
  double phase = 0.0;            ///< progress of the step, 0 … 1
  LegSet moving;                 ///< legs with a motion in this step
};

/// How an action ended.
struct ActionResult {
  std::uint64_t action = 0;  ///< its number; 0: none has ended
  Outcome outcome = Outcome::none;
  Cause cause = Cause::none;
  int step = 0;    ///< step in which it ended, from 1
  LegId leg = -1;  ///< leg that caused the failure; -1: none
};

}  // namespace hexagait
