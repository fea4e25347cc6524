// SPDX-License-Identifier: MIT

#include "shared/firmware/step_messages.hpp"

namespace batuta::firmware {
using namespace fencing;
namespace {

using Scene = DuelType::SceneType;
static_assert(Scene::kMaxEvents + 9 <= link::kMaxStepFrames,
              "two samples, poses, forces and touches, the events and the report");

std::array<float, 3> numbers(const Vec3<float>& v) {
  return {v.x(), v.y(), v.z()};
}

}  // namespace

link::Pose pose_message(const DuelType& duel, Side side) {
  // The world's slots 0 and 1 are the left and the right blade.
  const auto& world = duel.world();
  const auto* blade = world.get(world.id_at(static_cast<std::uint16_t>(index_of(side))));
  BATUTA_ASSERT(blade != nullptr);
  const Pose<float>& X_WB = blade->body.X_WB;
  link::Pose message;
  message.step = duel.steps();
  message.side = link_side(side);
  message.position_W = numbers(X_WB.p_W);
  message.rotation_WB = {X_WB.q_WB.w(), X_WB.q_WB.x(), X_WB.q_WB.y(), X_WB.q_WB.z()};
  return message;
}

link::Event event_message(const DuelType& duel, int index) {
  const ContactEvent<float>& event = duel.world().events()[index];
  link::Event message;
  message.step = duel.steps();
  message.index = static_cast<std::uint8_t>(index);
  message.kind = static_cast<std::uint8_t>(event.kind);
  message.contact_kind = static_cast<std::uint8_t>(event.contact_kind);
  message.body_A = event.body_A;
  message.body_B = event.body_B;
  message.time = event.time;
  message.point_W = numbers(event.contact.point_W);
  message.normal_BA_W = numbers(event.contact.normal_BA_W);
  message.gap = event.contact.gap;
  message.v_rel = event.v_rel;
  message.impulse = event.impulse;
  message.place_A = event.place_A;
  message.place_B = event.place_B;
  return message;
}

link::Touch touch_message(const DuelType& duel, int index) {
  const Touch<float>& touch = duel.bout().touches[index];
  link::Touch message;
  message.step = duel.steps();
  message.index = static_cast<std::uint8_t>(index);
  message.by = link_side(touch.by);
  message.part = static_cast<std::uint8_t>(touch.part);
  message.certain = touch.certain;
  message.when_step = touch.when.step;
  message.when_in_step = touch.when.in_step;
  message.point_W = numbers(touch.contact.point_W);
  message.normal_BA_W = numbers(touch.contact.normal_BA_W);
  message.gap = touch.contact.gap;
  message.place = touch.place;
  return message;
}

link::Force force_message(const haptics::SteppedBout& bout, Side side) {
  const haptics::StickForce& force = bout.forces().of(side);
  link::Force message;
  message.step = bout.steps();
  message.side = link_side(side);
  message.x = force.share.x();
  message.y = force.share.y();
  message.stale = force.silent;
  message.ramped = force.ramped;
  message.limited = force.limited;
  return message;
}

link::StickUsed used_message(const haptics::SteppedBout& bout, Side side) {
  const InputSample* sample = bout.used(side);
  BATUTA_ASSERT(sample != nullptr);
  link::StickUsed message;
  message.step = bout.steps();
  message.side = link_side(side);
  message.sample = *sample;
  return message;
}

link::StepReport report_message(const haptics::SteppedBout& bout) {
  const DuelType& duel = bout.duel();
  link::StepReport message;
  message.step = bout.steps();
  message.bout_state = static_cast<std::uint8_t>(duel.bout().state);
  message.touches = static_cast<std::uint8_t>(duel.bout().touches.size());
  message.score = duel.bout().score;
  message.used_left = bout.used(Side::kLeft) != nullptr;
  message.used_right = bout.used(Side::kRight) != nullptr;
  message.stale_steps = bout.forces().stale_steps();
  message.evaluations = duel.world().report().evaluations;
  message.incomplete_steps = duel.report().incomplete_steps;
  return message;
}

int new_touches(const DuelType& duel) {
  int count = 0;
  for (const auto& touch : duel.bout().touches) {  // Bound: 2
    if (touch.when.step + 1 == duel.steps()) ++count;
  }
  return count;
}

int frames_of(const haptics::SteppedBout& bout, bool samples) {
  int frames = 5;  // poses, forces, report
  frames += bout.duel().world().events().size() + new_touches(bout.duel());
  for (const Side side : {Side::kLeft, Side::kRight}) {  // Bound: 2
    if (samples && bout.used(side) != nullptr) ++frames;
  }
  return frames;
}

}  // namespace batuta::firmware
