// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/pipe/detail/packet_socket.hpp>
#include <hexagait/pipe/pipe_robot.hpp>

namespace hexagait {

bool PipeRobot::send(const Measurement& measurement) noexcept {
  return !closed_ && detail::send_packet(out_, state_packet(measurement, size_));
}

PipeRobot::Heard PipeRobot::receive(double patience) noexcept {
  if (closed_) return Heard::closed;
  if (!detail::wait_for(in_, patience)) return Heard::nothing;
  TargetPacket packet;
  const auto taken = detail::take_newest(in_, PacketHeader::targets, size_, packet, last_);
  if (taken == detail::Taken::nothing) return Heard::nothing;
  closed_ = taken == detail::Taken::end;
  if (closed_) return Heard::closed;
  targets_ = targets_from(packet);
  stopped_ = packet.stopped != 0.0;
  return Heard::targets;
}

std::string PipeRobot::problem() const {
  if (!closed_) return {};
  return why_no_packet(last_, sizeof(TargetPacket), PacketHeader::targets, size_);
}

}  // namespace hexagait
