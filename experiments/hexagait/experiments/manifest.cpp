// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/experiments/manifest.hpp>
#include <hexagait/recording/detail/walk_json.hpp>

namespace hexagait::experiments {
namespace {

using recording::finite;
using recording::Json;

Json bound_json(const Bound& bound) {
  return {{"least", finite(bound.least)}, {"most", finite(bound.most)}, {"open", bound.open}};
}

const char* to_string(Finding finding) {
  constexpr const char* kNames[] = {"holds", "fails", "fails_as_expected", "holds_unexpectedly",
                                    "fails_otherwise"};
  return kNames[static_cast<std::size_t>(finding)];
}

Json check_json(const Check& check, bool safety) {
  const Measured& m = check.measured();
  Json json{{"name", m.name},
            {"value", finite(m.value)},
            {"unit", m.unit},
            {"claimed", bound_json(check.bound())},
            {"finding", to_string(check.finding())},
            {"safety", safety}};
  if (m.interval) json["interval_95"] = {finite(m.interval->lower), finite(m.interval->upper)};
  if (!m.detail.empty()) json["detail"] = m.detail;
  if (check.band()) json["expected"] = bound_json(*check.band());
  if (check.band()) json["why_not"] = check.reason();
  return json;
}

Json verdicts_json(const std::vector<Verdict>& verdicts) {
  Json list = Json::array();
  for (const Verdict& verdict : verdicts) {
    Json checks = Json::array();
    for (const SafetyCheck& safe : verdict.safety) checks.push_back(check_json(safe.check(), true));
    if (verdict.not_judged.empty())
      for (const Check& check : verdict.checks) checks.push_back(check_json(check, false));
    list.push_back({{"claim", verdict.claim},
                    {"holds", verdict.not_judged.empty() ? Json(verdict.holds()) : Json()},
                    {"as_expected", verdict.is_accounted_for()},
                    {"word", verdict.word()},
                    {"checks", checks}});
    if (!verdict.remark.empty()) list.back()["remark"] = verdict.remark;
    if (!verdict.not_judged.empty()) list.back()["not_judged"] = verdict.not_judged;
  }
  return list;
}

Json settings_json(const Outcome& outcome) {
  Json json = Json::object();
  for (const auto& [name, value] : outcome.settings) json[name] = value;
  return json;
}

}  // namespace

bool Manifest::is_accounted_for() const {
  if (!outcome.left.empty()) return true;
  const bool judges_all = !short_form && plant.is_ideal() && outcome.judges_all;
  return !outcome.verdicts.empty() &&
         std::ranges::all_of(outcome.verdicts, [&](const Verdict& verdict) {
           return verdict.is_accounted_for() && (verdict.not_judged.empty() || !judges_all);
         });
}

std::string to_json(const Manifest& manifest) {
  Json outputs = Json::object();
  for (const Manifest::Output& output : manifest.outputs)
    outputs[output.name] = {{"fnv1a", recording::hex(output.hash)}};
  const Outcome& outcome = manifest.outcome;
  Json json{{"schema", recording::kJsonSchema},
            {"experiment", manifest.experiment},
            {"title", manifest.title},
            {"short_form", manifest.short_form},
            {"plant", recording::json(manifest.plant)},
            {"provenance", recording::json(manifest.provenance)}};
  json["configuration"] =
      outcome.walk ? recording::configuration(*outcome.walk) : settings_json(outcome);
  json["verdicts"] = verdicts_json(outcome.verdicts);
  if (outcome.walk) json["results"] = recording::results(*outcome.walk);
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
