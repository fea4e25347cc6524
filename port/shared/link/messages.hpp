// SPDX-License-Identifier: MIT
#pragma once
// What the two ends of the link tell each other, as plain structures. Where each field lies in a
// frame, and its range, is in link.md; messages.cpp says it once, for reading and for writing. A
// value out of its range is neither sent nor accepted. SI units, frame W (salle).

#include <array>
#include <cstdint>

#include "batuta/port/input.hpp"

namespace batuta::link {

/// In every frame. A change of any layout or meaning raises it; there is no second version to fall
/// back to.
inline constexpr std::uint8_t kProtocolVersion = 3;

/// Bytes of the longest payload (Step: 61), with a little air. Frames stay below 254 bytes, which
/// keeps COBS to one byte of overhead.
inline constexpr int kMaxPayload = 64;

/// A message's type byte. Bit 7 tells the sender, so that an echo of one's own frames is refused.
enum class MessageType : std::uint8_t {
  // host -> device
  kHello = 0x01,
  kStep = 0x02,
  kStickSample = 0x03,
  // device -> host
  kWelcome = 0x81,
  kPose = 0x82,
  kEvent = 0x83,
  kForce = 0x84,
  kTouch = 0x85,
  kStickUsed = 0x86,
  kStepReport = 0x87,
  kRefused = 0x88,
};

/// True for what a device sends.
constexpr bool is_from_device(MessageType type) {
  return (static_cast<unsigned>(type) & 0x80U) != 0;
}

/// Who makes the steps.
enum class Mode : std::uint8_t {
  kPaced,  ///< the host: one step for every Step
  kFree,   ///< the device, by its own clock
};

/// Whose blade, stick or force. The same numbers as batuta::fencing::Side, which only the duel
/// knows.
enum class LinkSide : std::uint8_t { kLeft, kRight };

/// Most touches that a bout can go to; as batuta::fencing::kMostTouches, which only the duel knows.
inline constexpr int kMostTouches = 99;

/// Opens a session. The same session again: the host has not heard the Welcome. Another one: a new
/// bout.
struct Hello {
  static constexpr MessageType kType = MessageType::kHello;
  std::uint32_t session = 0;  ///< chosen by the host, different each time; its low half not 0:
                              ///< StepReport tells that
  Mode mode = Mode::kPaced;
  std::uint8_t touches = 1;  ///< to which the bout goes, 1 ... kMostTouches
};

/// Answers Hello.
struct Welcome {
  static constexpr MessageType kType = MessageType::kWelcome;
  std::uint32_t session = 0;                         ///< of the Hello
  std::uint8_t protocol_version = kProtocolVersion;  ///< of the device
  Mode mode = Mode::kPaced;                          ///< that holds from now on
  std::uint32_t step_us = 1000;                      ///< length of a step, us, 100 ... 20000
  std::uint32_t fault_code = 0;  ///< of the last reset; 0: none. The device's own list
  std::array<std::uint32_t, 2> fault_detail{};
  std::uint32_t step = 0;  ///< steps that are over in this bout
};

/// Paced: asks for one step. A resend carries the same step number in a frame with a new sequence
/// number.
struct Step {
  static constexpr MessageType kType = MessageType::kStep;
  std::uint32_t step = 0;  ///< steps that are over once it is made: 1 for the first
  bool has_left = false;   ///< without a sample the stick goes on as it was
  bool has_right = false;
  InputSample left;  ///< only where has_left
  InputSample right;
};

/// Free: where a stick on the host's side is. The latest one wins.
struct StickSample {
  static constexpr MessageType kType = MessageType::kStickSample;
  LinkSide side = LinkSide::kLeft;
  InputSample sample;
};

/// Free: the sample that a step was made with, so that the host can make the same step.
struct StickUsed {
  static constexpr MessageType kType = MessageType::kStickUsed;
  std::uint32_t step = 0;
  LinkSide side = LinkSide::kLeft;
  InputSample sample;
};

/// Where a blade's body is after the step: X_WB.
struct Pose {
  static constexpr MessageType kType = MessageType::kPose;
  std::uint32_t step = 0;
  LinkSide side = LinkSide::kLeft;
  std::array<float, 3> position_W{};             ///< m
  std::array<float, 4> rotation_WB{1, 0, 0, 0};  ///< w, x, y, z; unit to within kUnitSlack
};

/// A contact: batuta::ContactEvent<float>, field by field.
struct Event {
  static constexpr MessageType kType = MessageType::kEvent;
  std::uint32_t step = 0;
  std::uint8_t index = 0;         ///< among the events of the step, in their order
  std::uint8_t kind = 0;          ///< batuta::EventKind, 0 ... 2
  std::uint8_t contact_kind = 0;  ///< batuta::ContactKind, 0 ... 2
  std::uint16_t body_A = 0;
  std::uint16_t body_B = 1;                   ///< > body_A
  float time = 0;                             ///< in the step, s
  std::array<float, 3> point_W{};             ///< m
  std::array<float, 3> normal_BA_W{1, 0, 0};  ///< unit to within kUnitSlack
  float gap = 0;                              ///< m
  float v_rel = 0;                            ///< m/s
  float impulse = 0;                          ///< N s
  float place_A = 0;                          ///< 0 ... 1, to within kUnitSlack
  float place_B = 0;
};

/// A touch of the bout: batuta::fencing::Touch<float>, field by field.
struct Touch {
  static constexpr MessageType kType = MessageType::kTouch;
  std::uint32_t step = 0;  ///< in which it is told
  std::uint8_t index = 0;  ///< in its exchange: 0 or 1
  LinkSide by = LinkSide::kLeft;
  std::uint8_t part = 0;  ///< batuta::fencing::BodyPart, 0 ... 11
  bool certain = true;
  std::uint32_t when_step = 0;  ///< steps that were over
  float when_in_step = 0;       ///< s
  std::array<float, 3> point_W{};
  std::array<float, 3> normal_BA_W{1, 0, 0};
  float gap = 0;
  float place = 0;
};

/// The force of the step on a stick; the motor's own share may be less, as after a silence of the
/// host. The other stick's motor, if there is one, is not the device's.
struct Force {
  static constexpr MessageType kType = MessageType::kForce;
  std::uint32_t step = 0;
  LinkSide side = LinkSide::kLeft;
  float x = 0;  ///< share of the actuator's range, -1 ... 1
  float y = 0;
  bool stale = false;    ///< the stick has been silent for too long
  bool ramped = false;   ///< the force is being taken back for it: smaller than the duel's
  bool limited = false;  ///< the blow was stronger than the actuator
};

/// The last frame of a step.
struct StepReport {
  static constexpr MessageType kType = MessageType::kStepReport;
  std::uint32_t step = 0;
  std::uint8_t frames = 1;  ///< that belong to the step, with those that found no room, and this
                            ///< one: 1 ... kMaxStepFrames
  std::uint8_t bout_state = 0;  ///< batuta::fencing::BoutState, 0 ... 4
  std::uint8_t touches = 0;     ///< of the exchange, so far, 0 ... 2
  /// Touches of the left and the right fencer that count, 0 ... kMostTouches
  std::array<std::uint8_t, 2> score{};
  bool used_left = false;  ///< the step was made with a new sample of this stick
  bool used_right = false;
  bool repeated = false;       ///< paced: the step was made before, this is the answer once more
  std::uint32_t overruns = 0;  ///< steps that took longer than they may, so far
  std::uint32_t skipped = 0;   ///< ticks of the device's clock that went by without a step, so far
  /// Times that the force was taken back: stick or host fell silent, so far
  std::uint32_t silences = 0;
  std::uint32_t stale_steps = 0;       ///< steps with a stale stick, so far
  std::uint32_t rejected = 0;          ///< frames from the host that were rejected, so far
  std::uint32_t lost = 0;              ///< frames from the host that are missing, so far
  std::uint32_t unsent = 0;            ///< frames to the host that found no room, so far
  std::uint32_t evaluations = 0;       ///< distance evaluations of this step's searches
  std::uint32_t incomplete_steps = 0;  ///< steps in which a blade was held, so far
  std::uint32_t spent_us = 0;          ///< on this step
  std::uint16_t session = 0;           ///< low half of the session's number; 0: the device is alone
  /// Commands that the motor did not take, so far; stays at 65535
  std::uint16_t force_failures = 0;
  std::uint16_t stick_invalid = 0;  ///< samples of the own stick out of its square, the same
};

enum class Refusal : std::uint8_t {
  kNoSession,  ///< Hello first: Step and StickSample
  kWrongMode,  ///< Step while free; StickSample while paced, or of a side that a rival plays
  kWrongStep,  ///< neither the next step nor the last one again
  kBoutOver,   ///< no more steps in this bout
  kNotReady,   ///< the duel could not be set up
};
inline constexpr int kRefusals = 5;

/// Why an intact frame was not obeyed.
struct Refused {
  static constexpr MessageType kType = MessageType::kRefused;
  Refusal why = Refusal::kNoSession;
  MessageType what = MessageType::kStep;  ///< type of the frame that was refused
  std::uint32_t step = 0;                 ///< its step number, or 0
  std::uint32_t steps_over = 0;           ///< steps that are over on the device
};

/// How far a unit quantity may be off and still be taken for one.
inline constexpr float kUnitSlack = 1e-3F;

/// Two poses, two forces, two samples, two touches, 16 events and the report, with air.
inline constexpr int kMaxStepFrames = 32;

/// A message as bytes, not yet framed.
struct Payload {
  std::array<std::uint8_t, kMaxPayload> bytes{};
  int size = 0;
};

/// Writes a message.
/// @returns true | false: a field is out of its range; `payload` is then not to be sent
/// Bound: kMaxPayload bytes. Allocates: never. ISR-safe: yes.
bool encode(const Hello& message, Payload& payload);
bool encode(const Welcome& message, Payload& payload);
bool encode(const Step& message, Payload& payload);
bool encode(const StickSample& message, Payload& payload);
bool encode(const StickUsed& message, Payload& payload);
bool encode(const Pose& message, Payload& payload);
bool encode(const Event& message, Payload& payload);
bool encode(const Touch& message, Payload& payload);
bool encode(const Force& message, Payload& payload);
bool encode(const StepReport& message, Payload& payload);
bool encode(const Refused& message, Payload& payload);

/// Reads a message.
/// @returns true | false: a wrong length, or a field out of its range; `message` is then unchanged
/// Bound: kMaxPayload bytes. Allocates: never. ISR-safe: yes.
bool decode(const std::uint8_t* bytes, int size, Hello& message);
bool decode(const std::uint8_t* bytes, int size, Welcome& message);
bool decode(const std::uint8_t* bytes, int size, Step& message);
bool decode(const std::uint8_t* bytes, int size, StickSample& message);
bool decode(const std::uint8_t* bytes, int size, StickUsed& message);
bool decode(const std::uint8_t* bytes, int size, Pose& message);
bool decode(const std::uint8_t* bytes, int size, Event& message);
bool decode(const std::uint8_t* bytes, int size, Touch& message);
bool decode(const std::uint8_t* bytes, int size, Force& message);
bool decode(const std::uint8_t* bytes, int size, StepReport& message);
bool decode(const std::uint8_t* bytes, int size, Refused& message);

/// What a type byte and a payload are.
enum class Verdict : std::uint8_t {
  kGood,         ///< a message with every field in its range
  kUnknownType,  ///< of a type that the other end must not send, or that is none
  kBadPayload,   ///< of a wrong length, or with a field out of its range
};

/// Judges what a device receives, and what a host receives. Two functions, so that a device does
/// not carry what only a host needs.
/// Bound: kMaxPayload bytes. Allocates: never. ISR-safe: yes.
Verdict judge_from_host(MessageType type, const std::uint8_t* bytes, int size);
Verdict judge_from_device(MessageType type, const std::uint8_t* bytes, int size);

}  // namespace batuta::link
