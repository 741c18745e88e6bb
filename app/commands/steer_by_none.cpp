// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/text/invalid_input.hpp>

#include "commands/commands.hpp"
#include "files/replay_output.hpp"
#include "options/replay_options.hpp"
#include "options/steer_options.hpp"

namespace hexagait::app {
namespace {

[[noreturn]] void refuse(const char* what) {
  throw InvalidInput(fmt::format(
      "{}: this hexagait was built without libwebsockets and zlib; install them (Debian: apt-get "
      "install libwebsockets-dev zlib1g-dev nodejs npm), configure with -DHEXAGAIT_VIEWER=ON and "
      "build again, or take ./run steer, which does that",
      what));
}

}  // namespace

int steer_command(const SteerArguments& /*arguments*/) { refuse("steer"); }

int teleop_command(const WalkArguments& /*arguments*/) { refuse("--teleop"); }

int replay_command(const ReplayArguments& /*arguments*/) { refuse("replay"); }

class ReplayOutput::Impl {};

ReplayOutput::ReplayOutput(const std::string& record, const std::string& html) {
  if (!record.empty()) refuse("--record");
  if (!html.empty()) refuse("--html");
}
ReplayOutput::~ReplayOutput() = default;
ReplayOutput::ReplayOutput(ReplayOutput&&) noexcept = default;

std::vector<std::pair<const char*, const OutputFile*>> ReplayOutput::files() const { return {}; }

void ReplayOutput::begin(const RobotModel& /*robot*/, const recording::Simulation& /*simulation*/) {
}

void ReplayOutput::observe(const footstep_gen::TickRecord& /*record*/, const GroundTruth& /*truth*/,
                           const walk::Referee& /*referee*/, const sim3d::World& /*world*/) {}

void ReplayOutput::observe(const ActionRecord& /*record*/, const GroundTruth& /*truth*/,
                           const sim3d::World& /*world*/) {}

void ReplayOutput::finish() {}

}  // namespace hexagait::app
