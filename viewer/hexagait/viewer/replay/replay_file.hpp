// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <hexagait/viewer/display/pose_frame.hpp>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>

/// A walk as a file: what a server sends of it, one message after the other.
///
///     "hxreplay"   u32 version   then, compressed by gzip, items until one of kind E:
///
///     item:  u8 kind, u32 size, `size` bytes of content                             little-endian
///     T   a text in JSON as a server sends it: a scene before its ground before its frames
///     F   u16 count, u16 width, then width × count bytes: of the first byte of each frame its
///         difference from that of the frame before (0 before the first of the file), modulo 256,
///         then of the second byte of each, …. A frame is what encode() makes of coarse(frame), with
///         zeros behind it up to the width.
///     E   u32 number of all frames
///
/// Bytes that stay as they are become zeros beside each other, which gzip makes small. It also
/// has the checksum. The layout of a frame is its own affair: it begins with its own version.
namespace hexagait::viewer {

inline constexpr std::string_view kReplayMagic = "hxreplay";
inline constexpr std::uint32_t kReplayVersion = 1;

/// The frame with as many digits as can be seen: positions to 0.06 mm, angles of joints to 0.06 mrad,
/// forces, speeds and powers to 0.2 %.
[[nodiscard]] PoseFrame coarse(PoseFrame frame);

/// Writes such a file as it comes; in memory is no more than some seconds of it. The same items, the
/// same bytes. What `out` can't take shows in its state.
class ReplayWriter {
 public:
  /// @param out  must outlive it
  explicit ReplayWriter(std::ostream& out);
  ~ReplayWriter();
  ReplayWriter(const ReplayWriter&) = delete;
  ReplayWriter& operator=(const ReplayWriter&) = delete;

  void text(std::string_view json);
  /// @param joints  of each leg
  void frame(const PoseFrame& frame, const LegArray<int>& joints);
  /// Nothing may come after it. Without it the file counts as cut off.
  void finish();

 private:
  class Gzip;
  void flush();
  void item(char kind, std::string_view content);

  std::unique_ptr<Gzip> gzip_;
  std::string block_, last_;  // frames that wait, each with its size; the one before them
  std::uint32_t waiting_ = 0, frames_ = 0;
  std::size_t width_ = 0;  // of the widest that waits
};

/// What takes the items of a file.
struct ReplayReader {
  std::function<void(std::string_view json)> text;
  std::function<void(const PoseFrame& frame)> frame;
};

/// Hands out all items, in their order.
/// @throws InvalidInput  if the bytes are no replay, of another version, cut off or damaged
void read_replay(std::string_view bytes, const ReplayReader& reader);

/// What is in a file.
struct ReplayFacts {
  std::string robot, terrain;  ///< of the first scene
  std::uint64_t seed = 0;
  double seconds = 0.0;  ///< of all scenes [s]
  int frames = 0, scenes = 0;
};

/// Reads all of it. @throws InvalidInput  as read_replay(), and if it has no robot that moves
[[nodiscard]] ReplayFacts check_replay(std::string_view bytes);

}  // namespace hexagait::viewer
