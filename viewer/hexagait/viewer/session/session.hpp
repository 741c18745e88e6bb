// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <hexagait/viewer/display/scene.hpp>
#include <hexagait/viewer/replay/replay_file.hpp>
#include <hexagait/viewer/server/host.hpp>
#include <hexagait/viewer/steering/command.hpp>
#include <hexagait/viewer/steering/wheel.hpp>
#include <hexagait/viewer/walking/live_walk.hpp>
#include <hexagait/viewer/walking/simulated_walk.hpp>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace hexagait::viewer {

/// A robot, and what is given of its parameters; the others are kDerived.
struct LoadedRobot {
  RobotModel model;
  RobotParams params;
};

struct SessionOptions {
  RobotModel robot;
  recording::Simulation simulation;
  heading_control::Heading heading = heading_control::Heading::stop();  ///< until a client steers
  double speed_factor = 1.0;        ///< simulated seconds per second
  double frame_rate = 60.0;         ///< pose frames per second, at most [1/s]
  std::vector<std::string> robots;  ///< names that a client may ask for, besides that of `robot`
  /// Of these names; from any thread.
  std::function<LoadedRobot(const std::string& name)> load;
  std::vector<std::string> paths;  ///< the same of paths to follow
  std::function<path_following::PathTask(const std::string& name, const RobotModel& robot,
                                         const StepParams& step)>
      load_path;
  std::vector<std::string> actions;  ///< the same of actions to perform
  std::function<std::string(const std::string& name)> load_action;  ///< their text
  /// If not null, a live robot is steered instead of a simulated one; must outlive the session.
  PipePlant* live = nullptr;
  double live_patience = LiveWalk::kPatience;  ///< for its first state [s]
  ReplayWriter* replay =
      nullptr;  ///< if not null, takes what clients are sent; must outlive the session
};

/// How a session has gone so far.
struct SessionStatistics {
  std::uint64_t ticks = 0, frames = 0, commands = 0;
  double seconds = 0.0;       ///< simulated, in all scenes [s]
  double path = 0.0;          ///< of the present scene [m]
  int worst_delay = 0;        ///< ticks between the arrival of a command and the one that obeyed it
  bool fell = false;          ///< in the present scene
  Fault fault = Fault::none;  ///< that holds the robot
  double processor = 0.0;     ///< time of the simulation's thread [s]
};

/// A walk in real time with clients that watch and steer. Owns the thread of the walk:
///
///     client ── receive() ──▶ parse_command ─▶ wheel ─▶ inbox ──▶ thread: SteeredWalk, tick by tick
///       │                          └──── emergency stop ─────────▶   │
///     client ◀─ newer_than() ── newest frame, scene, ground ◀────────┘
///
/// An action is checked in a thread of its own, one at a time, while the robot walks on.
///
/// Simulated time runs by the machine's clock, a live robot's by its states. An emergency stop takes effect
/// in the next tick, first of all, whoever sends it and however much was sent before; it drops what waits
/// in the inbox, and lasts until the holder of the wheel releases it, also in the scenes that follow.
///
/// What goes out lies in a mailbox that holds the newest of each kind: a client that is slow, or
/// reads nothing, misses frames, delays nobody, and nothing grows. All functions may be called from
/// any thread, and none waits for a tick.
class Session : public Host {
 public:
  /// Starts to walk.
  /// @throws InvalidInput  if there is no such walk
  explicit Session(SessionOptions options);
  ~Session() override;

  /// @param news  called from the simulation's thread
  void on_news(std::function<void()> news) override;

  [[nodiscard]] ClientId enter() override;
  void leave(ClientId client) override;
  [[nodiscard]] std::string receive(ClientId client, std::string_view message) override;
  /// In its newest version: a scene before its ground before its setup before frames.
  [[nodiscard]] bool newer_than(Seen& seen, Letter& letter) const override;

  [[nodiscard]] SessionStatistics statistics() const;

