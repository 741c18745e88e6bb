// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/pc04/navigation/navigation_walk.hpp>
#include <limits>
#include <set>

namespace hexagait::experiments {
namespace {

constexpr double kSampling = 0.5;  // of the trace [s]
constexpr double kSquare = 0.3;    // in which the area is counted [m]

// The sensors and the navigation of a robot in a world.
class Pilot {
 public:
  Pilot(const RobotModel& robot, const sim3d::World& world, const SenseNoise& noise,
        std::uint64_t seed)
      : world_(&world),
        layout_(navigation::sense_layout_for(robot)),
        params_(navigation::navigation_params_for(robot)),
        noise_(noise),
        noise_draws_{.seed = seed, .stream = RandomStream::senses},
        turn_draws_{.seed = seed, .stream = RandomStream::turns} {}

  heading_control::Heading steer(const footstep_gen::TickRecord& record) {
    navigation::Senses senses = sim3d::sense(*world_, layout_, noise_.range, noise_draws_);
    senses.time = record.measurement.time;
    senses.pitch = record.measurement.inclination.pitch;
    senses.odometry = in_plane(record.state.X_OB);
    state_ = navigation::navigate(state_, senses, params_, turn_draws_.u01());
    watch_blocks(senses.time);
    return heading_of(state_);
  }

  // Whether it has just been blocked twice in a row: whatever it does, it gets nowhere.
  [[nodiscard]] bool is_helpless() const { return helpless_; }

  // Of another start of the controller, from which odometry begins anew.
  void begin_anew() { state_.started = false; }

  [[nodiscard]] const navigation::NavigationState& state() const { return state_; }

 private:
  void watch_blocks(double time) {
    const long blocks = state_.met[static_cast<std::size_t>(navigation::Reason::blocked)];
    helpless_ = blocks > blocks_ && time < last_block_ + 1.5 * params_.patience;
    if (blocks > blocks_) last_block_ = time;
    blocks_ = blocks;
  }

  const sim3d::World* world_;
  navigation::SenseLayout layout_;
  navigation::NavigationParams params_;
  SenseNoise noise_;
  RandomSequence noise_draws_, turn_draws_;
  navigation::NavigationState state_;
  bool helpless_ = false;
  long blocks_ = 0;
  double last_block_ = -std::numeric_limits<double>::infinity();  // [s]
};

// Writes down where the robot goes, by the truth.
class Log {
 public:
  Log(NavigationWalk& walk, const RobotModel& robot) : walk_(&walk), robot_(&robot) {}

  // @returns whether there is a new sample
  bool observe(const GroundTruth& truth, const navigation::NavigationState& state) {
    const Vector3 rpy = roll_pitch_yaw(truth.X_WB.R);
    for (const FootTruth& foot : truth.feet)
      walk_->deepest = std::max(walk_->deepest, robot_->foot_radius - foot.p_WF.z());
    for (std::size_t k = 0; k < navigation::kReasons; ++k)
      if (state.met[k] > met_[k])
        walk_->meetings.push_back({truth.time, truth.X_WB.p, static_cast<navigation::Reason>(k)});
    met_ = state.met;
    if (!walk_->trace.empty() && truth.time < walk_->trace.back().time + kSampling - 1e-9)
      return false;
    add({truth.time, truth.X_WB.p, rpy.z(), rpy.y(), state.act});
    return true;
  }

 private:
  void add(const NavigationWalk::Sample& sample) {
    const auto square = [](double x) { return static_cast<int>(std::floor(x / kSquare)); };
    squares_.insert({square(sample.p_WB.x()), square(sample.p_WB.y())});
    walk_->area = kSquare * kSquare * static_cast<double>(squares_.size());
    if (!walk_->trace.empty()) {
      const NavigationWalk::Sample& before = walk_->trace.back();
      walk_->path += (sample.p_WB - before.p_WB).head<2>().norm();
      walk_->turned += std::abs(wrap_angle(sample.yaw - before.yaw));
    }
    walk_->trace.push_back(sample);
  }

  NavigationWalk* walk_;
  const RobotModel* robot_;
  std::array<long, navigation::kReasons> met_ = {};
  std::set<std::pair<int, int>> squares_;
};

}  // namespace

long NavigationWalk::met(navigation::Reason reason) const {
  return std::ranges::count(meetings, reason, &Meeting::reason);
}

NavigationWalk navigate(const RobotModel& robot, const recording::Simulation& simulation,
                        const SenseNoise& noise, const std::function<void(double)>& progress,
                        const std::atomic<bool>* stop, const recording::WorldObserver& observer) {
  NavigationWalk walk{.simulation = simulation};
  sim3d::World world(robot, simulation.terrain, world_params(simulation),
                     walk::random_posture(robot, simulation.random_posture, simulation.seed));
  walk::FaultyPlant faulty(world, robot, simulation.plant.faults, simulation.control_dt,
                           simulation.seed);
  sim3d::Inclinometer plant(faulty, world, noise.pitch, simulation.seed);
  footstep_gen::Walker walker(robot, walker_params(simulation));
  Pilot pilot(robot, world, noise, simulation.seed);
  Log log(walk, robot);

  walk::TrialOptions trial = simulation.trial;
  trial.schedule = {{0.0, heading_control::Heading::stop()}};
  trial.steer = [&](const footstep_gen::TickRecord& record) {
    const heading_control::Heading heading = pilot.steer(record);
    if (!pilot.is_helpless()) return heading;
    const Measurement measurement = record.measurement;
    walker.start(measurement);
    pilot.begin_anew();
    ++walk.restarts;
    return heading;
  };
  trial.referee = simulation.params.referee;
  const auto watch = [&](const auto& record, const GroundTruth& truth, const auto& referee) {
    if (log.observe(truth, pilot.state())) progress(truth.time);
    if (observer) observer(record, truth, referee, world);
    if (stop != nullptr && stop->load()) walker.emergency_stop();
  };
  walk.summary = walk::run_trial(walker, plant, world.truth(), trial, watch);
  return walk;
}

}  // namespace hexagait::experiments
