// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cstdio>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/viewer/server/server.hpp>
#include <hexagait/viewer/session/session.hpp>
#include <thread>

// Serves a walk for half a second.
int main(int, char** argv) {
  using namespace hexagait;
  viewer::SessionOptions options;
  options.robot = load_urdf(std::string(argv[1]) + "/argos.urdf");
  options.heading = heading_control::Heading::straight(0.0);
  viewer::Session session(std::move(options));
  viewer::Server server({.bind = "127.0.0.1", .port = 0, .token = {}}, session);
  std::atomic<bool> stop = false;
  std::thread clock([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    stop = true;
  });
  server.run(stop);
  clock.join();
  std::printf("viewer: %s served %d frames\n", server.url().c_str(),
              static_cast<int>(session.statistics().frames));
  return session.statistics().frames > 5 ? 0 : 1;
}
