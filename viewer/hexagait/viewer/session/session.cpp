// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/session/session.hpp>

namespace hexagait::viewer {
namespace {

constexpr std::size_t kMostOrders = 64;  // that wait for the next tick
constexpr auto kMostBehind = std::chrono::milliseconds(100);
constexpr auto kIdle = std::chrono::milliseconds(50);   // between two looks while paused
constexpr double kMeasuring = 0.5;                      // of the speed factor [s]
constexpr auto kBetweenGaps = std::chrono::seconds(1);  // that are told
constexpr std::size_t kLongestStop = 64;  // of an emergency stop that is read in any case [bytes]

Clock::duration seconds(double s) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(s));
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool is_drive(const Command& command) {
  return std::holds_alternative<Drive>(command) || std::holds_alternative<DriveTwist>(command);
}

// Is an order out of date once this one has come right after it?
bool is_replaced(const Command& order, const Command& next) {
  if (is_drive(order)) return is_drive(next);
  if (std::holds_alternative<Follow>(order)) return std::holds_alternative<Follow>(next);
  const bool begins_anew =
      std::holds_alternative<Scramble>(order) || std::holds_alternative<Reset>(order);
  return begins_anew && order.index() == next.index();
}

// The robot that it begins with is one to choose, wherever it comes from.
SessionOptions with_own_robot(SessionOptions options) {
  auto& robots = options.robots;
  if (std::ranges::find(robots, options.robot.name) == robots.end())
    robots.insert(robots.begin(), options.robot.name);
  return options;
}

}  // namespace

Session::Session(SessionOptions options)
    : options_(with_own_robot(std::move(options))), began_(options_) {
  command_.heading = options_.heading;
  command_.speed_limit = kNoLimit;
  std::promise<void> started;
  std::future<void> start = started.get_future();
  thread_ = std::thread([&] { run(started); });
  try {
    start.get();
  } catch (...) {
    thread_.join();
    throw;
  }
}

Session::~Session() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
    news_ = nullptr;
  }
  wake_.notify_all();
  thread_.join();
  action_dropped_ = true;
}

void Session::on_news(std::function<void()> news) {
  const std::lock_guard lock(mutex_);
  news_ = std::move(news);
}

ClientId Session::enter() {
  const std::lock_guard lock(mutex_);
  wheel_.enter(++clients_, Clock::now());
  return clients_;
}

void Session::leave(ClientId client) {
  const std::lock_guard lock(mutex_);
  if (wheel_.leave(client)) holder_left_ = true;
  wake_.notify_all();
}

std::string Session::receive(ClientId client, std::string_view message) {
  bool heard = false;
  {
    const std::lock_guard lock(mutex_);
    heard = wheel_.hear(client, Clock::now());
  }
  constexpr const char* kTooMany = "too many messages; some of them were not read";
  if (!heard && message.size() > kLongestStop) return error_json(kTooMany);
  auto read = parse_command(message);
  if (const auto* error = std::get_if<CommandError>(&read))
    return error_json(heard ? error->what : kTooMany);
  auto& command = std::get<Command>(read);
  if (std::holds_alternative<EmergencyStop>(command)) return press_stop(client), std::string();
  return heard ? accept(client, std::move(command)) : error_json(kTooMany);
}

// Nothing that was sent before it counts any more.
void Session::press_stop(ClientId client) {
  const std::lock_guard lock(mutex_);
  if (!stopped_by_) stopped_by_ = client;
  if (!stop_due_) stop_tick_ = statistics_.ticks;
  stop_due_ = true;
  inbox_.clear();
  wake_.notify_all();
}

std::string Session::accept(ClientId client, Command command) {
  if (const auto* restart = std::get_if<Restart>(&command);
      restart != nullptr && restart->robot &&
      std::ranges::find(began_.robots, *restart->robot) == began_.robots.end())
    return error_json(fmt::format("there is no robot \"{}\"", *restart->robot));

  if (const auto* follow = std::get_if<Follow>(&command);
      follow != nullptr && !follow->name.empty() &&
      std::ranges::find(began_.paths, follow->name) == began_.paths.end())
    return error_json(fmt::format("there is no path \"{}\"", follow->name));

  if (const auto* perform = std::get_if<Perform>(&command);
      perform != nullptr && perform->yaml.empty() &&
      std::ranges::find(began_.actions, perform->name) == began_.actions.end())
    return error_json(fmt::format("there is no action \"{}\"", perform->name));

  const std::lock_guard lock(mutex_);
  if (std::holds_alternative<Beat>(command)) return {};
  if (std::holds_alternative<Release>(command) && wheel_.holder() != client) return {};
  if (is_live())
    if (const char* const what = only_simulated(command); what != nullptr)
      return error_json(fmt::format("a live robot can't {}; only a simulated one can", what));
  if (!wheel_.take(client, Clock::now())) return error_json("another page holds the wheel");
  if (stopped_by_ && is_motion(command))
    return error_json("the emergency stop holds the robot; release it first");
  if (std::holds_alternative<Release>(command)) wheel_.release(client);

  if (!inbox_.empty() && is_replaced(inbox_.back().command, command)) {
    inbox_.back().command = std::move(command);
  } else {
    if (inbox_.size() >= kMostOrders) return error_json("too many commands at once");
    inbox_.push_back({std::move(command), statistics_.ticks});
  }
  wake_.notify_all();
  return {};
}

