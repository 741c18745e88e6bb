// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <bit>
#include <cmath>
#include <ctime>
#include <hexagait/recording/genghis.hpp>
#include <hexagait/sim/fnv1a.hpp>

namespace hexagait::recording {
namespace {

// Its kinematics in space are for drawing only: nothing follows from them.
constexpr RefereeParams kReferee = {.bounce = 0.05,
                                    .settling = 0.02,
                                    .brief_loss = 0.02,
                                    .near_loss = 0.005,
                                    .fall_speed = 0.6,
                                    .progress = 0.02,
                                    .patience = 30.0};

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// The pose in the plane, and the joints: what the physics has.
std::uint64_t state_hash(const sim2d::GenghisWorld& world, const sim2d::GenghisMeasurement& sensed,
                         std::uint64_t hash) {
  const auto add = [&hash](double value) {
    hash = fnv1a(std::bit_cast<std::uint64_t>(value), hash);
  };
  const Vector3& p_WB = world.truth().X_WB.p;
  for (const double value : {p_WB.x(), p_WB.z(), world.pitch()}) add(value);
  for (const sim2d::GenghisJoints& q : sensed.q) {
    add(q.swing);
    add(q.lift);
  }
  return hash;
}

}  // namespace

GenghisSummary simulate(const sim2d::GenghisTrial& trial, const walk::Observer& observer,
                        const std::atomic<bool>* stop) {
  const sim2d::GenghisModel model;
  check(trial, model);
  const RobotModel robot = robot_in_space(model);
  sim2d::GenghisWorld world = settled_world(trial, model);
  sim2d::GenghisController controller = sim2d::controller(trial, model);
  sim2d::GenghisMeasurement measurement;
  world.read(measurement);
  controller.start(measurement);

  const double dt = trial.control_dt;
  walk::Referee referee(robot, world.truth(), dt, kReferee);
  footstep_gen::TickRecord in_space;
  SideView side_view{.terrain = trial.terrain};
  std::uint64_t hash = kFnv1aBasis;
  double seconds = 0.0;
  const double processor_start = processor_seconds();
  const long ticks = std::lround(std::ceil(trial.seconds / dt - 1e-9));
  for (long k = 0; k < ticks; ++k) {
    const sim2d::GenghisRecord& record = controller.tick(measurement);
    world.write(record.targets);
    record_in_space(model, controller.params(), record, in_space);
    referee.observe(in_space, world.truth());
    hash = state_hash(world, measurement, hash);
    seconds += dt;
    if (world.underside_touches()) side_view.underside_time += dt;
    for (const sim2d::GenghisLeg& leg : record.legs) {
      side_view.blocked += leg.blocked;
      side_view.searches += leg.searched;
    }
    if (observer) observer(in_space, world.truth(), referee);
    if (referee.fell() || referee.stuck() || referee.distance() >= trial.distance) break;
    if (stop != nullptr && stop->load()) break;
    world.read(measurement);
  }

  GenghisSummary summary{referee.summary(), side_view};
  summary.state_hash = hash;
  // Summed up tick by tick: a product would give every speed other last bits.
  summary.seconds = seconds;
  summary.speed = summary.distance / seconds;
  summary.arrived = referee.distance() >= trial.distance;
  const double processor = processor_seconds() - processor_start;
  summary.real_time_factor = processor > 0.0 ? seconds / processor : 0.0;
  return summary;
}

}  // namespace hexagait::recording
