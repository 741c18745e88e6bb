// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
// Your own robot: a plant in another process behind a pipe, walked by the Walker that walks the
// simulated ones. docs/porting.md goes through it.        my_robot ROBOT.urdf PROGRAM [SECONDS]
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/pipe/pipe_plant.hpp>
#include <hexagait/pipe/robot_process.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>

using namespace hexagait;
const auto kLeftHandArc = heading_control::Heading::arc(2.0, 0.0);
volatile std::sig_atomic_t interrupted = 0;

int main(int argc, char** argv) try {
  if (argc < 3) return std::fputs("usage: my_robot ROBOT.urdf PROGRAM [SECONDS]\n", stderr), 2;
  std::signal(SIGINT, [](int) { interrupted = 1; });
  const RobotModel model = load_urdf(argv[1]);
  const RobotProcess process({argv[2], argv[1]});
  footstep_gen::Walker walker(model);
  PipePlant robot(process.pipe(), model, walker.params().control_dt);

  Measurement state;
  PlantStatus status = robot.read(state);
  while (status == PlantStatus::late && !interrupted) status = robot.read(state);
  if (status != PlantStatus::fresh)
    return std::fprintf(stderr, "my_robot: the robot %s\n", robot.problem().c_str()), 1;
  walker.start(state);
  const double end = state.time + (argc > 3 ? std::atof(argv[3]) : 10.0);
  while (state.time < end && walker.record().fault == footstep_gen::Fault::none) {
    if (interrupted) walker.emergency_stop();
    robot.write(walker.tick(status, state, kLeftHandArc).targets);
    status = robot.read(state);
  }
  robot.set_stopped(true);
  robot.write(walker.record().targets);
  std::printf("stopped at %.2f s, fault: %s\n", state.time, to_string(walker.record().fault));
  return walker.record().fault == footstep_gen::Fault::none ? 0 : 1;
} catch (const InvalidInput& error) {
  return std::fprintf(stderr, "my_robot: %s\n", error.what()), 2;
}