bool Session::newer_than(Seen& seen, Letter& letter) const {
  const std::lock_guard lock(mutex_);
  for (int kind = 0; kind < kMailKinds; ++kind) {
    const Mailbox& box = mail_[kind];
    if (box.number == seen.number[kind]) continue;
    seen.number[kind] = box.number;
    letter = {static_cast<Mail>(kind), box.content};
    return true;
  }
  return false;
}

SessionStatistics Session::statistics() const {
  const std::lock_guard lock(mutex_);
  return statistics_;
}

// What follows is the walk's thread.

void Session::run(std::promise<void>& started) {
  try {
    begin({});
  } catch (...) {
    started.set_exception(std::current_exception());
    return;
  }
  due_ = frame_due_ = measured_ = Clock::now();
  started.set_value();
  while (take_orders()) {
    watch_holder();
    watch_action();
    const bool waits = over_ || (paused_ && steps_ == 0);
    if (waits && changed_) publish();
    if (waits || (!is_live() && Clock::now() < due_)) {
      wait_until(waits ? Clock::now() + kIdle : due_);
      if (waits) due_ = Clock::now();
      continue;
    }
    tick();
    if (changed_ || Clock::now() >= frame_due_) publish();
  }
}

void Session::begin(const WalkStart& start) {
  drop_action("the robot was put down anew");
  if (is_live())
    walk_ = std::make_unique<LiveWalk>(options_.robot, options_.simulation, *options_.live,
                                       options_.live_patience);
  else
    begin_simulated(start);
  joints_ = joint_counts(options_.robot);
  tell_scene();
  hold_still();
  tell_setup();
  due_ = Clock::now();
  changed_ = true;
}

void Session::begin_simulated(const WalkStart& start) {
  walk_ = nullptr;
  simulated_ = nullptr;
  rival_ = nullptr;  // of more worlds at once there is no need
  auto walk = std::make_unique<SimulatedWalk>(options_.robot, options_.simulation, start);
  rival_ = make_rival(start);
  simulated_ = walk.get();
  walk_ = std::move(walk);
}

void Session::tell_scene() {
  ++scene_;
  post(Mail::scene,
       scene_json(options_.robot, walk_->terrain(), options_.simulation.seed, walk_->control_dt(),
                  scene_, {options_.robots, options_.paths, options_.actions, is_live()}));
  patch_ = GroundPatch::around(walk_->terrain(), walk_->place().shift);
  post(Mail::ground, ground_json(walk_->terrain(), patch_, scene_));
}

// On the same ground, from the same place, in the same posture, told the same; but of another gait.
std::unique_ptr<SimulatedWalk> Session::make_rival(const WalkStart& start) const {
  if (!race_) return nullptr;
  recording::Simulation simulation = options_.simulation;
  simulation.gait = *race_;
  return std::make_unique<SimulatedWalk>(options_.robot, simulation, start);
}

void Session::tell_setup() {
  SceneSetup setup{options_.simulation.plant, walk_->path(), race_, {}};
  {
    const std::lock_guard lock(mutex_);
    setup.stopped_by = stopped_by_;
  }
  post(Mail::setup, setup_json(setup, scene_));
  changed_ = true;
}

// Everything that has arrived is obeyed before the next tick; an emergency stop first.
bool Session::take_orders() {
  std::deque<Order> orders;
  {
    const std::lock_guard lock(mutex_);
    if (stop_) return false;
    if (std::exchange(stop_due_, false)) orders.push_back({EmergencyStop{}, stop_tick_});
    for (Order& order : inbox_) orders.push_back(std::move(order));
    inbox_.clear();
    if (holder_left_) orders.push_back({Stop{}, statistics_.ticks});
    holder_left_ = false;
  }
  for (const Order& order : orders) obey(order);
  return true;
}

