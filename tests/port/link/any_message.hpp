// SPDX-License-Identifier: MIT
#pragma once
// One of each message, and any of each: drawn from the whole range of every field. And what a
// message should look like in bytes, said once more and in another way than the library says it.

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <variant>
#include <vector>

#include "draws.hpp"
#include "shared/link/messages.hpp"

namespace batuta::link::test {

using Bytes = std::vector<std::uint8_t>;
using AnyMessage = std::variant<Hello, Step, StickSample, Welcome, Pose, Event, Force, Touch,
                                StickUsed, StepReport, Refused>;
inline constexpr int kMessages = static_cast<int>(std::variant_size_v<AnyMessage>);

inline MessageType type_of(const AnyMessage& message) {
  return std::visit([](const auto& m) { return m.kType; }, message);
}

/// A field in a column of bytes: `width` of them, least significant first.
struct Field {
  std::uint64_t value;
  int width;
};
using Layout = std::vector<Field>;

inline Field real(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return {bits, 4};
}

template <std::size_t N>
void add(Layout& layout, const std::array<float, N>& values) {
  for (const float value : values) layout.push_back(real(value));
}

inline void add(Layout& layout, const InputSample& s) {
  layout.insert(layout.end(), {{s.time, 4},
                               real(s.x),
                               real(s.y),
                               real(s.feet_x),
                               real(s.feet_y),
                               {s.buttons, 4},
                               {s.sequence, 4}});
}

inline std::uint64_t u(LinkSide side) {
  return side == LinkSide::kRight ? 1 : 0;
}

inline Layout layout(const Hello& m) {
  return {{m.session, 4}, {m.mode == Mode::kFree ? 1U : 0U, 1}, {m.touches, 1}};
}
inline Layout layout(const Welcome& m) {
  return {{m.session, 4},
          {m.protocol_version, 1},
          {m.mode == Mode::kFree ? 1U : 0U, 1},
          {m.step_us, 4},
          {m.fault_code, 4},
          {m.fault_detail[0], 4},
          {m.fault_detail[1], 4},
          {m.step, 4}};
}
inline Layout layout(const Step& m) {
  Layout all = {{m.step, 4}, {(m.has_left ? 1U : 0U) + (m.has_right ? 2U : 0U), 1}};
  if (m.has_left) add(all, m.left);
  if (m.has_right) add(all, m.right);
  return all;
}
inline Layout layout(const StickSample& m) {
  Layout all = {{u(m.side), 1}};
  add(all, m.sample);
  return all;
}
inline Layout layout(const StickUsed& m) {
  Layout all = {{m.step, 4}, {u(m.side), 1}};
  add(all, m.sample);
  return all;
}
inline Layout layout(const Pose& m) {
  Layout all = {{m.step, 4}, {u(m.side), 1}};
  add(all, m.position_W);
  add(all, m.rotation_WB);
  return all;
}
inline Layout layout(const Event& m) {
  Layout all = {{m.step, 4},   {m.index, 1},  {m.kind, 1}, {m.contact_kind, 1},
                {m.body_A, 2}, {m.body_B, 2}, real(m.time)};
  add(all, m.point_W);
  add(all, m.normal_BA_W);
  add(all, std::array<float, 5>{m.gap, m.v_rel, m.impulse, m.place_A, m.place_B});
  return all;
}
inline Layout layout(const Touch& m) {
  Layout all = {{m.step, 4},    {m.index, 1},     {u(m.by), 1},        {m.part, 1},
                {m.certain, 1}, {m.when_step, 4}, real(m.when_in_step)};
  add(all, m.point_W);
  add(all, m.normal_BA_W);
  add(all, std::array<float, 2>{m.gap, m.place});
  return all;
}
inline Layout layout(const Force& m) {
  const unsigned flags = (m.stale ? 1U : 0U) + (m.ramped ? 2U : 0U) + (m.limited ? 4U : 0U);
  return {{m.step, 4}, {u(m.side), 1}, real(m.x), real(m.y), {flags, 1}};
}
inline Layout layout(const StepReport& m) {
  const unsigned flags =
      (m.used_left ? 1U : 0U) + (m.used_right ? 2U : 0U) + (m.repeated ? 4U : 0U);
  return {{m.step, 4},     {m.frames, 1},   {m.bout_state, 1},     {m.touches, 1},
          {flags, 1},      {m.score[0], 1}, {m.score[1], 1},       {m.overruns, 4},
          {m.skipped, 4},  {m.silences, 4}, {m.stale_steps, 4},    {m.rejected, 4},
          {m.lost, 4},     {m.unsent, 4},   {m.evaluations, 4},    {m.incomplete_steps, 4},
          {m.spent_us, 4}, {m.session, 2},  {m.force_failures, 2}, {m.stick_invalid, 2}};
}
inline Layout layout(const Refused& m) {
  return {{static_cast<std::uint64_t>(m.why), 1},
          {static_cast<std::uint64_t>(m.what), 1},
          {m.step, 4},
          {m.steps_over, 4}};
}

/// The payload that the document promises.
template <class Message>
Bytes expected_payload(const Message& message) {
  Bytes bytes;
  for (const Field& field : layout(message)) {
    std::uint64_t rest = field.value;
    for (int i = 0; i < field.width; ++i, rest /= 256) {
      bytes.push_back(static_cast<std::uint8_t>(rest % 256));
    }
  }
  return bytes;
}

/// Draws of single fields: the whole range, its ends and the oddities more often than by chance.
class FieldDraws {
 public:
  explicit FieldDraws(std::uint64_t seed) : draws_(seed, 0, 0) {}

