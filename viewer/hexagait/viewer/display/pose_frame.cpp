// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/display/pose_frame.hpp>
#include <type_traits>

namespace hexagait::viewer {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are sent as they lie in memory");

// Of a quaternion: 0.03 mrad, and few digits, so that a file of frames is small.
constexpr double kTurnStep = 0x1p-16;

// Appends to a text.
struct Writer {
  static constexpr bool kReads = false;
  std::string bytes;

  template <class Wire, class Value>
  void number(const Value& value) {
    const auto wire = static_cast<Wire>(value);
    bytes.append(reinterpret_cast<const char*>(&wire), sizeof wire);
  }
};

// Takes from a text.
struct Reader {
  static constexpr bool kReads = true;
  std::string_view bytes;

  template <class Wire, class Value>
  void number(Value& value) {
    if (bytes.size() < sizeof(Wire)) throw InvalidInput("pose frame: it ends too early");
    Wire wire{};
    std::memcpy(&wire, bytes.data(), sizeof wire);
    bytes.remove_prefix(sizeof wire);
    value = static_cast<Value>(wire);
  }
};

// The order of the bytes, for both directions.
template <class Wire, class Stream, class Vector>
void vector(Stream& stream, Vector& v) {
  for (Eigen::Index i = 0; i < v.size(); ++i) stream.template number<Wire>(v[i]);
}

template <class Stream, class Set>
void legs(Stream& stream, Set& set) {
  std::uint32_t bits = set.bits();
  stream.template number<std::uint16_t>(bits);
  if constexpr (Stream::kReads) set = LegSet(bits);
}

template <class Stream, class Rotation>
void rotation(Stream& stream, Rotation& R) {
  Eigen::Quaterniond q(R);
  if constexpr (!Stream::kReads)
    for (double& c : q.coeffs()) c = std::round(c / kTurnStep) * kTurnStep;
  vector<float>(stream, q.coeffs());
  if constexpr (Stream::kReads) R = q.normalized().toRotationMatrix();
}

template <class Stream, class Frame>
void motion(Stream& stream, Frame& f) {
  stream.template number<std::uint32_t>(f.scene);
  stream.template number<std::uint32_t>(f.tick);
  stream.template number<std::uint32_t>(f.holder);
  stream.template number<double>(f.time);
  stream.template number<float>(f.speed_factor);
  vector<float>(stream, f.X_WB.p);
  rotation(stream, f.X_WB.R);
  vector<float>(stream, f.velocity.v);
  stream.template number<float>(f.velocity.w);
  for (auto* value : {&f.rho, &f.k, &f.crab}) stream.template number<float>(*value);
  stream.template number<float>(f.moving);
  vector<float>(stream, f.centre);
  stream.template number<float>(f.margin);
  vector<float>(stream, f.com);
  for (auto* value : {&f.lateral, &f.path, &f.slip_speed, &f.power})
    stream.template number<float>(*value);
}

template <class Stream, class Frame>
void gait(Stream& stream, Frame& f) {
  for (auto* bits : {&f.raw, &f.state}) stream.template number<std::uint16_t>(*bits);
  for (auto* value : {&f.ccn, &f.type}) stream.template number<std::uint8_t>(*value);
  for (auto* set : {&f.priority, &f.may_step, &f.waits, &f.contact, &f.support, &f.urgent})
    legs(stream, *set);
}

// Last: where all else is does not depend on how many corners there are.
template <class Stream, class Frame>
void polygon(Stream& stream, Frame& f) {
  stream.template number<std::uint8_t>(f.polygon.size);
  if (f.polygon.size > kMaxLegs) throw InvalidInput("pose frame: a polygon of too many corners");
  for (int i = 0; i < f.polygon.size; ++i)
    vector<float>(stream, f.polygon.vertices[static_cast<std::size_t>(i)]);
}

template <class Stream, class Leg>
void leg(Stream& stream, Leg& one, int& joints) {
  vector<float>(stream, one.p_WF);
  vector<float>(stream, one.p_WT);
  stream.template number<float>(one.force);
  stream.template number<float>(one.lag);
  stream.template number<std::uint8_t>(one.phase);
  stream.template number<std::uint8_t>(joints);
  if (joints > kMaxLegJoints) throw InvalidInput("pose frame: a leg of too many joints");
  for (int k = 0; k < joints; ++k) stream.template number<float>(one.q[k]);
}

}  // namespace

LegArray<int> joint_counts(const RobotModel& robot) {
  LegArray<int> joints(robot.num_legs());
  for (LegId i = 0; i < joints.size(); ++i) joints[i] = robot.legs[i].num_joints();
  return joints;
}

std::string encode(const PoseFrame& frame, const LegArray<int>& joints) {
  Writer writer;
  writer.bytes.reserve(1024);
  writer.number<std::uint8_t>(PoseFrame::kVersion);
  writer.number<std::uint8_t>(frame.legs.size());
  writer.number<std::uint8_t>(frame.flags);
  writer.number<std::uint8_t>(frame.fault);
  motion(writer, frame);
  gait(writer, frame);
  for (LegId i = 0; i < frame.legs.size(); ++i) {
    int count = joints[i];
    leg(writer, frame.legs[i], count);
  }
  polygon(writer, frame);
  return std::move(writer.bytes);
}

PoseFrame decode_front(std::string_view& bytes) {
  Reader reader{bytes};
  PoseFrame frame;
  int version = 0, n = 0;
  reader.number<std::uint8_t>(version);
  if (version != PoseFrame::kVersion)
    throw InvalidInput("pose frame: version " + std::to_string(version) + "; it must be " +
                       std::to_string(PoseFrame::kVersion));
  reader.number<std::uint8_t>(n);
  if (n > kMaxLegs) throw InvalidInput("pose frame: too many legs");
  reader.number<std::uint8_t>(frame.flags);
  reader.number<std::uint8_t>(frame.fault);
  motion(reader, frame);
  gait(reader, frame);
  frame.legs = LegArray<LegFrame>(n);
  for (LegFrame& one : frame.legs) {
    int joints = 0;
    leg(reader, one, joints);
  }
  polygon(reader, frame);
  bytes = reader.bytes;
  return frame;
}

PoseFrame decode(std::string_view bytes) {
  const PoseFrame frame = decode_front(bytes);
  if (!bytes.empty()) throw InvalidInput("pose frame: bytes are left over");
  return frame;
}

}  // namespace hexagait::viewer
