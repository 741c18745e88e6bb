// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/viewer/replay/walk_recorder.hpp>

namespace hexagait::viewer {
namespace {

constexpr std::uint32_t kScene = 1;  // there is only one

}  // namespace

SceneRecorder::SceneRecorder(std::ostream& out, const RobotModel& robot, std::uint64_t seed,
                             double control_dt)
    : robot_(&robot),
      seed_(seed),
      control_dt_(control_dt),
      writer_(out),
      joints_(joint_counts(robot)) {}

void SceneRecorder::write(PoseFrame frame, const sim3d::Terrain& terrain) {
  if (!patch_) writer_.text(scene_json(*robot_, terrain, seed_, control_dt_, kScene, {}));
  const Vector2 place = frame.X_WB.p.head<2>();
  if (!patch_ || patch_->is_left_by(terrain, place)) {
    patch_ = GroundPatch::around(terrain, place);
    writer_.text(ground_json(terrain, *patch_, kScene));
  }
  frame.scene = kScene;
  writer_.frame(frame, joints_);
  due_ += kSampling;
}

WalkRecorder::WalkRecorder(std::ostream& out, const RobotModel& robot,
                           const recording::Simulation& simulation)
    : stepping_(simulation.gait.stepper.stepping),
      schedule_(simulation.trial.schedule),
      scene_(out, robot, simulation.seed, simulation.control_dt),
      frames_(robot, simulation.control_dt) {}

void WalkRecorder::observe(const footstep_gen::TickRecord& record, const GroundTruth& truth,
                           const walk::Referee& referee, const sim3d::World& world) {
  if (last_) take(record, world);
  last_ = {truth, world.efforts(), referee.deviation().lateral, referee.fell()};
}

void WalkRecorder::observe(const ActionRecord& record, const GroundTruth& truth,
                           const sim3d::World& world) {
  if (last_) take(as_walk(record), world);
  last_ = {truth, world.efforts(), 0.0, false};
}

// What the controller measured and decided in this tick is about the end of the one before.
void WalkRecorder::take(const footstep_gen::TickRecord& record, const sim3d::World& world) {
  if (!began_) frames_.start(last_->truth, record.measurement.q);
  if (began_) frames_.observe(last_->truth, record.measurement.q, last_->efforts);
  began_ = true;
  if (!scene_.is_due(frames_.time())) return;
  PoseFrame frame = frames_.frame(record);
  frame.flags |= gait_flags(stepping(frame.time));
  if (last_->fell) frame.flags |= PoseFrame::fell;
  frame.lateral = last_->lateral;
  scene_.write(std::move(frame), world.terrain());
}

gait_state::Stepping WalkRecorder::stepping(double time) const {
  gait_state::Stepping now = stepping_;
  for (const walk::TimedCommand& command : schedule_)
    if (command.time <= time && command.duty_factor) now = gait_state::Stepping::wave;
  return now;
}

}  // namespace hexagait::viewer
