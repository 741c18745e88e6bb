// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <charconv>
#include <cmath>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim2d/terrain2d.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/nearest_word.hpp>
#include <hexagait/text/quantity.hpp>

namespace hexagait::sim2d {
namespace {

using Kind = TerrainSpec2d::Kind;

constexpr double kPad = 0.3;        // the start pad covers |x| < kPad [m]
constexpr double kFirstEdge = 0.5;  // of a step, at least [m]
constexpr double kTread = 1.2;      // length of a step's upper, and of its lower level [m]

struct Name {
  std::string_view word;
  Kind kind;
};
constexpr std::array<Name, 3> kNames = {
    {{"rough", Kind::rough}, {"step", Kind::step}, {"steps", Kind::steps}}};

[[noreturn]] void refuse(std::string_view text, const std::string& reason) {
  std::string message = "terrain \"";
  message.append(text).append("\": ").append(reason).append("; known terrains of the side view:");
  for (const TerrainDescription2d& known : known_terrains2d())
    message.append(" ").append(known.syntax);
  throw InvalidInput(message + ", with H a height such as 0.05 or 5cm");
}

double height_of(std::string_view text, std::string_view height) {
  const auto [metres, problem] = parse_quantity(height, Dimension::length);
  if (!problem.empty()) refuse(text, problem);
  if (metres < 0.0) refuse(text, "the height must not be negative");
  return metres;
}

}  // namespace

const std::vector<TerrainDescription2d>& known_terrains2d() {
  static const std::vector<TerrainDescription2d> known = {
      {"flat", "the line z = 0"},
      {"rough:H", "0.1 m cells at random levels from 0 to H, left and right independent"},
      {"step:H", "one step up by H, 1.2 m further one down again"},
      {"steps:H", "a step up by H and one down, again and again, 1.2 m apart"},
  };
  return known;
}

TerrainSpec2d parse_terrain2d(std::string_view text) {
  if (text == "flat") return {};
  const std::size_t colon = text.find(':');
  for (const Name& name : kNames) {
    if (name.word != text.substr(0, colon)) continue;
    if (colon == std::string_view::npos) refuse(text, "the height is missing");
    return {name.kind, height_of(text, text.substr(colon + 1))};
  }
  const std::vector<std::string> kinds = {"flat", "rough", "step", "steps"};
  refuse(text, "unknown kind" + did_you_mean(text.substr(0, colon), kinds));
}

std::string to_string(const TerrainSpec2d& spec) {
  for (const Name& name : kNames) {
    if (name.kind != spec.kind) continue;
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.begin(), digits.end(), spec.height).ptr;
    return std::string(name.word).append(":").append(digits.begin(), end);
  }
  return "flat";
}

Terrain2d::Terrain2d(const TerrainSpec2d& spec, std::uint64_t seed) : spec_(spec), seed_(seed) {
  if (!(spec.height >= 0.0) || !std::isfinite(spec.height))
    throw InvalidInput("terrain height " + std::to_string(spec.height) +
                       " m: must be finite and not negative");
  first_edge_ = kFirstEdge + kCell * random_u01(seed, RandomStream::terrain, 1, 0);
}

double Terrain2d::level(Side side, long cell) const {
  const auto high = static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell)) << 1;
  return spec_.height *
         random_u01(seed_, RandomStream::terrain, 0, high | (side == Side::right ? 1U : 0U));
}

double Terrain2d::height_at(Side side, double x) const {
  if (spec_.kind == Kind::flat) return 0.0;
  if (spec_.kind == Kind::rough) {
    const long cell = std::lround(std::floor(x / kCell));
    const double middle = (static_cast<double>(cell) + 0.5) * kCell;
    return std::abs(middle) < kPad ? 0.0 : level(side, cell);
  }
  const double beyond = std::abs(x) - first_edge_;
  const bool up =
      spec_.kind == Kind::step ? beyond < kTread : std::fmod(beyond, 2.0 * kTread) < kTread;
  return beyond >= 0.0 && up ? spec_.height : 0.0;
}

// Where the level may change between x0 and x1, ascending.
std::vector<double> Terrain2d::faces(double x0, double x1) const {
  std::vector<double> places;
  if (spec_.kind == Kind::flat) return places;
  const bool rough = spec_.kind == Kind::rough;
  const double spacing = rough ? kCell : kTread;
  const long last = std::lround(std::max(std::abs(x0), std::abs(x1)) / spacing) + 1;
  const auto add = [&](double x) {
    if (x0 < x && x < x1) places.push_back(x);
  };
  const long edges = spec_.kind == Kind::step ? std::min(last, 1L) : last;
  for (long k = edges; k >= 0; --k)
    add(-(rough ? static_cast<double>(k + 1) * kCell
                : first_edge_ + static_cast<double>(k) * kTread));
  for (long k = 0; k <= edges; ++k)
    add(rough ? static_cast<double>(k) * kCell : first_edge_ + static_cast<double>(k) * kTread);
  return places;
}

std::vector<Vector2> Terrain2d::profile(Side side, double x0, double x1) const {
  constexpr double kBeside = 1e-6;  // of a face, where its two levels are [m]
  std::vector<Vector2> points = {{x0, height_at(side, x0)}};
  for (const double x : faces(x0, x1)) {
    points.emplace_back(x, height_at(side, x - kBeside));
    points.emplace_back(x, height_at(side, x + kBeside));
  }
  points.emplace_back(x1, height_at(side, x1 - kBeside));
  return points;
}

}  // namespace hexagait::sim2d
