// SPDX-License-Identifier: MIT
#include "trial.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace fight {
namespace {

using namespace batuta;
using namespace batuta::fencing;

constexpr std::int32_t kStepUs = 1000;
constexpr double kStepSeconds = 0.001;
constexpr std::array<Side, 2> kSides = {Side::kLeft, Side::kRight};

Role role_of(const Plan& plan, Side side) {
  return (side == Side::kLeft) == plan.swapped ? kDefender : kAttacker;
}

/// The last of a blade, radius and all.
Capsule<float> point_of(const Capsule<float>& blade) {
  const Vec3<float> along = (blade.axis.b - blade.axis.a).normalized();
  return {{blade.axis.b - kPointLength * along, blade.axis.b}, blade.radius};
}

double depth(const Capsule<float>& a, const Capsule<float>& b) {
  return std::max(-static_cast<double>(capsule_gap(a, b).gap), 0.0);
}

}  // namespace

Plan plan_of(Jitter& jitter) {
  Plan plan;
  plan.distance = jitter.distance(kGuardDistance);
  plan.swapped = jitter.coin();
  for (Script& script : plan.scripts) script = on_guard(jitter);
  return plan;
}

bool Outcome::scores_first(Role role) const {
  const double mine = by[role].touched;
  const double his = by[1 - role].touched;
  return mine >= 0 && (his < 0 || mine <= his);
}

Arena::Arena(const Pair& fencers) : fencers_(fencers), duel_(std::make_unique<Duel<>>()) {}

Outcome Arena::play(const Plan& plan) {
  begin(plan);
  Outcome outcome;
  const auto steps = static_cast<std::uint32_t>(plan.length / kStepSeconds);
  while (duel_->steps() < steps && !duel_->bout().is_over()) {
    std::array<InputSample, 2> samples;
    std::array<float, 2> control{};
    for (const Side side : kSides) {
      const std::size_t i = index_of(side);
      samples[i] = plan.scripts[role_of(plan, side)].sample(duel_->steps());
      control[i] = duel_->grip(side).control();
    }
    const int touches = duel_->bout().touches.size();
    if (duel_->step(&samples[0], &samples[1]) != Status::kOk) break;
    note_touches(plan, touches, control, outcome);
    look(plan, outcome);
  }
  outcome.incomplete = duel_->report().incomplete_steps;
  return outcome;
}

void Arena::begin(const Plan& plan) {
  DuelSettings<> settings = duel_settings();
  settings.step_us = kStepUs;
  settings.salle.distance = static_cast<float>(plan.distance);
  const auto& left = fencers_[role_of(plan, Side::kLeft)];
  const auto& right = fencers_[role_of(plan, Side::kRight)];
  if (duel_->configure(settings, left, right) == Status::kOk) return;
  std::fprintf(stderr, "batuta-fight: the duel refuses the keys\n");
  std::exit(2);
}

/// @param control  of both hands before the step
void Arena::note_touches(const Plan& plan, int before, const std::array<float, 2>& control,
                         Outcome& outcome) const {
  for (int i = before; i < duel_->bout().touches.size(); ++i) {
    const auto& touch = duel_->bout().touches[i];
    Deeds& deeds = outcome.by[role_of(plan, touch.by)];
    deeds.touched = touch.when.step * kStepSeconds + static_cast<double>(touch.when.in_step);
    const float held = std::max(control[index_of(touch.by)], duel_->grip(touch.by).control());
    deeds.out_of_control = held < kLeastControl;
  }
}

void Arena::look(const Plan& plan, Outcome& outcome) const {
  const double time = duel_->steps() * kStepSeconds;
  for (const Side side : kSides) {
    Deeds& deeds = outcome.by[role_of(plan, side)];
    if (deeds.entered < 0 && is_point_inside(side)) deeds.entered = time;
    outcome.deepest = std::max(outcome.deepest, depth_in_weapon(plan, side));
  }
  if (time >= plan.blow_until) return;
  for (const auto& event : duel_->world().events()) {
    outcome.beat = std::max(outcome.beat, static_cast<double>(event.impulse));
  }
}

/// Of what a touch counts on.
bool Arena::is_point_inside(Side side) const {
  const Capsule<float> point = point_of(duel_->blade_W(side));
  const BodyShape<float>& body = duel_->body_W(other(side));
  for (std::size_t i = 0; i < body.size(); ++i) {
    if (static_cast<BodyPart>(i) == BodyPart::kWeaponHand) continue;
    if (depth(point, body[i]) > 0) return true;
  }
  return false;
}

/// How deep this side's blade is in the other's guard or hand.
double Arena::depth_in_weapon(const Plan& plan, Side side) const {
  const WeaponBody<float>& weapon = fencers_[role_of(plan, other(side))].weapon;
  const Pose<float> X_WB = chained(duel_->held_hand_W(other(side)), weapon.X_HB);
  const Capsule<float> blade = duel_->blade_W(side);
  return std::max(depth(blade, to_world(X_WB, weapon.guard_B)),
                  depth(blade, to_world(X_WB, weapon.hand_B)));
}

}  // namespace fight
