// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/plant/plant_watch.hpp>

namespace hexagait {

const char* to_string(Fault fault) noexcept {
  switch (fault) {
    case Fault::none:
      return "none";
    case Fault::not_started:
      return "not started";
    case Fault::bad_measurement:
      return "bad measurement";
    case Fault::plant_late:
      return "plant late";
    case Fault::plant_closed:
      return "plant closed";
    case Fault::emergency_stop:
      return "emergency stop";
    case Fault::bad_command:
      return "bad command";
  }
  return "?";
}

bool valid(const Measurement& measurement, const RobotModel& model) noexcept {
  const int n = model.num_legs();
  if (measurement.q.size() != n || measurement.contact.size() != n) return false;
  bool good = std::isfinite(measurement.time);
  if (measurement.imu)
    good &= measurement.imu->acceleration.allFinite() && measurement.imu->rate.allFinite();
  for (LegId i = 0; i < n; ++i) {
    const LegJoints& q = measurement.q[i];
    good &= (q.head<kMinLegJoints>().array().abs() <= kLargestJointAngle).all();
    for (int k = kMinLegJoints; k < model.legs[i].num_joints(); ++k)
      good &= std::abs(q[k]) <= kLargestJointAngle;
  }
  return good;
}

bool PlantWatch::accepts(PlantStatus status, const Measurement& measurement,
                         const RobotModel& model, double dt, double late_limit) noexcept {
  if (fault_ != Fault::none) return false;
  if (status == PlantStatus::late) {
    holding_ = true;
    silence_ += dt;
    if (silence_ > late_limit) stop(Fault::plant_late);
    return false;
  }
  if (status == PlantStatus::closed)
    stop(Fault::plant_closed);
  else if (!valid(measurement, model))
    stop(Fault::bad_measurement);
  if (fault_ != Fault::none) return false;
  elapsed_ = silence_ + dt;
  silence_ = 0.0;
  holding_ = false;
  return true;
}

}  // namespace hexagait
