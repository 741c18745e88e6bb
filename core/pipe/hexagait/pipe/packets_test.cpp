// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <hexagait/pipe/packets.hpp>
#include <string>

namespace hexagait {
namespace {

using ::testing::HasSubstr;

constexpr RobotSize kSize{.legs = 6, .joints = 18};

// Of which no two values are the same.
LegArray<LegJoints> joints(double first) {
  LegArray<LegJoints> all(6);
  for (LegJoints& leg : all)
    for (double& value : leg) value = first += 0.01;
  return all;
}

Received received(const void* packet, std::size_t bytes) {
  Received result{.bytes = bytes, .header = {}};
  std::memcpy(static_cast<void*>(&result.header), packet, std::min(bytes, sizeof result.header));
  return result;
}

TEST(Packets, CarryAMeasurement) {
  Measurement m{.time = 1.5, .q = joints(0.0), .contact = LegArray<bool>(6, false)};
  m.contact[2] = m.contact[5] = true;
  const Measurement plain = measurement_from(state_packet(m, kSize));
  EXPECT_EQ(plain.time, 1.5);
  ASSERT_EQ(plain.q.size(), 6);
  for (LegId i = 0; i < 6; ++i) {
    EXPECT_EQ(plain.q[i], m.q[i]);
    EXPECT_EQ(plain.contact[i], m.contact[i]);
  }
  EXPECT_TRUE(std::isnan(plain.inclination.roll) && std::isnan(plain.inclination.pitch));
  EXPECT_FALSE(plain.imu);

  m.inclination = {.roll = 0.1, .pitch = -0.2};
  m.imu = InertialMeasurement{.acceleration = {1.0, 2.0, 9.0}, .rate = {0.3, 0.4, 0.5}};
  const Measurement all = measurement_from(state_packet(m, kSize));
  EXPECT_EQ(all.inclination.roll, 0.1);
  EXPECT_EQ(all.inclination.pitch, -0.2);
  ASSERT_TRUE(all.imu);
  EXPECT_EQ(all.imu->acceleration, m.imu->acceleration);
  EXPECT_EQ(all.imu->rate, m.imu->rate);
}

TEST(Packets, CarryTargets) {
  JointTargets targets{.q = joints(0.0), .qd = joints(2.0), .effort = joints(4.0)};
  const TargetPacket by_position = target_packet(targets, false, kSize);
  EXPECT_EQ(by_position.stopped, 0.0);
  EXPECT_EQ(targets_from(by_position).mode[3], ControlMode::position);

  targets.mode = LegArray<ControlMode>(6, ControlMode::effort);
  targets.mode[4] = ControlMode::velocity;
  const TargetPacket packet = target_packet(targets, true, kSize);
  EXPECT_EQ(packet.stopped, 1.0);
  const JointTargets same = targets_from(packet);
  for (LegId i = 0; i < 6; ++i) {
    EXPECT_EQ(same.q[i], targets.q[i]);
    EXPECT_EQ(same.qd[i], targets.qd[i]);
    EXPECT_EQ(same.effort[i], targets.effort[i]);
    EXPECT_EQ(same.mode[i], targets.mode[i]);
  }
}

TEST(Packets, OfAnotherProgramAreNamed) {
  const auto why = [](const void* packet, std::size_t bytes) {
    const Received came = received(packet, bytes);
    EXPECT_FALSE(is_packet(came, sizeof(StatePacket), PacketHeader::state, kSize));
    return why_no_packet(came, sizeof(StatePacket), PacketHeader::state, kSize);
  };
  StatePacket good{.header = {.size = kSize}};
  EXPECT_TRUE(is_packet(received(&good, sizeof good), sizeof good, PacketHeader::state, kSize));

  EXPECT_THAT(why("hello\n", 6), HasSubstr("sent 6 bytes, beginning with \"hello\","));
  EXPECT_THAT(why("hello\n", 6), HasSubstr("standard error"));
  EXPECT_THAT(why(&good, sizeof good - 8),
              HasSubstr("it must have " + std::to_string(sizeof good)));
  StatePacket old = good;
  old.header.version = 7;
  EXPECT_THAT(why(&old, sizeof old), HasSubstr("speaks version 7 of the packets"));
  StatePacket other = good;
  other.header.size = {.legs = 4, .joints = 12};
  EXPECT_THAT(why(&other, sizeof other),
              HasSubstr("is of 4 legs and 12 joints, this end of 6 legs and 18 joints"));
  const TargetPacket targets{.header = {.kind = PacketHeader::targets, .size = kSize}};
  EXPECT_THAT(why(&targets, sizeof targets), HasSubstr("wrong kind"));
}

}  // namespace
}  // namespace hexagait
