// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <hexagait/plant/plant.hpp>
#include <limits>
#include <string>
#include <string_view>

/// What a controller and a robot in another process tell each other: two structs of fixed size, over a
/// pipe that keeps packets apart (a pair of SOCK_SEQPACKET sockets). The robot sends a StatePacket in each
/// control period and gets a TargetPacket back. Both are written as they lie in memory, so both processes
/// run on machines of the same byte order.
namespace hexagait {

/// Of all joints of a robot; leg by leg, in the order of the model's legs. Every leg has kMaxLegJoints
/// places, hip to foot; places of joints that it does not have are 0.
using JointValues = std::array<double, static_cast<std::size_t>(kMaxLegJoints) * kMaxLegs>;

/// How many legs and joints a robot has: both ends must agree.
struct RobotSize {
  std::uint32_t legs = 0, joints = 0;
  bool operator==(const RobotSize&) const = default;
};
[[nodiscard]] RobotSize size_of(const RobotModel& robot);

/// How each packet begins, so that a program that speaks something else is named rather than misread.
struct PacketHeader {
  enum Kind : std::uint32_t { state = 1, targets = 2 };
  static constexpr std::array<char, 8> kMagic = {'h', 'e', 'x', 'a', 'g', 'a', 'i', 't'};
  static constexpr std::uint32_t kVersion = 1;

  std::array<char, 8> magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t kind = state;
  RobotSize size = {};
};

/// From the robot: a Measurement.
struct StatePacket {
  PacketHeader header = {};
  double time = 0.0;                          ///< the robot's clock [s]
  JointValues q = {};                         ///< [rad]
  std::array<double, kMaxLegs> contact = {};  ///< 1: the foot presses on something; else 0
  /// Of an inclinometer [rad]; NaN: there is none.
  double roll = std::numeric_limits<double>::quiet_NaN();
  double pitch = std::numeric_limits<double>::quiet_NaN();
  double has_imu = 0.0;                     ///< 1: the two below are measured
  std::array<double, 3> acceleration = {};  ///< less gravity, axes of the body [m/s²]
  std::array<double, 3> rate = {};          ///< angular velocity, axes of the body [rad/s]
};

/// To the robot: JointTargets.
struct TargetPacket {
  PacketHeader header{.kind = PacketHeader::targets};
  /// 1: an emergency stop, a fault, or the end of the walk. Targets are held; the robot may brake, or cut
  /// its power.
  double stopped = 0.0;
  JointValues q = {};                      ///< at the end of the period [rad]
  JointValues qd = {};                     ///< [rad/s]
  JointValues effort = {};                 ///< [N m]
  std::array<double, kMaxLegs> mode = {};  ///< ControlMode of each leg
};

[[nodiscard]] StatePacket state_packet(const Measurement& measurement, RobotSize size) noexcept;
[[nodiscard]] Measurement measurement_from(const StatePacket& packet) noexcept;
[[nodiscard]] TargetPacket target_packet(const JointTargets& targets, bool stopped,
                                         RobotSize size) noexcept;
[[nodiscard]] JointTargets targets_from(const TargetPacket& packet) noexcept;

/// What came in place of a packet.
struct Received {
  std::size_t bytes = 0;     ///< its length
  PacketHeader header = {};  ///< its beginning
};

/// Is this a packet of that kind, of a robot of that size?
/// @param length  of such a packet
[[nodiscard]] bool is_packet(const Received& received, std::size_t length, PacketHeader::Kind kind,
                             RobotSize size) noexcept;

/// Why it is none, in words: "sent 12 bytes, \"Hello world\", that are no packet …"; without any bytes
/// "closed the pipe".
[[nodiscard]] std::string why_no_packet(const Received& received, std::size_t length,
                                        PacketHeader::Kind kind, RobotSize size);

}  // namespace hexagait
