// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/replay_output.hpp"

#include <hexagait/viewer/replay/walk_recorder.hpp>

#include "files/replay_files.hpp"
#include "terminal/output.hpp"

namespace hexagait::app {

class ReplayOutput::Impl {
 public:
  Impl(const std::string& record, const std::string& html) : files_(record, html) {}

  [[nodiscard]] const ReplayFiles& files() const { return files_; }

  void begin(const RobotModel& robot, const recording::Simulation& simulation) {
    write([&] { recorder_.emplace(files_.stream(), robot, simulation); });
  }

  template <class... Tick>
  void observe(const Tick&... tick) {
    write([&] { recorder_->observe(tick...); });
  }

  void finish() {
    write([&] { recorder_->finish(); });
    files_.finish(problem_);
  }

 private:
  void write(const std::function<void()>& what) {
    if (problem_.empty()) problem_ = write_problem(what);
  }

  ReplayFiles files_;
  std::optional<viewer::WalkRecorder> recorder_;
  std::string problem_;  // why the replay could not be written any further
};

ReplayOutput::ReplayOutput(const std::string& record, const std::string& html) {
  if (!record.empty() || !html.empty()) impl_ = std::make_unique<Impl>(record, html);
}
ReplayOutput::~ReplayOutput() = default;
ReplayOutput::ReplayOutput(ReplayOutput&&) noexcept = default;

std::vector<std::pair<const char*, const OutputFile*>> ReplayOutput::files() const {
  if (!impl_) return {};
  return impl_->files().files();
}

void ReplayOutput::begin(const RobotModel& robot, const recording::Simulation& simulation) {
  if (impl_) impl_->begin(robot, simulation);
}

void ReplayOutput::observe(const footstep_gen::TickRecord& record, const GroundTruth& truth,
                           const walk::Referee& referee, const sim3d::World& world) {
  if (impl_) impl_->observe(record, truth, referee, world);
}

void ReplayOutput::observe(const ActionRecord& record, const GroundTruth& truth,
                           const sim3d::World& world) {
  if (impl_) impl_->observe(record, truth, world);
}

void ReplayOutput::finish() {
  if (impl_) impl_->finish();
}

}  // namespace hexagait::app
