// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <hexagait/sim/fnv1a.hpp>
#include <hexagait/sweep/detail/journal.hpp>
#include <hexagait/sweep/detail/made_directory.hpp>
#include <hexagait/sweep/detail/write_all.hpp>
#include <hexagait/sweep/sweep.hpp>
#include <thread>

namespace hexagait::sweep {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kDigits = 16;          // of a checksum
constexpr std::size_t kBlock = 1U << 15;     // read at once [byte]
constexpr milliseconds kLinePatience{1000};  // until a line is synced
// The workers of a process that was killed hold its journal for as long as they take to die.
constexpr milliseconds kLockPatience{1000};

std::string checked(std::string_view content) {
  return fmt::format("{:016x} {}\n", fnv1a(content), content);
}

// A line without its checksum, if that is right.
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

bool has_first_line(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  return std::getline(file, line) && !file.eof();
}

}  // namespace

std::filesystem::path journal_path(const std::filesystem::path& directory) {
  return directory / "journal.txt";
}

std::filesystem::path retries_path(const std::filesystem::path& directory) {
  return directory / "retries.txt";
}

std::string journal_line(std::uint64_t position, std::string_view wall, std::string_view row) {
  return checked(fmt::format("{} {} {}", position, wall, row));
}

std::string journal_header(std::string_view header) { return checked(header); }

bool has_journal(const std::filesystem::path& directory) {
  return has_first_line(journal_path(directory));
}

LineReader::LineReader(std::filesystem::path file) : path_(std::move(file)) {
  if (!std::ifstream(path_))
    throw InvalidInput(fmt::format("{}: can't be read; '{}' is not the directory of a sweep",
                                   path_.string(), path_.parent_path().string()));
  if (!read_line(header_))
    throw InvalidInput(
        fmt::format("{}: has no first line; remove it to begin again", path_.string()));
}

