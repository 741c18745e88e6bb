// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim3d/terrain.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <limits>
#include <numbers>

namespace hexagait::sim3d {
namespace {

constexpr double kPad = kPadCells * kCellEdge;  // half an edge of the start pad [m]
constexpr double kAbyss = -1.0;                 // level of ditches, pits, and between stones [m]
constexpr double kWall = 1.0;                   // level of an arena's walls and pillars [m]
constexpr int kStretch = 4;                // cells of its border that are all wall or all cliff
constexpr double kDitchPeriod = 1.5;       // of which the ditch is a part [m]
constexpr int kFlight = 10, kLanding = 5;  // steps of the stairs
constexpr double kTwist = 1.0;  // way in which ground that rises sideways becomes a plane [m]
constexpr double kIce = 0.6;    // edge of the squares of ice [m]
constexpr std::uint32_t kDrawsPerCell = 4;

// Does cell i reach into the start pad, which ends so far from the origin?
bool on_pad(const CellAxis& axis, int i, double pad = kPad) {
  constexpr double kTie = 1e-6;
  return axis.edge(i + 1) > -pad + kTie && axis.edge(i) < pad - kTie;
}

// The first cell ahead of the start pad.
int first_ahead(const CellAxis& axis) {
  const int i = axis.index(kPad);
  return on_pad(axis, i) ? i + 1 : i;
}

// How far from the pad, along one axis.
double beyond_pad(double coordinate) { return std::max(0.0, std::abs(coordinate) - kPad); }

bool has_cells(TerrainKind kind) {
  using enum TerrainKind;
  return kind == boxes || kind == step || kind == stairs || kind == ditches || kind == stones ||
         kind == cliff || kind == arena;
}

// Is its extent the edge of its cells?
bool chooses_cells(TerrainKind kind) {
  using enum TerrainKind;
  return kind == boxes || kind == steps || kind == rubble;
}

bool is_random(TerrainKind kind) {
  using enum TerrainKind;
  return kind == boxes || kind == steps || kind == rubble || kind == ice || kind == arena;
}

bool has_height(TerrainKind kind) { return kind != TerrainKind::ice && kind != TerrainKind::soft; }

// Steps up and down again: level, as a number of steps, of the n-th step ahead.
int stairs_level(int n) {
  const int k = n % (2 * (kFlight + kLanding));
  if (k < kFlight) return k + 1;
  if (k < kFlight + kLanding) return kFlight;
  return std::max(0, 2 * kFlight + kLanding - 1 - k);
}

// Lowest and highest level.
std::pair<double, double> bounds(const TerrainPart& part) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double size = part.size;
  switch (part.kind) {
    case TerrainKind::flat:
    case TerrainKind::ice:
    case TerrainKind::soft:
      return {0.0, 0.0};
    case TerrainKind::stairs:
      return {std::min(0.0, kFlight * size), std::max(0.0, kFlight * size)};
    case TerrainKind::ditches:
    case TerrainKind::stones:
      return {kAbyss, 0.0};
    case TerrainKind::cliff:
      return {-part.extent, 0.0};
    case TerrainKind::arena:
      return {kAbyss, kWall};
    case TerrainKind::slope:
      return {-kInfinity, kInfinity};
    default:
      return {std::min(0.0, size), std::max(0.0, size)};
  }
}

std::pair<double, double> bounds(double size, const Heightmap& map) {
  const double a = size * map.lowest(), b = size * map.highest();
  return {std::min({0.0, a, b}), std::max({0.0, a, b})};
}

}  // namespace

double CellAxis::edge(int i) const {
  if (odd == 0.0) return i * even;
  const int pairs = i >= 0 ? i / 2 : -((1 - i) / 2);
  return pairs * (even + odd) + (i == 2 * pairs ? 0.0 : even);
}

double CellAxis::middle(int i) const {
  return odd == 0.0 ? (i + 0.5) * even : 0.5 * (edge(i) + edge(i + 1));
}

int CellAxis::index(double coordinate) const {
  if (odd == 0.0) return static_cast<int>(std::floor(coordinate / even));
  const int pairs = static_cast<int>(std::floor(coordinate / (even + odd)));
  return 2 * pairs + (coordinate >= edge(2 * pairs + 1) ? 1 : 0);
}

