// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/gait_state/gait_choice.hpp>
#include <hexagait/heading_control/heading.hpp>
#include <hexagait/math/planar.hpp>
#include <hexagait/recording/plant_setup.hpp>
#include <hexagait/sim3d/terrain.hpp>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// What a page may ask for. One message is one JSON object, flat, with a "type":
///
///     {"type":"drive","radius":2.5,"crab":0.3}         metres, radians; or "curvature":0.4 [1/m]
///     {"type":"spin","turn":"ccw"}                     or "cw"
///     {"type":"twist","vx":0.1,"vy":0,"wz":0.2}        of the body, [m/s], [rad/s]; an upper limit
///     {"type":"stop"}
///     {"type":"follow","points":[[0,0],[2,0.5]],"closed":false}     in the world [m], 2 to 100 of them
///     {"type":"follow","path":"square"}                a path that comes along, from where it is
///     {"type":"action","action":"wave"}                an action that comes along, checked and performed
///     {"type":"action","yaml":"steps: …","name":"my.yaml"}          one of the client's own; it names no file
///     {"type":"pause","on":true}    {"type":"step","ticks":1}    {"type":"speed","factor":0.25}
///     {"type":"scramble"}           {"type":"push","angle":1.57}  direction in the body frame
///     {"type":"gait","gait":"wave:0.75"}               or free, tripod
///     {"type":"race","on":true,"gait":"tripod"}        a second robot beside it, of any gait of hexagait walk
///     {"type":"race","on":false}
///     {"type":"fault","fault":"weak:LF_knee:50%"}      as of hexagait walk --fault, from now on
///     {"type":"mend"}                                  without faults, where it is
///     {"type":"plant","plant":"real"}                  a preset of hexagait list plants, where it is
///     {"type":"reset"}                                 robot and ground as they began
///     {"type":"restart","robot":"argos","terrain":"boxes:10cm","seed":2}   each may be left out
///     {"type":"beat"}               a sign of life from who holds the wheel
///     {"type":"release"}            gives the wheel back
///     {"type":"estop"}              emergency stop: from anybody, at once, however much was sent before
///     {"type":"release_estop"}      ends it: the robot stands until it is steered
///
/// An action ends with stop, and with whatever makes the robot walk. drive, spin and follow may have a "limit" of the speed [m/s of path]. An unknown key is refused, as a
/// key that is missing is.
namespace hexagait::viewer {

inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

struct Drive {
  heading_control::Heading heading = heading_control::Heading::stop();
  double limit = kNoLimit;  ///< [m/s of path]
};
struct DriveTwist {
  PlanarTwist twist;  ///< [m/s, rad/s]
};
struct Stop {};
/// A path through points, or one by its name, of those that the server lists.
struct Follow {
  std::vector<Vector2> points_W;  ///< [m]
  bool closed = false;
  std::string name = {};    ///< if not empty there are no points
  double limit = kNoLimit;  ///< [m/s of path]
};
/// A scripted action: one by its name, of those that the server lists, or a text.
struct Perform {
  std::string name;  ///< with a text: what it is called, and no more
  std::string yaml;  ///< empty: the action of that name
};
struct Pause {
  bool on = true;
};
struct SingleStep {
  int ticks = 1;
};
struct SpeedFactor {
  double factor = 1.0;
};
struct Scramble {};
struct Push {
  double angle = 0.0;  ///< from the body's x [rad]
};
struct ChangeGait {
  gait_state::StepperParams stepper;
};
struct Race {
  std::optional<gait_state::GaitChoice> rival;  ///< nothing: the race is over
};
struct Break {
  walk::PartFault fault;  ///< there from now on; not resolved()
};
struct Mend {};
struct ChangePlant {
  const recording::PlantPreset* preset = nullptr;  ///< never null
};
struct Reset {};
struct Restart {
  std::optional<std::string> robot;  ///< a name, of those that the server lists; never a path
  std::optional<sim3d::TerrainSpec> terrain;
  std::optional<std::uint64_t> seed;
};
struct Beat {};
struct Release {};
struct EmergencyStop {};
struct ReleaseEmergencyStop {};

using Command =
    std::variant<Drive, DriveTwist, Stop, Follow, Perform, Pause, SingleStep, SpeedFactor, Scramble,
                 Push, ChangeGait, Race, Break, Mend, ChangePlant, Reset, Restart, Beat, Release,
                 EmergencyStop, ReleaseEmergencyStop>;

/// Does it make the robot walk, or perform an action?
[[nodiscard]] bool is_motion(const Command& command);

/// What of it only a simulated robot can do, as "be pushed"; null if a live one can do it too.
[[nodiscard]] const char* only_simulated(const Command& command);

/// Why a message is no command, in words for the person who sent it.
struct CommandError {
  std::string what;
};

/// The longest message that is read, but for an action of the client's own [bytes].
inline constexpr std::size_t kMaxMessage = 4096;
/// The longest action of a client's own [bytes]; and the longest message with one, which must begin with
/// {"type":"action": in JSON, line ends and quotation marks have two bytes.
inline constexpr std::size_t kMaxAction = 65536;
inline constexpr std::size_t kMaxActionMessage = 2 * kMaxAction + kMaxMessage;
/// The most points of a path that is drawn.
inline constexpr std::size_t kMostPathPoints = 100;
/// The highest terrain that a page may ask for [m].
inline constexpr double kMaxTerrain = 0.5;

/// Reads a message. A pure function: the same text, the same answer; it never throws.
/// @returns an error for what is too long, not UTF-8, not JSON, of an unknown type, or with a value
///          that is missing, unknown, not finite or out of range
[[nodiscard]] std::variant<Command, CommandError> parse_command(std::string_view text);

}  // namespace hexagait::viewer
