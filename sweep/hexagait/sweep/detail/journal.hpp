// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <hexagait/text/invalid_input.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexagait::sweep {

/// A finished trial.
struct Entry {
  std::uint64_t position = 0;  ///< in its shard
  std::uint64_t trial = 0;
  std::string wall;  ///< time it took [s], as text
  std::string row;   ///< its row of trials.csv, without the line's end
};

/// How far apart trials may finish: a trial enters a journal only when all that lie kWindow
/// positions or more before it are in. So a journal is read in order with bounded memory, however
/// long it is.
inline constexpr std::uint64_t kWindow = 1U << 16;

/// A line of a journal: the FNV-1a of the rest in 16 hexadecimal digits, position, wall time, row.
[[nodiscard]] std::string journal_line(std::uint64_t position, std::string_view wall,
                                       std::string_view row);

/// The first line of a journal: the checksum, and what is swept, as JSON.
[[nodiscard]] std::string journal_header(std::string_view header);

/// Reads the lines of a file in the order in which they were written. It is open only while a block of
/// it is read, so there may be more readers than descriptors.
class LineReader {
 public:
  /// @throws InvalidInput  if there is none, or its first line is damaged
  explicit LineReader(std::filesystem::path file);

  /// The first line: what is swept, as JSON.
  [[nodiscard]] const std::string& header() const { return header_; }

  /// The next line. @throws InvalidInput  for a damaged one. A last line without an end is one that was
  /// never finished, and passed over.
  [[nodiscard]] std::optional<Entry> next();

  /// Where the lines read so far end [byte].
  [[nodiscard]] std::uint64_t end() const { return end_; }

  /// What is wrong with the line that was read last.
  [[nodiscard]] InvalidInput problem(const std::string& what) const;

 private:
  [[nodiscard]] bool read_block();
  [[nodiscard]] bool read_line(std::string& content);

  std::filesystem::path path_;
  std::string block_;  // bytes of the file from end_ on
  std::string header_;
  std::uint64_t line_ = 0, end_ = 0;
  std::size_t used_ = 0;  // of block_, before end_
};

/// Trials that had no result and were run again: lines as in the journal, whose rows take their places.
/// The journal itself is only ever added to, in an order on which its readers rely.
struct Retries {
  std::map<std::uint64_t, Entry> rows;  ///< the last of each position
  std::uint64_t end = 0;                ///< of its good lines [byte]; 0: there are none
};

/// @param header  of the journal beside it
/// @throws InvalidInput  for a damaged line, or those of another sweep
[[nodiscard]] Retries read_retries(const std::filesystem::path& directory,
                                   const std::string& header);

/// Reads a journal, in which trials stand as they finished, in the order of their positions.
class JournalReader {
 public:
  /// @throws InvalidInput  if there is none, or a first line is damaged
  explicit JournalReader(const std::filesystem::path& directory);

  /// The first line: what is swept, as JSON.
  [[nodiscard]] const std::string& header() const { return lines_.header(); }

  /// The next finished trial; one without a result as it came out when it was run again.
  /// @throws InvalidInput  for a damaged line, or a trial that is there twice
  [[nodiscard]] std::optional<Entry> next();

  /// Where the lines read so far end [byte].
  [[nodiscard]] std::uint64_t end() const { return lines_.end(); }
  /// Where those of the retries end [byte].
  [[nodiscard]] std::uint64_t retries_end() const { return retries_.end; }

 private:
  [[nodiscard]] bool read_ahead();

  LineReader lines_;
  Retries retries_;
  std::map<std::uint64_t, Entry> ahead_;  // read, and not yet asked for, by position
  std::uint64_t next_ = 0;                // all positions before it were asked for
};

/// A file to which lines are added. A line is in it whole or, after a failure, is cut off again.
class Journal {
 public:
  /// Waits until a file's bytes are on the disk; as fdatasync().
  using Sync = int (*)(int file);

  /// Opens or makes the file, and holds it: read it only from now on.
  /// @throws InvalidInput  if it can't be written, or held
  explicit Journal(const std::filesystem::path& file);
  Journal(const std::filesystem::path& file, Sync sync);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Goes on with it, or begins it by its first line.
  /// @param end  where its good lines end; what follows is cut off. 0: there are none
  /// @throws InvalidInput  if it can't be written
  void resume(const std::string& header, std::uint64_t end);

  /// Adds whole lines, safe from the end of this process at once.
  /// @returns why they could not be added, else nothing
  [[nodiscard]] std::optional<std::string> append(std::string_view lines);

  /// Makes all lines safe from the end of the machine. @returns why not, else nothing
  [[nodiscard]] std::optional<std::string> sync();

  /// The same if a line has waited for it longer than a second: to be called often.
  [[nodiscard]] std::optional<std::string> sync_if_due();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  Sync sync_;
  int file_ = -1;
  std::uint64_t end_ = 0;
  std::optional<std::chrono::steady_clock::time_point> waiting_since_;  // the first line not synced
};

/// Why a file can't be held, from the errno of flock().
[[nodiscard]] std::string lock_failure(int error);

/// Whether a directory has a journal, with at least its first line.
[[nodiscard]] bool has_journal(const std::filesystem::path& directory);

/// "journal.txt" of a directory, and "retries.txt".
[[nodiscard]] std::filesystem::path journal_path(const std::filesystem::path& directory);
[[nodiscard]] std::filesystem::path retries_path(const std::filesystem::path& directory);

/// Which positions of a sequence are done, where none is done that lies kWindow or more beyond the
/// first that is not.
class DoneWindow {
 public:
  /// The first position that is not done.
  [[nodiscard]] std::uint64_t low() const { return low_; }
  [[nodiscard]] bool done(std::uint64_t position) const;
  void mark(std::uint64_t position);

 private:
  std::uint64_t low_ = 0;
  std::vector<bool> done_ = std::vector<bool>(kWindow);  // of position p at p % kWindow
};

}  // namespace hexagait::sweep
