// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include "words/results_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <hexagait/recording/provenance.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <iterator>
#include <thread>

namespace hexagait::app {
namespace {

using experiments::Check;
using experiments::Measured;
using experiments::Verdict;

constexpr std::string_view kHead =
    "# Results\n\n"
    "`hexagait results` makes this page, `hexagait results --only GROUP` a section of it anew. No "
    "number is typed by "
    "hand.\n\n"
    "A claim *holds* if every figure below it is within what is claimed. Where there is a 95 % "
    "interval and the claim "
    "is about a mean, all of the interval must be. *As expected, does not hold*: it is known to "
    "fail, by how much, and "
    "why; it would be reported as failed if it failed by more, or held. Figures marked as safety "
    "are never excused. "
    "Definitions: [theory.md](theory.md#the-referee).\n";
constexpr std::string_view kTitle = "\n## ";

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "an unknown processor";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  return fmt::format("{:04}-{:02}-{:02}", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday);
}

// Today, by this program on this machine.
std::string made_by() {
  const recording::Provenance program = recording::provenance();
  std::string libraries;
  for (const auto& [name, version] : program.libraries)
    libraries += fmt::format(", {} {}", name, version.substr(0, version.find(" (")));
  return fmt::format("{} with hexagait {} ({}), {}{}, on {} with {} cores", today(),
                     program.version, program.revision, program.compiler, libraries, processor(),
                     std::thread::hardware_concurrency());
}

// A cell may hold anything but the line that ends it.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, 1, '\\');
  return text;
}

std::string number(double value) {
  return std::isnan(value) ? "not measured" : fmt::format("{:.4g}", value == 0.0 ? 0.0 : value);
}

void write_check(std::string& out, const Check& check, bool safety) {
  const Measured& m = check.measured();
  const std::string unit = m.unit.empty() ? "" : ' ' + m.unit;
  std::string found = number(m.value) + unit;
  if (!m.detail.empty()) found += fmt::format(" ({})", m.detail);
  const std::string interval =
      m.interval ? fmt::format("{} … {}", number(m.interval->lower), number(m.interval->upper))
                 : "";
  std::string claimed = to_string(check.bound(), m.unit);
  if (check.band()) claimed += "; expected " + to_string(*check.band(), m.unit);
  fmt::format_to(std::back_inserter(out), "| {}{} | {} | {} | {} |\n", cell(m.name),
                 safety ? " (safety)" : "", cell(claimed), cell(found), interval);
}

void write_verdict(std::string& out, const Verdict& verdict) {
  fmt::format_to(std::back_inserter(out), "| **{}**: {} | | | |\n", verdict.word(),
                 cell(verdict.claim));
  for (const auto& safe : verdict.safety) write_check(out, safe.check(), true);
  if (verdict.not_judged.empty())
    for (const Check& check : verdict.checks) write_check(out, check, false);
  else
    fmt::format_to(std::back_inserter(out), "| not judged: {} | | | |\n", cell(verdict.not_judged));
  for (const Check& check : verdict.checks)
    if (check.band())
      fmt::format_to(std::back_inserter(out), "| because {} | | | |\n", cell(check.reason()));
  if (!verdict.remark.empty())
    fmt::format_to(std::back_inserter(out), "| {} | | | |\n", cell(verdict.remark));
}

}  // namespace

ResultsPage::ResultsPage(std::string_view text) {
  if (!text.starts_with(kHead.substr(0, kHead.find('\n') + 1)))
    throw InvalidInput("it is not a page of hexagait results");
  for (std::size_t at = text.find(kTitle); at != std::string_view::npos;) {
    const std::size_t begin = at + kTitle.size(), next = text.find(kTitle, begin);
    const std::string_view section = text.substr(begin, next - begin);
    const std::size_t end = std::min(section.find('\n'), section.size());
    sections_.push_back({std::string(section.substr(0, end)), std::string(section.substr(end))});
    at = next;
  }
}

void ResultsPage::set(const ResultsGroup& group) {
  std::string text = fmt::format(
      "\n\n`{}`, {}.{}\n\n| figure | claimed | measured | 95 % interval |\n|---|---|---|---|\n",
      group.command, made_by(),
      group.short_form ? " **Short form: not the figures that are claimed.**" : "");
  for (const Verdict& verdict : group.verdicts) write_verdict(text, verdict);
  const auto old = std::ranges::find(sections_, group.title, &Section::title);
  if (old == sections_.end())
    sections_.push_back({group.title, text});
  else
    old->text = text;
}

std::string ResultsPage::text(const std::vector<std::string>& titles) const {
  std::string page(kHead);
  for (const std::string& title : titles) {
    const auto section = std::ranges::find(sections_, title, &Section::title);
    if (section != sections_.end()) page += fmt::format("{}{}{}", kTitle, title, section->text);
  }
  return page;
}

}  // namespace hexagait::app