  std::uint32_t u32() {
    const std::uint64_t bits = draws_.bits();
    if (bits % 8 == 0) return 0;
    if (bits % 8 == 1) return 0xFFFFFFFFU;
    return static_cast<std::uint32_t>(bits >> 32U);
  }
  int below(int limit) { return static_cast<int>(draws_.unit() * limit); }
  bool flag() { return below(2) == 1; }
  LinkSide side() { return flag() ? LinkSide::kRight : LinkSide::kLeft; }
  float between(float low, float high) {
    switch (below(8)) {
      case 0:
        return low;
      case 1:
        return high;
      case 2:
        return low < 0 ? -0.0F : low;
      case 3:
        return std::min(high, std::numeric_limits<float>::denorm_min());
      default:
        return std::min(high, std::max(low, static_cast<float>(draws_.between(low, high))));
    }
  }
  /// Any finite float.
  float finite() {
    std::uint32_t bits = u32();
    if ((bits & 0x7F800000U) == 0x7F800000U) bits &= ~0x00800000U;
    float value = 0;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
  }
  std::array<float, 3> vector() {
    const float x = finite();
    const float y = finite();
    return {x, y, finite()};
  }
  std::array<float, 3> normal() {
    const Vec3<float> n = draws_.direction().cast<float>();
    return {n.x(), n.y(), n.z()};
  }
  std::array<float, 4> rotation() {
    const Quat<float> q = draws_.rotation().cast<float>();
    return {q.w(), q.x(), q.y(), q.z()};
  }
  InputSample sample() {
    InputSample s;
    s.time = u32();
    s.x = between(-1, 1);
    s.y = between(-1, 1);
    s.feet_x = between(-1, 1);
    s.feet_y = between(-1, 1);
    s.buttons = u32();
    s.sequence = u32();
    return s;
  }