Terrain::Terrain(const TerrainSpec& spec, std::uint64_t seed) : spec_(spec), seed_(seed) {
  // Its words say which dimensions are wrong.
  static_cast<void>(parse_terrain(to_string(spec)));

  std::uint32_t draws = 0;
  for (const TerrainPart& part : spec_.parts) {
    if (part.kind == TerrainKind::flat) continue;
    layers_.push_back(layer(part, draws));
    if (is_random(part.kind)) draws += kDrawsPerCell;
    const auto [lowest, highest] =
        part.kind == TerrainKind::heightmap ? bounds(part.size, layers_.back().map) : bounds(part);
    lowest_ += lowest;
    highest_ += highest;
    if (part.kind == TerrainKind::soft && (!softness_ || part.size < softness_->stiffness))
      softness_ = {part.size, part.extent};
    if (chooses_cells(part.kind)) spacing_ = std::min(spacing_, part.extent / kSamplesPerCell);
  }
  int high = 0, of_cells = 0;
  for (const Layer& one : layers_) {
    if (!has_height(one.part.kind)) continue;
    ++high;
    if (!has_cells(one.part.kind)) continue;
    ++of_cells;
    cells_ = one.cells;
  }
  if (high > 0) surface_ = high == 1 && of_cells == 1 ? Surface::cells : Surface::samples;
}

Terrain::Layer Terrain::layer(const TerrainPart& part, std::uint32_t draws) {
  Layer result{.part = part, .cells = {}, .draws = draws};
  if (chooses_cells(part.kind))
    result.cells = {{part.extent, 0.0}, {part.extent, 0.0}, kPadCells * part.extent};
  switch (part.kind) {
    case TerrainKind::stairs:
      result.cells.x = {part.extent, 0.0};
      break;
    case TerrainKind::ditches:
      result.cells.x = {kDitchPeriod - part.size, part.size};
      break;
    case TerrainKind::stones:
      result.cells.x = result.cells.y = {part.size, part.extent};
      break;
    case TerrainKind::cliff:
      result.cells.x = result.cells.y = {0.5 * part.size, 0.0};
      break;
    case TerrainKind::slope: {
      const portable::SinCos angle = portable::sincos(part.size);
      const portable::SinCos direction = portable::sincos(part.extent);
      result.along = angle.s / angle.c * direction.c;
      result.across = angle.s / angle.c * direction.s;
      break;
    }
    case TerrainKind::heightmap:
      result.map = load_heightmap(part.file);
      break;
    case TerrainKind::ice:
      result.cells = {{kIce, 0.0}, {kIce, 0.0}};
      break;
    default:
      break;
  }
  return result;
}

double Terrain::random(const Layer& layer, std::uint32_t which, int i, int j) const {
  // The pair of indices is the draw, so every cell has its own random numbers.
  const std::uint64_t high = static_cast<std::uint32_t>(i), low = static_cast<std::uint32_t>(j);
  return random_u01(seed_, RandomStream::terrain, layer.draws + which, (high << 32) | low);
}

// Of a part that has one level in each cell.
double Terrain::level(const Layer& layer, int i, int j) const {
  const auto& [x, y, half_pad] = layer.cells;
  const double size = layer.part.size;
  const bool pad_x = on_pad(x, i, half_pad), pad = pad_x && on_pad(y, j, half_pad);
  switch (layer.part.kind) {
    case TerrainKind::boxes:
    case TerrainKind::steps:
      return pad ? 0.0 : size * random(layer, 0, i, j);
    case TerrainKind::step:
      return i >= first_ahead(x) ? size : 0.0;
    case TerrainKind::stairs:
      return i >= first_ahead(x) ? size * stairs_level(i - first_ahead(x)) : 0.0;
    case TerrainKind::ditches:
      return i % 2 != 0 && !pad_x ? kAbyss : 0.0;
    case TerrainKind::stones:
      return x.odd > 0.0 && (i % 2 != 0 || j % 2 != 0) && !pad ? kAbyss : 0.0;
    case TerrainKind::cliff:
      return i < -1 || i > 0 || j < -1 || j > 0 ? -layer.part.extent : 0.0;
    case TerrainKind::arena:
      return pad ? 0.0 : arena(layer, i, j);
    default:
      return 0.0;
  }
}

