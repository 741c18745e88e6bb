// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/split.hpp>
#include <hexagait/viewer/tasks/checked_action.hpp>

namespace hexagait::viewer {
namespace {

constexpr const char* kSource = "action";  // begins what the loader says
constexpr std::size_t kLongestLine = 200;  // of the action that is shown [bytes]

struct Cancelled {};

std::string line_of(const std::vector<std::string_view>& lines, int number) {
  if (number < 1 || static_cast<std::size_t>(number) > lines.size()) return {};
  std::string_view line = lines[static_cast<std::size_t>(number - 1)].substr(0, kLongestLine);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return std::string(line);
}

// "17: …" as 17; the text is what follows.
int take_number(std::string_view& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end == text.data() + text.size() || *end != ':') return 0;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()) + 1);
  return number;
}

// A line of the loader: "action:3:17: unknown key …"; some have no place.
ActionFinding finding_of(std::string_view text) {
  ActionFinding finding;
  const std::string prefix = fmt::format("{}:", kSource);
  if (text.starts_with(prefix)) {
    text.remove_prefix(prefix.size());
    finding.line = take_number(text);
    if (finding.line > 0) finding.column = take_number(text);
  }
  finding.text = text.substr(std::min(text.find_first_not_of(' '), text.size()));
  return finding;
}

std::vector<ActionFinding> refusal(const InvalidInput& error) {
  std::vector<ActionFinding> findings;
  for (const std::string_view line : split(error.what(), '\n'))
    findings.push_back(finding_of(line));
  return findings;
}

Preview played_ahead(const action::Action& action, const ActionCheck& check,
                     const std::atomic<bool>& cancelled) {
  PreviewParams params;
  params.runner = check.runner;
  params.most_seconds = kLongestAction;
  return preview(check.robot, nominal_joints(check.robot), action, params,
                 [&](const ActionRecord&) {
                   if (cancelled) throw Cancelled();
                 });
}

std::string why_refused(const Preview& ahead) {
  const auto errors = std::ranges::count_if(ahead.findings, &Finding::is_error);
  std::string text = fmt::format("{} error{}", errors, errors == 1 ? "" : "s");
  if (ahead.result.outcome == Outcome::failed)
    text += fmt::format("; it would fail in step {}: {}", ahead.result.step,
                        walk::in_words(ahead.result.cause));
  return text;
}

void check_into(CheckedAction& result, const std::string& yaml, const ActionCheck& check,
                const std::atomic<bool>& cancelled) {
  action::Action action = walk::action_for(yaml, kSource, check.robot, {}, check.load_robot);
  const Preview ahead = played_ahead(action, check, cancelled);
  for (const Finding& f : ahead.findings)
    result.findings.push_back({f.mark.line, f.mark.column, f.is_error, f.text, {}});
  if (walk::has_errors(ahead))
    result.why = why_refused(ahead);
  else
    result.action = std::move(action);
}

}  // namespace

CheckedAction check_action(const std::string& yaml, const ActionCheck& check,
                           const std::atomic<bool>& cancelled) {
  CheckedAction result;
  try {
    check_into(result, yaml, check, cancelled);
  } catch (const InvalidInput& error) {
    result.findings = refusal(error);
    result.why =
        fmt::format("{} error{}", result.findings.size(), result.findings.size() == 1 ? "" : "s");
  } catch (Cancelled) {
    result.why = "stopped while it was checked";
  }
  if (result.findings.size() > CheckedAction::kMostFindings)
    result.findings.resize(CheckedAction::kMostFindings);
  const std::vector<std::string_view> lines = split(yaml, '\n');
  for (ActionFinding& finding : result.findings) finding.source = line_of(lines, finding.line);
  return result;
}

}  // namespace hexagait::viewer
