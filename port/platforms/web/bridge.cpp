// SPDX-License-Identifier: MIT
// Between the C API (batuta/c/duel.h) and the page: one bout that is fenced now, one that a
// recording gives back, and the numbers that a page shows of them. All of it is in static memory,
// and from one context: the page's worker, which calls these functions (page/bridge.js).

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "batuta/c/duel.h"
#include "programs/devices/script_device.hpp"

namespace batuta::web {
namespace {

constexpr std::int32_t kStepUs = 1000;
constexpr float kSeen = 4;          // m on guard, where a fencer sees
constexpr std::uint32_t kSeed = 1;  // of such a one
/// Who may hold a stick, by the numbers of the page: scripts that see nothing, and then fencers
/// that see, by their skill.
constexpr std::array<const char*, 3> kScripts = {"guard", "parry", "attack"};
constexpr std::array<std::int32_t, 3> kSkills = {BATUTA_NOVICE, BATUTA_CLUB, BATUTA_MASTER};
constexpr std::uint32_t kHashEvery =
    1;                           // as batuta-duel: a replay names the step in which it parts
constexpr int kTaken = 1 << 16;  // bytes between two calls of web_forget()
constexpr int kRoom = 1 << 16;   // bytes of a recording that are fed at a time

/// A capsule: both ends of its axis, and its radius.
using Numbers = std::array<float, BATUTA_CAPSULE_NUMBERS>;
using Point = std::array<float, 3>;

struct WebTouch {
  float by = 0;    ///< 0 left, 1 right
  float part = 0;  ///< fencing::BodyPart
  float time = 0;  ///< s since the start of the bout
  Point point_W{};
};

struct WebSide {
  float score = 0;  ///< touches that count, of the exchanges that are over
  float place = 0;  ///< where the feet are along the strip, m
  float feet = 0;   ///< their order: -1 back ... 1 forward
  std::array<float, 2> stick{};
  std::array<float, 2> force{};  ///< share of the device's range, 0 where it is silent
  float control = 0;             ///< of the grip: 0 free ... 1 held
  Numbers blade_W{};
  std::array<Numbers, BATUTA_BODY_PARTS> body_W{};
};

/// What the page sees after a step: floats alone, in the order that page/layout.js repeats. SI
/// units.
struct WebState {
  float steps = 0;
  float bout = 0;  ///< as batuta_duel_state
  float exchange = 0;
  float annulled = 0;  ///< 1: the touches of this exchange do not count
  float touches = 0;   ///< of this exchange
  std::array<WebTouch, 2> touch{};
  float gap = 0;       ///< of the blades, m
  float impulse = 0;   ///< of all blows of the step, N s
  float has_blow = 0;  ///< 1: the blades met in this step
  Point blow_W{};      ///< where
  std::array<WebSide, 2> sides{};
};

Point point_of(const float* numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

Numbers capsule_of(const float* numbers) {
  Numbers capsule;
  std::copy_n(numbers, capsule.size(), capsule.begin());
  return capsule;
}

WebTouch told(const batuta_touch& touch) {
  WebTouch told;
  told.by = static_cast<float>(touch.by);
  told.part = static_cast<float>(touch.part);
  told.time = 1e-6F * static_cast<float>(touch.time_us);
  told.point_W = point_of(touch.point_W);
  return told;
}

WebSide told(const batuta_duel_state& duel, std::size_t side) {
  WebSide told;
  told.score = static_cast<float>(duel.score[side]);
  told.place = duel.place[side];
  told.feet = duel.feet[side];
  told.stick = {duel.stick[side][0], duel.stick[side][1]};
  told.force = {duel.force[side][0], duel.force[side][1]};
  told.control = duel.control[side];
  told.blade_W = capsule_of(duel.blade_W[side]);
  for (std::size_t i = 0; i < told.body_W.size(); ++i) {  // Bound: BATUTA_BODY_PARTS
    told.body_W[i] = capsule_of(duel.body_W[side][i]);
  }
  return told;
}

WebState told(const batuta_duel_state& duel) {
  WebState web;
  web.steps = static_cast<float>(duel.steps);
  web.bout = static_cast<float>(duel.bout);
  web.exchange = static_cast<float>(duel.exchange);
  web.annulled = static_cast<float>(duel.annulled);
  web.touches = static_cast<float>(duel.touches);
  web.gap = duel.gap;
  web.impulse = duel.impulse;
  web.has_blow = duel.blows > 0 ? 1.0F : 0.0F;
  web.blow_W = point_of(duel.blow_W);
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: 2
    if (static_cast<std::int32_t>(i) < duel.touches) web.touch[i] = told(duel.touch[i]);
    web.sides[i] = told(duel, i);
  }
  return web;
}

/// Who holds a stick: a script, a fencer that sees, or else whoever calls.
struct Stick {
  std::optional<host::ScriptDevice> script;
  std::int32_t skill = -1;  ///< none
  batuta_opponent fencer;
  std::uint32_t looks = 0;  ///< of the fencer
  std::array<float, 2> feet{};
  batuta_sample sample{};
  bool fresh = false;

