// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/executor/leg_lane.hpp>

namespace hexagait {

const char* to_string(LegPhase phase) noexcept {
  switch (phase) {
    case LegPhase::support:
      return "support";
    case LegPhase::unload:
      return "unload";
    case LegPhase::lift:
      return "lift";
    case LegPhase::transfer:
      return "transfer";
    case LegPhase::descend:
      return "descend";
    case LegPhase::retreat:
      return "retreat";
    case LegPhase::follow:
      return "follow";
    case LegPhase::search:
      return "search";
    case LegPhase::hold:
      return "hold";
  }
  return "?";
}

}  // namespace hexagait
