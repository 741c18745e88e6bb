// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "words/action_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hexagait/recording/detail/walk_json.hpp>
#include <hexagait/recording/version.hpp>
#include <hexagait/walk/actions/action_check.hpp>

#include "words/words.hpp"

namespace hexagait::app {
namespace {

using recording::finite;
using recording::Json;

constexpr int kShownOfAKind = 3;  // later ones mostly follow from the first

std::string count(long number, const char* what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

long num_errors(const Preview& ahead) {
  return std::ranges::count_if(ahead.findings, [](const Finding& f) { return f.is_error; });
}

long num_warnings(const Preview& ahead) {
  return static_cast<long>(ahead.findings.size()) - num_errors(ahead);
}

std::string name(const ActionReport& report) {
  return fmt::format("{} on {}", report.input->action.id, report.input->robot.name);
}

std::string steps(const ActionReport& report) {
  return count(static_cast<long>(report.input->action.steps.size()), "step");
}

std::string margin(double metres, int step) {
  if (!std::isfinite(metres)) return "the body rests on the ground";
  return fmt::format("stability margin at least {}, in step {}", length(metres), step);
}

std::string leg_name(const ActionReport& report, LegId leg) {
  return leg < 0 ? "" : report.input->robot.legs[leg].name;
}

std::string failure(const ActionReport& report) {
  const ActionResult& result = report.summary.result;
  std::string text = fmt::format("Failed in step {}", result.step);
  if (result.leg >= 0) text += ", " + leg_name(report, result.leg);
  return text + fmt::format(": {}; ", walk::in_words(result.cause));
}

std::string ending(const ActionReport& report) {
  const walk::ActionSummary& s = report.summary;
  if (s.fell) return "Fell: ";
  if (s.fault != Fault::none) return fmt::format("Stopped by a fault ({}): ", to_string(s.fault));
  if (report.interrupted) return "Interrupted: ";
  if (s.out_of_time) return "Stopped, as it did not end: ";
  if (s.result.outcome == Outcome::failed) return failure(report);
  return s.result.outcome == Outcome::succeeded ? "Succeeded: " : "Stopped: ";
}

const char* kind(Finding::Kind kind) {
  switch (kind) {
    case Finding::Kind::out_of_reach:
      return "out_of_reach";
    case Finding::Kind::unstable:
      return "unstable";
    case Finding::Kind::narrow:
      return "narrow";
    case Finding::Kind::too_fast:
      return "too_fast";
    case Finding::Kind::not_finite:
      return "not_finite";
    case Finding::Kind::no_result:
      return "no_result";
  }
  return "?";
}

Json findings_json(const Preview& ahead) {
  Json list = Json::array();
  for (const Finding& f : ahead.findings)
    list.push_back({{"line", f.mark.line},
                    {"column", f.mark.column},
                    {"step", f.step},
                    {"severity", f.is_error ? "error" : "warning"},
                    {"kind", kind(f.kind)},
                    {"text", f.text}});
  return list;
}

Json subject(const ActionReport& report) {
  const ActionInput& input = *report.input;
  return {{"schema", recording::kJsonSchema},
          {"action", input.action.id},
          {"file", input.file},
          {"robot", input.robot.name},
          {"steps", input.action.steps.size()}};
}

Json ahead_json(const Preview& ahead) {
  return {{"errors", num_errors(ahead)},
          {"warnings", num_warnings(ahead)},
          {"findings", findings_json(ahead)},
          {"seconds", ahead.seconds},
          {"stability_margin_m", finite(ahead.least_margin)},
          {"stability_margin_step", ahead.least_margin_step},
          {"outcome", to_string(ahead.result.outcome)}};
}

}  // namespace

std::string findings(const ActionReport& report) {
  const std::vector<Finding>& all = report.ahead.findings;
  const auto alike = [](const Finding& a, const Finding& b) {
    return a.kind == b.kind && a.is_error == b.is_error;
  };
  std::string text;
  for (auto finding = all.begin(); finding != all.end(); ++finding) {
    const auto is_like_it = [&](const Finding& other) { return alike(*finding, other); };
    const auto before = std::count_if(all.begin(), finding, is_like_it);
    if (before < kShownOfAKind) text += hexagait::in_words(*finding, report.input->file) + "\n";
    const auto more = std::count_if(finding, all.end(), is_like_it) - 1;
    if (before + 1 == kShownOfAKind && more > 0)
      text += fmt::format(
          "{}: {} more {} of this kind ({}); hexagait check --json lists them all\n",
          report.input->file, more, finding->is_error ? "errors" : "warnings", kind(finding->kind));
  }
  return text;
}

std::string check_verdict(const ActionReport& report) {
  const Preview& ahead = report.ahead;
  std::string text =
      fmt::format("{}: {}, {:.1f} s; {}; {}, {}", name(report), steps(report), ahead.seconds,
                  margin(ahead.least_margin, ahead.least_margin_step),
                  count(num_errors(ahead), "error"), count(num_warnings(ahead), "warning"));
  if (ahead.result.outcome == Outcome::failed)
    text += fmt::format("; it would fail in step {}: {}", ahead.result.step,
                        walk::in_words(ahead.result.cause));
  return text + ".";
}

std::string check_json(const ActionReport& report) {
  Json json = subject(report);
  json["ok"] = !walk::has_errors(report.ahead);
  json.update(ahead_json(report.ahead));
  json["version"] = recording::kVersion;
  return json.dump(2);
}

std::string run_headline(const ActionReport& report) {
  const walk::ActionSummary& s = report.summary;
  const bool whole = s.result.outcome == Outcome::succeeded;
  return ending(report) + fmt::format("{} {}, {} in {:.1f} s; {}.", name(report),
                                      ground(sim3d::to_string(report.input->terrain)),
                                      whole ? steps(report) : fmt::format("of {}", steps(report)),
                                      s.seconds, margin(s.margin_min, s.margin_step));
}

std::string run_in_words(const ActionReport& report) {
  const walk::ActionSummary& s = report.summary;
  std::string text = run_headline(report) + "\n";
  add(text, "body",
      fmt::format("height {:.3f} … {:.3f} m, tilt up to {:.1f}°; {}", s.height_min, s.height_max,
                  degrees(s.tilt_max),
                  s.base_touched ? "it touched the ground" : "it never touched the ground"));
  add(text, "off plan",
      fmt::format("the body by up to {} in height, {} sideways, {:.1f}° of tilt",
                  length(s.off_plan_height), length(s.off_plan_sideways),
                  degrees(s.off_plan_tilt)));
  add(text, "feet",
      fmt::format("a foot carried up to {:.0f} N; ", s.foot_force_max) +
          (s.leg_touched ? "a leg touched the ground beside its foot"
                         : "no leg touched the ground but by its foot"));
  add(text, "controller",
      report.input->controller == WholeBodyController::kinematic
          ? "kinematic: by joint positions"
          : "virtual_model: the legs that stand by joint torques");
  add(text, "at the end", s.stands_at_end ? "stands on all feet" : "does not stand on all feet");
  add(text, "odometry", fmt::format("{} from the truth at the end", length(s.odometry_position)));
  return text;
}

std::string run_json(const ActionReport& report) {
  const walk::ActionSummary& s = report.summary;
  Json json = subject(report);
  json["terrain"] = sim3d::to_string(report.input->terrain);
  json["seed"] = report.input->seed;
  json["plant"] = recording::json(report.input->plant);
  json["controller"] = to_string(report.input->controller);
  json["outcome"] = to_string(s.result.outcome);
  json["cause"] = to_string(s.result.cause);
  json["step"] = s.result.step;
  json["leg"] = leg_name(report, s.result.leg);
  json["seconds"] = s.seconds;
  json["fell"] = s.fell;
  json["base_touched"] = s.base_touched;
  json["leg_touched"] = s.leg_touched;
  json["stands_at_end"] = s.stands_at_end;
  json["stability_margin_m"] = finite(s.margin_min);
  json["stability_margin_step"] = s.margin_step;
  json["tilt_rad"] = s.tilt_max;
  json["body_height_m"] = {{"min", s.height_min}, {"max", s.height_max}};
  json["odometry_error_m"] = s.odometry_position;
  json["off_plan"] = {{"height_m", s.off_plan_height},
                      {"sideways_m", s.off_plan_sideways},
                      {"tilt_rad", s.off_plan_tilt}};
  json["foot_force_max_n"] = s.foot_force_max;
  json["fault"] = to_string(s.fault);
  json["out_of_time"] = s.out_of_time;
  json["interrupted"] = report.interrupted;
  json["check"] = ahead_json(report.ahead);
  json["state_hash"] = recording::hex(s.state_hash);
  json["version"] = recording::kVersion;
  return json.dump(2);
}

}  // namespace hexagait::app
