// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <hexagait/sim/fnv1a.hpp>
#include <hexagait/sweep/journal.hpp>
#include <hexagait/text/invalid_input.hpp>

namespace hexagait::sweep {
namespace {

constexpr std::size_t kDigits = 16;  // of a checksum

std::string checked(std::string_view content) {
  return fmt::format("{:016x} {}\n", fnv1a(content), content);
}

// What follows a checksum that fits.
std::optional<std::string_view> content(std::string_view line) {
  if (line.size() <= kDigits || line[kDigits] != ' ') return {};
  const std::string_view rest = line.substr(kDigits + 1);
  if (line.substr(0, kDigits) != fmt::format("{:016x}", fnv1a(rest))) return {};
  return rest;
}

// The whole number that a text begins with.
bool number(std::string_view text, std::uint64_t& value) {
  return std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc();
}

double seconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Writes all of it. @returns errno, or 0
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

std::filesystem::path journal_path(const std::filesystem::path& directory) {
  return directory / "journal.txt";
}

std::string journal_line(std::uint64_t position, std::string_view wall, std::string_view row) {
  return checked(fmt::format("{} {} {}", position, wall, row));
}

std::string journal_title(std::string_view title) { return checked(title); }

bool has_journal(const std::filesystem::path& directory) {
  std::ifstream file(journal_path(directory), std::ios::binary);
  std::string line;
  return std::getline(file, line) && !file.eof();
}

JournalReader::JournalReader(const std::filesystem::path& directory)
    : path_(journal_path(directory)), file_(path_, std::ios::binary) {
  if (!file_)
    throw InvalidInput(fmt::format("{}: can't be read; '{}' is not the directory of a sweep",
                                   path_.string(), directory.string()));
  if (!read_line(title_))
    throw InvalidInput(
        fmt::format("{}: has no first line; remove it to begin again", path_.string()));
}

bool JournalReader::read_line(std::string& result) {
  std::string line;
  if (!std::getline(file_, line) || file_.eof()) return false;
  ++line_;
  const std::optional<std::string_view> rest = content(line);
  if (!rest)
    throw InvalidInput(fmt::format(
        "{}:{}: damaged, its checksum does not fit; remove this line and those after it, and run "
        "the sweep again to replace them",
        path_.string(), line_));
  result = *rest;
  end_ += line.size() + 1;
  return true;
}

bool JournalReader::read_entry() {
  std::string line;
  if (!read_line(line)) return false;

  // position, wall time, row; a row begins with the number of its trial.
  Entry entry;
  const std::size_t wall = line.find(' ') + 1, row = line.find(' ', wall) + 1;
  const bool whole = wall > 0 && row > wall && number(line, entry.position) &&
                     number(std::string_view(line).substr(row), entry.trial);
  if (!whole)
    throw InvalidInput(fmt::format("{}:{}: is not the row of a trial", path_.string(), line_));
  entry.wall = line.substr(wall, row - wall - 1);
  entry.row = line.substr(row);

  const std::uint64_t position = entry.position, trial = entry.trial;
  if (position < next_ || !ahead_.emplace(position, std::move(entry)).second)
    throw InvalidInput(fmt::format("{}:{}: trial {} is there twice", path_.string(), line_, trial));
  return true;
}

std::optional<Entry> JournalReader::next() {
  // Behind kWindow lines that are ahead nothing can be missing that is still to be read.
  const auto found = [&] { return !ahead_.empty() && ahead_.begin()->first == next_; };
  while (!found() && ahead_.size() < kWindow && read_entry()) {
  }
  if (ahead_.empty()) return {};
  Entry entry = std::move(ahead_.extract(ahead_.begin()).mapped());
  next_ = entry.position + 1;
  return entry;
}

Journal::Journal(const std::filesystem::path& directory, const std::string& title,
                 std::uint64_t end)
    : end_(end), synced_(seconds_now()) {
  const std::filesystem::path path = journal_path(directory);
  const auto refuse = [&](const std::string& why) {
    if (file_ >= 0) close(file_);
    throw InvalidInput(fmt::format("{}: {}", path.string(), why));
  };
  file_ = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
  if (file_ < 0) refuse(fmt::format("can't be written: {}", std::strerror(errno)));
  if (flock(file_, LOCK_EX | LOCK_NB) != 0)
    refuse("another process is writing it; wait for its end, or give another --out");
  if (ftruncate(file_, static_cast<off_t>(end)) != 0 || lseek(file_, 0, SEEK_END) < 0)
    refuse(fmt::format("can't be written: {}", std::strerror(errno)));
  if (end > 0) return;
  if (const auto failure = append(journal_title(title))) refuse("can't be written: " + *failure);
  sync();
}

Journal::~Journal() {
  sync();
  close(file_);
}

std::optional<std::string> Journal::append(std::string_view lines) {
  if (const int error = write_all(file_, lines)) {
    // If this fails too, the next reader passes over the part of a line.
    if (ftruncate(file_, static_cast<off_t>(end_)) == 0) lseek(file_, 0, SEEK_END);
    return std::strerror(error);
  }
  end_ += lines.size();
  if (seconds_now() - synced_ > 1.0) sync();
  return {};
}

void Journal::sync() {
  fdatasync(file_);
  synced_ = seconds_now();
}

bool DoneWindow::done(std::uint64_t position) const {
  return position < low_ || (position < low_ + kWindow && done_[position % kWindow]);
}

void DoneWindow::mark(std::uint64_t position) {
  if (position < low_ || position >= low_ + kWindow) return;
  done_[position % kWindow] = true;
  for (; done_[low_ % kWindow]; ++low_) done_[low_ % kWindow] = false;
}

}  // namespace hexagait::sweep
