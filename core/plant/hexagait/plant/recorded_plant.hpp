// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/plant/plant.hpp>
#include <span>
#include <vector>

namespace hexagait {

/// A plant that plays back what another one measured: the same controller then computes the same
/// targets, so what happened on a robot can be looked into at a desk. Keeps what it is told.
class RecordedPlant final : public Plant {
 public:
  /// @param measurements  one per control period; must outlive the plant
  explicit RecordedPlant(std::span<const Measurement> measurements) : measurements_(measurements) {
    targets_.reserve(measurements.size() + 1);
  }

  /// The next measurement; `closed` after the last.
  PlantStatus read(Measurement& measurement) override {
    if (next_ == measurements_.size()) return PlantStatus::closed;
    measurement = measurements_[next_++];
    return PlantStatus::fresh;
  }

  void write(const JointTargets& targets) override { targets_.push_back(targets); }

  /// All that was written, in order.
  [[nodiscard]] const std::vector<JointTargets>& targets() const { return targets_; }

 private:
  std::span<const Measurement> measurements_;
  std::size_t next_ = 0;
  std::vector<JointTargets> targets_;
};

/// A robot that is where it is told to be, at once, with its feet on the ground: what a preview
/// runs on. Contacts are left to SensorMask::foot_contacts = false.
class PreviewPlant final : public Plant {
 public:
  /// @param q   where it starts [rad]
  /// @param dt  control period [s]
  PreviewPlant(const LegArray<LegJoints>& q, double dt) : dt_(dt) {
    now_ = {0.0, q, LegArray<bool>(q.size(), true)};
  }

  PlantStatus read(Measurement& measurement) override {
    measurement = now_;
    now_.time += dt_;
    return PlantStatus::fresh;
  }

  void write(const JointTargets& targets) override { now_.q = targets.q; }

 private:
  double dt_;
  Measurement now_;
};

}  // namespace hexagait
