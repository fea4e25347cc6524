// SPDX-License-Identifier: MIT
#include "batuta/fencing/opponent.hpp"

#include <algorithm>

// Numbers of the policy: opponent.md says what each was chosen for.

namespace batuta::fencing {

/// What two late looks come to.
struct detail::Situation {
  float distance = 0;  ///< between the trunks, m
  float closing = 0;   ///< speed of the rival's guard towards oneself, as seen, m/s
  float ahead = 0;     ///< from one's trunk to the rival's point, m
  int line = 0;        ///< in which the rival's blade comes, or would come
};

namespace {

using Vec2f = Vec2<float>;

/// A line: where the stick lunges into it, how it extends there before, and what closes it.
struct Line {
  Vec2f lunge;
  Vec2f extension;
  Vec2f parry;
};

Vec2f at(float x, float y) {
  return {x, y};
}

/// High inside, low inside, low outside, high outside, as the rival's keys have them.
Line line_of(int index) {
  switch (index) {
    case 0:
      return {at(-1, 1), at(-0.5F, 0.5F), at(-1, 0)};
    case 1:
      return {at(-0.5F, 1), at(-0.25F, 0.5F), at(-1, -1)};
    case 2:
      return {at(0.5F, 1), at(0.25F, 0.5F), at(1, -1)};
    default:
      return {at(1, 1), at(0.5F, 0.5F), at(1, 0)};
  }
}

/// What sets the skills apart: probabilities are of one decision.
struct Style {
  std::int32_t hesitation_us;  ///< between a decision and the hand, beyond the eye's delay
  float scatter;               ///< of a stick's place, along each axis
  float alarm_speed;           ///< m/s at which a coming hand is taken for an attack
  float alarm_distance;        ///< m to the point within which it matters
  float measure;               ///< m between the trunks that it keeps
  float defends;               ///< answers an attack at all
  float retreats;              ///< of these, by a step back
  float counters;              ///< of these, by an attack of its own
  float reads;                 ///< sees the line of an attack
  float ripostes;              ///< after a parry
  float attacks;               ///< of the looks in measure
  float beats;                 ///< of its attacks, begun by a beat
  float learns;                ///< goes by the rival's habits where it cannot read a line
};

constexpr std::array<Style, 3> kStyles = {{
    {90000, 0.12F, 1.6F, 0.7F, 2.30F, 0.55F, 0.4F, 0.10F, 0.45F, 0.4F, 0.03F, 0.10F, 0.0F},
    {30000, 0.06F, 1.1F, 0.9F, 2.40F, 0.80F, 0.3F, 0.15F, 0.75F, 0.7F, 0.03F, 0.25F, 0.5F},
    {0, 0.03F, 0.8F, 1.1F, 2.50F, 0.95F, 0.3F, 0.15F, 0.95F, 0.9F, 0.03F, 0.35F, 1.0F},
}};

const Style& style_of(Skill skill) {
  return kStyles[static_cast<std::size_t>(skill)];
}

constexpr float kSecondsPerLook = 1e-6F * static_cast<float>(DelayedObservation::kLookUs);
constexpr float kReachSlack = 0.10F;  ///< m around the measure in which no step is made

// Times of the moves, us.
constexpr std::int32_t kStepTime = 150000;
constexpr std::int32_t kWaitTime = 90000;
constexpr std::int32_t kParryTime = 100000;
constexpr std::int32_t kHoldTime = 150000;
constexpr std::int32_t kBeatTime = 90000;
constexpr std::int32_t kExtensionTime = 120000;
constexpr std::int32_t kLungeTime = 250000;
constexpr std::int32_t kRecoveryTime = 250000;

/// The line in which a blade lies, seen from one's own trunk: the rival's inside is where one's own
/// right is.
int line_seen(const Observation& sight) {
  const Vec3<float> offset = sight.rival.point_V - sight.own.torso_V;
  const bool inside = offset.y() < 0;
  const bool high = offset.z() > 0;
  if (inside) return high ? 0 : 1;
  return high ? 3 : 2;
}

/// The line that a blade in this one leaves open.
int across(int line) {
  return static_cast<int>(Opponent::kLines) - 1 - line;
}

detail::Situation situation_of(const DelayedObservation& eye) {
  const Observation& now = eye.seen();
  detail::Situation situation;
  situation.distance = now.rival.torso_V.x() - now.own.torso_V.x();
  situation.closing = (eye.before().rival.guard_V.x() - now.rival.guard_V.x()) / kSecondsPerLook;
  situation.ahead = now.rival.point_V.x() - now.own.torso_V.x();
  situation.line = line_seen(now);
  return situation;
}

/// 0 ... 1 with no slope at either end. Its steepest slope is 1.5.
float eased(float share) {
  return share * share * (3.0F - 2.0F * share);
}
constexpr float kSteepest = 1.5F;

bool is_finite(const FencerSeen& seen) {
  return seen.guard_V.allFinite() && seen.point_V.allFinite() && seen.torso_V.allFinite();
}

}  // namespace

Status Opponent::configure(Skill skill, std::uint32_t seed) {
  if (static_cast<std::size_t>(skill) >= kStyles.size()) return Status::kInvalidArgument;
  *this = {};
  skill_ = skill;
  // Spread over all bits, so that seeds beside each other have nothing in common; never 0.
  draw_ = (seed + 0x9E3779B9U) * 0x85EBCA6BU | 1U;
  return Status::kOk;
}

const StickPlace& Opponent::step(const Observation& now, std::int32_t step_us) {
  if (now.halted) {
    stand_down();
  } else if (is_finite(now.own) && is_finite(now.rival)) {
    if (eye_.look(now, step_us) && eye_.sees()) decide();
  }
  advance(step_us);
  return place_;
}

/// xorshift32 [Marsaglia 2003], the upper 24 bits. @returns [0, 1)
float Opponent::drawn() {
  draw_ ^= draw_ << 13U;
  draw_ ^= draw_ >> 17U;
  draw_ ^= draw_ << 5U;
  constexpr float kUnit = 1.0F / 16777216.0F;
  return static_cast<float>(draw_ >> 8U) * kUnit;
}

/// Back to guard once, blind until the next exchange, in which everybody stands elsewhere.
void Opponent::stand_down() {
  if (!eye_.sees()) return;
  eye_.clear();
  begin(Intent::kWait);
  then(kRecoveryTime, {at(0, 0), 0});
}

void Opponent::decide() {
  const detail::Situation now = situation_of(eye_);
  const Style& style = style_of(skill_);
  const bool attacked = now.closing > style.alarm_speed && now.ahead < style.alarm_distance;
  const bool over = move_ >= moves_.size();
  // Who defends or attacks goes through with it; who waits or walks looks on.
  if (attacked && (over || intent_ == Intent::kWait || intent_ == Intent::kStep)) {
    defend(now);
  } else if (over) {
    choose(now);
  }
}

void Opponent::defend(const detail::Situation& now) {
  const Style& style = style_of(skill_);
  std::uint16_t& habit = habits_[static_cast<std::size_t>(now.line)];
  if (habit < UINT16_MAX) ++habit;
  if (!chance(style.defends)) return;
  const float way = drawn();
  if (way < style.retreats) {
    begin(Intent::kRetreat);
    then(kParryTime, {at(0, -1), -1});
    then(kHoldTime, {at(0, -1), -1});
    then(kRecoveryTime, {at(0, 0), 0});
  } else if (way < style.retreats + style.counters) {
    attack(across(now.line), Intent::kCounter);
  } else {
    const Vec2f parry = line_of(line_to_close(now.line)).parry;
    begin(Intent::kParry);
    then(kParryTime, near({parry, 0}));
    then(kHoldTime, {parry, 0});
  }
}

/// The line that a defender believes in.
int Opponent::line_to_close(int seen) {
  const Style& style = style_of(skill_);
  if (chance(style.reads)) return seen;
  if (!chance(style.learns)) return guessed_line();
  std::size_t most = 0;
  for (std::size_t i = 1; i < kLines; ++i) {  // Bound: kLines
    if (habits_[i] > habits_[most]) most = i;
  }
  return static_cast<int>(most);
}

int Opponent::guessed_line() {
  return static_cast<int>(drawn() * static_cast<float>(kLines));
}

void Opponent::choose(const detail::Situation& now) {
  const Style& style = style_of(skill_);
  if (intent_ == Intent::kParry && chance(style.ripostes)) {
    attack(now.line, Intent::kRiposte);
  } else if (now.distance > style.measure + kReachSlack) {
    begin(Intent::kStep);
    then(kStepTime, near({at(0, 0), 1}));
  } else if (now.distance < style.measure - kReachSlack) {
    begin(Intent::kStep);
    then(kStepTime, near({at(0, 0), -1}));
  } else if (chance(style.attacks)) {
    const int line = chance(style.reads) ? across(now.line) : guessed_line();
    attack(line, chance(style.beats) ? Intent::kBeat : Intent::kAttack);
  } else {
    begin(Intent::kWait);
    then(kWaitTime, near({at(0, 0), 0}));
  }
}

void Opponent::attack(int index, Intent intent) {
  const Line line = line_of(index);
  begin(intent);
  if (intent == Intent::kBeat) then(kBeatTime, {at(0, 0.5F), 1});
  if (intent == Intent::kAttack) then(kExtensionTime, near({line.extension, 1}));
  then(kLungeTime, near({line.lunge, 1}));
  then(kRecoveryTime, {at(0, 0), -1});
}

void Opponent::begin(Intent intent) {
  intent_ = intent;
  moves_.clear();
  move_ = 0;
  spent_us_ = 0;
  from_ = place_;
  const std::int32_t hesitation_us = style_of(skill_).hesitation_us;
  const bool is_sudden = intent != Intent::kWait && intent != Intent::kStep;
  if (is_sudden && hesitation_us > 0) then(hesitation_us, {place_.blade, 0});
}

/// The next move of the action, slowed to what a hand can do.
void Opponent::then(std::int32_t duration_us, const StickPlace& to) {
  const Vec2f& start = moves_.empty() ? place_.blade : moves_[moves_.size() - 1].to.blade;
  const float way = (to.blade - start).norm();
  const auto least_us = static_cast<std::int32_t>(kSteepest * way / kHandSpeed * 1e6F) + 1;
  const bool fits = moves_.push({std::max(duration_us, least_us), to});
  BATUTA_INVARIANT(fits);
}

/// A place as this hand finds it.
StickPlace Opponent::near(StickPlace place) {
  const float scatter = style_of(skill_).scatter;
  for (int axis = 0; axis < 2; ++axis) {  // Bound: 2
    const float missed = scatter * (2.0F * drawn() - 1.0F);
    place.blade[axis] = std::clamp(place.blade[axis] + missed, -1.0F, 1.0F);
  }
  return place;
}

void Opponent::advance(std::int32_t step_us) {
  spent_us_ += step_us;
  for (; move_ < moves_.size(); ++move_) {  // Bound: kMaxMoves
    const StickMove& move = moves_[move_];
    if (spent_us_ < move.duration_us) {
      const float share = static_cast<float>(spent_us_) / static_cast<float>(move.duration_us);
      place_.blade = from_.blade + eased(share) * (move.to.blade - from_.blade);
      place_.feet = move.to.feet;
      return;
    }
    spent_us_ -= move.duration_us;
    from_ = move.to;
    place_ = move.to;
  }
  place_.feet = 0;
  spent_us_ = 0;
}

}  // namespace batuta::fencing
