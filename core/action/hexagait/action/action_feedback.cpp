// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/action/action_feedback.hpp>

namespace hexagait {

const char* to_string(ActionStatus status) noexcept {
  switch (status) {
    case ActionStatus::idle:
      return "idle";
    case ActionStatus::executing:
      return "executing";
    case ActionStatus::paused:
      return "paused";
    case ActionStatus::regaining:
      return "regaining contact";
    case ActionStatus::stopping:
      return "stopping";
  }
  return "?";
}

const char* to_string(Outcome outcome) noexcept {
  switch (outcome) {
    case Outcome::none:
      return "none";
    case Outcome::succeeded:
      return "succeeded";
    case Outcome::preempted:
      return "preempted";
    case Outcome::failed:
      return "failed";
  }
  return "?";
}

const char* to_string(Cause cause) noexcept {
  switch (cause) {
    case Cause::none:
      return "none";
    case Cause::no_contact:
      return "no contact";
    case Cause::lost_contact:
      return "lost contact";
    case Cause::out_of_reach:
      return "out of reach";
    case Cause::unstable:
      return "unstable";
    case Cause::not_finite:
      return "not finite";
    case Cause::plant:
      return "plant";
  }
  return "?";
}

}  // namespace hexagait