// The outermost ring of cells is wall or cliff, by lot in each stretch; inside, a cell is a pit, a
// pillar or the floor by lot.
double Terrain::arena(const Layer& layer, int i, int j) const {
  const CellAxis& axis = layer.cells.x;
  // Cells 0 … last are those whose middles are within half an edge; −1 … −1 − last the others.
  const int last = std::max(0, axis.index(0.5 * (layer.part.size + axis.even)) - 1);
  const auto from_middle = [](int k) { return k >= 0 ? k : -1 - k; };
  const int farthest = std::max(from_middle(i), from_middle(j));
  if (farthest > last) return kAbyss;
  if (farthest == last) {
    const auto stretch = [](int k) {
      return static_cast<int>(std::floor(static_cast<double>(k) / kStretch));
    };
    const bool across = from_middle(i) == last;  // a side that x = constant runs along
    const int side = across ? i : j, along = stretch(across ? j : i);
    return random(layer, across ? 0 : 1, side, along) < 0.5 ? kWall : kAbyss;
  }
  const double share = layer.part.extent, lot = random(layer, 2, i, j);
  return lot >= share ? 0.0 : lot < 0.5 * share ? kAbyss : kWall;
}

// Level and tilt are such that no corner is below 0 or above the height.
double Terrain::rubble(const Layer& layer, double x, double y) const {
  const auto& [of_x, of_y, pad] = layer.cells;
  const int i = of_x.index(x), j = of_y.index(y);
  if (on_pad(of_x, i, pad) && on_pad(of_y, j, pad)) return 0.0;
  const double size = layer.part.size, half = 0.5 * of_x.even;
  // Rise from the middle to an edge.
  const double rise_x = 0.25 * size * (2.0 * random(layer, 1, i, j) - 1.0);
  const double rise_y = 0.25 * size * (2.0 * random(layer, 2, i, j) - 1.0);
  const double corner = std::abs(rise_x) + std::abs(rise_y);
  const double middle = corner + (size - 2.0 * corner) * random(layer, 0, i, j);
  return middle + rise_x * ((x - of_x.edge(i)) / half - 1.0) +
         rise_y * ((y - of_y.edge(j)) / half - 1.0);
}

// The picture lies ahead of the pad, its left edge at the pad's end, its middle row straight ahead.
double Terrain::on_map(const Layer& layer, double x, double y) {
  if (x < kPad) return 0.0;
  const double pixel = layer.part.extent / layer.map.columns;
  return layer.part.size *
         layer.map.at((x - kPad) / pixel - 0.5, 0.5 * (layer.map.rows - 1) - y / pixel);
}

double Terrain::height(const Layer& layer, double x, double y) const {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const auto& [kind, size, extent, file] = layer.part;
  const double ahead = std::max(0.0, x - kPad);
  switch (kind) {
    case TerrainKind::slope:
      return layer.along * ahead + layer.across * y * std::min(ahead / kTwist, 1.0);
    case TerrainKind::waves: {
      const double of_x = 1.0 - portable::cos(kTurn * beyond_pad(x) / extent);
      const double of_y = 1.0 - portable::cos(kTurn * beyond_pad(y) / extent);
      return 0.25 * size * (of_x + of_y);
    }
    case TerrainKind::ramps: {
      const double t = 0.5 * ahead / extent, phase = t - std::floor(t);
      return size * (phase < 0.5 ? 2.0 * phase : 2.0 - 2.0 * phase);
    }
    case TerrainKind::rubble:
      return rubble(layer, x, y);
    case TerrainKind::heightmap:
      return on_map(layer, x, y);
    default:
      return level(layer, layer.cells.x.index(x), layer.cells.y.index(y));
  }
}

double Terrain::level(int i, int j) const {
  if (surface_ != Surface::cells) return 0.0;
  double sum = 0.0;
  for (const Layer& one : layers_)
    if (has_cells(one.part.kind)) sum += level(one, i, j);
  return sum;
}

double Terrain::height_at(double x, double y) const {
  switch (surface_) {
    case Surface::plane:
      return 0.0;
    case Surface::cells:
      return level(cells_.x.index(x), cells_.y.index(y));
    case Surface::samples:
      return heightfield_at(x, y);
  }
  return 0.0;
}

double Terrain::friction_at(double x, double y, double otherwise) const {
  for (const Layer& one : layers_) {
    if (one.part.kind != TerrainKind::ice) continue;
    const int i = one.cells.x.index(x), j = one.cells.y.index(y);
    const bool pad = on_pad(one.cells.x, i) && on_pad(one.cells.y, j);
    if (!pad && random(one, 0, i, j) < 0.5) return one.part.size;
  }
  return otherwise;
}

double Terrain::sample(int a, int b) const {
  const double x = (a + 0.5) * sample_spacing(), y = (b + 0.5) * sample_spacing();
  double sum = 0.0;
  for (const Layer& one : layers_) sum += height(one, x, y);
  return sum;
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
