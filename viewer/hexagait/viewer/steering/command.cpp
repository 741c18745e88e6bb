// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <hexagait/gait_state/gait_choice.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/steering/command.hpp>
#include <nlohmann/json.hpp>
#include <numbers>

namespace hexagait::viewer {
namespace {

using heading_control::Heading;
using JsonValue = nlohmann::json;

constexpr double kFullTurn = 2.0 * std::numbers::pi;
constexpr std::size_t kLongestWord = 64;
constexpr std::string_view kActionBegins = R"({"type":"action")";

// The values of a message. Refuses by InvalidInput, which parse_command() turns into an answer.
class Message {
 public:
  Message(const JsonValue& json, std::string type) : json_(json), type_(std::move(type)) {}

  [[nodiscard]] bool has(const char* key) const { return json_.contains(key); }

  [[nodiscard]] double number(const char* key, double least, double greatest) const {
    const JsonValue& value = at(key);
    if (!value.is_number()) refuse(key, "it must be a number");
    const auto result = value.get<double>();
    if (!std::isfinite(result) || result < least || result > greatest)
      refuse(key, fmt::format("it must be from {:.4g} to {:.4g}", least, greatest));
    return result;
  }

  [[nodiscard]] double number_or(const char* key, double least, double greatest,
                                 double otherwise) const {
    return has(key) ? number(key, least, greatest) : otherwise;
  }

  [[nodiscard]] std::uint64_t count(const char* key, std::uint64_t least,
                                    std::uint64_t greatest) const {
    const JsonValue& value = at(key);
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() < least ||
        value.get<std::uint64_t>() > greatest)
      refuse(key, fmt::format("it must be a whole number from {} to {}", least, greatest));
    return value.get<std::uint64_t>();
  }

  [[nodiscard]] bool truth(const char* key) const {
    if (!at(key).is_boolean()) refuse(key, "it must be true or false");
    return at(key).get<bool>();
  }

  [[nodiscard]] std::string word(const char* key) const {
    if (!at(key).is_string() || at(key).get_ref<const std::string&>().size() > kLongestWord)
      refuse(key, fmt::format("it must be a text of at most {} letters", kLongestWord));
    return at(key).get<std::string>();
  }

  // No other keys than these, and type.
  void only(std::initializer_list<std::string_view> keys) const {
    for (const auto& [key, value] : json_.items())
      if (key != "type" && std::ranges::find(keys, std::string_view(key)) == keys.end())
        throw InvalidInput(fmt::format("\"{}\" has no \"{}\"", type_, key.substr(0, 32)));
  }

  [[nodiscard]] const JsonValue& at(const char* key) const {
    const auto found = json_.find(key);
    if (found == json_.end()) refuse(key, "it is missing");
    return *found;
  }

  [[noreturn]] void refuse(const char* key, const std::string& why) const {
    throw InvalidInput(fmt::format("\"{}\" of \"{}\": {}", key, type_, why));
  }

