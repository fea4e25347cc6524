// SPDX-License-Identifier: MIT
#include "batuta/record/duel.hpp"

#include "duel_for_c.hpp"
#include "numbers.hpp"

namespace batuta::fencing {
namespace {

static_assert(kBodyParts == BATUTA_BODY_PARTS && kMostTouches == BATUTA_MOST_TOUCHES,
              "batuta/c/duel.h says so");
static_assert(batuta::detail::holds_closely<DuelForC, batuta_duel>(),
              "BATUTA_DUEL_BYTES, or an alignment");

constexpr std::array<Side, 2> kBothSides = {Side::kLeft, Side::kRight};

bool is_axis(float value) {
  return value >= -1 && value <= 1;
}
bool is_stick(const batuta_stick* stick) {
  return stick == nullptr || (is_axis(stick->x) && is_axis(stick->y) && is_axis(stick->feet_x) &&
                              is_axis(stick->feet_y));
}
const batuta_stick* stick_of(const batuta_sample* sample) {
  return sample != nullptr ? &sample->stick : nullptr;
}

/// A sample that the device has taken at the beginning of the step; nothing where none came.
batuta_sample sample_of(const batuta_stick* stick, Side side, const DuelForC& own) {
  batuta_sample sample{};
  if (stick == nullptr) return sample;
  sample.stick = *stick;
  sample.time_us = now_of(own.bout.duel());
  sample.sequence = own.bout.duel().stick(side).next_sequence();
  return sample;
}

InputSample read(const batuta_sample* sample) {
  if (sample == nullptr) return {};
  const batuta_stick& stick = sample->stick;
  return {sample->time_us, stick.x,         stick.y,         stick.feet_x,
          stick.feet_y,    sample->buttons, sample->sequence};
}

/// @pre is_stick() of both
std::int32_t step(DuelForC& own, const batuta_sample* left, const batuta_sample* right) {
  const InputSample of_left = read(left);
  const InputSample of_right = read(right);
  return batuta::detail::code_of(
      own.bout.step(left != nullptr ? &of_left : nullptr, right != nullptr ? &of_right : nullptr));
}

/// A bout that remembers nothing of another one. @pre valid settings
void begin(batuta_duel* duel, const haptics::BoutSettings& settings) {
  DuelForC& own = *batuta::detail::make_in<DuelForC>(duel);
  own.settings = settings;
  const Status status = own.bout.start(settings);
  BATUTA_ASSERT(status == Status::kOk);
  static_cast<void>(status);
}

void put_blows(const Duel<>& duel, batuta_duel_state& out) {
  for (const auto& event : duel.world().events()) {  // Bound: DuelScene::kMaxEvents
    if (event.kind == EventKind::kEnd) continue;
    ++out.blows;
    out.impulse += event.impulse;
    batuta::detail::put(event.contact.point_W, out.blow_W);
  }
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

void put_side(const haptics::SteppedBout& bout, Side side, batuta_duel_state& out) {
  const Duel<>& duel = bout.duel();
  const std::size_t i = index_of(side);
  const Vec2<float>& stick = duel.stick(side).position();
  const Vec2<float>& share = bout.forces().of(side).share;
  for (int axis = 0; axis < 2; ++axis) {  // Bound: 2
    out.stick[i][axis] = stick[axis];
    out.force[i][axis] = share[axis];
  }
  out.score[i] = duel.bout().score[i];
  out.control[i] = duel.grip(side).control();
  out.place[i] = duel.X_WF(side).p_W.x();
  out.feet[i] = duel.stick(side).feet().y();
  batuta::detail::put(duel.blade_W(side), out.blade_W[i]);
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
  batuta::haptics::BoutSettings settings;
  settings.step_us = step_us;
  settings.touches = touches;
  batuta::fencing::begin(duel, settings);
  return BATUTA_OK;
}

std::int32_t batuta_duel_set_distance(batuta_duel* duel, float distance) {
  auto* const own = batuta::fencing::bout_in(duel);
  if (own == nullptr) return BATUTA_INVALID_ARGUMENT;
  const bool begins = own->bout.steps() == 0 && !own->is_played;
  if (!begins || !batuta::rounds_each_operation<float>()) return BATUTA_UNAVAILABLE;
  batuta::haptics::BoutSettings settings = own->settings;
  settings.distance = distance;
  const batuta::Status status = own->bout.start(settings);
  if (status == batuta::Status::kOk) batuta::fencing::begin(duel, settings);
  return batuta::detail::code_of(status);
}

std::int32_t batuta_duel_step(batuta_duel* duel, const batuta_stick* left,
                              const batuta_stick* right) {
  using namespace batuta::fencing;
  const auto* const own = bout_in(duel);
  if (own == nullptr) return BATUTA_INVALID_ARGUMENT;
  const batuta_sample of_left = sample_of(left, Side::kLeft, *own);
  const batuta_sample of_right = sample_of(right, Side::kRight, *own);
  return batuta_duel_step_sampled(duel, left != nullptr ? &of_left : nullptr,
                                  right != nullptr ? &of_right : nullptr);
}

std::int32_t batuta_duel_step_sampled(batuta_duel* duel, const batuta_sample* left,
                                      const batuta_sample* right) {
  using namespace batuta::fencing;
  auto* const own = bout_in(duel);
  const bool good = own != nullptr && is_stick(stick_of(left)) && is_stick(stick_of(right));
  return good ? step(*own, left, right) : BATUTA_INVALID_ARGUMENT;
}

std::int32_t batuta_duel_get_state(const batuta_duel* duel, batuta_duel_state* out) {
  const auto* const own = batuta::fencing::bout_in(duel);
  if (own == nullptr || out == nullptr) return BATUTA_INVALID_ARGUMENT;
  const batuta::fencing::Duel<>& shown = own->bout.duel();
  *out = batuta_duel_state{};
  out->steps = shown.steps();
  batuta::fencing::put_bout(shown, *out);
  batuta::fencing::put_blows(shown, *out);
  for (const auto side : batuta::fencing::kBothSides) {  // Bound: 2
    batuta::fencing::put_side(own->bout, side, *out);
  }
  out->gap = batuta::capsule_gap(shown.blade_W(batuta::fencing::Side::kLeft),
                                 shown.blade_W(batuta::fencing::Side::kRight))
                 .gap;
  return BATUTA_OK;
}

std::int32_t batuta_duel_hash(const batuta_duel* duel, std::uint64_t* out) {
  const auto* const own = batuta::fencing::bout_in(duel);
  if (own == nullptr || out == nullptr) return BATUTA_INVALID_ARGUMENT;
  *out = batuta::hash_of(own->bout.duel());
  return BATUTA_OK;
}
