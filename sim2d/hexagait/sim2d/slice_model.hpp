// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <hexagait/gait_state/decide.hpp>
#include <hexagait/gait_state/gait_choice.hpp>
#include <hexagait/sim2d/slice_terrain.hpp>

/// The 2D slice model of [PC04] 5.1: gaits without mechanics, in time slices and units of length.
///
/// A foot's place p counts from its workspace centre, forwards. A step takes 1 slice to raise and
/// advance the foot, which is then at p = +25 in the body frame, and 5 to descend on flat ground.
/// In each slice
///
///     gait state (gait 4) → who may step → who does (gait 5) → those lift: p = +25
///     d = Σ_all p_i / n_support,   support feet: p ← p − d,   the body advances by d     (slice 1)
///     feet in the air come down; those that touch the ground stand from the next slice on
///
/// So the feet, those in the air included, end each slice centred on average. A tripod advances
/// exactly 50 units every 6 slices on flat ground.
///
/// **Bound.** Two neighbours a, b never share the air. While one flies the body passes over the
/// other, which sweeps at most S in the body frame in a stance. So with d their step times
///
///     v ≤ 2 S / (d_a + d_b)      for every pair of neighbours                           (slice 2)
///
/// up to the two stances with which the run began: distance ≤ bound · slices + 2 S. The model does
/// not limit S; a robot does.
namespace hexagait::sim2d {

/// Where a foot lands, ahead of its workspace centre, and how far from it feet start at most.
inline constexpr double kHalfStroke = 25.0;  // [units]

struct SliceConfig {
  gait_state::GaitChoice gait = {};
  SliceTerrain terrain = {};
  int slices = 500;
  int num_legs = 6;
};

/// What one slice did.
struct SliceRecord {
  gait_state::GaitDecision gait;
  LegSet lifted;         ///< legs that began a step
  LegSet airborne;       ///< legs in the air in this slice, those that lifted included
  double advance = 0.0;  ///< of the body [units]
};

/// How a run went.
struct SliceSummary {
  int slices = 0;
  double distance = 0.0;     ///< of the body [units]
  double speed = 0.0;        ///< mean [units per slice]
  int lifts = 0;             ///< steps begun, of all legs
  double step_time = 0.0;    ///< mean time in the air of the steps that ended [slices]
  double stroke = 0.0;       ///< S: the longest way of a foot in the body frame in a stance [units]
  double mean_stroke = 0.0;  ///< the same, mean of the stances that ended [units]
  double bound = 0.0;        ///< (slice 2) with this S and the slowest pair [units per slice]
  int tripod_after = -1;     ///< slices before the first lift from which on whole tripods alternate
                             ///< to the end, six at least; −1 if the run does not end so
  std::uint64_t hash = 0;    ///< FNV-1a of all lifts and the last state

  [[nodiscard]] double fraction_of_bound() const { return bound > 0.0 ? speed / bound : 0.0; }
};

/// The robot of the slice model. A value: a copy continues identically. No allocation.
class SliceRobot {
 public:
  /// All feet on the ground, at places uniform in ±25 (RandomStream::posture).
  SliceRobot(const SliceConfig& config, const SliceSeed& seed);

  /// All feet on the ground, at these places.
  SliceRobot(const SliceConfig& config, const SliceSeed& seed, const LegArray<double>& foot);

  /// One slice.
  SliceRecord advance();

  [[nodiscard]] const LegArray<double>& foot() const { return foot_; }  ///< p [units]
  [[nodiscard]] LegSet airborne() const { return airborne_; }
  [[nodiscard]] double position() const { return position_; }  ///< of the body [units]
  [[nodiscard]] SliceSummary summary() const;

 private:
  void lift(LegSet legs);
  double move_body();
  void lower_feet();
  [[nodiscard]] bool touches_ground(LegId leg);
  void land(LegId leg);
  void watch_tripods(LegSet lifted);

  SliceConfig config_;
  SliceSeed seed_;
  gait_state::GaitParams gait_params_;
  gait_state::GaitMemory memory_;
  int slice_ = 0;

  // Feet and body.
  LegArray<double> foot_;
  LegSet airborne_;
  LegArray<int> in_air_;  // slices since the leg lifted
  LegArray<int> due_;     // slices in the air after which it lands; unused in profile mode
  double position_ = 0.0;

  // Profile mode: ground under the foot, the cell it was last looked up in, the last footholds.
  LegArray<double> ground_, foothold_;
  LegArray<std::int64_t> cell_;

  // What the summary tells.
  LegArray<double> stance_from_;  // where the stance began [units]
  LegArray<int> lifts_, landings_, air_time_;
  double longest_stroke_ = 0.0, stroke_sum_ = 0.0;
  LegSet last_lifted_;
  int tripods_ = 0, tripods_since_ = -1;
  std::uint64_t hash_;
};

/// Called after each slice.
using SliceObserver = std::function<void(const SliceRecord& record, const SliceRobot& robot)>;

/// A trial: a pure function of its arguments.
SliceSummary run_slices(const SliceConfig& config, const SliceSeed& seed,
                        const SliceObserver& observer = {});

}  // namespace hexagait::sim2d
