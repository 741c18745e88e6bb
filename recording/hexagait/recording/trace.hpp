// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/walk/trial.hpp>
#include <iosfwd>

namespace hexagait::recording {

/// The first line of a trace: names of the columns, with their units.
void write_trace_header(std::ostream& out, const RobotModel& robot);

/// One tick as one line of comma-separated values.
void write_trace_row(std::ostream& out, const footstep_gen::TickRecord& record,
                     const GroundTruth& truth, const walk::Referee& referee);

}  // namespace hexagait::recording
