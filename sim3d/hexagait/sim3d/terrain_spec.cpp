// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <hexagait/sim3d/terrain_spec.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/nearest_word.hpp>
#include <hexagait/text/quantity.hpp>
#include <limits>
#include <numbers>

namespace hexagait::sim3d {
namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();

/// A dimension of a kind of terrain.
struct Measure {
  std::string_view name;  ///< empty: the kind has none
  Dimension dimension = Dimension::length;
  double least = 0.0, most = kAny;
  std::string_view range = "0 or more";
};

constexpr Measure kHeight{"the height"};
constexpr Measure kSignedHeight{"the height", Dimension::length, -kAny, kAny, ""};
constexpr Measure kLength{"the length", Dimension::length, 0.05, kAny, "0.05 m or more"};
constexpr Measure kEdge{"the width", Dimension::length, 0.005, kAny, "5 mm or more"};
constexpr double kSteepest = std::numbers::pi / 3.0;

/// A kind of terrain in words; all there is to read and write it.
struct KindWords {
  TerrainKind kind;
  TerrainDescription description;
  Measure size;
  Measure extent = {};
  double usual_extent = 0.0;
  bool is_height = true;  ///< its size is a height

  constexpr std::string_view name() const {
    return description.syntax.substr(0, description.syntax.find(':'));
  }
};

constexpr TerrainDescription kFlat = {"flat", "the plane z = 0", "flat"};
constexpr std::array kKinds = {
    KindWords{TerrainKind::boxes,
              {"boxes:H,WIDTH", "cells of 0.3 m at random levels from 0 to H, with vertical faces",
               "boxes:10cm"},
              kHeight,
              kEdge,
              kCellEdge},
    KindWords{TerrainKind::steps,
              {"steps:H,WIDTH",
               "the same levels as a heightfield: 25 mm wide ramps instead of vertical faces",
               "steps:10cm"},
              kHeight,
              kEdge,
              kCellEdge},
    KindWords{
        TerrainKind::step,
        {"step:H", "one step up to H, or down, 0.6 m ahead of where the robot starts", "step:12cm"},
        kSignedHeight},
    KindWords{TerrainKind::stairs,
              {"stairs:H,TREAD", "flights of 10 steps up (H < 0: down) and back; treads of 0.29 m",
               "stairs:12cm,35cm"},
              kSignedHeight,
              {"the tread", Dimension::length, 0.05, kAny, "0.05 m or more"},
              0.29},
    KindWords{TerrainKind::ditches,
              {"ditches:W", "ditches of width W across the way, 1 m deep, one in each 1.5 m",
               "ditches:15cm"},
              {"the width", Dimension::length, 0.01, 0.8, "0.01 to 0.8 m"},
              {},
              0.0,
              false},
    KindWords{TerrainKind::stones,
              {"stones:EDGE,GAP", "square stepping stones, 1 m above the ground; gaps of 0.15 m",
               "stones:25cm,8cm"},
              {"the edge", Dimension::length, 0.02, kAny, "0.02 m or more"},
              {"the gap", Dimension::length, 0.0, kAny, "0 or more"},
              0.15,
              false},
    KindWords{TerrainKind::slope,
              {"slope:ANGLE,DIRECTION", "a plane that rises ahead, or in this direction from ahead",
               "slope:10deg,90deg"},
              {"the angle", Dimension::angle, -kSteepest, kSteepest, "-60 to 60 degrees"},
              {"the direction", Dimension::angle, -kAny, kAny, ""},
              0.0,
              false},
    KindWords{TerrainKind::waves,
              {"waves:H,LENGTH", "sines along x and y, 0 to H; waves of 1.5 m", "waves:10cm,1m"},
              kHeight,
              kLength,
              1.5},
    KindWords{
        TerrainKind::ramps,
        {"ramps:H,LENGTH", "ramps up to H and down again in turn; each 1 m long", "ramps:15cm"},
        kHeight,
        kLength,
        1.0},
    KindWords{TerrainKind::rubble,
              {"rubble:H,WIDTH",
               "cells of 0.3 m, 0 to H, each tilted at random; 25 mm wide ramps between them",
               "rubble:10cm"},
              kHeight,
              kEdge,
              kCellEdge},
    KindWords{TerrainKind::ice,
              {"ice:MU", "squares of 0.6 m, half of which have the friction MU", "ice:0.1"},
              {"the friction", Dimension::number, 0.0, 10.0, "0 to 10"},
              {},
              0.0,
              false},
    KindWords{TerrainKind::cliff,
              {"cliff:EDGE,DEPTH", "a square around the start; beyond its edges it is 1 m down",
               "cliff:3m,50cm"},
              {"the edge", Dimension::length, 1.2, kAny, "1.2 m or more"},
              {"the depth", Dimension::length, 0.05, kAny, "0.05 m or more"},
              1.0,
              false},
    KindWords{TerrainKind::arena,
              {"arena:EDGE,SHARE",
               "a square between walls and cliffs of 1 m; 4 % of its cells are pits or pillars",
               "arena:4m,0.06"},
              {"the edge", Dimension::length, 2.0, kAny, "2 m or more"},
              {"the share", Dimension::number, 0.0, 0.5, "0 to 0.5"},
              0.04,
              false},
    KindWords{TerrainKind::heightmap,
              {"heightmap:H,LENGTH,FILE",
               "a grey PNG or a table (CSV), ahead, so long; white, or 1, is H high",
               "heightmap:20cm,4m,dunes.png", true},
              kSignedHeight,
              {"the length", Dimension::length, 0.1, kAny, "0.1 m or more"}},
    KindWords{
        TerrainKind::soft,
        {"soft:K,D", "feet sink in by their load / K [N/m]; damping 1000 N s/m", "soft:20000"},
        {"the stiffness", Dimension::number, 100.0, 1e8, "100 to 1e8 N/m"},
        {"the damping", Dimension::number, 0.0, 1e7, "0 to 1e7 N s/m"},
        1000.0,
        false}};

const KindWords& words(TerrainKind kind) {
  return *std::ranges::find(kKinds, kind, &KindWords::kind);
}

[[noreturn]] void refuse(std::string_view text, const std::string& reason) {
  std::string message = "terrain \"";
  message.append(text).append("\": ").append(reason).append("; known terrains:");
  for (const TerrainDescription& known : known_terrains()) message.append(" ").append(known.syntax);
  throw InvalidInput(message + ", and sums such as slope:10deg+boxes:10cm");
}

double read(std::string_view text, std::string_view value, const Measure& measure) {
  const auto [number, problem] = parse_quantity(value, measure.dimension);
  if (!problem.empty()) refuse(text, problem);
  if (number < measure.least || number > measure.most)
    refuse(text, std::string(measure.name) + " must be " + std::string(measure.range) + ", not " +
                     std::string(value));
  return number;
}

// What follows the size of a kind that reads a file: extent and file.
TerrainPart with_file(std::string_view text, TerrainPart part, const KindWords& known,
                      std::string_view values) {
  const std::size_t first = values.find(',');
  const std::size_t second = first == std::string_view::npos ? first : values.find(',', first + 1);
  if (second == std::string_view::npos || second + 1 == values.size())
    refuse(text,
           "its length or its file is missing: write " + std::string(known.description.example));
  part.extent = read(text, values.substr(first + 1, second - first - 1), known.extent);
  part.file = values.substr(second + 1);
  if (part.file.find_first_of(",\"\n") != std::string::npos)
    refuse(text, "the name of the file must not have commas, quotes or line breaks");
  return part;
}

// `text` is the whole terrain, for messages.
TerrainPart parse_part(std::string_view text, std::string_view part) {
  const std::size_t colon = part.find(':');
  const std::string_view name = part.substr(0, colon);
  const auto known = std::ranges::find(kKinds, name, &KindWords::name);
  if (known == kKinds.end()) {
    std::vector<std::string> names = {std::string(kFlat.syntax)};
    for (const KindWords& kind : kKinds) names.emplace_back(kind.name());
    refuse(text, "unknown kind" + did_you_mean(name, names));
  }
  if (colon == std::string_view::npos) refuse(text, std::string(known->size.name) + " is missing");

  std::string with_commas(part.substr(colon + 1));
  std::ranges::replace(with_commas, ';', ',');
  const std::string_view values = with_commas;
  const std::size_t comma = values.find(',');
  TerrainPart result{
      known->kind, read(text, values.substr(0, comma), known->size), known->usual_extent, {}};
  if (known->description.reads_file) return with_file(text, result, *known, values);
  if (comma == std::string_view::npos) return result;
  if (known->extent.name.empty())
    refuse(text, std::string(name) + " takes one number, " + std::string(known->size.name));
  result.extent = read(text, values.substr(comma + 1), known->extent);
  return result;
}

// Where the next part begins: behind a + that is no sign of an exponent.
std::size_t end_of_part(std::string_view text, std::size_t begin) {
  const auto is_sign = [&](std::size_t at) {
    return at + 1 < text.size() &&
           (text[at + 1] == '.' || ('0' <= text[at + 1] && text[at + 1] <= '9'));
  };
  std::size_t end = text.find('+', begin);
  while (end != std::string_view::npos && is_sign(end)) end = text.find('+', end + 1);
  return std::min(end, text.size());
}

std::string shortest(double value) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return {digits.data(), end};
}

}  // namespace