 private:
  const JsonValue& json_;
  std::string type_;
};

double limit(const Message& m) { return m.number_or("limit", 0.0, 10.0, kNoLimit); }

Command drive(const Message& m) {
  m.only({"radius", "curvature", "crab", "limit"});
  if (m.has("radius") == m.has("curvature"))
    throw InvalidInput("\"drive\" needs one of \"radius\" and \"curvature\"");
  const double crab = m.number_or("crab", -kFullTurn, kFullTurn, 0.0);
  double curvature = 0.0;
  if (m.has("curvature")) {
    curvature = m.number("curvature", -1e3, 1e3);
  } else {
    const double radius = m.number("radius", -1e6, 1e6);
    if (std::abs(radius) < 1e-3)
      m.refuse("radius", "it must be at least 1 mm; to turn on the spot, spin");
    curvature = 1.0 / radius;
  }
  const Vector2 along = unit_vector(crab);
  return Drive{Heading::along(along, curvature), limit(m)};
}

Command spin(const Message& m) {
  m.only({"turn", "limit"});
  const std::string turn = m.word("turn");
  if (turn != "ccw" && turn != "cw") m.refuse("turn", "it must be ccw (to the left) or cw");
  using heading_control::Turn;
  return Drive{Heading::spin(turn == "ccw" ? Turn::ccw : Turn::cw), limit(m)};
}

Vector2 point(const Message& m, const JsonValue& json) {
  constexpr double kFar = 1e5;  // [m]
  const auto refuse = [&] {
    m.refuse("points",
             fmt::format("each must be [x, y] of numbers from {:.4g} to {:.4g}", -kFar, kFar));
  };
  if (!json.is_array() || json.size() != 2) refuse();
  Vector2 p;
  for (std::size_t k = 0; k < 2; ++k) {
    if (!json[k].is_number()) refuse();
    const auto value = json[k].get<double>();
    if (!(std::abs(value) <= kFar)) refuse();
    p[static_cast<Eigen::Index>(k)] = value;
  }
  return p;
}

Command follow(const Message& m) {
  m.only({"points", "closed", "path", "limit"});
  if (m.has("points") == m.has("path"))
    throw InvalidInput("\"follow\" needs one of \"points\" and \"path\"");
  Follow result;
  result.limit = limit(m);
  if (m.has("path")) {
    m.only({"path", "limit"});
    result.name = m.word("path");
    if (result.name.empty()) m.refuse("path", "it must not be empty");
    return result;
  }
  if (m.has("closed")) result.closed = m.truth("closed");
  const JsonValue& points = m.at("points");
  if (!points.is_array() || points.size() < 2 || points.size() > kMostPathPoints)
    m.refuse("points", fmt::format("it must be a list of 2 to {} points", kMostPathPoints));
  for (const JsonValue& one : points) result.points_W.push_back(point(m, one));
  return result;
}

// The name of a text is shown, and names nothing.
Command action(const Message& m) {
  if (m.has("yaml") == m.has("action"))
    throw InvalidInput("\"action\" needs one of \"action\" and \"yaml\"");
  const char* const key = m.has("yaml") ? "name" : "action";
  Perform result;
  result.name = m.word(key);
  if (result.name.empty()) m.refuse(key, "it must not be empty");
  if (m.has("action")) {
    m.only({"action"});
    return result;
  }
  m.only({"yaml", "name"});
  const JsonValue& yaml = m.at("yaml");
  if (!yaml.is_string() || yaml.get_ref<const std::string&>().empty() ||
      yaml.get_ref<const std::string&>().size() > kMaxAction)
    m.refuse("yaml", fmt::format("it must be a text of 1 to {} bytes", kMaxAction));
  result.yaml = yaml.get<std::string>();
  return result;
}

Command twist(const Message& m) {
  m.only({"vx", "vy", "wz"});
  DriveTwist result;
  result.twist.v = {m.number("vx", -10.0, 10.0), m.number("vy", -10.0, 10.0)};
  result.twist.w = m.number("wz", -10.0, 10.0);
  return result;
}

Command gait(const Message& m) {
  m.only({"gait"});
  const auto choice = gait_state::parse_gait_choice(m.word("gait"));
  if (!choice || choice->adjustment != gait_state::Adjustment::latched || choice->open_loop)
    m.refuse("gait", "it must be free, tripod or wave:BETA with BETA from 0.5 to less than 1");
  return ChangeGait{choice->stepper};
}

Command race(const Message& m) {
  m.only({"on", "gait"});
  if (!m.truth("on")) {
    m.only({"on"});
    return Race{};
  }
  const auto choice = gait_state::parse_gait_choice(m.word("gait"));
  if (!choice) m.refuse("gait", fmt::format("it must be {}", gait_state::kGaitChoices));
  return Race{choice};
}

Command fault(const Message& m) {
  m.only({"fault"});
  const std::string text = m.word("fault");
  if (text.find('@') != std::string::npos)
    m.refuse("fault", "it begins when it comes; leave out the @ and what is behind it");
  return Break{walk::parse_part_fault(text)};
}

Command plant(const Message& m) {
  m.only({"plant"});
  const auto& presets = recording::plant_presets();
  const auto preset = std::ranges::find(presets, m.word("plant"), &recording::PlantPreset::name);
  if (preset != presets.end()) return ChangePlant{&*preset};
  std::vector<std::string_view> names;
  names.reserve(presets.size());
  for (const auto& one : presets) names.push_back(one.name);
  m.refuse("plant", fmt::format("it must be {}", fmt::join(names, " or ")));
}

Command restart(const Message& m) {
  m.only({"robot", "terrain", "seed"});
  Restart result;
  if (m.has("robot")) result.robot = m.word("robot");
  if (m.has("terrain")) result.terrain = sim3d::parse_terrain(m.word("terrain"));
  if (result.terrain && std::ranges::any_of(result.terrain->parts,
                                            [](const auto& part) { return !part.file.empty(); }))
    m.refuse("terrain", "it must not name a file; files are named where the walk is started");
  if (result.terrain && result.terrain->roughness() > kMaxTerrain)
    m.refuse("terrain", fmt::format("its height must be at most {} m", kMaxTerrain));
  if (m.has("seed")) result.seed = m.count("seed", 0, 1ULL << 53U);
  return result;
}

template <class Plain>
Command plain(const Message& m) {
  m.only({});
  return Plain{};
}

struct Kind {
  const char* type;
  Command (*read)(const Message&);
};
constexpr std::array kKinds = {
    Kind{"drive", drive},
    Kind{"spin", spin},
    Kind{"twist", twist},
    Kind{"stop", plain<Stop>},
    Kind{"follow", follow},
    Kind{"action", action},
    Kind{"pause",
         [](const Message& m) -> Command {
           m.only({"on"});
           return Pause{m.truth("on")};
         }},
    Kind{"step",
         [](const Message& m) -> Command {
           m.only({"ticks"});
           return SingleStep{static_cast<int>(m.count("ticks", 1, 500))};
         }},
    Kind{"speed",
         [](const Message& m) -> Command {
           m.only({"factor"});
           return SpeedFactor{m.number("factor", 0.05, 10.0)};
         }},
    Kind{"scramble", plain<Scramble>},
    Kind{"push",
         [](const Message& m) -> Command {
           m.only({"angle"});
           return Push{m.number("angle", -kFullTurn, kFullTurn)};
         }},
    Kind{"gait", gait},
    Kind{"race", race},
    Kind{"fault", fault},
    Kind{"mend", plain<Mend>},
    Kind{"plant", plant},
    Kind{"reset", plain<Reset>},
    Kind{"restart", restart},
    Kind{"beat", plain<Beat>},
    Kind{"release", plain<Release>},
    Kind{"estop", plain<EmergencyStop>},
    Kind{"release_estop", plain<ReleaseEmergencyStop>},
};

// Well-formed by RFC 3629: no overlong form, no surrogate, nothing above U+10FFFF.
bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t k) {
      return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U;
    };
    const unsigned first = byte(i);
    const std::size_t more = first < 0x80   ? 0
                             : first < 0xC2 ? 4
                             : first < 0xE0 ? 1
                             : first < 0xF0 ? 2
                             : first < 0xF5 ? 3
                                            : 4;
    if (more == 4) return false;
    for (std::size_t k = 1; k <= more; ++k)
      if ((byte(i + k) & 0xC0U) != 0x80) return false;
    const unsigned second = byte(i + 1);
    if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
        (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F))
      return false;
    i += more + 1;
  }
  return true;
}

