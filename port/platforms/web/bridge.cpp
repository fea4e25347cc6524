// SPDX-License-Identifier: MIT
// Between the library and the page: one bout that is fenced now, one that a recording gives back,
// and the numbers that a page shows of them. All of it is in static memory, and from one context:
// the page's worker, which calls these functions (page/bridge.js). A later C API takes its place.

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "batuta/fencing/observation.hpp"
#include "batuta/geometry/capsule.hpp"
#include "batuta/record/duel.hpp"
#include "batuta/record/memory_stream.hpp"
#include "batuta/record/player.hpp"
#include "batuta/record/recorder.hpp"
#include "programs/devices/script_device.hpp"
#include "programs/devices/seeing_device.hpp"
#include "shared/firmware/stepped_bout.hpp"

namespace batuta::web {
using namespace fencing;
namespace {

constexpr std::array<Side, 2> kSides = {Side::kLeft, Side::kRight};
constexpr std::int32_t kStepUs = 1000;
constexpr std::array<const char*, 6> kScripts = {"guard",  "parry", "attack",
                                                 "novice", "club",  "master"};
constexpr std::uint32_t kHashEvery =
    1;                           // as batuta-duel: a replay names the step in which it parts
constexpr int kTaken = 1 << 16;  // bytes between two calls of web_forget()
constexpr int kRoom = 1 << 16;   // bytes of a recording that are fed at a time

using DuelType = firmware::DuelType;

/// A capsule: both ends of its axis, and its radius.
using Numbers = std::array<float, 7>;
using Point = std::array<float, 3>;

struct WebTouch {
  float by = 0;    ///< 0 left, 1 right
  float part = 0;  ///< BodyPart
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
  std::array<Numbers, kBodyParts> body_W{};
};

/// What the page sees after a step: floats alone, in the order that page/layout.js repeats. SI
/// units.
struct WebState {
  float steps = 0;
  float bout = 0;  ///< BoutState
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

Point numbers_of(const Vec3<float>& v) {
  return {v.x(), v.y(), v.z()};
}

Numbers numbers_of(const Capsule<float>& capsule) {
  const Vec3<float>& a = capsule.axis.a;
  const Vec3<float>& b = capsule.axis.b;
  return {a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), capsule.radius};
}

void fill_bout(const DuelType& duel, WebState& state) {
  const Bout<float>& bout = duel.bout();
  state.bout = static_cast<float>(bout.state);
  state.exchange = static_cast<float>(bout.exchange);
  state.annulled = bout.annulled ? 1.0F : 0.0F;
  std::size_t count = 0;
  for (const Touch<float>& touch : bout.touches) {  // Bound: 2
    WebTouch& told = state.touch[count++];
    told.by = touch.by == Side::kLeft ? 0.0F : 1.0F;
    told.part = static_cast<float>(touch.part);
    told.time = 1e-6F * static_cast<float>(duel.time_us(touch.when));
    told.point_W = numbers_of(touch.contact.point_W);
  }
  state.touches = static_cast<float>(count);
}

void fill_blows(const DuelType& duel, WebState& state) {
  state.impulse = 0;
  state.has_blow = 0;
  for (const auto& event : duel.world().events()) {  // Bound: DuelScene::kMaxEvents
    if (event.kind == EventKind::kEnd) continue;
    state.impulse += event.impulse;
    state.has_blow = 1;
    state.blow_W = numbers_of(event.contact.point_W);
  }
}

void fill(const DuelType& duel, const firmware::StickForces& forces, WebState& state) {
  state.steps = static_cast<float>(duel.steps());
  fill_bout(duel, state);
  fill_blows(duel, state);
  state.gap = capsule_gap(duel.blade_W(Side::kLeft), duel.blade_W(Side::kRight)).gap;
  for (const Side side : kSides) {  // Bound: 2
    WebSide& told = state.sides[index_of(side)];
    told.score = static_cast<float>(duel.bout().score[index_of(side)]);
    told.place = duel.X_WF(side).p_W.x();
    told.feet = duel.stick(side).feet().y();
    const Vec2<float>& stick = duel.stick(side).position();
    const Vec2<float>& share = forces.of(side).share;
    told.stick = {stick.x(), stick.y()};
    told.force = {share.x(), share.y()};
    told.control = duel.grip(side).control();
    told.blade_W = numbers_of(duel.blade_W(side));
    const BodyShape<float>& body = duel.body_W(side);
    for (std::size_t i = 0; i < body.size(); ++i) {  // Bound: kBodyParts
      told.body_W[i] = numbers_of(body[i]);
    }
  }
}

/// Gives the bytes that the page has put into the room.
class Room final : public ByteSource {
 public:
  std::uint8_t* bytes() { return bytes_.data(); }
  int unread() const { return size_ - at_; }
  void fill(int count, bool is_all) {
    size_ = std::clamp(count, 0, kRoom);
    at_ = 0;
    is_all_ = is_all;
  }

