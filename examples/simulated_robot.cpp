// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A robot in a process of its own, at the far end of a pipe; here a simulated one. It owns the clock: it
// sends its state, waits for targets, moves on by one control period, and says at the end how far it got.
// With --real-time it takes its time, as a robot does, and waits for nobody: hexagait steer --live. With a
// terrain it is the test of docs/rough_terrain.md for a controller of any kind and language.
//                                 simulated_robot [--real-time] ROBOT.urdf [TERRAIN [SEED]]
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/pipe/pipe_robot.hpp>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <thread>

using namespace hexagait;
using Clock = std::chrono::steady_clock;

constexpr double kPatience = 3600.0;  // for targets, without --real-time [s]
constexpr auto kMostBehind = std::chrono::milliseconds(100);  // of a machine that is too slow

// What drives do that get no new targets: they keep the last ones.
JointTargets held(JointTargets targets) {
  for (LegJoints& qd : targets.qd) qd.setZero();
  return targets;
}

void tell_stop(bool stopped, double time) {
  std::fprintf(stderr, "robot: %s at %.2f s\n", stopped ? "stopped" : "released", time);
}

int main(int argc, char** argv) try {
  const bool real_time = argc > 1 && std::strcmp(argv[1], "--real-time") == 0;
  if (real_time) ++argv, --argc;
  if (argc < 2)
    return std::fputs("usage: simulated_robot [--real-time] ROBOT.urdf [TERRAIN [SEED]]\n", stderr),
           2;
  const RobotModel model = load_urdf(argv[1]);
  LegArray<LegJoints> stance(model.num_legs());
  for (LegId i = 0; i < model.num_legs(); ++i)
    stance[i] = inverse_kinematics(model.legs[i], model.legs[i].p_BC).q;
  sim3d::WorldParams params;
  params.seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  sim3d::World world(model, sim3d::parse_terrain(argc > 2 ? argv[2] : "flat"), params, stance);

  PipeRobot pipe(STDIN_FILENO, STDOUT_FILENO, size_of(model));
  const auto period =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(params.control_dt));
  auto next = Clock::now();
  Measurement state;
  bool fell = false, stopped = false;
  while (world.read(state) == PlantStatus::fresh) {
    pipe.send(state);
    next = std::max(next + period, Clock::now() - kMostBehind);
    const std::chrono::duration<double> left = next - Clock::now();
    const PipeRobot::Heard heard = pipe.receive(real_time ? left.count() : kPatience);
    if (heard == PipeRobot::Heard::closed) break;
    if (pipe.stopped() != stopped) tell_stop(stopped = pipe.stopped(), state.time);
    if (heard == PipeRobot::Heard::targets)
      world.write(pipe.targets());
    else if (pipe.targets().q.size() > 0)
      world.write(held(pipe.targets()));
    if (real_time) std::this_thread::sleep_until(next);
    fell = fell || world.truth().base_touches_ground;
  }
  if (const std::string problem = pipe.problem(); problem.find("closed") == std::string::npos)
    std::fprintf(stderr, "simulated_robot: the controller %s\n", problem.c_str());
  const Vector3& p_WB = world.truth().X_WB.p;
  std::fprintf(stderr,
               "robot: at x %.3f, y %.3f, z %.3f m after %.2f s; %s; cost of transport %.2f\n",
               p_WB.x(), p_WB.y(), p_WB.z(), world.truth().time, fell ? "fell" : "did not fall",
               world.truth().work / (9.81 * model.mass * p_WB.head<2>().norm()));
  return 0;
} catch (const InvalidInput& error) {
  return std::fprintf(stderr, "simulated_robot: %s\n", error.what()), 2;
}
