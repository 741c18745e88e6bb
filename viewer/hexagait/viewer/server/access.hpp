// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

/// Who may talk to the server. A page of somebody else's, opened in the same browser, can send
/// requests to this machine; its browser tells whose page it is (Origin) and which name was asked
/// for (Host), and a foreign one is refused. Pure functions.
namespace hexagait::viewer {

struct Access {
  std::string bind = "127.0.0.1";  ///< address that is listened on
  int port = 0;
  std::string token;  ///< that watching and steering needs; empty: none

  /// 127.0.0.0/8 or ::1: only programs of this machine get there.
  [[nodiscard]] bool is_loopback() const;
};

/// May a request of this Host be answered? On a loopback address: localhost or a loopback address, and
/// our port, so that no foreign name that leads here is one. On another address any name is: there
/// the token protects.
[[nodiscard]] bool is_our_host(const Access& access, std::string_view host);

/// May a page of this Origin steer? Only our own: http:// and the Host that it asked for. A program
/// that is no browser sends none: empty.
[[nodiscard]] bool is_our_origin(const Access& access, std::string_view origin,
                                 std::string_view host);

/// Is this the token? In a time that does not depend on where they differ.
[[nodiscard]] bool is_token(const Access& access, std::string_view given);

/// A random token of 32 hexadecimal digits, from the system's source.
[[nodiscard]] std::string make_token();

}  // namespace hexagait::viewer
