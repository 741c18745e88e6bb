// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/pipe/packets.hpp>

namespace hexagait {

/// The robot's end of the pipe, for a program that drives a robot or simulates one: it sends what is
/// measured in each control period, and takes the targets.
class PipeRobot {
 public:
  enum class Heard : std::uint8_t {
    targets,  ///< new ones
    nothing,  ///< the last ones stay
    closed,   ///< the controller is gone, or is of another robot: problem()
  };

  /// @param in, out  what the program was started with: STDIN_FILENO and STDOUT_FILENO
  PipeRobot(int in, int out, RobotSize size) : in_(in), out_(out), size_(size) {}

  /// Never waits. @returns false if the controller is gone; its last targets may still wait for receive()
  bool send(const Measurement& measurement) noexcept;

  /// Waits for targets for up to so long [s]. Of several that have come it takes the newest.
  [[nodiscard]] Heard receive(double patience) noexcept;

  [[nodiscard]] const JointTargets& targets() const { return targets_; }  ///< the last ones
  /// Told with them: an emergency stop, a fault, or the end of the walk.
  [[nodiscard]] bool stopped() const { return stopped_; }

  /// Why it is closed, as "closed the pipe"; empty: it is not.
  [[nodiscard]] std::string problem() const;

 private:
  int in_, out_;
  RobotSize size_;
  JointTargets targets_;
  bool stopped_ = false, closed_ = false;
  Received last_;
};

}  // namespace hexagait