 private:
  int do_read(std::uint8_t* bytes, int capacity) override {
    if (unread() == 0) return is_all_ ? -1 : 0;
    const int count = std::min(capacity, unread());
    std::copy_n(bytes_.data() + at_, count, bytes);
    at_ += count;
    return count;
  }

  std::array<std::uint8_t, kRoom> bytes_{};
  int size_ = 0;
  int at_ = 0;
  bool is_all_ = true;
};

/// A stick: of a script, which may see, or of whoever calls.
struct Stick {
  std::optional<host::ScriptDevice> script;
  std::optional<host::SeeingDevice> fencer;
  InputSample sample;
  bool fresh = false;

  /// Null: whoever calls moves it.
  host::Source* source() {
    if (script) return &*script;
    return fencer ? &*fencer : nullptr;
  }
};

/// A bout that is fenced now. A world counts who has lived in its rooms: only a new one has the
/// bits of the program's first bout.
struct Live {
  std::optional<firmware::SteppedBout> bout{std::in_place};
  std::array<Stick, 2> sticks;
  std::array<std::uint8_t, kTaken> bytes{};  // recorded, and not yet fetched
  std::optional<MemorySink> taken;           // into them
  std::array<std::uint8_t, static_cast<std::size_t>(Recorder::kRoom<DuelType>)> buffer{};
  std::optional<Recorder> recorder;
};

/// A bout that was.
struct Past {
  DuelType duel;
  firmware::StickForces forces;
  std::array<std::uint32_t, 2> used{};
  Room room;
  std::array<std::uint8_t, static_cast<std::size_t>(Player::kRoom<DuelType>)> buffer{};
  std::optional<Player> player;
};

Live live;
Past past;
bool is_past = false;  // which of the two is shown
WebState state;

const DuelType& shown() {
  return is_past ? past.duel : live.bout->duel();
}

void show() {
  fill(shown(), is_past ? past.forces : live.bout->forces(), state);
}

/// The stick of a side for the step that comes, or null.
const InputSample* read(Side side) {
  Stick& stick = live.sticks[index_of(side)];
  host::Source* const source = stick.source();
  if (source == nullptr) return std::exchange(stick.fresh, false) ? &stick.sample : nullptr;
  if (source->sees()) source->see(observation_of(live.bout->duel(), side), kStepUs);
  const Microseconds now = live.bout->steps() * Microseconds{kStepUs};
  return source->read(now, stick.sample) == Status::kOk ? &stick.sample : nullptr;
}

Stick& stick_of(int side) {
  return live.sticks[side == 0 ? 0 : 1];
}

void flush() {
  if (live.recorder) (void)live.recorder->flush();
}

/// Forces are not recorded: they follow from the duel and from who gave a sign of life.
void follow_forces() {
  std::array<bool, 2> alive{};
  for (const Side side : kSides) {  // Bound: 2
    const std::uint32_t used = past.duel.stick(side).report().used;
    alive[index_of(side)] = used != past.used[index_of(side)];
    past.used[index_of(side)] = used;
  }
  past.forces.advance(past.duel, alive);
}

Playback begin_play() {
  const Playback answer = past.player->begin<DuelInput>(past.duel);
  if (answer != Playback::kReady) return answer;
  (void)past.forces.configure({});  // kOk: they are the library's own
  for (const Side side : kSides) {  // Bound: 2
    past.used[index_of(side)] = past.duel.stick(side).report().used;
  }
  is_past = true;
  show();
  return answer;
}

}  // namespace

extern "C" {

/// Begins a bout of the library's two fencers. @param touches  to which it goes, 1 ... 99
/// @param record  0: what happens is not recorded. @returns a Status; where not kOk, no bout goes
/// on
int web_start(int touches, int record) {
  live.bout.emplace();
  firmware::BoutSettings settings;
  settings.step_us = kStepUs;
  settings.touches = touches;
  if (live.sticks[0].fencer || live.sticks[1].fencer)
    settings.distance = fencing::Opponent::kOnGuard;
  const Status status = live.bout->start(settings);
  if (status != Status::kOk) return static_cast<int>(status);
  is_past = false;
  live.taken.emplace(live.bytes.data(), kTaken);
  live.recorder.reset();
  if (record != 0) {
    live.recorder.emplace(*live.taken, live.buffer.data(), static_cast<int>(live.buffer.size()));
    // A duel that its own settings made can be saved, and the buffer is made for it.
    (void)live.recorder->begin<DuelInput>(live.bout->duel(), kHashEvery);
  }
  for (Stick& stick : live.sticks) {  // Bound: 2
    if (host::Source* const source = stick.source()) source->rewind();
    stick.fresh = false;
  }
  flush();
  show();
  return static_cast<int>(Status::kOk);
}

/// Who moves a stick: the kScripts by their number, anything else is a hand.
void web_choose(int side, int script) {
  Stick& stick = stick_of(side);
  stick.script.reset();
  stick.fencer.reset();
  if (script < 0 || script >= static_cast<int>(kScripts.size())) return;
  const char* const name = kScripts[static_cast<std::size_t>(script)];
  if (const auto named = host::script_named(name)) stick.script.emplace(*named);
  if (const auto named = host::seeing_script(name)) stick.fencer.emplace(*named);
}

/// Where a device's second pair of axes stands, from the next web_sample() on.
void web_feet(int side, float x, float y) {
  InputSample& sample = stick_of(side).sample;
  sample.feet_x = x;
  sample.feet_y = y;
}

/// A hand's sample for the next step, as its device tells it; its feet are those of web_feet().
void web_sample(int side, std::uint32_t time_us, float x, float y, std::uint32_t buttons,
                std::uint32_t sequence) {
  Stick& stick = stick_of(side);
  stick.sample = {time_us, x, y, stick.sample.feet_x, stick.sample.feet_y, buttons, sequence};
  stick.fresh = true;
}

/// One step of 1 ms. @returns a Status
int web_step() {
  is_past = false;
  const InputSample* const left = read(Side::kLeft);
  const InputSample* const right = read(Side::kRight);
  const Status status = live.bout->step(left, right);
  if (status != Status::kOk) return static_cast<int>(status);
  if (live.recorder) {
    DuelInput input;
    for (const Side side : kSides) input.set(side, live.bout->used(side));  // Bound: 2
    live.recorder->step(input, live.bout->duel());
    flush();
  }
  show();
  return static_cast<int>(status);
}

/// The end mark of the recording. @returns a Status
int web_end() {
  if (!live.recorder) return static_cast<int>(Status::kUnavailable);
  const Status status = live.recorder->end(live.bout->duel());
  flush();
  return static_cast<int>(status);
}

/// WebState, and how many floats it is.
const float* web_state() {
  return &state.steps;
}
int web_state_size() {
  return static_cast<int>(sizeof state / sizeof(float));
}

/// hash_of() the duel that is shown.
std::uint64_t web_hash() {
  return hash_of(shown());
}

/// What was recorded since the last web_forget(), and how many bytes: at most 64 KB are kept.
const std::uint8_t* web_recorded() {
  return live.bytes.data();
}
int web_recorded_size() {
  return live.taken ? live.taken->size() : 0;
}
void web_forget() {
  live.taken.emplace(live.bytes.data(), kTaken);
  flush();
}

/// Where up to 64 KB of a recording go before web_play() and web_feed().
std::uint8_t* web_room() {
  return past.room.bytes();
}

/// Begins with the `count` bytes in the room. @param is_all  0: there are more
/// @returns a Playback; the first 64 KB hold the start of any recording of this duel
int web_play(int count, int is_all) {
  past.room.fill(count, is_all != 0);
  past.player.emplace(past.room, past.buffer.data(), static_cast<int>(past.buffer.size()));
  return static_cast<int>(begin_play());
}

/// Goes on with these. @pre the player is waiting: what it has not read is gone
void web_feed(int count, int is_all) {
  past.room.fill(count, is_all != 0);
}

/// Bytes of the room that the player has not asked for; behind an end mark there should be none.
int web_unread() {
  return past.room.unread();
}

/// The recording's next step. @returns a Playback
int web_next() {
  if (!past.player) return static_cast<int>(Playback::kForeign);
  DuelInput input;
  const Playback answer = past.player->next(input, past.duel);
  if (answer == Playback::kStep) {
    // What the duel says to a step is part of its state, and compared with it.
    (void)past.duel.step(input.at(Side::kLeft), input.at(Side::kRight));
    follow_forces();
    is_past = true;
    show();
  }
  return static_cast<int>(answer);
}

/// Hashes that agreed so far.
std::uint32_t web_agreed() {
  return past.player ? past.player->agreed() : 0;
}

}  // extern "C"

}  // namespace batuta::web
