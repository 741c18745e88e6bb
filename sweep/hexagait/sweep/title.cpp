// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "title.hpp"

#include <fmt/format.h>

#include <hexagait/recording/version.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <nlohmann/json.hpp>

namespace hexagait::sweep {
namespace {

using nlohmann::ordered_json;

constexpr int kFormat = 1;

ordered_json robots(const Sweep& sweep) {
  ordered_json list = ordered_json::array();
  for (const Robot& robot : sweep.robots)
    list.push_back({{"name", robot.name}, {"urdf", fmt::format("{:016x}", robot.file_hash)}});
  return list;
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

ordered_json without_shard(const std::string& title) {
  ordered_json json = ordered_json::parse(title);
  json.erase("shard");
  return json;
}

}  // namespace

std::string to_title(const Sweep& sweep, const Shard& shard) {
  ordered_json json = {
      {"format", kFormat},
      {"version", fmt::format("{} ({})", recording::kVersion, recording::kRevision)},
      {"compiler", recording::kCompiler},
      {"simulator", to_string(sweep.engine)}};
  for (const gait_state::GaitChoice& choice : sweep.controllers)
    json["controllers"].push_back(to_string(choice));
  json["robots"] = robots(sweep);
  for (const Ground& ground : sweep.terrains) json["terrains"].push_back(ground.terrain);
  json["seeds"] = seeds(sweep);
  json["limits"] = limits(sweep);
  json["measure"] = sweep.measure;
  json["header"] = header(sweep);
  json["trials"] = num_trials(sweep);
  json["shard"] = {shard.index + 1, shard.count};
  return json.dump();
}

Title parse_title(const std::string& title, const std::string& place) {
  try {
    const ordered_json json = ordered_json::parse(title);
    if (json.at("format") != kFormat)
      throw InvalidInput(fmt::format("{}: is of format {}; this program reads format {}", place,
                                     json.at("format").dump(), kFormat));
    return {.identity = without_shard(title).dump(),
            .header = json.at("header"),
            .measure = json.at("measure"),
            .trials = json.at("trials"),
            .shard = {json.at("shard").at(0).get<std::uint64_t>() - 1, json.at("shard").at(1)}};
  } catch (const ordered_json::exception&) {
    throw InvalidInput(fmt::format("{}: its first line is not that of a sweep", place));
  }
}

std::string whole_title(const std::string& title) {
  ordered_json json = ordered_json::parse(title);
  json["shard"] = {1, 1};
  return json.dump();
}

std::string to_manifest(const std::string& title, std::uint64_t trials, std::uint64_t rows_hash,
                        double wall) {
  ordered_json json = ordered_json::parse(title);
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
  for (const auto& [key, value] : a.items())
    if (!b.contains(key) || b[key] != value)
      lines.push_back(fmt::format("{}: {} against {}", key, value.dump(),
                                  b.contains(key) ? b[key].dump() : "nothing"));
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
