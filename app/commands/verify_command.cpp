// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/verify/verify.hpp>
#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "terminal/output.hpp"
#include "terminal/progress.hpp"

namespace hexagait::app {
namespace {

using verify::CaseTable;
using verify::CaseValue;
using verify::Theorem;
using verify::TheoremReport;

constexpr std::size_t kWidth = 98;  // of a paragraph

std::string text_of(const CaseValue& cell) {
  if (const auto* number = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *number);
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{:.4f}", *number);
  return std::get<std::string>(cell);
}

/// Columns as wide as need be; `…` is one column wide but three bytes long.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string aligned(const std::string& text, std::size_t columns) {
  return fmt::format("{:{}}{}", "", columns - width(text), text);
}

void print(const CaseTable& table) {
  if (table.rows.empty()) return;
  std::vector<std::vector<std::string>> lines(1, table.columns);
  for (std::string& heading : lines.front()) std::ranges::replace(heading, '_', ' ');
  for (const auto& row : table.rows) {
    lines.emplace_back();
    std::ranges::transform(row, std::back_inserter(lines.back()),
                           [](const CaseValue& cell) { return text_of(cell); });
  }
  for (const auto& line : lines) {
    std::string text = "  ";
    for (std::size_t k = 0; k < line.size(); ++k) {
      std::size_t columns = 0;
      for (const auto& other : lines) columns = std::max(columns, width(other[k]));
      text += fmt::format("  {}", aligned(line[k], columns));
    }
    print_out(fmt::format("{}\n", text));
  }
}

void print_paragraph(const std::string& text) {
  std::string line = " ";
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    if (width(line) + 1 + width(word) > kWidth) {
      print_out(fmt::format("{}\n", line));
      line.assign(1, ' ');
    }
    line.append(" ").append(word);
    at = end + 1;
  }
  print_out(fmt::format("{}\n", line));
}

void print(const Theorem& theorem) {
  std::string name = theorem.name;
  std::ranges::replace(name, '_', ' ');
  print_out(
      fmt::format("{}: {}, {} cases\n", name, theorem.holds() ? "holds" : "FAILS", theorem.cases));
  print_paragraph(theorem.statement);
  print_paragraph(theorem.convention);
  if (!theorem.holds())
    print_out(fmt::format("  first counter-example: {}\n", theorem.counterexample));
  print(theorem.table);
  print_out(fmt::format("\n"));
}

std::int64_t cases(const TheoremReport& report) {
  std::int64_t sum = 0;
  for (const Theorem& theorem : report.theorems) sum += theorem.cases;
  return sum;
}

nlohmann::ordered_json json(const Theorem& theorem) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& row : theorem.table.rows) {
    nlohmann::ordered_json object;
    for (std::size_t k = 0; k < row.size(); ++k)
      std::visit([&](const auto& value) { object[theorem.table.columns[k]] = value; }, row[k]);
    rows.push_back(object);
  }
  nlohmann::ordered_json object = {{"name", theorem.name},
                                   {"statement", theorem.statement},
                                   {"convention", theorem.convention},
                                   {"holds", theorem.holds()},
                                   {"cases", theorem.cases},
                                   {"counterexample", nullptr},
                                   {"table", rows}};
  if (!theorem.holds()) object["counterexample"] = theorem.counterexample;
  return object;
}

void print_json(const TheoremReport& report) {
  nlohmann::ordered_json theorems = nlohmann::ordered_json::array();
  for (const Theorem& theorem : report.theorems) theorems.push_back(json(theorem));
  const nlohmann::ordered_json object = {
      {"holds", report.holds()}, {"cases", cases(report)}, {"theorems", theorems}};
  print_out(fmt::format("{}\n", object.dump(2)));
}

}  // namespace

int verify_command(bool as_json, bool quiet) {
  TheoremReport report;
  {
    Progress progress(1.0, Progress::Measure::share, quiet);
    report = verify::verify({}, {}, [&](double share) { progress.at(share); });
  }
  if (as_json) {
    print_json(report);
  } else {
    for (const Theorem& theorem : report.theorems) print(theorem);
    const auto holding = std::ranges::count_if(report.theorems, &Theorem::holds);
    print_out(fmt::format(
        "{} of {} theorems hold in {} cases. Each tries all cases within the bounds that it "
        "states\n"
        "(legs, step times, duty factors), under the assumptions that it states; lags, which are\n"
        "real numbers, are tried on a grid. What holds beyond the bounds is proved in theory.md.\n",
        holding, report.theorems.size(), cases(report)));
  }
  return report.holds() ? kOk : kFailed;
}

}  // namespace hexagait::app
