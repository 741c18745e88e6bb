// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/pipe/packets.hpp>
#include <type_traits>

namespace hexagait {
namespace {

// No gaps: every byte of a packet is one of these.
static_assert(std::is_trivially_copyable_v<StatePacket> &&
              sizeof(StatePacket) ==
                  sizeof(PacketHeader) + sizeof(JointValues) + (10 + kMaxLegs) * sizeof(double));
static_assert(std::is_trivially_copyable_v<TargetPacket> &&
              sizeof(TargetPacket) ==
                  sizeof(PacketHeader) + 3 * sizeof(JointValues) + (1 + kMaxLegs) * sizeof(double));

std::size_t place(LegId leg, int joint) {
  return static_cast<std::size_t>(kMaxLegJoints * leg + joint);
}

void put(const LegArray<LegJoints>& joints, JointValues& values) {
  for (LegId i = 0; i < joints.size(); ++i)
    for (int k = 0; k < joints[i].size(); ++k) values[place(i, k)] = joints[i][k];
}

LegArray<LegJoints> joints_from(const JointValues& values, int legs) {
  LegArray<LegJoints> joints(legs);
  for (LegId i = 0; i < legs; ++i) joints[i] = LegJoints(values.data() + place(i, 0));
  return joints;
}

int legs_of(const PacketHeader& header) {
  return static_cast<int>(std::min<std::uint32_t>(header.size.legs, kMaxLegs));
}

ControlMode mode_from(double number) {
  if (number == 1.0) return ControlMode::velocity;
  return number == 2.0 ? ControlMode::effort : ControlMode::position;
}

std::string in_words(RobotSize size) {
  return std::to_string(size.legs) + " legs and " + std::to_string(size.joints) + " joints";
}

// Its beginning, as far as it can be printed.
std::string beginning(const Received& received) {
  std::string text;
  for (const char c : received.header.magic) {
    if (text.size() == received.bytes || c < ' ' || c > '~') break;
    text += c;
  }
  return text.empty() ? "" : ", beginning with \"" + text + "\",";
}

}  // namespace

RobotSize size_of(const RobotModel& robot) {
  RobotSize size{.legs = static_cast<std::uint32_t>(robot.num_legs())};
  for (const LegModel& leg : robot.legs)
    size.joints += static_cast<std::uint32_t>(leg.num_joints());
  return size;
}

StatePacket state_packet(const Measurement& m, RobotSize size) noexcept {
  StatePacket packet{.header = {.size = size}, .time = m.time};
  put(m.q, packet.q);
  for (LegId i = 0; i < m.contact.size(); ++i)
    packet.contact[static_cast<std::size_t>(i)] = m.contact[i] ? 1.0 : 0.0;
  packet.roll = m.inclination.roll;
  packet.pitch = m.inclination.pitch;
  if (!m.imu) return packet;
  packet.has_imu = 1.0;
  Eigen::Map<Vector3>(packet.acceleration.data()) = m.imu->acceleration;
  Eigen::Map<Vector3>(packet.rate.data()) = m.imu->rate;
  return packet;
}

Measurement measurement_from(const StatePacket& packet) noexcept {
  const int legs = legs_of(packet.header);
  Measurement m{
      .time = packet.time, .q = joints_from(packet.q, legs), .contact = LegArray<bool>(legs)};
  for (LegId i = 0; i < legs; ++i) m.contact[i] = packet.contact[static_cast<std::size_t>(i)] > 0.5;
  m.inclination = {.roll = packet.roll, .pitch = packet.pitch};
  if (packet.has_imu != 0.0)
    m.imu = InertialMeasurement{.acceleration = Vector3(packet.acceleration.data()),
                                .rate = Vector3(packet.rate.data())};
  return m;
}

TargetPacket target_packet(const JointTargets& targets, bool stopped, RobotSize size) noexcept {
  TargetPacket packet{.header = {.kind = PacketHeader::targets, .size = size},
                      .stopped = stopped ? 1.0 : 0.0};
  put(targets.q, packet.q);
  put(targets.qd, packet.qd);
  put(targets.effort, packet.effort);
  for (LegId i = 0; i < targets.mode.size(); ++i)
    packet.mode[static_cast<std::size_t>(i)] = static_cast<double>(targets.mode[i]);
  return packet;
}

JointTargets targets_from(const TargetPacket& packet) noexcept {
  const int legs = legs_of(packet.header);
  JointTargets targets{.q = joints_from(packet.q, legs),
                       .qd = joints_from(packet.qd, legs),
                       .effort = joints_from(packet.effort, legs),
                       .mode = LegArray<ControlMode>(legs)};
  for (LegId i = 0; i < legs; ++i)
    targets.mode[i] = mode_from(packet.mode[static_cast<std::size_t>(i)]);
  return targets;
}

bool is_packet(const Received& received, std::size_t length, PacketHeader::Kind kind,
               RobotSize size) noexcept {
  const PacketHeader& header = received.header;
  return received.bytes == length && header.magic == PacketHeader::kMagic &&
         header.version == PacketHeader::kVersion && header.kind == kind && header.size == size;
}

std::string why_no_packet(const Received& received, std::size_t length, PacketHeader::Kind kind,
                          RobotSize size) {
  const PacketHeader& header = received.header;
  if (received.bytes == 0) return "closed the pipe";
  if (received.bytes < sizeof header || header.magic != PacketHeader::kMagic)
    return "sent " + std::to_string(received.bytes) + " bytes" + beginning(received) +
           " that are no packet of a robot; its standard output is the pipe, so it must print to "
           "its standard error";
  if (header.version != PacketHeader::kVersion)
    return "speaks version " + std::to_string(header.version) +
           " of the packets of hexagait, this end version " +
           std::to_string(PacketHeader::kVersion) + "; build both from the same hexagait";
  if (!(header.size == size))
    return "is of " + in_words(header.size) + ", this end of " + in_words(size) +
           "; start both with the same robot";
  if (header.kind != kind) return "sends packets of the wrong kind: is it a controller?";
  return "sent a packet of " + std::to_string(received.bytes) + " bytes; it must have " +
         std::to_string(length);
}

}  // namespace hexagait
