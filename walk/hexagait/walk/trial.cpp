// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/walk/trial.hpp>

namespace hexagait::walk {
namespace {

using heading_control::HeadingCommand;

// Of this thread: others may walk as well.
double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Lets the robot come to rest on its feet before anything is judged.
Measurement settled(footstep_gen::Walker& walker, Plant& plant, double seconds) {
  Measurement measurement;
  PlantStatus status = plant.read(measurement);
  walker.start(measurement);
  const double dt = walker.params().control_dt;
  const auto stop = heading_control::Heading::stop();
  for (double t = 0.0; t < seconds; t += dt) {
    plant.write(walker.tick(status, measurement, stop).targets);
    status = plant.read(measurement);
  }
  walker.start(measurement);
  return measurement;
}

bool there(const Referee& referee, const TrialOptions& options) {
  return referee.distance() >= options.distance || std::abs(referee.turned()) >= options.turn;
}

}  // namespace

Summary run_trial(footstep_gen::Walker& walker, Plant& plant, const GroundTruth& truth,
                  const TrialOptions& options, const Observer& observer) {
  if (options.schedule.empty())
    throw InvalidInput(
        "the schedule of the walk is empty; it must have a command, if only to stop");
  const double dt = walker.params().control_dt;
  const auto ticks = static_cast<long>(std::llround(options.seconds / dt));
  Measurement measurement = settled(walker, plant, options.settle);
  Referee referee(walker.model(), truth, dt, options.referee);
  std::optional<PathPilot> pilot;
  if (options.path) {
    pilot.emplace(*options.path, options.localised_by, truth);
    referee.follow(*options.path);
  }
  std::vector<double> tick_times;
  tick_times.reserve(static_cast<std::size_t>(ticks));

  const double processor_start = processor_seconds();
  PlantStatus status = PlantStatus::fresh;
  for (long k = 0; k < ticks; ++k) {
    const TimedCommand& command = command_at(options.schedule, static_cast<double>(k) * dt);
    if (command.duty_factor)
      walker.set_stepping(
          {.stepping = gait_state::Stepping::wave, .duty_factor = *command.duty_factor});
    const HeadingCommand asked = pilot ? pilot->steer(walker, truth)
                                 : options.steer
                                     ? HeadingCommand{options.steer(walker.record()), options.speed}
                                     : HeadingCommand{command.heading, options.speed};
    const auto before = std::chrono::steady_clock::now();
    const footstep_gen::TickRecord& record = walker.tick(
        status, measurement, {asked.heading, std::min(asked.speed_limit, options.speed)});
    tick_times.push_back(
        std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - before)
            .count());

    plant.write(record.targets);
    referee.observe(record, truth);
    if (observer) observer(record, truth, referee);
    const bool arrived = there(referee, options);
    const bool at_end = pilot && pilot->stands_at_end(walker);
    if (arrived || at_end || referee.fell() || referee.stuck() ||
        record.fault != footstep_gen::Fault::none)
      break;
    status = plant.read(measurement);
  }

  Summary summary = referee.summary();
  summary.arrived = pilot ? pilot->progress().arrived : there(referee, options);
  if (summary.path) summary.path->arrived = summary.arrived;
  const double processor = processor_seconds() - processor_start;
  summary.real_time_factor = processor > 0.0 ? summary.seconds / processor : 0.0;
  summary.tick_median = percentile(tick_times, 0.5);
  summary.tick_p99 = percentile(tick_times, 0.99);
  return summary;
}

LegArray<LegJoints> nominal_posture(const RobotModel& model) {
  return random_posture(model, 0.0, 0);
}

LegArray<LegJoints> random_posture(const RobotModel& model, double spread, std::uint64_t seed) {
  RandomSequence random{.seed = seed, .stream = RandomStream::posture};
  LegArray<LegJoints> q(model.num_legs());
  for (LegId i = 0; i < model.num_legs(); ++i) {
    const double radius = spread * std::sqrt(random.u01());
    const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
    Vector3 offset = Vector3::Zero();
    offset.head<2>() = radius * unit_vector(angle);
    q[i] = inverse_kinematics(model.legs[i], model.legs[i].p_BC + offset).q;
  }
  return q;
}

}  // namespace hexagait::walk
