// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <sys/random.h>

#include <array>
#include <cerrno>
#include <hexagait/viewer/server/access.hpp>
#include <system_error>

namespace hexagait::viewer {
namespace {

bool is_loopback_name(std::string_view name) {
  if (name == "localhost" || name == "::1" || name == "[::1]") return true;
  return name.starts_with("127.") &&
         name.find_first_not_of("0123456789.") == std::string_view::npos;
}

}  // namespace

bool Access::is_loopback() const { return is_loopback_name(bind); }

bool is_our_host(const Access& access, std::string_view host) {
  if (!access.is_loopback()) return !host.empty();
  const std::size_t colon = host.rfind(':');
  return colon != std::string_view::npos && host.substr(colon + 1) == std::to_string(access.port) &&
         is_loopback_name(host.substr(0, colon));
}

bool is_our_origin(const Access& access, std::string_view origin, std::string_view host) {
  if (origin.empty()) return true;
  constexpr std::string_view kScheme = "http://";
  return is_our_host(access, host) && origin.starts_with(kScheme) &&
         origin.substr(kScheme.size()) == host;
}

bool is_token(const Access& access, std::string_view given) {
  if (access.token.empty()) return true;
  unsigned different = given.size() != access.token.size();
  for (std::size_t i = 0; i < access.token.size(); ++i)
    different |= static_cast<unsigned char>(access.token[i]) ^
                 (i < given.size() ? static_cast<unsigned char>(given[i]) : 0xFFU);
  return different == 0;
}

std::string make_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::system_error(errno, std::generic_category(), "no random numbers for a token");
  std::string token;
  for (const unsigned char byte : bytes) {
    token += "0123456789abcdef"[byte >> 4U];
    token += "0123456789abcdef"[byte & 15U];
  }
  return token;
}

}  // namespace hexagait::viewer
