// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "live/page_server.hpp"

#include <fmt/format.h>

#include <chrono>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/parse_number.hpp>
#include <hexagait/viewer/server/page_files.hpp>
#include <hexagait/viewer/server/server.hpp>
#include <thread>

#include "terminal/interrupt.hpp"
#include "terminal/output.hpp"

namespace hexagait::app {
namespace {

int port(const std::string& text) {
  const auto number = parse_number<int>(text);
  if (number && 0 <= *number && *number <= 65535) return *number;
  throw InvalidInput(fmt::format(
      "--port is '{}'; it must be a whole number from 0 (any that is free) to 65535", text));
}

constexpr auto kLastWords = std::chrono::milliseconds(300);  // for pages to hear that it is over

// Raises `end` with Ctrl-C, when the time is over, or it is over by itself.
class End {
 public:
  End(double seconds, const Ended& over)
      : thread_([this, seconds, &over, &interrupted = watch_interrupts()] {
          const auto begin = viewer::Clock::now();
          const std::chrono::duration<double> length(seconds);
          while (!ended_ && !interrupted && viewer::Clock::now() - begin < length && !over())
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
          if (over()) std::this_thread::sleep_for(kLastWords);
          ended_ = true;
        }) {}
  ~End() {
    ended_ = true;
    thread_.join();
  }
  End(const End&) = delete;
  End& operator=(const End&) = delete;

  [[nodiscard]] const std::atomic<bool>& ended() const { return ended_; }

 private:
  std::atomic<bool> ended_ = false;
  std::thread thread_;
};

}  // namespace

void wait_for_end(double seconds, const Ended& ended) {
  const End end(seconds, ended);
  while (!end.ended()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

void serve_page(const char* command, const PageAddress& address, bool quiet, viewer::Host& host,
                double seconds, const Ended& ended) {
  if (viewer::page_files().empty())
    throw InvalidInput(fmt::format("{}: {}", command, viewer::kNoPage));
  const std::string bind = address.bind == "localhost" ? "127.0.0.1" : address.bind;
  viewer::Access access{.bind = bind, .port = port(address.port), .token = {}};
  if (!access.is_loopback()) access.token = viewer::make_token();
  viewer::Server server(std::move(access), host);
  print_out(fmt::format("{}\n", server.url()));
  if (!quiet) fmt::print(stderr, "Open this address in a browser; Ctrl-C ends.\n");
  const End end(seconds, ended);
  server.run(end.ended());
}

}  // namespace hexagait::app
