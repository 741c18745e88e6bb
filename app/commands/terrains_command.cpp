// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/recording/figures/terrain_figure.hpp>
#include <hexagait/text/invalid_input.hpp>

#include "commands/commands.hpp"
#include "files/output_file.hpp"
#include "options/arguments.hpp"

namespace hexagait::app {
namespace {

// An example of each kind, but those that read a file.
std::vector<std::string> examples() {
  std::vector<std::string> all;
  for (const sim3d::TerrainDescription& known : sim3d::known_terrains())
    if (!known.reads_file) all.emplace_back(known.example);
  return all;
}

}  // namespace

int terrains_command(const TerrainsArguments& arguments) {
  if (arguments.plot.empty()) {
    if (!arguments.terrains.empty()) throw InvalidInput("a terrain is only drawn: add --plot FILE");
    return list_command("terrains", false);
  }
  const std::vector<std::string> terrains =
      arguments.terrains.empty() ? examples() : arguments.terrains;
  const std::uint64_t number = seed(arguments.seed);
  std::vector<recording::NamedTerrain> drawn;
  drawn.reserve(terrains.size());
  for (const std::string& terrain : terrains)
    drawn.push_back({terrain, sim3d::Terrain(sim3d::parse_terrain(terrain), number)});
  std::optional<OutputFile> plot = output_file("--plot", arguments.plot, {".png", ".svg", ".pdf"});
  figures::require_gnuplot();
  write_output("--plot", *plot, [&] {
    recording::draw_terrains(
        plot->files,
        {.stem = plot->path.stem(),
         .suffix = plot->path.extension(),
         .headline = terrains.size() == 1 ? terrains[0] : "Terrains",
         .subtitle = "From the start pad to 4.5 m ahead, 1.5 m to each side · seed " +
                     arguments.seed + " · blue: ice, brown: soft"},
        drawn);
    plot->files.publish();
  });
  return kOk;
}

}  // namespace hexagait::app
