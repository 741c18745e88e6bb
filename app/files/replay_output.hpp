// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/experiments/experiment.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "files/output_file.hpp"

namespace hexagait::app {

/// The replay that --record and --html write of what is simulated, or none.
class ReplayOutput : public experiments::Spectator {
 public:
  /// @param record, html  names of the files; empty: none
  /// @throws InvalidInput  for a name that can't be written, or if this hexagait has no viewer, or
  ///                       no page for --html
  ReplayOutput(const std::string& record, const std::string& html);
  ~ReplayOutput() override;
  ReplayOutput(ReplayOutput&&) noexcept;
  ReplayOutput& operator=(ReplayOutput&&) = delete;

  [[nodiscard]] bool wanted() const { return impl_ != nullptr; }
  /// Options and their files.
  [[nodiscard]] std::vector<std::pair<const char*, const OutputFile*>> files() const;

  void begin(const RobotModel& robot, const recording::Simulation& simulation) override;
  /// What can't be written is told in the end.
  void observe(const footstep_gen::TickRecord& record, const GroundTruth& truth,
               const walk::Referee& referee, const sim3d::World& world) override;
  void observe(const ActionRecord& record, const GroundTruth& truth,
               const sim3d::World& world) override;
  /// @throws InvalidInput  naming the file that could not be written
  void finish();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hexagait::app
