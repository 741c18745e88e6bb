// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "replay_output.hpp"

#include <fmt/format.h>

#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/page_files.hpp>
#include <hexagait/viewer/replay_page.hpp>
#include <hexagait/viewer/walk_recorder.hpp>
#include <sstream>

#include "output.hpp"

namespace hexagait::app {

class ReplayOutput::Impl {
 public:
  Impl(const std::string& record, const std::string& html)
      : record_(output_file("--record", record, {".replay"})),
        html_(output_file("--html", html, {".html"})) {
    if (html_ && viewer::page_files().empty())
      throw InvalidInput(fmt::format("--html: {}", viewer::kNoPage));
    if (record_ && !html_) file_ = record_->files.open(record_->path.filename());
  }

  [[nodiscard]] std::vector<std::pair<const char*, const OutputFile*>> files() const {
    std::vector<std::pair<const char*, const OutputFile*>> all;
    if (record_) all.emplace_back("--record", &*record_);
    if (html_) all.emplace_back("--html", &*html_);
    return all;
  }

  // A page has all of the replay in it, so it is kept; else it goes to its file as it comes.
  void begin(const RobotModel& robot, const recording::Simulation& simulation) {
    write([&] {
      std::ostream& out = html_ ? static_cast<std::ostream&>(kept_) : file_;
      recorder_.emplace(out, robot, simulation);
    });
  }

  template <class... Tick>
  void observe(const Tick&... tick) {
    write([&] { recorder_->observe(tick...); });
  }

  void finish() {
    write([&] { recorder_->finish(); });
    if (!problem_.empty()) refuse_output("--record", *record_, problem_);
    if (html_) write_text("--html", *html_, viewer::replay_page(kept_.view()));
    if (html_ && record_) write_text("--record", *record_, kept_.view());
    if (html_ || !record_) return;
    write_output("--record", *record_, [&] {
      file_.close();
      record_->files.publish();
    });
  }

 private:
  void write(const std::function<void()>& what) {
    if (problem_.empty()) problem_ = write_problem(what);
  }

  std::optional<OutputFile> record_, html_;
  std::ofstream file_;
  std::ostringstream kept_;
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
  return impl_->files();
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
