// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <hexagait/sim/height.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim3d/terrain.hpp>
#include <hexagait/text/invalid_input.hpp>

namespace hexagait::sim3d {
namespace {

constexpr int kPadCells = 2;  // the start pad covers cells −2 … 1 of both axes

// The kinds of terrain with a height.
struct HighKind {
  std::string_view name;
  TerrainSpec::Kind kind;
};
constexpr std::array kHighKinds = {HighKind{"boxes", TerrainSpec::Kind::boxes},
                                   HighKind{"steps", TerrainSpec::Kind::steps},
                                   HighKind{"step", TerrainSpec::Kind::step}};

[[noreturn]] void refuse(std::string_view text, const std::string& reason) {
  std::string message = "terrain \"";
  message.append(text).append("\": ").append(reason).append("; known terrains:");
  for (const TerrainDescription& known : known_terrains()) {
    message.append(" ").append(known.syntax);
  }
  throw InvalidInput(message + ", with H a height such as 0.10 or 10cm");
}

double height_of(std::string_view text, std::string_view height) {
  const ParsedHeight parsed = parse_height(height);
  if (!parsed.problem.empty()) refuse(text, parsed.problem);
  return parsed.metres;
}

int floor_divide(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

}  // namespace

const std::vector<TerrainDescription>& known_terrains() {
  static const std::vector<TerrainDescription> known = {
      {"flat", "the plane z = 0"},
      {"boxes:H", "0.3 m cells at random levels from 0 to H, with vertical faces between them"},
      {"steps:H", "the same levels as a heightfield: 25 mm wide ramps instead of vertical faces"},
      {"step:H", "one step up to H, 0.6 m ahead of where the robot starts"},
  };
  return known;
}

TerrainSpec parse_terrain(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view kind = text.substr(0, colon);
  if (text == "flat") return {};
  const auto known = std::ranges::find(kHighKinds, kind, &HighKind::name);
  if (known == kHighKinds.end()) refuse(text, "unknown kind");
  if (colon == std::string_view::npos) refuse(text, "the height is missing");

  TerrainSpec spec;
  spec.kind = known->kind;
  spec.height = height_of(text, text.substr(colon + 1));
  return spec;
}

std::string to_string(const TerrainSpec& spec) {
  if (spec.kind == TerrainSpec::Kind::flat) return "flat";
  std::array<char, 32> digits{};
  const auto [end, error] =
      std::to_chars(digits.data(), digits.data() + digits.size(), spec.height);
  const auto known = std::ranges::find(kHighKinds, spec.kind, &HighKind::kind);
  return std::string(known->name) + ":" + std::string(digits.data(), end);
}

Terrain::Terrain(const TerrainSpec& spec, std::uint64_t seed) : spec_(spec), seed_(seed) {
  if (!(spec.height >= 0.0) || !std::isfinite(spec.height)) {
    throw InvalidInput("terrain height " + std::to_string(spec.height) +
                       " m: must be finite and not negative");
  }
  if (!(spec.cell > 0.0) || !std::isfinite(spec.cell)) {
    throw InvalidInput("terrain cell " + std::to_string(spec.cell) +
                       " m: must be finite and positive");
  }
}

double Terrain::level(int i, int j) const {
  const auto on_pad = [](int k) { return -kPadCells <= k && k < kPadCells; };
  if (spec_.kind == TerrainSpec::Kind::flat || (on_pad(i) && on_pad(j))) return 0.0;

  if (spec_.kind == TerrainSpec::Kind::step) return i >= kPadCells ? spec_.height : 0.0;

  // The pair of indices is the draw, so every cell has its own random number.
  const std::uint64_t high = static_cast<std::uint32_t>(i), low = static_cast<std::uint32_t>(j);
  return spec_.height * random_u01(seed_, RandomStream::terrain, 0, (high << 32) | low);
}

int Terrain::cell_index(double coordinate) const {
  return static_cast<int>(std::floor(coordinate / spec_.cell));
}

double Terrain::height_at(double x, double y) const {
  if (spec_.kind == TerrainSpec::Kind::steps) return heightfield_at(x, y);
  return level(cell_index(x), cell_index(y));
}

double Terrain::sample(int a, int b) const {
  return level(floor_divide(a, kSamplesPerCell), floor_divide(b, kSamplesPerCell));
}

double Terrain::heightfield_at(double x, double y) const {
  // Position within the square of four samples, u and v in [0, 1).
  const double s = x / sample_spacing() - 0.5, t = y / sample_spacing() - 0.5;
  const int a = static_cast<int>(std::floor(s)), b = static_cast<int>(std::floor(t));
  const double u = s - a, v = t - b;

  // Two triangles, split along the diagonal from (a, b) to (a+1, b+1).
  const double near = sample(a, b), far = sample(a + 1, b + 1);
  if (u >= v) {
    const double corner = sample(a + 1, b);
    return near + (corner - near) * u + (far - corner) * v;
  }
  const double corner = sample(a, b + 1);
  return near + (corner - near) * v + (far - corner) * u;
}

}  // namespace hexagait::sim3d
