// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/socket.h>
#include <unistd.h>

#include <hexagait/plant/plant.hpp>

// How the two example processes talk: fixed-size packets of doubles over a pipe that keeps packets
// apart. A stand-in for the bus, the shared memory or the middleware of a real robot.

inline constexpr int kMaxJoints = hexagait::kMaxLegJoints * hexagait::kMaxLegs;

struct StatePacket {
  double time = 0.0;                        // [s]
  double q[kMaxJoints] = {};                // [rad], leg by leg, hip to foot
  double contact[hexagait::kMaxLegs] = {};  // 0 or 1
};

struct TargetPacket {
  double q[kMaxJoints] = {};       // [rad]
  double qd[kMaxJoints] = {};      // [rad/s]
  double effort[kMaxJoints] = {};  // [N m]
};

// Every leg has kMaxLegJoints places; those of joints it doesn't have are 0.
inline hexagait::LegJoints joints_of(const double* values, hexagait::LegId leg) {
  return hexagait::LegJoints(values + hexagait::kMaxLegJoints * leg);
}
inline void put_joints(const hexagait::LegJoints& joints, hexagait::LegId leg, double* values) {
  for (int k = 0; k < joints.size(); ++k) values[hexagait::kMaxLegJoints * leg + k] = joints[k];
}

inline hexagait::Measurement measurement_from(const StatePacket& packet, int num_legs) {
  hexagait::Measurement m{packet.time, hexagait::LegArray<hexagait::LegJoints>(num_legs),
                          hexagait::LegArray<bool>(num_legs)};
  for (hexagait::LegId i = 0; i < num_legs; ++i) {
    m.q[i] = joints_of(packet.q, i);
    m.contact[i] = packet.contact[i] != 0.0;
  }
  return m;
}

inline StatePacket packet_from(const hexagait::Measurement& m) {
  StatePacket packet{.time = m.time};
  for (hexagait::LegId i = 0; i < m.q.size(); ++i) {
    put_joints(m.q[i], i, packet.q);
    packet.contact[i] = m.contact[i] ? 1.0 : 0.0;
  }
  return packet;
}

inline TargetPacket packet_from(const hexagait::JointTargets& targets) {
  TargetPacket packet;
  for (hexagait::LegId i = 0; i < targets.q.size(); ++i) {
    put_joints(targets.q[i], i, packet.q);
    put_joints(targets.qd[i], i, packet.qd);
    put_joints(targets.effort[i], i, packet.effort);
  }
  return packet;
}

inline hexagait::JointTargets targets_from(const TargetPacket& packet, int num_legs) {
  using hexagait::LegArray, hexagait::LegJoints;
  hexagait::JointTargets targets{LegArray<LegJoints>(num_legs), LegArray<LegJoints>(num_legs),
                                 LegArray<LegJoints>(num_legs)};
  for (hexagait::LegId i = 0; i < num_legs; ++i) {
    targets.q[i] = joints_of(packet.q, i);
    targets.qd[i] = joints_of(packet.qd, i);
    targets.effort[i] = joints_of(packet.effort, i);
  }
  return targets;
}

// Starts a program whose standard input and output are the far end of the returned pipe.
inline int start_process(const char* program, const char* argument) {
  int ends[2] = {-1, -1};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends) != 0) return -1;
  if (fork() == 0) {
    dup2(ends[1], STDIN_FILENO);
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    execl(program, program, argument, static_cast<char*>(nullptr));
    _exit(127);
  }
  close(ends[1]);
  return ends[0];
}