// Adds what follows in the file to the block.
bool LineReader::read_block() {
  block_.erase(0, used_);
  used_ = 0;
  std::ifstream file(path_, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(end_ + block_.size()));
  const std::size_t before = block_.size();
  block_.resize(before + kBlock);
  file.read(block_.data() + before, kBlock);
  block_.resize(before + static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return block_.size() > before;
}

bool LineReader::read_line(std::string& result) {
  std::size_t end = 0;
  while ((end = block_.find('\n', used_)) == std::string::npos)
    if (!read_block()) return false;
  ++line_;
  const std::string_view line = std::string_view(block_).substr(used_, end - used_);
  const std::optional<std::string_view> rest = content(line);
  if (!rest)
    throw problem(
        "damaged, its checksum does not fit; remove this line and those after it, and run the "
        "sweep "
        "again to replace them");
  result = *rest;
  end_ += line.size() + 1;
  used_ = end + 1;
  return true;
}

InvalidInput LineReader::problem(const std::string& what) const {
  return InvalidInput(fmt::format("{}:{}: {}", path_.string(), line_, what));
}

std::optional<Entry> LineReader::next() {
  std::string line;
  if (!read_line(line)) return {};

  // position, wall time, row; a row begins with the number of its trial.
  Entry entry;
  const std::size_t wall = line.find(' ') + 1, row = line.find(' ', wall) + 1;
  const bool whole = wall > 0 && row > wall && number(line, entry.position) &&
                     number(std::string_view(line).substr(row), entry.trial);
  if (!whole) throw problem("is not the row of a trial");
  entry.wall = line.substr(wall, row - wall - 1);
  entry.row = line.substr(row);
  return entry;
}

Retries read_retries(const std::filesystem::path& directory, const std::string& header) {
  Retries retries;
  const std::filesystem::path file = retries_path(directory);
  if (!has_first_line(file)) return retries;
  LineReader lines(file);
  if (lines.header() != header)
    throw lines.problem("is of another sweep than the journal beside it; remove this file");
  while (std::optional<Entry> entry = lines.next())
    retries.rows.insert_or_assign(entry->position, std::move(*entry));
  retries.end = lines.end();
  return retries;
}

JournalReader::JournalReader(const std::filesystem::path& directory)
    : lines_(journal_path(directory)), retries_(read_retries(directory, lines_.header())) {}

bool JournalReader::read_ahead() {
  std::optional<Entry> entry = lines_.next();
  if (!entry) return false;
  const std::uint64_t position = entry->position, trial = entry->trial;
  if (position < next_ || !ahead_.emplace(position, std::move(*entry)).second)
    throw lines_.problem(fmt::format("trial {} is there twice", trial));
  return true;
}

std::optional<Entry> JournalReader::next() {
  // With kWindow lines read ahead, a position that is missing is in no later line (see kWindow).
  const auto found = [&] { return !ahead_.empty() && ahead_.begin()->first == next_; };
  while (!found() && ahead_.size() < kWindow && read_ahead()) {
  }
  if (ahead_.empty()) return {};
  Entry entry = std::move(ahead_.extract(ahead_.begin()).mapped());
  next_ = entry.position + 1;
  const auto again = retries_.rows.find(entry.position);
  if (again != retries_.rows.end() && has_no_result(entry.row)) return again->second;
  return entry;
}

std::string lock_failure(int error) {
  switch (error) {
    case EWOULDBLOCK:
      return "another process is writing it; wait for its end, or give another --out";
    case EINVAL:
    case ENOSYS:
    case ENOTSUP:
    case ENOLCK:
      return fmt::format(
          "its file system can't lock files ({}), so two sweeps could write it at once; give an "
          "--out on another",
          std::strerror(error));
    default:
      return fmt::format("can't be locked: {}", std::strerror(error));
  }
}

Journal::Journal(const std::filesystem::path& file) : Journal(file, fdatasync) {}

Journal::Journal(const std::filesystem::path& file, Sync sync) : path_(file), sync_(sync) {
  file_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
  if (file_ < 0)
    throw InvalidInput(
        fmt::format("{}: can't be written: {}", path_.string(), std::strerror(errno)));
  const Clock::time_point deadline = Clock::now() + kLockPatience;
  while (flock(file_, LOCK_EX | LOCK_NB) != 0) {
    const int error = errno;
    if (error == EWOULDBLOCK && Clock::now() < deadline) {
      std::this_thread::sleep_for(milliseconds(20));
      continue;
    }
    if (error == EINTR) continue;
    close(file_);
    throw InvalidInput(fmt::format("{}: {}", path_.string(), lock_failure(error)));
  }
}

void Journal::resume(const std::string& header, std::uint64_t end) {
  const auto refuse = [this](const std::string& why) {
    if (end_ == 0) unlink(path_.c_str());  // nothing is in it
    throw InvalidInput(fmt::format("{}: can't be written: {}", path_.string(), why));
  };
  end_ = end;
  if (ftruncate(file_, static_cast<off_t>(end)) != 0 || lseek(file_, 0, SEEK_END) < 0)
    refuse(std::strerror(errno));
  if (end > 0) return;
  if (const auto failure = append(journal_header(header))) refuse(*failure);
  if (const auto failure = sync()) refuse(*failure);
  sync_directory(path_.parent_path());
}

Journal::~Journal() {
  static_cast<void>(sync());
  close(file_);
}

std::optional<std::string> Journal::append(std::string_view lines) {
  if (const int error = write_all(file_, lines)) {
    // If this fails too, the next reader passes over the part of a line.
    if (ftruncate(file_, static_cast<off_t>(end_)) == 0) lseek(file_, 0, SEEK_END);
    return std::strerror(error);
  }
  end_ += lines.size();
  if (!waiting_since_) waiting_since_ = Clock::now();
  return sync_if_due();
}

std::optional<std::string> Journal::sync_if_due() {
  if (!waiting_since_ || Clock::now() - *waiting_since_ < kLinePatience) return {};
  return sync();
}

std::optional<std::string> Journal::sync() {
  if (!waiting_since_) return {};
  waiting_since_.reset();
  if (sync_(file_) == 0 || errno == EINVAL || errno == ENOTSUP)
    return {};  // a file system that can't
  return fmt::format("its bytes did not reach the disk: {}", std::strerror(errno));
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
