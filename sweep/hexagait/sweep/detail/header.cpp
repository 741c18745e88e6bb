// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/recording/detail/walk_json.hpp>
#include <hexagait/sweep/detail/header.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <nlohmann/json.hpp>

namespace hexagait::sweep {
namespace {

using nlohmann::ordered_json;

constexpr int kFormat = 3;

// Version, parameters, models of all robots, and the versions of the libraries, but not of a simulator
// that the sweep does not use: rows that another version of it could not change may be merged.
ordered_json provenance(const Sweep& sweep) {
  recording::Provenance result = recording::provenance();
  if (sweep.engine == Engine::box2d) result = recording::provenance(sim2d::GenghisTrial{});
  if (sweep.engine == Engine::ode) {
    result = recording::provenance(sweep.robots[0].name, sweep.robots[0].model, {});
    result.robots.clear();
    for (const Robot& robot : sweep.robots)
      result.robots.push_back({robot.name, recording::model_hash(robot.model)});
  }
  std::erase_if(result.libraries, [&](const auto& library) {
    return (library.first == "ODE" && sweep.engine != Engine::ode) ||
           (library.first == "Box2D" && sweep.engine != Engine::box2d);
  });
  return recording::json(result);
}

ordered_json limits(const Sweep& sweep) {
  const Limits& l = sweep.limits;
  if (sweep.engine == Engine::slice) return {{"slices", l.slices}};
  return {
      {"seconds", l.seconds}, {"distance_m", l.distance}, {"random_posture_m", l.random_posture}};
}

ordered_json seeds(const Sweep& sweep) {
  if (!sweep.seeds.empty()) return sweep.seeds;
  return {{"number", sweep.num_seeds}, {"master", sweep.master_seed}};
}

// Hashes of the files that terrains read: other contents make other rows.
ordered_json files(const Sweep& sweep) {
  ordered_json json;
  if (sweep.engine != Engine::ode) return json;
  for (const Ground& ground : sweep.terrains)
    for (const sim3d::TerrainPart& part : sim3d::parse_terrain(ground.terrain).parts)
      if (!part.file.empty())
        json[part.file] = recording::hex(sim3d::load_heightmap(part.file).hash());
  return json;
}

ordered_json without_shard(const std::string& header) {
  ordered_json json = ordered_json::parse(header);
  json.erase("shard");
  return json;
}

// A difference per value of nested objects, each with its path.
void compare(const std::string& path, const ordered_json& a, const ordered_json& b,
             std::vector<std::string>& lines) {
  if (a == b) return;
  if (!a.is_object() || !b.is_object()) {
    const auto words = [](const ordered_json& json) {
      return json.is_null() ? "nothing" : json.dump();
    };
    lines.push_back(fmt::format("{}: {} against {}", path, words(a), words(b)));
    return;
  }
  const auto at = [](const ordered_json& json, const std::string& key) {
    return json.contains(key) ? json[key] : ordered_json();
  };
  ordered_json all = a;
  all.update(b);
  for (const auto& [key, value] : all.items())
    compare(path.empty() ? key : path + "." + key, at(a, key), at(b, key), lines);
}

}  // namespace

std::string to_header(const Sweep& sweep, const Shard& shard) {
  ordered_json json = {{"format", kFormat}};
  json.update(provenance(sweep));
  json["simulator"] = to_string(sweep.engine);
  for (const gait_state::GaitChoice& choice : sweep.controllers)
    json["controllers"].push_back(to_string(choice));
  if (sweep.engine == Engine::ode)
    for (const recording::PlantSetup& plant : sweep.plants)
      json["plants"][plant.name] = recording::json(plant);
  for (const Ground& ground : sweep.terrains) json["terrains"].push_back(ground.terrain);
  const ordered_json read = files(sweep);
  if (!read.is_null()) json["files"] = read;
  json["seeds"] = seeds(sweep);
  json["limits"] = limits(sweep);
  json["measure"] = sweep.measure;
  json["columns"] = csv_header(sweep);
  json["trials"] = num_trials(sweep);
  json["shard"] = {shard.index + 1, shard.count};
  return json.dump();
}

Header parse_header(const std::string& header, const std::string& place) {
  try {
    const ordered_json json = ordered_json::parse(header);
    if (json.at("format") != kFormat)
      throw InvalidInput(fmt::format("{}: is of format {}; this program reads format {}", place,
                                     json.at("format").dump(), kFormat));
    Header result{
        .columns = json.at("columns"),
        .measure = json.at("measure"),
        .trials = json.at("trials"),
        .shard = {json.at("shard").at(0).get<std::uint64_t>() - 1, json.at("shard").at(1)}};
    for (const Engine engine : kEngines)
      if (json.at("simulator") == to_string(engine)) result.engine = engine;
    return result;
  } catch (const ordered_json::exception&) {
    throw InvalidInput(fmt::format("{}: its first line is not that of a sweep", place));
  }
}

std::string whole_header(const std::string& header) {
  ordered_json json = ordered_json::parse(header);
  json["shard"] = {1, 1};
  return json.dump();
}

std::string to_manifest(const std::string& header, std::uint64_t trials, std::uint64_t rows_hash,
                        double wall) {
  ordered_json json = ordered_json::parse(header);
  json["trials_done"] = trials;
  json["rows_hash"] = fmt::format("{:016x}", rows_hash);
  json["outputs"] = {"trials.csv", "timings.csv"};
  json["timing"] = {{"trials_wall_s", wall}};
  return json.dump(2);
}

std::vector<std::string> differences(const std::string& here, const std::string& there,
                                     bool with_shard) {
  const ordered_json a = with_shard ? ordered_json::parse(here) : without_shard(here);
  const ordered_json b = with_shard ? ordered_json::parse(there) : without_shard(there);
  std::vector<std::string> lines;
  compare("", a, b, lines);
  return lines;
}

void require_same(const std::string& wanted, const std::string& found,
                  const std::filesystem::path& directory) {
  const std::vector<std::string> lines = differences(wanted, found, true);
  if (lines.empty()) return;
  throw InvalidInput(fmt::format("'{}' holds another sweep; asked for, against there:\n  {}",
                                 directory.string(), fmt::join(lines, "\n  ")));
}

}  // namespace hexagait::sweep