TerrainSpec::TerrainSpec(TerrainKind kind, double size) {
  if (kind != TerrainKind::flat) parts = {{kind, size, words(kind).usual_extent, {}}};
}

double TerrainSpec::roughness() const {
  double sum = 0.0;
  for (const TerrainPart& part : parts)
    if (part.kind != TerrainKind::flat && words(part.kind).is_height) sum += std::abs(part.size);
  return sum;
}

const std::vector<TerrainDescription>& known_terrains() {
  static const std::vector<TerrainDescription> known = [] {
    std::vector<TerrainDescription> all = {kFlat};
    for (const KindWords& kind : kKinds) all.push_back(kind.description);
    return all;
  }();
  return known;
}

TerrainSpec parse_terrain(std::string_view text) {
  TerrainSpec spec;
  if (text == kFlat.syntax) return spec;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = end_of_part(text, begin);
    spec.parts.push_back(parse_part(text, text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return spec;
}

std::string to_string(const TerrainSpec& spec) {
  std::string text;
  for (const TerrainPart& part : spec.parts) {
    if (part.kind == TerrainKind::flat) continue;
    const KindWords& kind = words(part.kind);
    if (!text.empty()) text += '+';
    text.append(kind.name()).append(":").append(shortest(part.size));
    if (part.extent != kind.usual_extent) text.append(",").append(shortest(part.extent));
    if (kind.description.reads_file) text.append(",").append(part.file);
  }
  return text.empty() ? std::string(kFlat.syntax) : text;
}

}  // namespace hexagait::sim3d
