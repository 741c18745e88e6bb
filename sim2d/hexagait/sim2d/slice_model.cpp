// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <bit>
#include <hexagait/sim/fnv1a.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim2d/slice_model.hpp>
#include <limits>

namespace hexagait::sim2d {
namespace {

constexpr double kTie = 1.0;        // lags that differ by no more are tied: 2 % of a stroke [units]
constexpr double kClearance = 5.0;  // a foot is raised so far above the body's level
constexpr double kContact = 0.5;    // half of what a foot descends in a slice
constexpr int kTripods = 6;         // in a row make a tripod gait

LegArray<double> random_posture(int num_legs, const SliceSeed& seed) {
  RandomSequence random{.seed = seed.seed, .stream = RandomStream::posture, .trial = seed.trial};
  LegArray<double> foot(num_legs);
  for (double& place : foot) place = random.uniform(-kHalfStroke, kHalfStroke);
  return foot;
}

}  // namespace

SliceRobot::SliceRobot(const SliceConfig& config, const SliceSeed& seed)
    : SliceRobot(config, seed, random_posture(config.num_legs, seed)) {}

SliceRobot::SliceRobot(const SliceConfig& config, const SliceSeed& seed,
                       const LegArray<double>& foot)
    : config_(config),
      seed_(seed),
      gait_params_{.tie_tolerance = kTie, .adjustment = config.gait.adjustment},
      memory_(foot.size(), 1.0 + descent_of({}, seed, 0, 0)),
      foot_(foot),
      in_air_(foot.size(), 0),
      due_(foot.size(), 0),
      ground_(foot.size(), 0.0),
      foothold_(foot.size(), 0.0),
      cell_(foot.size(), std::numeric_limits<std::int64_t>::min()),
      stance_from_(foot),
      lifts_(foot.size(), 0),
      landings_(foot.size(), 0),
      air_time_(foot.size(), 0),
      hash_(kFnv1aBasis) {
  if (config.terrain.kind != SliceTerrain::Kind::profile) return;
  for (LegId leg = 0; leg < foot.size(); ++leg) {
    cell_[leg] = cell_at(config.terrain, foot[leg]);
    ground_[leg] = cell_height(config.terrain, seed, leg, cell_[leg]);
    foothold_[leg] = ground_[leg];
  }
}

SliceRecord SliceRobot::advance() {
  gait_state::GaitInput input{LegArray<double>(foot_.size()), airborne_, {}};
  for (LegId leg = 0; leg < foot_.size(); ++leg) input.lag[leg] = -foot_[leg];

  SliceRecord record;
  const gait_state::StepDecision decision = gait_state::decide(
      memory_, input, {.time = static_cast<double>(slice_)}, gait_params_, config_.gait.stepper);
  record.gait = decision.gait;
  record.lifted = decision.lifts;
  if (!record.lifted.empty()) lift(record.lifted);
  record.airborne = airborne_;
  record.advance = move_body();
  lower_feet();
  ++slice_;
  return record;
}

void SliceRobot::lift(LegSet legs) {
  for (LegId leg = 0; leg < foot_.size(); ++leg) {
    if (!legs.contains(leg)) continue;
    const double stroke = stance_from_[leg] - foot_[leg];
    longest_stroke_ = std::max(longest_stroke_, stroke);
    stroke_sum_ += stroke;
    if (config_.terrain.kind != SliceTerrain::Kind::profile)
      due_[leg] = 1 + descent_of(config_.terrain, seed_, leg, lifts_[leg]);
    ++lifts_[leg];
    in_air_[leg] = 0;
    foot_[leg] = kHalfStroke;
  }
  airborne_ = airborne_ | legs;
  watch_tripods(legs);
  hash_ = fnv1a(static_cast<std::uint32_t>(slice_), hash_);
  hash_ = fnv1a(static_cast<std::uint16_t>(legs.bits()), hash_);
}

// (slice 1)
double SliceRobot::move_body() {
  double sum = 0.0;
  for (const double place : foot_) sum += place;
  const double advance = sum / (foot_.size() - airborne_.size());
  for (LegId leg = 0; leg < foot_.size(); ++leg)
    if (!airborne_.contains(leg)) foot_[leg] -= advance;
  position_ += advance;
  return advance;
}

void SliceRobot::lower_feet() {
  const bool has_profile = config_.terrain.kind == SliceTerrain::Kind::profile;
  LegSet landed;
  for (LegId leg = 0; leg < foot_.size(); ++leg) {
    if (!airborne_.contains(leg)) continue;
    ++in_air_[leg];
    if (has_profile ? touches_ground(leg) : in_air_[leg] == due_[leg]) landed.insert(leg);
  }
  // After all have looked: each foothold changes the body's level.
  for (LegId leg = 0; leg < foot_.size(); ++leg)
    if (landed.contains(leg)) land(leg);
}

// (slice 3)
bool SliceRobot::touches_ground(LegId leg) {
  const std::int64_t cell = cell_at(config_.terrain, position_ + foot_[leg]);
  if (cell != cell_[leg]) {
    cell_[leg] = cell;
    ground_[leg] = cell_height(config_.terrain, seed_, leg, cell);
  }
  const int descended = in_air_[leg] - 1;
  double level = 0.0;
  for (const double height : foothold_) level += height;
  level /= foothold_.size();
  return descended > 0 && kClearance - descended + level <= ground_[leg] + kContact;
}

void SliceRobot::land(LegId leg) {
  airborne_.erase(leg);
  foothold_[leg] = ground_[leg];
  stance_from_[leg] = foot_[leg];
  air_time_[leg] += in_air_[leg];
  ++landings_[leg];
}

void SliceRobot::watch_tripods(LegSet lifted) {
  const int n = foot_.size();
  const bool is_tripod =
      lifted == gait_state::first_tripod(n) || lifted == gait_state::second_tripod(n);
  if (!is_tripod || lifted == last_lifted_) tripods_ = 0;
  if (is_tripod && tripods_++ == 0) tripods_since_ = slice_;
  last_lifted_ = lifted;
}

SliceSummary SliceRobot::summary() const {
  const int n = foot_.size();
  SliceSummary s{.slices = slice_, .distance = position_, .stroke = longest_stroke_, .hash = hash_};
  if (slice_ > 0) s.speed = position_ / slice_;
  if (tripods_ >= kTripods) s.tripod_after = tripods_since_;

  int landings = 0, air_time = 0;
  for (LegId leg = 0; leg < n; ++leg) {
    s.lifts += lifts_[leg];
    landings += landings_[leg];
    air_time += air_time_[leg];
    if (!airborne_.contains(leg)) s.stroke = std::max(s.stroke, stance_from_[leg] - foot_[leg]);
    s.hash = fnv1a(std::bit_cast<std::uint64_t>(foot_[leg]), s.hash);
  }
  s.hash = fnv1a(static_cast<std::uint16_t>(airborne_.bits()), s.hash);
  s.hash = fnv1a(std::bit_cast<std::uint64_t>(position_), s.hash);
  if (s.lifts > 0) s.mean_stroke = stroke_sum_ / s.lifts;
  if (landings > 0) s.step_time = static_cast<double>(air_time) / landings;

  // (slice 2): 2 S / (d_a + d_b), with the mean of the steps that the pair made.
  double longest = 0.0;
  for (int k = 0; k < n; ++k) {
    const LegId a = gait_state::leg_at(k, n), b = gait_state::leg_at((k + 1) % n, n);
    const int steps = landings_[a] + landings_[b];
    if (steps > 0)
      longest = std::max(longest, static_cast<double>(air_time_[a] + air_time_[b]) / steps);
  }
  if (longest > 0.0) s.bound = s.stroke / longest;
  return s;
}

SliceSummary run_slices(const SliceConfig& config, const SliceSeed& seed,
                        const SliceObserver& observer) {
  SliceRobot robot(config, seed);
  for (int slice = 0; slice < config.slices; ++slice) {
    const SliceRecord record = robot.advance();
    if (observer) observer(record, robot);
  }
  return robot.summary();
}

}  // namespace hexagait::sim2d
