// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/figures/staged_files.hpp>
#include <hexagait/sweep/journal.hpp>
#include <hexagait/sweep/results.hpp>
#include <hexagait/sweep/title.hpp>
#include <hexagait/text/invalid_input.hpp>

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

// A directory that is made, and removed again if nothing comes into it.
class MadeDirectory {
 public:
  explicit MadeDirectory(const fs::path& directory) : directory_(directory) {
    std::error_code error;
    made_ = fs::create_directories(directory, error);
    if (error)
      throw InvalidInput(
          fmt::format("can't make the directory '{}': {}", directory.string(), error.message()));
  }
  ~MadeDirectory() {
    std::error_code ignored;
    if (made_) fs::remove(directory_, ignored);  // succeeds only if it is empty
  }
  MadeDirectory(const MadeDirectory&) = delete;
  MadeDirectory& operator=(const MadeDirectory&) = delete;

 private:
  fs::path directory_;
  bool made_ = false;
};

// Ranges of trials of which something is said, the first of them in full.
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
    const Shard shard = parse_title(part.journal.title(), part.name).shard;
    words.push_back(fmt::format("{}/{}", shard.index + 1, shard.count));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

void require_one_configuration(const std::vector<Part>& parts) {
  std::vector<std::string> lines;
  for (const Part& part : parts)
    for (const std::string& line :
         differences(parts.front().journal.title(), part.journal.title(), false))
      lines.push_back(fmt::format("'{}' against '{}': {}", parts.front().name, part.name, line));
  if (!lines.empty())
    throw InvalidInput(
        fmt::format("these are parts of different sweeps:\n  {}", fmt::join(lines, "\n  ")));
}

// Writes the trials of all parts in order; tells what is missing or double.
std::vector<std::string> interleave(std::vector<Part>& parts, std::uint64_t whole,
                                    std::ostream& journal) {
  Ranges missing("missing"), twice("there twice: in ");
  std::uint64_t expected = 0;
  std::string last_part;
  for (;;) {
    const auto first = std::ranges::min_element(parts, {}, [](const Part& part) {
      return part.next ? part.next->trial : ~std::uint64_t{0};
    });
    if (!first->next) break;
    const Entry entry = std::move(*first->next);
    first->next = first->journal.next();
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
  require_one_configuration(parts);
  const std::string& title = parts.front().journal.title();
  const Title known = parse_title(title, parts.front().name);

  const MadeDirectory made(directory);
  if (has_journal(directory))
    require_same(whole_title(title), JournalReader(directory).title(), directory);
  try {
    figures::StagedFiles files(directory);
    std::ofstream journal = files.create(journal_path("").string());
    journal << journal_title(whole_title(title));
    const std::vector<std::string> problems = interleave(parts, known.trials, journal);
    if (!problems.empty())
      throw InvalidInput(
          fmt::format("the shards {} make no whole sweep of {} trials, numbered from 0:\n  {}",
                      shards(parts), known.trials, fmt::join(problems, "\n  ")));
    journal.close();
    files.publish();
  } catch (const std::ios::failure&) {
    throw std::runtime_error(
        fmt::format("can't write into '{}'; is the disk full?", directory.string()));
  }
  return publish(directory);
}

}  // namespace hexagait::sweep