 private:
  struct Order {
    Command command;
    std::uint64_t tick = 0;  ///< that had been made when it arrived
  };
  struct Mailbox {
    std::uint64_t number = 0;
    std::string content;
  };

  [[nodiscard]] std::string accept(ClientId client, Command command);
  void press_stop(ClientId client);
  void run(std::promise<void>& started);
  void begin(const WalkStart& start);
  void begin_simulated(const WalkStart& start);
  void tell_scene();
  [[nodiscard]] bool is_live() const { return options_.live != nullptr; }
  [[nodiscard]] std::unique_ptr<SimulatedWalk> make_rival(const WalkStart& start) const;
  // Of each robot that walks.
  template <class Act>
  void each(Act act) {
    act(*walk_);
    if (rival_ != nullptr) act(*rival_);
  }
  template <class Act>
  void each_simulated(Act act) {
    if (simulated_ != nullptr) act(*simulated_);
    if (rival_ != nullptr) act(*rival_);
  }
  [[nodiscard]] bool take_orders();
  void obey(const Order& order);
  void obey(const Drive& drive);
  void obey(const DriveTwist& drive);
  void obey(Stop);
  void obey(const Follow& follow);
  void obey(const Perform& perform);
  void obey(const Pause& pause);
  void obey(const SingleStep& step);
  void obey(const SpeedFactor& speed);
  void obey(Scramble);
  void obey(const Push& push);
  void obey(const ChangeGait& change);
  void obey(const Race& race);
  void obey(const Break& fault);
  void obey(Mend);
  void obey(const ChangePlant& change);
  void obey(Reset);
  void obey(const Restart& restart);
  void obey(Beat) {}
  void obey(Release) { obey(Stop{}); }
  void obey(EmergencyStop);
  void obey(ReleaseEmergencyStop);
  void hold_still();
  void watch_holder();
  void watch_robot();
  void tick();
  void keep_time();
  void publish();
  void watch_action();
  void begin_action(CheckedAction checked);
  void follow_progress();
  void stop_action();
  void drop_action(const char* why);
  void end_action(ActionNews::State state, std::string why);
  void tell_action();
  void tell_setup();
  void take_off_path();
  void post(Mail kind, std::string content);
  void call();
  void wait_until(Clock::time_point due);

  // Of the simulation's thread alone.
  SessionOptions options_, began_;
  std::unique_ptr<SteeredWalk> walk_;
  SimulatedWalk* simulated_ = nullptr;          // the same; null: a live robot
  std::unique_ptr<SimulatedWalk> rival_;        // in a world of its own; without a race none
  std::optional<gait_state::GaitChoice> race_;  // of the rival
  LegArray<int> joints_;
  heading_control::HeadingCommand command_;
  Follow followed_;
  ActionNews action_;                        // the last one that was asked for
  std::atomic<bool> action_dropped_{false};  // while it is checked
  std::future<CheckedAction> check_;         // of it, while it is checked
  std::uint32_t scene_ = 0;
  std::uint64_t draws_ = 0;
  GroundPatch patch_;
  bool paused_ = false, silent_ = false, changed_ = true;
  bool over_ = false;  // the robot is gone
  int steps_ = 0;
  Clock::time_point due_, frame_due_, measured_, gap_told_;
  double measured_factor_ = 1.0;
  std::uint64_t measured_ticks_ = 0;

  // Shared, under the mutex.
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  Wheel wheel_;
  ClientId clients_ = 0;
  bool holder_left_ = false;
  std::optional<ClientId> stopped_by_;  // an emergency stop that lasts
  bool stop_due_ = false;               // it is to be obeyed
  std::deque<Order> inbox_;
  std::uint64_t stop_tick_ = 0;  // ticks that had been made when it was pressed
  Mailbox mail_[kMailKinds];
  SessionStatistics statistics_;
  std::function<void()> news_;
  bool stop_ = false;

  std::thread thread_;  // last: it uses all of the above
};

}  // namespace hexagait::viewer
