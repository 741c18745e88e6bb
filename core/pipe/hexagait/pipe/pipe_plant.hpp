// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/pipe/packets.hpp>

namespace hexagait {

/// A robot in another process, as a Plant: the controller's end of the pipe. The other end is a PipeRobot,
/// or any program that sends and takes the structs of packets.hpp.
class PipePlant : public Plant {
 public:
  /// Wait for a state, after which the first one is late [s]. The next ones are late after a control period.
  static constexpr double kPatience = 0.02;

  /// @param socket      stays the caller's, which keeps it open, as RobotProcess does
  /// @param control_dt  [s]
  PipePlant(int socket, const RobotModel& robot, double control_dt);

  /// Waits for the robot's next state: the robot owns the clock. Of several that have come it takes the
  /// newest.
  PlantStatus read(Measurement& measurement) override;

  /// Never waits: if the robot reads nothing, targets are lost.
  void write(const JointTargets& targets) override;

  /// From the next write() on the robot is told that it is stopped, or that it no longer is.
  void set_stopped(bool stopped) { stopped_ = stopped; }

  /// Why the pipe is closed, as "sent 6 bytes …" or "closed the pipe"; empty: it is open.
  [[nodiscard]] std::string problem() const;

 private:
  [[nodiscard]] PlantStatus close(const Received& received);

  int socket_;
  RobotSize size_;
  double control_dt_;
  bool stopped_ = false, late_ = false, closed_ = false;
  Received last_;  ///< when it was closed; without bytes the other end has gone
};

}  // namespace hexagait