  bool sees() const { return skill >= 0; }
};

/// A bout that is fenced now.
struct Live {
  batuta_duel duel;
  std::uint32_t steps = 0;
  std::array<Stick, 2> sticks;
  batuta_recorder recorder;
  bool records = false;
  std::array<std::uint8_t, kTaken> bytes{};  // recorded, and not yet fetched
  std::size_t taken = 0;
};

/// A bout that was.
struct Past {
  batuta_duel duel;
  batuta_player player;
  bool is_made = false;
  std::array<std::uint8_t, kRoom> room{};
};

Live live;
Past past;
bool is_past = false;  // which of the two is shown
WebState state;

const batuta_duel& shown() {
  return is_past ? past.duel : live.duel;
}

void show() {
  batuta_duel_state duel;
  if (batuta_duel_get_state(&shown(), &duel) == BATUTA_OK) state = told(duel);
}

batuta_sample told(const InputSample& sample) {
  return {{sample.x, sample.y, sample.feet_x, sample.feet_y},
          static_cast<std::uint32_t>(sample.time),
          sample.buttons,
          sample.sequence};
}

/// The stick of a side for the step that comes, or null.
const batuta_sample* read(int side) {
  Stick& stick = live.sticks[static_cast<std::size_t>(side)];
  const std::uint32_t now_us = live.steps * static_cast<std::uint32_t>(kStepUs);
  if (stick.sees()) {
    (void)batuta_opponent_look(&stick.fencer, &live.duel, side, &stick.sample.stick);
    stick.sample.time_us = now_us;
    stick.sample.buttons = 0;
    stick.sample.sequence = stick.looks++;
    return &stick.sample;
  }
  if (!stick.script) return std::exchange(stick.fresh, false) ? &stick.sample : nullptr;
  InputSample sample;
  if (stick.script->read(now_us, sample) != Status::kOk) return nullptr;
  stick.sample = told(sample);
  return &stick.sample;
}

Stick& stick_of(int side) {
  return live.sticks[side == BATUTA_LEFT ? 0 : 1];
}

void take_recorded() {
  if (!live.records) return;
  live.taken += batuta_recorder_take(&live.recorder, live.bytes.data() + live.taken,
                                     live.bytes.size() - live.taken);
}

/// Who holds it begins anew.
void begin(Stick& stick) {
  if (stick.script) stick.script->rewind();
  if (stick.sees()) {
    (void)batuta_opponent_init(&stick.fencer, sizeof stick.fencer, stick.skill, kSeed);
  }
  stick.looks = 0;
}

void begin_recording() {
  live.taken = 0;
  if (!live.records) return;
  (void)batuta_recorder_init(&live.recorder, sizeof live.recorder, &live.duel, kHashEvery);
  take_recorded();
}

bool is_axis(float value) {
  return value >= -1 && value <= 1;
}

/// @param function  batuta_player_begin() or batuta_player_next()  @returns a Playback
template <class Function>
std::int32_t play(Function* function) {
  std::int32_t playback = BATUTA_PLAYBACK_FOREIGN;  // of a player that was not begun
  (void)function(&past.player, &past.duel, &playback);
  if (playback == BATUTA_PLAYBACK_READY || playback == BATUTA_PLAYBACK_STEP) {
    is_past = true;
    show();
  }
  return playback;
}

}  // namespace

extern "C" {

/// Begins a bout of the library's two fencers. @param touches  to which it goes, 1 ... 99
/// @param record  0: what happens is not recorded. @returns a status; where not BATUTA_OK, the last
/// bout goes on
int web_start(int touches, int record) {
  const int status = batuta_duel_init(&live.duel, sizeof live.duel, kStepUs, touches);
  if (status != BATUTA_OK) return status;
  if (live.sticks[0].sees() || live.sticks[1].sees()) {
    (void)batuta_duel_set_distance(&live.duel, kSeen);
  }
  is_past = false;
  live.steps = 0;
  live.records = record != 0;
  for (Stick& stick : live.sticks) {  // Bound: 2
    begin(stick);
    stick.fresh = false;
  }
  begin_recording();
  show();
  return status;
}

/// Who moves a stick: kScripts and then kSkills by their number, anything else is a hand.
void web_choose(int side, int who) {
  Stick& stick = stick_of(side);
  const auto number = static_cast<std::size_t>(who);
  stick.script.reset();
  stick.skill = -1;
  if (number < kScripts.size()) {
    if (const auto named = host::script_named(kScripts[number])) stick.script.emplace(*named);
  } else if (number < kScripts.size() + kSkills.size()) {
    stick.skill = kSkills[number - kScripts.size()];
  }
  begin(stick);
}

/// Where a device's second pair of axes stands, from the next web_sample() on.
void web_feet(int side, float x, float y) {
  stick_of(side).feet = {x, y};
}

/// A hand's sample for the next step, as its device tells it; its feet are those of web_feet(). One
/// that is out of range is none.
void web_sample(int side, std::uint32_t time_us, float x, float y, std::uint32_t buttons,
                std::uint32_t sequence) {
  Stick& stick = stick_of(side);
  const auto [feet_x, feet_y] = stick.feet;
  stick.sample = {{x, y, feet_x, feet_y}, time_us, buttons, sequence};
  stick.fresh = is_axis(x) && is_axis(y) && is_axis(feet_x) && is_axis(feet_y);
}

/// One step of 1 ms. @returns a status
int web_step() {
  is_past = false;
  const batuta_sample* const left = read(BATUTA_LEFT);
  const batuta_sample* const right = read(BATUTA_RIGHT);
  const int status = batuta_duel_step_sampled(&live.duel, left, right);
  if (status != BATUTA_OK) return status;
  ++live.steps;
  if (live.records) (void)batuta_recorder_step(&live.recorder, &live.duel);
  take_recorded();
  show();
  return status;
}

/// The end mark of the recording. @returns a status
int web_end() {
  if (!live.records) return BATUTA_UNAVAILABLE;
  const int status = batuta_recorder_end(&live.recorder, &live.duel);
  take_recorded();
  return status;
}

/// WebState, and how many floats it is.
const float* web_state() {
  return &state.steps;
}
int web_state_size() {
  return static_cast<int>(sizeof state / sizeof(float));
}

/// Of the duel that is shown.
std::uint64_t web_hash() {
  std::uint64_t hash = 0;
  (void)batuta_duel_hash(&shown(), &hash);
  return hash;
}

/// What was recorded since the last web_forget(), and how many bytes: at most 64 KB are kept.
const std::uint8_t* web_recorded() {
  return live.bytes.data();
}
int web_recorded_size() {
  return static_cast<int>(live.taken);
}
void web_forget() {
  live.taken = 0;
  take_recorded();
}

/// Where up to 64 KB of a recording go before web_play() and web_feed().
std::uint8_t* web_room() {
  return past.room.data();
}

/// Goes on with the `count` bytes in the room. @param is_all  0: there are more
/// @pre the player is waiting: what it has not read is gone
void web_feed(int count, int is_all) {
  const auto size = static_cast<std::size_t>(std::clamp(count, 0, kRoom));
  (void)batuta_player_give(&past.player, past.room.data(), size, is_all);
}

/// Begins with them. @returns a Playback; the first 64 KB hold the start of any recording of this
/// duel
int web_play(int count, int is_all) {
  // What is no recording leaves the one that is shown.
  if (!past.is_made) (void)batuta_duel_init(&past.duel, sizeof past.duel, kStepUs, 1);
  past.is_made = true;
  (void)batuta_player_init(&past.player, sizeof past.player);
  web_feed(count, is_all);
  return play(batuta_player_begin);
}

/// Bytes of the room that the player has not asked for; behind an end mark there should be none.
int web_unread() {
  return static_cast<int>(batuta_player_unread(&past.player));
}

/// The recording's next step. @returns a Playback
int web_next() {
  return play(batuta_player_next);
}

/// Hashes that agreed so far.
std::uint32_t web_agreed() {
  return batuta_player_agreed(&past.player);
}

}  // extern "C"

}  // namespace batuta::web
