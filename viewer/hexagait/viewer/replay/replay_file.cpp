// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/replay/replay_file.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <stdexcept>

namespace hexagait::viewer {
namespace {

constexpr std::uint32_t kBlock = 256;         // frames that are compressed together, at most
constexpr std::size_t kMostItem = 32u << 20;  // [bytes]
constexpr std::size_t kInflated = std::size_t{1} << 16;  // at once [bytes]
constexpr double kLongest = 1e9;                         // time of a frame [s]
constexpr const char* kCutOff = "is cut off: its end is missing";
constexpr const char* kDamaged = "is damaged: ";
constexpr int kGzipWindow = 15 + 16;  // of zlib: 32 kB, with the header of gzip

template <class Number>
void put(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

template <class Number>
Number number_at(std::string_view bytes, std::size_t at) {
  Number number{};
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

unsigned char difference(char a, char b) {
  return static_cast<unsigned char>(static_cast<unsigned char>(a) - static_cast<unsigned char>(b));
}

// To a multiple of 2^-bits, of which a float has few digits.
double on_grid(double x, int bits) { return std::ldexp(std::round(std::ldexp(x, bits)), -bits); }

template <class Vector>
void round_all(Vector& v, int bits) {
  for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = on_grid(v[i], bits);
}

// To so many binary digits.
double with_digits(double x, int digits) {
  if (x == 0.0 || !std::isfinite(x)) return x;
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(on_grid(mantissa, digits), exponent);
}

}  // namespace

PoseFrame coarse(PoseFrame f) {
  constexpr int kPlace = 13, kDigits = 8;
  f.time = on_grid(f.time, 20);
  f.speed_factor = on_grid(f.speed_factor, 6);
  round_all(f.X_WB.p, kPlace);
  round_all(f.centre, kPlace - 3);
  round_all(f.com, kPlace);
  for (double* value : {&f.margin, &f.lateral, &f.path}) *value = on_grid(*value, kPlace);
  for (double* value :
       {&f.velocity.v.x(), &f.velocity.v.y(), &f.velocity.w, &f.slip_speed, &f.power})
    *value = with_digits(*value, kDigits);
  for (auto& corner : f.polygon.vertices) round_all(corner, kPlace);
  for (LegFrame& leg : f.legs) {
    round_all(leg.p_WF, kPlace);
    round_all(leg.p_WT, kPlace);
    round_all(leg.q, kPlace);
    leg.force = with_digits(leg.force, kDigits);
    leg.lag = on_grid(leg.lag, kPlace);
  }
  return f;
}

class ReplayWriter::Gzip {
 public:
  explicit Gzip(std::ostream& out) : out_(out) {
    if (deflateInit2(&stream_, Z_BEST_COMPRESSION, Z_DEFLATED, kGzipWindow, 9,
                     Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::runtime_error("replay: no memory to compress it");
  }
  ~Gzip() { deflateEnd(&stream_); }
  Gzip(const Gzip&) = delete;
  Gzip& operator=(const Gzip&) = delete;

  void write(std::string_view bytes, int flush = Z_NO_FLUSH) {
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream_.avail_in = static_cast<uInt>(bytes.size());
    do {
      std::array<char, 16384> chunk;
      stream_.next_out = reinterpret_cast<Bytef*>(chunk.data());
      stream_.avail_out = static_cast<uInt>(chunk.size());
      deflate(&stream_, flush);
      out_.write(chunk.data(), static_cast<std::streamsize>(chunk.size() - stream_.avail_out));
    } while (stream_.avail_out == 0);
  }

 private:
  std::ostream& out_;
  z_stream stream_{};
};

ReplayWriter::ReplayWriter(std::ostream& out) : gzip_(std::make_unique<Gzip>(out)) {
  std::string begin(kReplayMagic);
  put(begin, kReplayVersion);
  out.write(begin.data(), static_cast<std::streamsize>(begin.size()));
}

ReplayWriter::~ReplayWriter() = default;

void ReplayWriter::item(char kind, std::string_view content) {
  std::string head(1, kind);
  put(head, static_cast<std::uint32_t>(content.size()));
  gzip_->write(head);
  gzip_->write(content);
}

void ReplayWriter::text(std::string_view json) {
  flush();
  item('T', json);
}

void ReplayWriter::frame(const PoseFrame& frame, const LegArray<int>& joints) {
  const std::string bytes = encode(coarse(frame), joints);
  put(block_, static_cast<std::uint32_t>(bytes.size()));
  block_ += bytes;
  width_ = std::max(width_, bytes.size());
  ++frames_;
  if (++waiting_ == kBlock) flush();
}

void ReplayWriter::flush() {
  if (waiting_ == 0) return;
  // As rows of one width, the one before the block first.
  std::string rows = last_;
  rows.resize(width_);
  for (std::size_t at = 0; at < block_.size();) {
    const auto size = number_at<std::uint32_t>(block_, at);
    rows.append(block_, at + sizeof size, size);
    rows.resize((rows.size() + width_ - 1) / width_ * width_);
    at += sizeof size + size;
  }
  std::string content;
  put(content, static_cast<std::uint16_t>(waiting_));
  put(content, static_cast<std::uint16_t>(width_));
  for (std::size_t byte = 0; byte < width_; ++byte)
    for (std::size_t at = byte; at + width_ < rows.size(); at += width_)
      content += static_cast<char>(difference(rows[at + width_], rows[at]));
  item('F', content);
  last_ = rows.substr(waiting_ * width_);
  block_.clear();
  waiting_ = 0;
  width_ = 0;
}

void ReplayWriter::finish() {
  flush();
  std::string count;
  put(count, frames_);
  item('E', count);
  gzip_->write({}, Z_FINISH);
}

namespace {

// Takes the items out of a compressed text, piece by piece.
class Items {
 public:
  explicit Items(std::string_view compressed) {
    if (inflateInit2(&stream_, kGzipWindow) != Z_OK)
      throw std::runtime_error("replay: no memory to read it");
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.data()));
    stream_.avail_in = static_cast<uInt>(compressed.size());
  }
  ~Items() { inflateEnd(&stream_); }
  Items(const Items&) = delete;
  Items& operator=(const Items&) = delete;

  struct Item {
    char kind = 0;
    std::string_view content;  // until the next one
  };
  Item next() {
    bytes_.erase(0, used_);
    used_ = 0;
    constexpr std::size_t kHead = 5;
    need(kHead);
    const auto size = number_at<std::uint32_t>(bytes_, 1);
    if (size > kMostItem) throw InvalidInput(fmt::format("{}an item of {} bytes", kDamaged, size));
    need(used_ = kHead + size);
    return {bytes_[0], std::string_view(bytes_).substr(kHead, size)};
  }

  // Of what was compressed nothing is left, and its checksum is right.
  void end() {
    if (!ended_) inflate_more();
    if (bytes_.size() > used_ || stream_.avail_in > 0)
      throw InvalidInput(fmt::format("{}there is more behind its end", kDamaged));
    if (!ended_) throw InvalidInput(kCutOff);
  }

 private:
  void need(std::size_t size) {
    while (bytes_.size() < size)
      if (ended_ || inflate_more() == 0) throw InvalidInput(kCutOff);
  }

  std::size_t inflate_more() {
    const std::size_t before = bytes_.size();
    bytes_.resize(before + kInflated);
    stream_.next_out = reinterpret_cast<Bytef*>(bytes_.data() + before);
    stream_.avail_out = kInflated;
    const int status = inflate(&stream_, Z_NO_FLUSH);
    const std::size_t got = kInflated - stream_.avail_out;
    bytes_.resize(before + got);
    ended_ = status == Z_STREAM_END;
    if (status != Z_OK && !ended_ && status != Z_BUF_ERROR)
      throw InvalidInput(
          fmt::format("{}{}", kDamaged, stream_.msg != nullptr ? stream_.msg : "no gzip"));
    return got;
  }

  z_stream stream_{};
  std::string bytes_;
  std::size_t used_ = 0;
  bool ended_ = false;
};

PoseFrame padded_frame(std::string_view bytes) {
  try {
    PoseFrame frame = decode_front(bytes);
    if (bytes.find_first_not_of('\0') == std::string_view::npos) return frame;
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}{}", kDamaged, error.what()));
  }
  throw InvalidInput(fmt::format("{}bytes behind a frame", kDamaged));
}

// The frames of an item of kind F; `last` is the one before, and then the last of these.
std::uint32_t hand_out_frames(std::string_view content, std::string& last,
                              const ReplayReader& reader) {
  constexpr std::size_t kHead = 4;
  if (content.size() < kHead) throw InvalidInput(fmt::format("{}no frames", kDamaged));
  const std::size_t count = number_at<std::uint16_t>(content, 0);
  const std::size_t width = number_at<std::uint16_t>(content, 2);
  if (content.size() != kHead + count * width)
    throw InvalidInput(fmt::format("{}frames of another size than it says", kDamaged));
  last.resize(width);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t byte = 0; byte < width; ++byte)
      last[byte] = static_cast<char>(static_cast<unsigned char>(last[byte]) +
                                     static_cast<unsigned char>(content[kHead + byte * count + k]));
    const PoseFrame frame = padded_frame(last);
    if (reader.frame) reader.frame(frame);
  }
  return static_cast<std::uint32_t>(count);
}

std::string_view compressed_part(std::string_view bytes) {
  const std::size_t head = kReplayMagic.size() + sizeof kReplayVersion;
  if (!bytes.starts_with(kReplayMagic)) {
    if (!bytes.empty() && kReplayMagic.starts_with(bytes)) throw InvalidInput(kCutOff);
    throw InvalidInput("is no replay: hexagait walk --record FILE makes one");
  }
  if (bytes.size() < head) throw InvalidInput(kCutOff);
  const auto version = number_at<std::uint32_t>(bytes, kReplayMagic.size());
  if (version != kReplayVersion)
    throw InvalidInput(fmt::format("is a replay of version {}; this hexagait reads version {}",
                                   version, kReplayVersion));
  return bytes.substr(head);
}

}  // namespace

