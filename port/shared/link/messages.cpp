// SPDX-License-Identifier: MIT
// Every message's layout and ranges, once: list(fields, message) names the fields in the order of
// the wire, and the same list reads and writes. link.md shows the same as tables.

#include "shared/link/messages.hpp"

#include "shared/link/fields.hpp"

namespace batuta::link {
namespace {

constexpr int kModes = 2;
constexpr int kSides = 2;
constexpr int kEventKinds = 3;
constexpr int kContactKinds = 3;
constexpr int kBoutStates = 5;
constexpr int kTouches = 2;
constexpr int kBodyParts = 12;
constexpr std::uint32_t kShortestStep_us = 100;
constexpr std::uint32_t kLongestStep_us = 20000;
constexpr float kLongestStep = 0.02F;  ///< s
constexpr float kOne = 1.0F + kUnitSlack;

void list(Fields& fields, InputSample& sample) {
  fields.u32(sample.time);
  fields.real(sample.x, -1.0F, 1.0F);
  fields.real(sample.y, -1.0F, 1.0F);
  fields.real(sample.feet_x, -1.0F, 1.0F);
  fields.real(sample.feet_y, -1.0F, 1.0F);
  fields.u32(sample.buttons);
  fields.u32(sample.sequence);
}

/// Unit to within kUnitSlack. A sum of squares of numbers that were found to be small is finite.
template <std::size_t N>
void unit(Fields& fields, std::array<float, N>& values) {
  fields.reals(values, -kOne, kOne);
  float square = 0;
  for (const float value : values) square += value * value;  // Bound: N
  fields.require(square >= 1.0F - 2.0F * kUnitSlack && square <= 1.0F + 2.0F * kUnitSlack);
}

/// Its low half, which StepReport tells, is not the device's word for "alone".
void session(Fields& fields, std::uint32_t& session) {
  fields.u32(session);
  fields.require(static_cast<std::uint16_t>(session) != 0);
}

void list(Fields& fields, Hello& message) {
  session(fields, message.session);
  fields.choice(message.mode, kModes);
  fields.choice(message.touches, kMostTouches + 1);
  fields.require(message.touches > 0);
}

void list(Fields& fields, Welcome& message) {
  session(fields, message.session);
  fields.u8(message.protocol_version);
  fields.choice(message.mode, kModes);
  fields.u32(message.step_us);
  fields.require(message.step_us >= kShortestStep_us && message.step_us <= kLongestStep_us);
  fields.u32(message.fault_code);
  for (std::uint32_t& detail : message.fault_detail) fields.u32(detail);  // Bound: 2
  fields.u32(message.step);
}

void list(Fields& fields, Step& message) {
  fields.u32(message.step);
  fields.flags(message.has_left, message.has_right);
  if (message.has_left) list(fields, message.left);
  if (message.has_right) list(fields, message.right);
}

void list(Fields& fields, StickSample& message) {
  fields.choice(message.side, kSides);
  list(fields, message.sample);
}

void list(Fields& fields, StickUsed& message) {
  fields.u32(message.step);
  fields.choice(message.side, kSides);
  list(fields, message.sample);
}

void list(Fields& fields, Pose& message) {
  fields.u32(message.step);
  fields.choice(message.side, kSides);
  fields.reals(message.position_W);
  unit(fields, message.rotation_WB);
}

void list(Fields& fields, Event& message) {
  fields.u32(message.step);
  fields.choice(message.index, kMaxStepFrames);
  fields.choice(message.kind, kEventKinds);
  fields.choice(message.contact_kind, kContactKinds);
  fields.u16(message.body_A);
  fields.u16(message.body_B);
  fields.require(message.body_A < message.body_B);
  fields.real(message.time, 0.0F, kLongestStep);
  fields.reals(message.point_W);
  unit(fields, message.normal_BA_W);
  fields.real(message.gap);
  fields.real(message.v_rel);
  fields.real(message.impulse);
  fields.real(message.place_A, -kUnitSlack, kOne);
  fields.real(message.place_B, -kUnitSlack, kOne);
}

void list(Fields& fields, Touch& message) {
  fields.u32(message.step);
  fields.choice(message.index, kTouches);
  fields.choice(message.by, kSides);
  fields.choice(message.part, kBodyParts);
  fields.flags(message.certain);
  fields.u32(message.when_step);
  fields.real(message.when_in_step, 0.0F, kLongestStep);
  fields.reals(message.point_W);
  unit(fields, message.normal_BA_W);
  fields.real(message.gap);
  fields.real(message.place, -kUnitSlack, kOne);
}

void list(Fields& fields, Force& message) {
  fields.u32(message.step);
  fields.choice(message.side, kSides);
  fields.real(message.x, -1.0F, 1.0F);
  fields.real(message.y, -1.0F, 1.0F);
  fields.flags(message.stale, message.ramped, message.limited);
}

void list(Fields& fields, StepReport& message) {
  fields.u32(message.step);
  fields.u8(message.frames);
  fields.require(message.frames >= 1 && message.frames <= kMaxStepFrames);
  fields.choice(message.bout_state, kBoutStates);
  fields.choice(message.touches, kTouches + 1);
  fields.flags(message.used_left, message.used_right, message.repeated);
  for (std::uint8_t& score : message.score) fields.choice(score, kMostTouches + 1);  // Bound: 2
  fields.u32(message.overruns);
  fields.u32(message.skipped);
  fields.u32(message.silences);
  fields.u32(message.stale_steps);
  fields.u32(message.rejected);
  fields.u32(message.lost);
  fields.u32(message.unsent);
  fields.u32(message.evaluations);
  fields.u32(message.incomplete_steps);
  fields.u32(message.spent_us);
  fields.u16(message.session);
  fields.u16(message.force_failures);
  fields.u16(message.stick_invalid);
}

void list(Fields& fields, Refused& message) {
  fields.choice(message.why, kRefusals);
  auto what = static_cast<std::uint8_t>(message.what);
  fields.u8(what);
  message.what = static_cast<MessageType>(what);
  fields.require(!is_from_device(message.what));
  fields.u32(message.step);
  fields.u32(message.steps_over);
}

template <class Message>
bool write(const Message& message, Payload& payload) {
  Message copy = message;  // a list may read into its message
  Fields fields = Fields::writer(payload.bytes.data(), kMaxPayload);
  list(fields, copy);
  payload.size = fields.good() ? fields.position() : 0;
  return fields.good();
}

template <class Message>
bool read(const std::uint8_t* bytes, int size, Message& message) {
  Message fresh;
  Fields fields = Fields::reader(bytes, size);
  list(fields, fresh);
  if (!fields.good() || fields.position() != size) return false;
  message = fresh;
  return true;
}

template <class Message>
Verdict judge(const std::uint8_t* bytes, int size) {
  Message message;
  return decode(bytes, size, message) ? Verdict::kGood : Verdict::kBadPayload;
}

}  // namespace

bool encode(const Hello& message, Payload& payload) {
  return write(message, payload);
}
bool encode(const Welcome& message, Payload& payload) {
  return write(message, payload);
}
bool encode(const Step& message, Payload& payload) {
  return write(message, payload);
}
bool encode(const StickSample& message, Payload& payload) {
  return write(message, payload);
}
bool encode(const StickUsed& message, Payload& payload) {
  return write(message, payload);
}
bool encode(const Pose& message, Payload& payload) {
  return write(message, payload);
}
bool encode(const Event& message, Payload& payload) {
  return write(message, payload);
}
bool encode(const Touch& message, Payload& payload) {
  return write(message, payload);
}
bool encode(const Force& message, Payload& payload) {
  return write(message, payload);
}
bool encode(const StepReport& message, Payload& payload) {
  return write(message, payload);
}
bool encode(const Refused& message, Payload& payload) {
  return write(message, payload);
}

bool decode(const std::uint8_t* bytes, int size, Hello& message) {
  return read(bytes, size, message);
}
bool decode(const std::uint8_t* bytes, int size, Welcome& message) {
  return read(bytes, size, message);
}
bool decode(const std::uint8_t* bytes, int size, Step& message) {
  return read(bytes, size, message);
}
bool decode(const std::uint8_t* bytes, int size, StickSample& message) {
  return read(bytes, size, message);
}
bool decode(const std::uint8_t* bytes, int size, StickUsed& message) {
  return read(bytes, size, message);
}
bool decode(const std::uint8_t* bytes, int size, Pose& message) {
  return read(bytes, size, message);
}
bool decode(const std::uint8_t* bytes, int size, Event& message) {
  return read(bytes, size, message);
}
bool decode(const std::uint8_t* bytes, int size, Touch& message) {
  return read(bytes, size, message);
}
bool decode(const std::uint8_t* bytes, int size, Force& message) {
  return read(bytes, size, message);
}
bool decode(const std::uint8_t* bytes, int size, StepReport& message) {
  return read(bytes, size, message);
}
bool decode(const std::uint8_t* bytes, int size, Refused& message) {
  return read(bytes, size, message);
}

Verdict judge_from_host(MessageType type, const std::uint8_t* bytes, int size) {
  switch (type) {
    case MessageType::kHello:
      return judge<Hello>(bytes, size);
    case MessageType::kStep:
      return judge<Step>(bytes, size);
    case MessageType::kStickSample:
      return judge<StickSample>(bytes, size);
    default:
      return Verdict::kUnknownType;
  }
}

Verdict judge_from_device(MessageType type, const std::uint8_t* bytes, int size) {
  switch (type) {
    case MessageType::kWelcome:
      return judge<Welcome>(bytes, size);
    case MessageType::kStickUsed:
      return judge<StickUsed>(bytes, size);
    case MessageType::kPose:
      return judge<Pose>(bytes, size);
    case MessageType::kEvent:
      return judge<Event>(bytes, size);
    case MessageType::kTouch:
      return judge<Touch>(bytes, size);
    case MessageType::kForce:
      return judge<Force>(bytes, size);
    case MessageType::kStepReport:
      return judge<StepReport>(bytes, size);
    case MessageType::kRefused:
      return judge<Refused>(bytes, size);
    default:
      return Verdict::kUnknownType;
  }
}

}  // namespace batuta::link
