// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/navigation/senses.hpp>
#include <hexagait/plant/plant.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim3d/world.hpp>

namespace hexagait::sim3d {

/// A plant with an inclinometer of pitch, [PC04] 5: what it measures of the base, by the truth and with
/// white noise, goes to the controller of the legs.
class Inclinometer final : public Plant {
 public:
  /// @param plant  of the robot in the world; both must outlive this
  /// @param noise  standard deviation [rad]
  Inclinometer(Plant& plant, const World& world, double noise, std::uint64_t seed)
      : plant_(&plant), world_(&world), noise_(noise) {
    draws_.seed = seed;
  }
  PlantStatus read(Measurement& measurement) override;
  void write(const JointTargets& targets) override { plant_->write(targets); }

 private:
  Plant* plant_;
  const World* world_;
  double noise_;
  RandomSequence draws_{.stream = RandomStream::senses, .trial = 1};
};

/// What whiskers and infrared sensors of a robot sense in its world: a whisker bends if ground or a block is between its
/// root and its tip, and a beam measures the distance to the nearest of them. Whiskers weigh nothing and
/// push nothing. Time, odometry and pitch are those of the controller's measurement: not set.
/// @param noise        of the beams, as a share of what they measure
/// @param noise_draws  advanced only if there is noise
[[nodiscard]] navigation::Senses sense(const World& world, const navigation::SenseLayout& layout,
                                       double noise, RandomSequence& noise_draws);

}  // namespace hexagait::sim3d
