// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <hexagait/viewer/steering/key_steering.hpp>
#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "live/walk_session.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/raw_terminal.hpp"
#include "words/words.hpp"

namespace hexagait::app {
namespace {

using viewer::Clock;
using viewer::PoseFrame;
using viewer::Session;

constexpr const char* kKeys =
    "W S ahead, backwards · A D curve to the left, right · Q E crab · X stop · ↑ go on · Space "
    "pause\n"
    "→ one tick · P push · R scramble the legs · Backspace begin again · Ctrl-C ends\n"
    "Esc EMERGENCY STOP, any number of times; ! releases it\n";
constexpr int kWait = 50;  // for a key, and between two lines at most [ms]

std::string state_of(const PoseFrame& frame) {
  if ((frame.flags & PoseFrame::fell) != 0) return "fell: Backspace begins again";
  if (frame.fault == static_cast<int>(Fault::emergency_stop))
    return "EMERGENCY STOP: ! releases it";
  if (frame.fault != 0) return "stopped by a fault: Backspace begins again";
  if ((frame.flags & PoseFrame::paused) != 0) return "paused";
  if ((frame.flags & PoseFrame::silent) != 0) return "stopped: no sign of life";
  if ((frame.flags & PoseFrame::refuses) != 0) return "stands: too few legs are left to walk";
  return frame.moving ? "walks" : "stopped";
}

std::string path_of(const PoseFrame& frame) {
  if (frame.k == 0.0) return "r inf";
  if (frame.rho < 1e-6) return frame.k > 0.0 ? "spin ccw" : "spin cw";
  return fmt::format("r {:.2f} m", frame.rho / frame.k);
}

// To hundredths, and never −0.
double rounded(double value) { return 0.01 * std::round(100.0 * value) + 0.0; }

const char* gait_of(const PoseFrame& frame) {
  if ((frame.flags & PoseFrame::wave) != 0) return "wave";
  return (frame.flags & PoseFrame::tripod) != 0 ? "tripod" : "free gait";
}

// The terminal is a client of the session, as a page is one.
class Terminal {
 public:
  Terminal(Session& session, const heading_control::Heading& heading, const RawTerminal& terminal)
      : session_(session), client_(session.enter()), steering_(heading), terminal_(terminal) {}
  ~Terminal() { session_.leave(client_); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  void type(const std::string& bytes) {
    if (bytes.empty()) press(keys_.rest());
    for (const char byte : bytes) press(keys_.take(byte));
  }

  // A sign of life, without which the robot would be stopped; and what is new.
  void refresh() {
    send(R"({"type":"beat"})");
    viewer::Host::Letter letter;
    while (session_.newer_than(seen_, letter)) {
      if (letter.kind == viewer::Host::Mail::frame) frame_ = viewer::decode(letter.content);
      if (letter.kind == viewer::Host::Mail::notice) complain(letter.content);
    }
    if (frame_) terminal_.show(line(*frame_));
  }

 private:
  void press(std::optional<viewer::Key> key) {
    if (key) send(steering_.message(*key));
  }

  void send(const std::string& message) {
    if (const std::string answer = session_.receive(client_, message); !answer.empty())
      complain(answer);
  }

  // The reason stays on the line above.
  void complain(const std::string& error) {
    terminal_.show(nlohmann::json::parse(error).value("what", ""));
    fmt::print(stderr, "\n");
  }

  static std::string line(const PoseFrame& f) {
    return fmt::format(
        "{}  {}  α {:.0f}°  {:.2f} m/s  margin {}  {}  twist {:.2f} {:.2f} m/s {:.2f} rad/s",
        state_of(f), path_of(f), degrees(f.crab), f.velocity.v.norm(), length(f.margin), gait_of(f),
        rounded(f.velocity.v.x()), rounded(f.velocity.v.y()), rounded(f.velocity.w));
  }

  Session& session_;
  viewer::ClientId client_;
  viewer::KeyDecoder keys_;
  viewer::KeySteering steering_;
  const RawTerminal& terminal_;
  viewer::Host::Seen seen_;
  std::optional<PoseFrame> frame_;
};

void attend(Session& session, const heading_control::Heading& heading, double seconds, bool quiet) {
  const std::atomic<bool>& interrupted = watch_interrupts();
  const RawTerminal raw;
  if (!quiet) fmt::print(stderr, "{}", kKeys);
  Terminal terminal(session, heading, raw);
  const auto begin = Clock::now();
  while (!interrupted && std::chrono::duration<double>(Clock::now() - begin).count() < seconds) {
    const auto bytes = raw.read(kWait);
    if (!bytes) return;
    terminal.type(*bytes);
    terminal.refresh();
  }
}

}  // namespace

int teleop_command(const WalkArguments& arguments) {
  require_terminal("--teleop");
  const auto in_terminal = [&](Session& session, const auto& heading, double seconds) {
    attend(session, heading, seconds, arguments.quiet);
  };
  return walk_in_session("walk --teleop", arguments, {}, in_terminal).fell ? kFailed : kOk;
}

}  // namespace hexagait::app