void Session::obey(const Order& order) {
  try {
    std::visit([this](const auto& command) { obey(command); }, order.command);
  } catch (const std::exception& error) {
    post(Mail::notice, error_json(error.what()));
    if (walk_ == nullptr) {
      options_ = began_;
      race_ = std::nullopt;
      begin({});
    }
  }
  const std::lock_guard lock(mutex_);
  ++statistics_.commands;
  const auto delay = static_cast<int>(statistics_.ticks - order.tick);
  if (!paused_) statistics_.worst_delay = std::max(statistics_.worst_delay, delay);
}

void Session::watch_holder() {
  if (silent_) return;
  {
    const std::lock_guard lock(mutex_);
    if (!wheel_.is_silent(Clock::now())) return;
  }
  silent_ = true;
  changed_ = true;
  command_.heading = command_.heading.stopped();
  stop_action();
  each([](SteeredWalk& walk) {
    if (walk.path() != nullptr) walk.path()->interrupt();
  });
}

void Session::tick() {
  each([&](SteeredWalk& walk) { walk.tick(command_); });
  if (steps_ > 0 && --steps_ == 0) changed_ = true;
  watch_robot();
  keep_time();
}

// A live one: that it was late, or is gone.
void Session::watch_robot() {
  if (!is_live()) return;
  if (!over_ && walk_->fault() == Fault::plant_closed) {
    over_ = changed_ = true;
    post(Mail::notice, error_json("the robot " + options_.live->problem()));
  }
  if (Clock::now() - gap_told_ < kBetweenGaps) return;
  const double gap = static_cast<LiveWalk&>(*walk_).take_gap();
  if (gap == 0.0) return;
  gap_told_ = Clock::now();
  post(Mail::notice, error_json(fmt::format("no state of the robot for {:.0f} ms", 1e3 * gap)));
}

void Session::keep_time() {
  const auto now = Clock::now();
  due_ += seconds(walk_->control_dt() / options_.speed_factor);
  if (now - due_ > kMostBehind) due_ = now;  // the machine is too slow: so is the walk

  const std::lock_guard lock(mutex_);
  ++statistics_.ticks;
  statistics_.seconds += walk_->control_dt();
  statistics_.fault = walk_->fault();
  const double passed = std::chrono::duration<double>(now - measured_).count();
  if (passed < kMeasuring) return;
  measured_factor_ =
      static_cast<double>(statistics_.ticks - measured_ticks_) * walk_->control_dt() / passed;
  measured_ = now;
  measured_ticks_ = statistics_.ticks;
}

void Session::publish() {
  PoseFrame frame = walk_->frame();
  if (patch_.is_left_by(walk_->terrain(), frame.X_WB.p.head<2>())) {
    patch_ = GroundPatch::around(walk_->terrain(), frame.X_WB.p.head<2>());
    post(Mail::ground, ground_json(walk_->terrain(), patch_, scene_));
  }
  frame.scene = scene_;
  frame.speed_factor = measured_factor_;
  if (paused_) frame.flags |= PoseFrame::paused;
  if (silent_) frame.flags |= PoseFrame::silent;
  {
    const std::lock_guard lock(mutex_);
    frame.holder = wheel_.holder();
    ++statistics_.frames;
    statistics_.fell = walk_->fell();
    statistics_.path = frame.path;
    statistics_.processor = processor_seconds();
  }
  if (options_.replay != nullptr) options_.replay->frame(frame, joints_);
  std::string frames = encode(frame, joints_);
  if (rival_ != nullptr) {  // in the same letter: two of one moment, however slow a client is
    PoseFrame rival = rival_->frame();
    rival.scene = scene_;
    frames += encode(rival, joints_);
  }
  post(Mail::frame, std::move(frames));
  const auto now = Clock::now(), next = frame_due_ + seconds(1.0 / options_.frame_rate);
  frame_due_ = next > now ? next : now + seconds(1.0 / options_.frame_rate);
  changed_ = false;
  call();
}

void Session::post(Mail kind, std::string content) {
  if (options_.replay != nullptr &&
      (kind == Mail::scene || kind == Mail::ground || kind == Mail::setup))
    options_.replay->text(content);
  const std::lock_guard lock(mutex_);
  Mailbox& box = mail_[static_cast<int>(kind)];
  ++box.number;
  box.content = std::move(content);
}

// Under the mutex: once on_news() has returned, the one before it is not called any more.
void Session::call() {
  const std::lock_guard lock(mutex_);
  if (news_) news_();
}

void Session::wait_until(Clock::time_point due) {
  std::unique_lock lock(mutex_);
  wake_.wait_until(lock, due, [this] { return stop_ || !inbox_.empty() || holder_left_; });
}

}  // namespace hexagait::viewer
