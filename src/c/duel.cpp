// SPDX-License-Identifier: MIT
#include "batuta/record/duel.hpp"

#include "numbers.hpp"
#include "storage.hpp"

namespace batuta::fencing {
namespace {

static_assert(kBodyParts == BATUTA_BODY_PARTS && kMostTouches == BATUTA_MOST_TOUCHES,
              "batuta/c.h says so");

constexpr std::array<Side, 2> kBothSides = {Side::kLeft, Side::kRight};

struct DuelForC {
  static constexpr std::uint32_t kMark = file_id("batuta_duel");

  std::uint32_t mark = kMark;
  std::int32_t step_us = 0;
  std::array<std::uint32_t, 2> samples{};  ///< that came, by index_of(side)
  Duel<> duel;
};
static_assert(batuta::detail::holds_closely<DuelForC, batuta_duel>(),
              "BATUTA_DUEL_BYTES, or an alignment");

bool is_axis(float value) {
  return value >= -1 && value <= 1;
}
bool is_stick(const batuta_stick* stick) {
  return stick == nullptr || (is_axis(stick->x) && is_axis(stick->y) && is_axis(stick->feet_x) &&
                              is_axis(stick->feet_y));
}

/// A sample that the device has taken at the beginning of the step; nothing where none came.
InputSample sample_of(const batuta_stick* stick, Side side, const DuelForC& own) {
  InputSample sample;
  if (stick == nullptr) return sample;
  sample.time = own.duel.steps() * static_cast<Microseconds>(own.step_us);
  sample.x = stick->x;
  sample.y = stick->y;
  sample.feet_x = stick->feet_x;
  sample.feet_y = stick->feet_y;
  sample.sequence = own.samples[index_of(side)];
  return sample;
}

std::int32_t step(DuelForC& own, const batuta_stick* left, const batuta_stick* right) {
  const InputSample of_left = sample_of(left, Side::kLeft, own);
  const InputSample of_right = sample_of(right, Side::kRight, own);
  const Status status =
      own.duel.step(left == nullptr ? nullptr : &of_left, right == nullptr ? nullptr : &of_right);
  if (status != Status::kOk) return batuta::detail::code_of(status);
  if (left != nullptr) ++own.samples[index_of(Side::kLeft)];
  if (right != nullptr) ++own.samples[index_of(Side::kRight)];
  return BATUTA_OK;
}

void put_bout(const Duel<>& duel, batuta_duel_state& out) {
  const Bout<float>& bout = duel.bout();
  out.bout = static_cast<std::int32_t>(bout.state);
  out.exchange = static_cast<std::int32_t>(bout.exchange);
  out.annulled = bout.annulled ? 1 : 0;
  out.touches = bout.touches.size();
  for (std::int32_t i = 0; i < out.touches; ++i) {  // Bound: 2
    const Touch<float>& touch = bout.touches[i];
    batuta_touch& shown = out.touch[i];
    shown.by = static_cast<std::int32_t>(index_of(touch.by));
    shown.part = static_cast<std::int32_t>(touch.part);
    shown.time_us = duel.time_us(touch.when);
    batuta::detail::put(touch.contact.point_W, shown.point_W);
  }
}

void put_side(const Duel<>& duel, Side side, batuta_duel_state& out) {
  const std::size_t i = index_of(side);
  out.score[i] = duel.bout().score[i];
  batuta::detail::put(duel.blade_W(side), out.blade_W[i]);
  const Vec2<float>& stick = duel.stick(side).position();
  out.stick[i][0] = stick.x();
  out.stick[i][1] = stick.y();
  out.control[i] = duel.grip(side).control();
  const BodyShape<float>& body_W = duel.body_W(side);
  for (std::size_t part = 0; part < body_W.size(); ++part) {  // Bound: kBodyParts
    batuta::detail::put(body_W[part], out.body_W[i][part]);
  }
}

}  // namespace
}  // namespace batuta::fencing

using batuta::fencing::DuelForC;

std::size_t batuta_duel_size() {
  return sizeof(DuelForC);
}

std::size_t batuta_duel_align() {
  return alignof(DuelForC);
}

std::int32_t batuta_duel_init(batuta_duel* duel, std::size_t bytes, std::int32_t step_us,
                              std::int32_t touches) {
  const bool good = batuta::detail::has_room<DuelForC>(duel, bytes) &&
                    step_us >= BATUTA_SHORTEST_STEP_US && step_us <= BATUTA_LONGEST_STEP_US &&
                    touches >= 1 && touches <= BATUTA_MOST_TOUCHES;
  if (!good) return BATUTA_INVALID_ARGUMENT;
  if (!batuta::rounds_each_operation<float>()) return BATUTA_UNAVAILABLE;
  auto settings = batuta::fencing::duel_settings<>();
  settings.step_us = step_us;
  settings.touches = static_cast<decltype(settings.touches)>(touches);
  DuelForC& own = *batuta::detail::make_in<DuelForC>(duel);
  own.step_us = step_us;
  return batuta::detail::code_of(own.duel.configure(
      settings, batuta::fencing::first_fencer<float>(), batuta::fencing::second_fencer<float>()));
}

std::int32_t batuta_duel_step(batuta_duel* duel, const batuta_stick* left,
                              const batuta_stick* right) {
  auto* const own = batuta::detail::found_in<DuelForC>(duel);
  const bool good =
      own != nullptr && batuta::fencing::is_stick(left) && batuta::fencing::is_stick(right);
  return good ? batuta::fencing::step(*own, left, right) : BATUTA_INVALID_ARGUMENT;
}

std::int32_t batuta_duel_get_state(const batuta_duel* duel, batuta_duel_state* out) {
  const auto* const own = batuta::detail::found_in<DuelForC>(duel);
  if (own == nullptr || out == nullptr) return BATUTA_INVALID_ARGUMENT;
  *out = batuta_duel_state{};
  out->steps = own->duel.steps();
  batuta::fencing::put_bout(own->duel, *out);
  for (const auto side : batuta::fencing::kBothSides) {  // Bound: 2
    batuta::fencing::put_side(own->duel, side, *out);
  }
  out->gap = batuta::capsule_gap(own->duel.blade_W(batuta::fencing::Side::kLeft),
                                 own->duel.blade_W(batuta::fencing::Side::kRight))
                 .gap;
  return BATUTA_OK;
}

std::int32_t batuta_duel_hash(const batuta_duel* duel, std::uint64_t* out) {
  const auto* const own = batuta::detail::found_in<DuelForC>(duel);
  if (own == nullptr || out == nullptr) return BATUTA_INVALID_ARGUMENT;
  *out = batuta::hash_of(own->duel);
  return BATUTA_OK;
}