Command command_of(const JsonValue& json) {
  const auto type = json.find("type");
  if (type == json.end() || !type->is_string()) throw InvalidInput("a message needs a \"type\"");
  const auto& name = type->get_ref<const std::string&>();
  const auto kind = std::ranges::find_if(kKinds, [&](const Kind& k) { return name == k.type; });
  if (kind == kKinds.end())
    throw InvalidInput(fmt::format("there is no \"{}\" to ask for", name.substr(0, 32)));
  return kind->read(Message(json, name));
}

struct OnlySimulated {
  const char* operator()(const Pause&) const { return "be paused"; }
  const char* operator()(const SingleStep&) const { return "be moved tick by tick"; }
  const char* operator()(const SpeedFactor&) const { return "be slowed down with its time"; }
  const char* operator()(const Scramble&) const { return "be put down with other legs"; }
  const char* operator()(const Push&) const { return "be pushed"; }
  const char* operator()(const Race&) const { return "race"; }
  const char* operator()(const Break&) const { return "be broken"; }
  const char* operator()(const Mend&) const { return "be mended"; }
  const char* operator()(const ChangePlant&) const { return "have another plant"; }
  const char* operator()(const Reset&) const { return "begin again"; }
  const char* operator()(const Restart&) const { return "be another robot, or on other ground"; }
  const char* operator()(const auto& /*other*/) const { return nullptr; }
};

}  // namespace

bool is_motion(const Command& command) {
  return std::holds_alternative<Drive>(command) || std::holds_alternative<DriveTwist>(command) ||
         std::holds_alternative<Follow>(command) || std::holds_alternative<Perform>(command);
}

const char* only_simulated(const Command& command) { return std::visit(OnlySimulated(), command); }

std::variant<Command, CommandError> parse_command(std::string_view text) {
  const std::size_t most = text.starts_with(kActionBegins) ? kMaxActionMessage : kMaxMessage;
  if (text.size() > most)
    return CommandError{fmt::format("the message has more than {} bytes", most)};
  if (!is_utf8(text)) return CommandError{"the message is not UTF-8"};
  const JsonValue json = JsonValue::parse(text, nullptr, false);
  if (json.is_discarded()) return CommandError{"the message is not JSON"};
  if (!json.is_object()) return CommandError{"the message is not a JSON object"};
  try {
    return command_of(json);
  } catch (const InvalidInput& error) {
    return CommandError{error.what()};
  }
}

}  // namespace hexagait::viewer
