// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/math/leg.hpp>

namespace hexagait {

enum class ActionStatus : std::uint8_t {
  idle,       ///< no action
  executing,  ///< a step is under way
  paused,     ///< by pause()
  regaining,  ///< a support leg has lost the ground and searches for it; everything else waits
  stopping,   ///< the action has ended; what is in the air and is to stand goes down
};

enum class Outcome : std::uint8_t { none, succeeded, preempted, failed };

/// Why an action failed.
enum class Cause : std::uint8_t {
  none,
  no_contact,    ///< a foot found no ground as far as its leg reaches, or in time
  lost_contact,  ///< a support leg lost the ground and did not find it again
  out_of_reach,  ///< a foot or the base is to go where the legs don't reach
  unstable,      ///< the legs that would stand in the step don't carry the centre of mass
  plant,         ///< the robot fell silent, sent nonsense or was stopped
};

[[nodiscard]] const char* to_string(ActionStatus status) noexcept;
[[nodiscard]] const char* to_string(Outcome outcome) noexcept;
[[nodiscard]] const char* to_string(Cause cause) noexcept;

/// How far an action is, every tick. Of fixed size.
struct ActionFeedback {
  std::uint64_t action = 0;  ///< number of the action, from 1 in the order of their start
  int step = 0;              ///< under way, from 1; 0: none
  int steps = 0;             ///< of the action
  int queue = 0;             ///< steps still to come after this one
  ActionStatus status = ActionStatus::idle;
  const char* description = "";  ///< for people: "Regaining contact"; a literal
  double duration = 0.0;         ///< of the step, as planned [s]
  double phase = 0.0;            ///< 0 … 1 of that
  LegSet moving;                 ///< legs that have a motion in this step
};

/// How an action ended.
struct ActionResult {
  std::uint64_t action = 0;  ///< its number; 0: none has ended
  Outcome outcome = Outcome::none;
  Cause cause = Cause::none;
  int step = 0;    ///< in which it ended, from 1
  LegId leg = -1;  ///< that caused it; -1: none
};

}  // namespace hexagait
