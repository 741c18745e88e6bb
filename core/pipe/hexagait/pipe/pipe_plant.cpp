// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/pipe/detail/packet_socket.hpp>
#include <hexagait/pipe/pipe_plant.hpp>

namespace hexagait {

PipePlant::PipePlant(int socket, const RobotModel& robot, double control_dt)
    : socket_(socket), size_(size_of(robot)), control_dt_(control_dt) {}

PlantStatus PipePlant::read(Measurement& measurement) {
  if (closed_) return PlantStatus::closed;
  late_ = !detail::wait_for(socket_, late_ ? control_dt_ : kPatience);
  if (late_) return PlantStatus::late;
  StatePacket packet;
  Received received;
  const auto taken = detail::take_newest(socket_, PacketHeader::state, size_, packet, received);
  if (taken == detail::Taken::end) return close(received);
  if (taken == detail::Taken::nothing) return PlantStatus::late;
  measurement = measurement_from(packet);
  return PlantStatus::fresh;
}

void PipePlant::write(const JointTargets& targets) {
  const TargetPacket packet = target_packet(targets, stopped_, size_);
  if (!closed_ && !detail::send_packet(socket_, packet)) (void)close({});
}

PlantStatus PipePlant::close(const Received& received) {
  closed_ = true;
  last_ = received;
  return PlantStatus::closed;
}

std::string PipePlant::problem() const {
  if (!closed_) return {};
  return why_no_packet(last_, sizeof(StatePacket), PacketHeader::state, size_);
}

}  // namespace hexagait
