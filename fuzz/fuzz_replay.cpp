// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <zlib.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/replay/replay_file.hpp>
#include <string>

namespace hexagait::viewer {
namespace {

// The file of these items: what is changed in a compressed one only damages its checksum.
std::string file_of(const std::string& items) {
  constexpr int kGzipWindow = 15 + 16;
  std::string file(kReplayMagic);
  file.append(reinterpret_cast<const char*>(&kReplayVersion), sizeof kReplayVersion);
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, kGzipWindow, 9, Z_DEFAULT_STRATEGY) != Z_OK)
    std::abort();
  std::string compressed(deflateBound(&stream, items.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(items.data()));
  stream.avail_in = static_cast<uInt>(items.size());
  stream.next_out = reinterpret_cast<Bytef*>(compressed.data());
  stream.avail_out = static_cast<uInt>(compressed.size());
  if (deflate(&stream, Z_FINISH) != Z_STREAM_END) std::abort();
  compressed.resize(stream.total_out);
  deflateEnd(&stream);
  return file + compressed;
}

void check(const std::string& file) {
  try {
    const ReplayFacts facts = check_replay(file);
    if (facts.frames <= 0 || facts.scenes <= 0 || !std::isfinite(facts.seconds)) std::abort();
  } catch (const InvalidInput& error) {
    if (error.what()[0] == '\0') std::abort();
  }
}

}  // namespace
}  // namespace hexagait::viewer

// Whatever the bytes, as a file and as the items of one: facts that are sound, or InvalidInput with a message.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  hexagait::viewer::check(bytes);
  hexagait::viewer::check(hexagait::viewer::file_of(bytes));
  return 0;
}
