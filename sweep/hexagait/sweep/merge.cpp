// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <functional>
#include <hexagait/figures/staged_files.hpp>
#include <hexagait/sweep/detail/header.hpp>
#include <hexagait/sweep/detail/journal.hpp>
#include <hexagait/sweep/detail/made_directory.hpp>
#include <hexagait/sweep/results.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <queue>

namespace hexagait::sweep {
namespace {

namespace fs = std::filesystem;

// The journal of a part, and its next trial.
struct Part {
  explicit Part(const fs::path& directory)
      : name(directory.string()), journal(directory), next(journal.next()) {}
  std::string name;
  JournalReader journal;
  std::optional<Entry> next;
};

// Ranges of trials with one thing wrong: the first are listed, the others only counted.
class Ranges {
 public:
  explicit Ranges(std::string what) : what_(std::move(what)) {}

  void add(std::uint64_t first, std::uint64_t last, const std::string& where) {
    const bool goes_on = number_ > 0 && first == last_ + 1 && where == where_;
    if (!goes_on && ++number_ <= kShown) ranges_.push_back({first, last, where});
    if (number_ <= kShown) ranges_.back().last = last;
    last_ = last;
    where_ = where;
  }

  void tell(std::vector<std::string>& lines) const {
    for (const Range& range : ranges_)
      lines.push_back(
          range.first == range.last
              ? fmt::format("trial {} {}{}", range.first, what_, range.where)
              : fmt::format("trials {} to {} {}{}", range.first, range.last, what_, range.where));
    if (number_ > ranges_.size())
      lines.push_back(fmt::format("and {} more such ranges", number_ - ranges_.size()));
  }

 private:
  static constexpr std::size_t kShown = 10;
  struct Range {
    std::uint64_t first, last;
    std::string where;
  };
  std::string what_, where_;
  std::vector<Range> ranges_;
  std::uint64_t number_ = 0, last_ = 0;
};

// "1/3, 3/3".
std::string shards(const std::vector<Part>& parts) {
  std::vector<std::string> words;
  for (const Part& part : parts) {
    const Shard shard = parse_header(part.journal.header(), part.name).shard;
    words.push_back(fmt::format("{}/{}", shard.index + 1, shard.count));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

// Configuration and provenance must be the same: other physics makes other rows.
void require_one_sweep(const std::vector<Part>& parts) {
  constexpr std::size_t kShown = 10;
  std::vector<std::string> lines;
  for (const Part& part : parts)
    for (const std::string& line :
         differences(parts.front().journal.header(), part.journal.header(), false))
      lines.push_back(fmt::format("'{}' against '{}': {}", parts.front().name, part.name, line));
  if (lines.empty()) return;
  const std::size_t more = lines.size() > kShown ? lines.size() - kShown : 0;
  lines.resize(lines.size() - more);
  if (more > 0) lines.push_back(fmt::format("and {} more differences", more));
  throw InvalidInput(
      fmt::format("these are parts of different sweeps:\n  {}", fmt::join(lines, "\n  ")));
}

// Writes the trials of all parts in order; tells what is missing or double.
std::vector<std::string> interleave(std::vector<Part>& parts, std::uint64_t whole,
                                    std::ostream& journal) {
  Ranges missing("missing"), twice("there twice: in ");
  using Next = std::pair<std::uint64_t, std::size_t>;  // its trial, and the part that has it
  std::priority_queue<Next, std::vector<Next>, std::greater<>> queue;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i].next) queue.emplace(parts[i].next->trial, i);

  std::uint64_t expected = 0;
  std::string last_part;
  while (!queue.empty()) {
    Part* const first = &parts[queue.top().second];
    const Entry entry = std::move(*first->next);
    first->next = first->journal.next();
    const std::size_t index = queue.top().second;
    queue.pop();
    if (first->next) queue.emplace(first->next->trial, index);
    if (entry.trial < expected) {
      twice.add(entry.trial, entry.trial, fmt::format("'{}' and '{}'", last_part, first->name));
      continue;
    }
    if (entry.trial > expected) missing.add(expected, entry.trial - 1, "");
    journal << journal_line(entry.trial, entry.wall, entry.row);
    expected = entry.trial + 1;
    last_part = first->name;
  }
  if (expected < whole) missing.add(expected, whole - 1, "");
  std::vector<std::string> lines;
  missing.tell(lines);
  twice.tell(lines);
  return lines;
}

}  // namespace

Published merge(const std::vector<fs::path>& directories, const fs::path& directory) {
  std::vector<Part> parts;
  for (const fs::path& part : directories) {
    std::error_code ignored;
    if (fs::equivalent(part, directory, ignored))
      throw InvalidInput(fmt::format("--out is '{}', which is one of the parts; give another",
                                     directory.string()));
    parts.emplace_back(part);
  }
  require_one_sweep(parts);
  const std::string& header = parts.front().journal.header();
  const Header known = parse_header(header, parts.front().name);

  MadeDirectory made(directory);
  if (has_journal(directory))
    require_same(whole_header(header), JournalReader(directory).header(), directory);
  try {
    figures::StagedFiles files(directory);
    std::ofstream journal = files.create(journal_path("").string());
    journal << journal_header(whole_header(header));
    const std::vector<std::string> problems = interleave(parts, known.trials, journal);
    if (!problems.empty())
      throw InvalidInput(
          fmt::format("the shards {} make no whole sweep of {} trials, numbered from 0:\n  {}",
                      shards(parts), known.trials, fmt::join(problems, "\n  ")));
    journal.close();
    files.publish();
    made.keep();
  } catch (const std::ios::failure&) {
    throw InvalidInput(fmt::format("can't write into '{}'; is the disk full?", directory.string()));
  }
  return publish(directory);
}

}  // namespace hexagait::sweep