void read_replay(std::string_view bytes, const ReplayReader& reader) {
  Items items(compressed_part(bytes));
  std::string last;
  std::uint32_t frames = 0;
  while (true) {
    const auto [kind, content] = items.next();
    if (kind == 'T') {
      if (reader.text) reader.text(content);
    } else if (kind == 'F') {
      frames += hand_out_frames(content, last, reader);
    } else if (kind == 'E' && content.size() == sizeof frames &&
               number_at<std::uint32_t>(content, 0) == frames) {
      break;
    } else {
      throw InvalidInput(fmt::format("{}an item that is none", kDamaged));
    }
  }
  items.end();
}

namespace {

// Takes a scene into the facts. @returns its number of legs, or nothing for another text
std::optional<std::size_t> take_scene(std::string_view text, ReplayFacts& facts) {
  try {
    const auto json = nlohmann::json::parse(text);
    if (json.at("type") != "scene") return {};
    if (facts.scenes++ == 0) {
      facts.robot = json.at("robot");
      facts.terrain = json.at("terrain");
      facts.seed = json.at("seed");
    }
    return json.at("legs").size();
  } catch (const nlohmann::json::exception& error) {
    throw InvalidInput(fmt::format("{}{}", kDamaged, error.what()));
  }
}

}  // namespace

ReplayFacts check_replay(std::string_view bytes) {
  ReplayFacts facts;
  std::size_t legs = 0;
  double time = 0.0;
  const auto text = [&](std::string_view words) {
    const auto of_scene = take_scene(words, facts);
    if (!of_scene) return;
    legs = *of_scene;
    facts.seconds += time;
    time = 0.0;
  };
  const auto frame = [&](const PoseFrame& f) {
    if (facts.scenes == 0) throw InvalidInput(fmt::format("{}a frame before its scene", kDamaged));
    if (!(f.time >= 0.0 && f.time <= kLongest))
      throw InvalidInput(fmt::format("{}a frame at {:g} s", kDamaged, f.time));
    if (static_cast<std::size_t>(f.legs.size()) != legs)
      throw InvalidInput(fmt::format("{}a frame of {} legs, of a robot that has {}", kDamaged,
                                     f.legs.size(), legs));
    time = f.time;
    ++facts.frames;
  };
  read_replay(bytes, {text, frame});
  facts.seconds = std::round(1e3 * (facts.seconds + time)) * 1e-3;
  if (facts.frames == 0) throw InvalidInput("has no frames: nothing has moved");
  return facts;
}

}  // namespace hexagait::viewer
