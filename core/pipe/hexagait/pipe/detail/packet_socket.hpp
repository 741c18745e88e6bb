// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <hexagait/pipe/packets.hpp>

namespace hexagait::detail {

/// Waits for something to read, an end too. @returns false if nothing came for so long [s]
inline bool wait_for(int socket, double seconds) noexcept {
  pollfd ready{socket, POLLIN, 0};
  const int milliseconds = std::max(0, static_cast<int>(std::ceil(1e3 * seconds - 1e-6)));
  int count = 0;
  do count = poll(&ready, 1, milliseconds);
  while (count < 0 && errno == EINTR);
  return count != 0;
}

enum class Taken : std::uint8_t { packet, nothing, end };

/// Takes what has come, without waiting. The other end may have left without reading all that it was sent
/// (ECONNRESET, told once); what it had sent before can still be taken.
/// @param packet  its bytes, as far as there is room for them
template <class Packet>
Taken take(int socket, Packet& packet, Received& received) noexcept {
  ssize_t count = 0;
  do count = recv(socket, &packet, sizeof packet, MSG_DONTWAIT | MSG_TRUNC);
  while (count < 0 && (errno == EINTR || errno == ECONNRESET));
  received = {};
  if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return Taken::nothing;
  if (count <= 0) return Taken::end;
  received.bytes = static_cast<std::size_t>(count);
  received.header.magic = {};
  std::memcpy(static_cast<void*>(&received.header), &packet,
              std::min(received.bytes, sizeof received.header));
  return Taken::packet;
}

/// Takes the newest packet of those that have come. @returns end if one of them is none, or there will be
/// no more; `received` is then what came in its place
template <class Packet>
Taken take_newest(int socket, PacketHeader::Kind kind, RobotSize size, Packet& newest,
                  Received& received) noexcept {
  Packet packet;
  for (Taken all = Taken::nothing;; all = Taken::packet) {
    const Taken one = take(socket, packet, received);
    if (one == Taken::nothing || (one == Taken::end && all == Taken::packet)) return all;
    if (one == Taken::end || !is_packet(received, sizeof packet, kind, size)) return Taken::end;
    newest = packet;
  }
}

/// @returns false if there is nobody at the other end; what there is no room for is lost
template <class Packet>
bool send_packet(int socket, const Packet& packet) noexcept {
  ssize_t count = 0;
  do count = send(socket, &packet, sizeof packet, MSG_NOSIGNAL | MSG_DONTWAIT);
  while (count < 0 && errno == EINTR);
  return count >= 0 || errno == EAGAIN || errno == EWOULDBLOCK;
}

}  // namespace hexagait::detail