 private:
  batuta::test::Draws draws_;
};

inline void draw(FieldDraws& d, Hello& m) {
  m.session = d.u32() | 1U;
  m.mode = d.flag() ? Mode::kFree : Mode::kPaced;
  m.touches = static_cast<std::uint8_t>(1 + d.below(kMostTouches));
}
inline void draw(FieldDraws& d, Welcome& m) {
  m.session = d.u32() | 0x8000U;
  m.protocol_version = static_cast<std::uint8_t>(d.below(256));
  m.mode = d.flag() ? Mode::kFree : Mode::kPaced;
  m.step_us = 100U + static_cast<std::uint32_t>(d.below(19901));
  m.fault_code = d.u32();
  m.fault_detail[0] = d.u32();
  m.fault_detail[1] = d.u32();
  m.step = d.u32();
}
inline void draw(FieldDraws& d, Step& m) {
  m.step = d.u32();
  m.has_left = d.flag();
  m.has_right = d.flag();
  if (m.has_left) m.left = d.sample();
  if (m.has_right) m.right = d.sample();
}
inline void draw(FieldDraws& d, StickSample& m) {
  m.side = d.side();
  m.sample = d.sample();
}
inline void draw(FieldDraws& d, StickUsed& m) {
  m.step = d.u32();
  m.side = d.side();
  m.sample = d.sample();
}
inline void draw(FieldDraws& d, Pose& m) {
  m.step = d.u32();
  m.side = d.side();
  m.position_W = d.vector();
  m.rotation_WB = d.rotation();
}
inline void draw(FieldDraws& d, Event& m) {
  m.step = d.u32();
  m.index = static_cast<std::uint8_t>(d.below(kMaxStepFrames));
  m.kind = static_cast<std::uint8_t>(d.below(3));
  m.contact_kind = static_cast<std::uint8_t>(d.below(3));
  m.body_A = static_cast<std::uint16_t>(d.below(0xFFFF));
  m.body_B = static_cast<std::uint16_t>(m.body_A + 1 + d.below(0xFFFF - m.body_A));
  m.time = d.between(0.0F, 0.02F);
  m.point_W = d.vector();
  m.normal_BA_W = d.normal();
  m.gap = d.finite();
  m.v_rel = d.finite();
  m.impulse = d.finite();
  m.place_A = d.between(0, 1);
  m.place_B = d.between(0, 1);
}
inline void draw(FieldDraws& d, Touch& m) {
  m.step = d.u32();
  m.index = static_cast<std::uint8_t>(d.below(2));
  m.by = d.side();
  m.part = static_cast<std::uint8_t>(d.below(12));
  m.certain = d.flag();
  m.when_step = d.u32();
  m.when_in_step = d.between(0.0F, 0.02F);
  m.point_W = d.vector();
  m.normal_BA_W = d.normal();
  m.gap = d.finite();
  m.place = d.between(0, 1);
}
inline void draw(FieldDraws& d, Force& m) {
  m.step = d.u32();
  m.side = d.side();
  m.x = d.between(-1, 1);
  m.y = d.between(-1, 1);
  m.stale = d.flag();
  m.ramped = d.flag();
  m.limited = d.flag();
}
inline void draw(FieldDraws& d, StepReport& m) {
  m.step = d.u32();
  m.frames = static_cast<std::uint8_t>(1 + d.below(kMaxStepFrames));
  m.bout_state = static_cast<std::uint8_t>(d.below(5));
  m.touches = static_cast<std::uint8_t>(d.below(3));
  for (std::uint8_t& score : m.score) {
    score = static_cast<std::uint8_t>(d.below(kMostTouches + 1));
  }
  m.used_left = d.flag();
  m.used_right = d.flag();
  m.repeated = d.flag();
  for (std::uint32_t* count :
       {&m.overruns, &m.skipped, &m.silences, &m.stale_steps, &m.rejected, &m.lost, &m.unsent,
        &m.evaluations, &m.incomplete_steps, &m.spent_us}) {
    *count = d.u32();
  }
  for (std::uint16_t* count : {&m.session, &m.force_failures, &m.stick_invalid}) {
    *count = static_cast<std::uint16_t>(d.u32());
  }
}
inline void draw(FieldDraws& d, Refused& m) {
  constexpr std::array<MessageType, 3> kFromHost = {MessageType::kHello, MessageType::kStep,
                                                    MessageType::kStickSample};
  m.why = static_cast<Refusal>(d.below(kRefusals));
  m.what = kFromHost[static_cast<std::size_t>(d.below(3))];
  m.step = d.u32();
  m.steps_over = d.u32();
}

template <std::size_t I = 0>
AnyMessage default_message(int index) {
  if constexpr (I + 1 < std::variant_size_v<AnyMessage>) {
    if (index != static_cast<int>(I)) return default_message<I + 1>(index);
  }
  return std::variant_alternative_t<I, AnyMessage>{};
}

/// The message with this place in AnyMessage, its fields a function of the seed.
inline AnyMessage any_message(int index, std::uint64_t seed) {
  AnyMessage message = default_message(index);
  FieldDraws draws(seed);
  std::visit([&draws](auto& m) { draw(draws, m); }, message);
  return message;
}

/// One of each type.
inline std::vector<AnyMessage> one_of_each(std::uint64_t seed) {
  std::vector<AnyMessage> all;
  for (int i = 0; i < kMessages; ++i) all.push_back(any_message(i, seed));
  return all;
}

}  // namespace batuta::link::test
