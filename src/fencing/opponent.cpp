// SPDX-License-Identifier: MIT
#include "batuta/fencing/opponent.hpp"

#include <algorithm>

#include "opponent_sight.hpp"
#include "opponent_styles.hpp"

// Numbers of the policy: opponent.md says what each was chosen for.

namespace batuta::fencing {
namespace {

using detail::across;
using detail::at;
using detail::is_attack;
using detail::kStyles;
using detail::Line;
using detail::line_of;
using detail::Style;
using detail::style_of;
using Vec2f = Vec2<float>;

constexpr float kMeasureSlack = 0.08F;  ///< m around the measure in which no step is made
constexpr float kLungeRange = 2.30F;    ///< m between trunks that a lunge bridges without the feet
constexpr float kStepLunge = 2.65F;     ///< m that it bridges when they go along
constexpr float kRiposteRange = 2.9F;   ///< m that a riposte bridges: who has attacked is near
constexpr int kOpenLooks = 30;          ///< after an attack in which it is open
constexpr float kFollow = 0.4F;         ///< m more of range then
constexpr float kDrawn = 0.25F;         ///< of the stick, forward: more, and the arm is out
constexpr float kEagerness = 2.0F;      ///< order to the feet for each m that the measure is off
constexpr float kDangerAhead = 1.15F;   ///< m: a point further off is not answered
constexpr float kWalksIn = 0.6F;        ///< m/s: above, somebody walks in
constexpr float kGoesBack = -0.6F;      ///< m/s of the feet: below, somebody gives ground
constexpr int kYieldLooks = 20;         ///< at an attack for which he does: he will again
constexpr int kMostYieldLooks = 40;     ///< so long does he keep that name
constexpr float kHeldOut = 0.6F;        ///< m before its trunk: further, an arm is out
constexpr float kComes = 0.1F;          ///< m/s: slower, an arm stands
constexpr int kHeldLooks = 12;          ///< for which an arm stands that is held out
constexpr float kTakeRange = 3.4F;      ///< m between trunks from which a blade is taken
constexpr float kTaken = 2.2F;          ///< m at which who has taken it thrusts
constexpr float kHighThrust = 0.6F;     ///< of the way of a lunge, high inside, and
constexpr float kLowThrust = 0.75F;     ///< low inside: no further, the point is there still
constexpr float kAlongBlade = 0.75F;    ///< m/s of the feet meanwhile: slower than a point touches
constexpr float kRushes = 1.0F;         ///< m/s of the feet: faster, somebody may rush in
constexpr int kRushLooks = 16;          ///< for which they are faster than slower: he does
constexpr int kMostRushLooks = 20;      ///< blades that meet hide it for a few looks
constexpr float kMeet = 2.8F;           ///< m between upright trunks within which he is met
constexpr float kLead = 2.4F;           ///< m between them that is kept until then
constexpr float kFarOff = 1.0F;         ///< m that it is off beyond which he is awaited
constexpr float kLeadGain = 3.0F;       ///< m/s of the feet for each m that it is off
constexpr int kMeetLine = 1;            ///< low inside
constexpr int kLongestRhythm = 40;      ///< looks between two lunges, after which there is none
constexpr int kArrival = 20;            ///< looks from what is seen to the end of a lunge
constexpr float kBackOnGuard = 0.82F;   ///< of the rhythm, since a lunge was plain: from then on
                                        ///< until the next is plain, who lunges cannot touch

// Times of the moves, us.
constexpr std::int32_t kStepTime = 60000;
constexpr std::int32_t kWaitTime = 60000;
constexpr std::int32_t kParryTime = 100000;
constexpr std::int32_t kHoldTime = 80000;
constexpr std::int32_t kBeatTime = 90000;
constexpr std::int32_t kRecoveryTime = 250000;
constexpr std::int32_t kApartTime = 500000;  ///< of a halt, so that no body walks onto a blade

/// The order to the feet for a speed forward, m/s.
float feet_order(float forward) {
  constexpr FeetSettings<float> kFeet;
  const float most = forward > 0 ? kFeet.forward_speed : kFeet.backward_speed;
  return std::clamp(forward / most, -1.0F, 1.0F);
}

/// 0 ... 1 with no slope at either end. Its steepest slope is 1.5.
float eased(float share) {
  return share * share * (3.0F - 2.0F * share);
}
constexpr float kSteepest = 1.5F;

bool is_seen(const FencerSeen& seen) {
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
  } else if (is_seen(now.own) && is_seen(now.rival)) {
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
  then(kRecoveryTime, {at(0, 0), -1});
  then(kApartTime, {at(0, 0), -1});
}

/// Nothing is under way that has to be gone through with: who recovers from an attack can defend.
bool Opponent::is_free() const {
  if (move_ >= moves_.size() || intent_ == Intent::kWait || intent_ == Intent::kStep) return true;
  return is_attack(intent_) && move_ == moves_.size() - 1;
}

void Opponent::decide() {
  const detail::Situation now = detail::situation_of(eye_);
  const Style& style = style_of(skill_);
  const bool comes = now.reach > style.alarm_reach && now.thrust > kComes;
  look_at_rush(now, comes);
  look_on(now, comes);
  if (!is_free()) return;
  const bool over = move_ >= moves_.size();
  if (style.meets && is_rushed()) {
    const bool is_idle = over || intent_ == Intent::kWait || intent_ == Intent::kStep;
    if (is_idle && place_.blade.y() < kDrawn) meet(now);
  } else if (comes && now.ahead < kDangerAhead) {
    defend(now);
  } else {
    choose(now, over);
  }
}

/// Whether the rival's feet come and come, and how often he lunges meanwhile.
void Opponent::look_at_rush(const detail::Situation& now, bool comes) {
  rushed_ = std::clamp(rushed_ + (now.gait > kRushes ? 1 : -1), 0, kMostRushLooks);
  since_ = std::min(since_ + 1, detail::kQuietLooks);
  if (!comes || threatened_) return;
  rhythm_ = since_ < kLongestRhythm ? since_ : 0;
  since_ = 0;
}

/// A point that is held out and carried in is none: see take().
bool Opponent::is_rushed() const {
  return rushed_ >= kRushLooks && held_ < kHeldLooks;
}

/// At the end of an attack its line is plain, and whoever made it is open.
void Opponent::look_on(const detail::Situation& now, bool comes) {
  if (opening_ > 0) --opening_;
  if (is_attack(intent_)) {
    yields_ = std::clamp(yields_ + (now.gait < kGoesBack ? 1 : -1), 0, kMostYieldLooks);
  }
  const bool stands = now.reach > kHeldOut && now.thrust < kComes && now.thrust > -kComes;
  held_ = stands ? std::min(held_ + 1, kHeldLooks) : 0;
  if (threatened_ && !comes) {
    std::uint16_t& habit = habits_[static_cast<std::size_t>(came_)];
    if (habit < UINT16_MAX) ++habit;
    opening_ = kOpenLooks;
  }
  threatened_ = comes;
  came_ = now.line;
}

void Opponent::defend(const detail::Situation& now) {
  const Style& style = style_of(skill_);
  if (!chance(style.defends)) return;
  const float way = drawn();
  if (way < style.retreats) {
    begin(Intent::kRetreat);
    then(kParryTime, {at(0, -1), -1});
    then(kHoldTime, {at(0, -1), -1});
    then(kParryTime, {at(0, 0), 0});
  } else if (way < style.retreats + style.counters && place_.blade.y() < kDrawn) {
    attack(now, across(now.line), Intent::kCounter);
  } else {
    parry(line_to_close(now.line));
  }
}

/// Somebody who rushes in: leads him back, and lunges so that the point is there when he is back on
/// guard between two lunges, or at once if he makes none.
void Opponent::meet(const detail::Situation& now) {
  if (!is_time_to_meet() || now.upright > kMeet) {
    begin(Intent::kStep);
    const float off = now.upright - kLead;
    const float forward = off < kFarOff ? kLeadGain * off - now.gait : 0.0F;
    then(DelayedObservation::kLookUs, {at(0, 0), feet_order(forward)});
  } else {
    begin(Intent::kCounter);
    then(style_of(skill_).lunge_us, near({line_of(kMeetLine).lunge, 0}));
    then(kRecoveryTime, {at(0, 0), -1});
  }
}

bool Opponent::is_time_to_meet() const {
  if (rhythm_ == 0) return since_ >= kLongestRhythm;
  const int arrives = (std::min(since_, kLongestRhythm) + kArrival) % rhythm_;
  return static_cast<float>(arrives) > kBackOnGuard * static_cast<float>(rhythm_);
}

void Opponent::parry(int line) {
  const Vec2f place = line_of(line).parry;
  begin(Intent::kParry);
  then(kParryTime, near({place, 0}));
  then(kHoldTime, {place, 0});
}

/// The line that a defender believes in.
int Opponent::line_to_close(int seen) {
  const Style& style = style_of(skill_);
  if (chance(style.reads)) return seen;
  return chance(style.learns) ? usual_line() : guessed_line();
}

/// In which most attacks came.
int Opponent::usual_line() const {
  std::size_t most = 0;
  for (std::size_t i = 1; i < kLines; ++i) {  // Bound: kLines
    if (habits_[i] > habits_[most]) most = i;
  }
  return static_cast<int>(most);
}

int Opponent::guessed_line() {
  return static_cast<int>(drawn() * static_cast<float>(kLines));
}

void Opponent::choose(const detail::Situation& now, bool over) {
  if (may_take(now)) {
    if (over || intent_ == Intent::kWait) take(now);
  } else if (place_.blade.y() > kDrawn) {  // an arm that is out cannot thrust
    if (over) keep_measure(now);
  } else {
    choose_attack(now, over);
  }
}

void Opponent::choose_attack(const detail::Situation& now, bool over) {
  const Style& style = style_of(skill_);
  const bool is_open = opening_ > 0;
  const float eager = since_ < detail::kQuietLooks ? style.attacks : style.hurries;
  const bool in_range = now.upright < style.range + (is_open ? kFollow : 0.0F);
  const bool walks_in = now.gait > kWalksIn && is_near(now);
  if (over && intent_ == Intent::kParry && now.upright < kRiposteRange && chance(style.ripostes)) {
    attack(now, line_of(line_to_close(now.line)).riposte, Intent::kRiposte);
  } else if (walks_in && chance(style.stops)) {
    attack(now, line_to_attack(), Intent::kCounter);
  } else if (presses_ || (in_range && chance(is_open ? style.pursues : eager))) {
    press(now);
  } else if (over) {
    keep_measure(now);
  }
}

/// A point that is held out in line: who is not in another action goes for the blade.
bool Opponent::may_take(const detail::Situation& now) {
  return held_ == kHeldLooks && now.distance < kTakeRange && place_.blade.y() < kDrawn &&
         chance(style_of(skill_).takes);
}

/// Along a blade that is held out: in sixte, slower than a point has to come, and then inside of
/// it.
void Opponent::take(const detail::Situation& now) {
  // As much slower as the rival walks in: what counts is how fast the two come together.
  const float feet = feet_order(kAlongBlade - std::max(now.gait, 0.0F));
  if (now.soon < kTaken) {
    begin(Intent::kAttack);
    const Vec2f place =
        chance(0.5F) ? kHighThrust * line_of(0).lunge : kLowThrust * line_of(1).lunge;
    then(style_of(skill_).lunge_us, near({place, feet}));
    then(kRecoveryTime, {at(0, 0), -1});
  } else {
    begin(Intent::kStep);
    then(kParryTime, near({line_of(3).parry, feet}));
  }
}

/// Whether a lunge would arrive, when it does, where the feet of both will be: who leans in his own
/// lunge is back by then.
bool Opponent::is_near(const detail::Situation& now) const {
  return now.upright - style_of(skill_).foresight * now.closing < kStepLunge;
}

/// Attacks where it is near enough; else it walks in, and looks on: what comes there is answered.
void Opponent::press(const detail::Situation& now) {
  const bool may_beat = chance(style_of(skill_).beats);
  if (is_near(now)) {
    attack(now, line_to_attack(), may_beat ? Intent::kBeat : Intent::kAttack);
  } else if (move_ >= moves_.size() || !presses_) {
    begin(Intent::kStep);
    then(kStepTime, near({at(0, 0), 1}));
    presses_ = true;
  }
}

/// With the feet, if it is off by more than the slack.
void Opponent::keep_measure(const detail::Situation& now) {
  const float off = now.soon - style_of(skill_).measure;
  if (off > kMeasureSlack || off < -kMeasureSlack) {
    begin(Intent::kStep);
    then(kStepTime, near({at(0, 0), off > 0 ? std::min(kEagerness * off, 1.0F) : -1.0F}));
  } else {
    begin(Intent::kWait);
    then(kWaitTime, near({at(0, 0), 0}));
  }
}

/// High outside, the arm would run onto the point of who stays on guard: who knows, goes elsewhere.
int Opponent::line_to_attack() {
  const int line = guessed_line();
  return line == 3 && chance(style_of(skill_).reads) ? guessed_line() : line;
}

void Opponent::attack(const detail::Situation& now, int index, Intent intent) {
  const Style& style = style_of(skill_);
  const Line line = line_of(index);
  // The feet bring it into reach, and no further: who runs on runs onto the other's point.
  const float feet = now.upright > kLungeRange ? 1.0F : 0.0F;
  // No time for an extension where the rival is open, or walks in.
  const bool is_urgent = opening_ > 0 || now.gait > kWalksIn;
  begin(intent);
  if (intent == Intent::kBeat) then(kBeatTime, {at(0, 0.5F), feet});
  if (intent == Intent::kAttack && !is_urgent) {
    const int shown = chance(style.feints) ? guessed_line() : index;
    then(style.extension_us, near({line_of(shown).extension, feet}));
  }
  then(style.lunge_us, near({line.lunge, feet}));
  // Who gives ground gets none back.
  then(kRecoveryTime, {at(0, 0), yields_ >= kYieldLooks ? 0.0F : -1.0F});
}

void Opponent::begin(Intent intent) {
  intent_ = intent;
  presses_ = false;
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
  const float most = kHandSpeed * static_cast<float>(step_us) * 1e-6F;  // as the blade's hand
  place_.feet += std::clamp(move_blade(step_us) - place_.feet, -most, most);
}

/// @returns what the feet are asked meanwhile
float Opponent::move_blade(std::int32_t step_us) {
  spent_us_ += step_us;
  for (; move_ < moves_.size(); ++move_) {  // Bound: kMaxMoves
    const StickMove& move = moves_[move_];
    if (spent_us_ < move.duration_us) {
      const float share = static_cast<float>(spent_us_) / static_cast<float>(move.duration_us);
      place_.blade = from_.blade + eased(share) * (move.to.blade - from_.blade);
      return move.to.feet;
    }
    spent_us_ -= move.duration_us;
    from_ = move.to;
    place_.blade = move.to.blade;
  }
  spent_us_ = 0;
  return 0;
}

}  // namespace batuta::fencing
