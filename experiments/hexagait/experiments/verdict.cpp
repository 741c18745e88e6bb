// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/experiments/verdict.hpp>
#include <hexagait/recording/detail/walk_json.hpp>
#include <hexagait/recording/version.hpp>

namespace hexagait::experiments {
namespace {

using recording::Json;

Json verdicts_json(const std::vector<Verdict>& verdicts) {
  Json list = Json::array();
  for (const Verdict& verdict : verdicts) {
    list.push_back(
        {{"claim", verdict.claim}, {"holds", verdict.holds}, {"numbers", verdict.numbers}});
    if (!verdict.why_not.empty()) list.back()["why_not"] = verdict.why_not;
  }
  return list;
}

Json settings_json(const Outcome& outcome) {
  Json json = Json::object();
  for (const auto& [name, value] : outcome.settings) json[name] = value;
  return json;
}

}  // namespace

std::string to_json(const Manifest& manifest) {
  Json outputs = Json::object();
  for (const Manifest::Output& output : manifest.outputs)
    outputs[output.name] = {{"fnv1a", recording::hex(output.hash)}};
  const Outcome& outcome = manifest.outcome;
  Json json{{"experiment", manifest.experiment},
            {"title", manifest.title},
            {"version", recording::kVersion},
            {"revision", recording::kRevision},
            {"compiler", recording::kCompiler}};
  json["configuration"] =
      outcome.walk ? recording::configuration(*outcome.walk) : settings_json(outcome);
  json["verdicts"] = verdicts_json(outcome.verdicts);
  if (outcome.walk) json["results"] = recording::results(outcome.walk->summary);
  json["outputs"] = outputs;
  json["timing"] = outcome.walk ? recording::timing(outcome.walk->summary) : Json::object();
  if (outcome.compute_seconds > 0.0) json["timing"]["compute_s"] = outcome.compute_seconds;
  return json.dump(2);
}

std::string to_json(const std::vector<Manifest>& manifests) {
  Json json = Json::object();
  for (const Manifest& manifest : manifests)
    json[manifest.experiment] = verdicts_json(manifest.outcome.verdicts);
  return json.dump(2);
}

}  // namespace hexagait::experiments
