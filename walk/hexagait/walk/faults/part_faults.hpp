// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <hexagait/plant/plant.hpp>
#include <hexagait/walk/faults/history.hpp>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Faults of one part of a robot: a leg, a joint, a sensor; and what happens to it from outside. What
/// is wrong with all parts alike is PlantFaults'.
namespace hexagait::walk {

enum class PartFaultKind : std::uint8_t {
  dead,
  cut,
  weak,
  contact_on,
  contact_off,
  contact_late,
  contact_noise,
  noise,
  bias,
  load,
  push,
};

/// One fault. As text, for command lines and sweep files, a line of part_fault_kinds() each:
///
///     dead:LF@5s    weak:LF_knee:0.5    contact_late:RM:50ms@2s    load:15kg:10cm:0    push:50Ns:90deg@3s
///
/// `@TIME` is that of the walk; without it the fault is there from the beginning.
struct PartFault {
  PartFaultKind kind = PartFaultKind::dead;
  std::string part;                 ///< name of the leg or the joint, as it was written
  double value = 0.0;               ///< share, [s], [rad], [kg] or [N s]
  Vector2 place = Vector2::Zero();  ///< load: of its centre of mass, body frame [m]
  double direction = 0.0;           ///< push: in the body, 0 forward, 90° to the left [rad]
  double start = -std::numeric_limits<double>::infinity();  ///< time of the walk [s]
  std::string text;                                         ///< as it was written

  // Filled in by resolved():
  LegId leg = -1;
  int joint = -1;

  friend bool operator==(const PartFault&, const PartFault&) = default;
};

/// A kind of fault: what `hexagait list faults` shows.
struct PartFaultWords {
  PartFaultKind kind;
  const char* syntax;  ///< "weak:JOINT:SHARE"
  const char* meaning;
};
[[nodiscard]] std::span<const PartFaultWords> part_fault_kinds();

/// The words before the first colon of all kinds.
[[nodiscard]] const std::vector<std::string>& part_fault_names();

/// What may be written behind the part in a fault of this kind, for a try: "50%", "50ms". A load is 0.3
/// of this robot's mass, a push of what gives it √(g h)/4, with the height h of its body. Empty where
/// there is nothing to write.
[[nodiscard]] std::string example_values(PartFaultKind kind, const RobotModel& robot);

/// Reads one fault.
/// @throws InvalidInput  naming what is wrong in the text and what would be right
[[nodiscard]] PartFault parse_part_fault(std::string_view text);

/// The faults with the legs and joints of this robot.
/// @throws InvalidInput  naming every part that the robot does not have, and those that it has
[[nodiscard]] std::vector<PartFault> resolved(std::vector<PartFault> faults,
                                              const RobotModel& robot);

/// The robot with the loads among the faults fixed to its base: as it is, not as its controller knows.
/// A load is a point on top of the base's origin.
[[nodiscard]] RobotModel with_loads(RobotModel robot, std::span<const PartFault> faults);

/// What a simulated body can suffer. It outlives the plant that uses it.
struct BodyAccess {
  std::function<void(LegId leg)> cut;
  std::function<void(LegId leg, int joint, double share)> weaken;    ///< of its greatest effort
  std::function<void(const Vector2& force_B, double seconds)> push;  ///< [N], at the base
};

/// A plant with faults of parts:
///
///     read   joints ─▶ noise, bias ─▶        contacts ─▶ late ─▶ noise ─▶ stuck ─▶ controller
///     write  controller ─▶ bias; dead: driven by no effort ─▶ servos; then what happens to the body
///
/// Deterministic, as FaultyPlant. Without faults it passes everything on, bit by bit. Allocates when it
/// is made, and at the first push, cut or weakening.
class PartFaultPlant final : public Plant {
 public:
  /// @param plant       must outlive this
  /// @param faults      resolved()
  /// @param control_dt  of one read() and write() [s]
  /// @param lead        time before the walk begins, from the first read() on [s]
  PartFaultPlant(Plant& plant, std::vector<PartFault> faults, BodyAccess body, double control_dt,
                 double lead, std::uint64_t seed);

  PlantStatus read(Measurement& measurement) override;
  void write(const JointTargets& targets) override;

  /// One more fault, from the next read() or write() on, as if it had been there when this was made; but
  /// not a load, which is the body's from the beginning. Allocates.
  /// @param fault  resolved()
  void add(PartFault fault);

 private:
  [[nodiscard]] double time() const { return static_cast<double>(periods_) * dt_ - lead_; }
  [[nodiscard]] bool begun(const PartFault& fault) const;
  [[nodiscard]] double draw(std::size_t fault, std::uint32_t more) const;
  void misread(std::size_t index, Measurement& measurement);
  void suffer();

  Plant* plant_;
  std::vector<PartFault> faults_;
  BodyAccess body_;
  double dt_, lead_;
  std::uint64_t seed_;
  std::uint64_t periods_ = 0;
  std::vector<bool> suffered_;           ///< per fault: the body has it
  std::vector<History<char>> contacts_;  ///< per fault: of its leg, if they come late
};

}  // namespace hexagait::walk
