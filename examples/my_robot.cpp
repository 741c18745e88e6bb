// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
// Your own robot: a plant in another process behind a pipe, walked by the Walker that walks the
// simulated ones. docs/porting.md goes through it.        my_robot ROBOT.urdf PROGRAM [SECONDS]
#include <poll.h>

#include <csignal>
#include <cstdio>
#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>

#include "robot_link.hpp"

using namespace hexagait;
class MyRobot : public Plant {
 public:
  MyRobot(int pipe, int num_legs) : pipe_(pipe), num_legs_(num_legs) {}

  // The robot owns the clock: wait for its next state, but not for ever.
  PlantStatus read(Measurement& measurement) override {
    pollfd ready{pipe_, POLLIN, 0};
    if (poll(&ready, 1, 20 /* ms */) == 0) return PlantStatus::late;
    StatePacket packet;
    if (recv(pipe_, &packet, sizeof packet, 0) != sizeof packet) return PlantStatus::closed;
    measurement = measurement_from(packet, num_legs_);
    return PlantStatus::fresh;
  }
  void write(const JointTargets& targets) override {
    const TargetPacket packet = packet_from(targets);
    send(pipe_, &packet, sizeof packet, MSG_NOSIGNAL);
  }

 private:
  int pipe_, num_legs_;
};
const auto kLeftHandArc = heading_control::Heading::arc(2.0, 0.0);
volatile std::sig_atomic_t interrupted = 0;

int main(int argc, char** argv) try {
  if (argc < 3) return std::fputs("usage: my_robot ROBOT.urdf PROGRAM [SECONDS]\n", stderr), 2;
  std::signal(SIGINT, [](int) { interrupted = 1; });
  const RobotModel model = load_urdf(argv[1]);
  MyRobot robot(start_process(argv[2], argv[1]), model.num_legs());
  footstep_gen::Walker walker(model);

  Measurement state;
  PlantStatus status = robot.read(state);
  while (status == PlantStatus::late && !interrupted) status = robot.read(state);
  if (status != PlantStatus::fresh) return std::fputs("my_robot: no answer\n", stderr), 1;
  walker.start(state);
  const double end = state.time + (argc > 3 ? std::atof(argv[3]) : 10.0);
  while (state.time < end && walker.record().fault == footstep_gen::Fault::none) {
    if (interrupted) walker.emergency_stop();
    robot.write(walker.tick(status, state, kLeftHandArc).targets);
    status = robot.read(state);
  }
  std::printf("stopped at %.2f s, fault: %s\n", state.time, to_string(walker.record().fault));
  return walker.record().fault == footstep_gen::Fault::none ? 0 : 1;
} catch (const InvalidInput& error) {
  return std::fprintf(stderr, "my_robot: %s\n", error.what()), 2;
}
