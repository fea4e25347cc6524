// SPDX-License-Identifier: MIT
// What must hold of snapshots and recordings for any bytes whatever, as a libFuzzer target. Bytes
// at random would not get past the fingerprint, and seeds of whole states would be worth nothing
// after the next change of a member. So an input is a list of forgeries of what a healthy world
// wrote; the check sums are put right afterwards.

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "batuta/record/memory_stream.hpp"
#include "batuta/record/player.hpp"
#include "batuta/record/recorder.hpp"
#include "batuta/record/snapshot.hpp"
#include "batuta/record/world.hpp"
#include "batuta/world/scenes.hpp"
#include "hostile_numbers.hpp"

namespace batuta {
namespace {

using Bytes = std::vector<std::uint8_t>;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "a saved state broke a promise: %s\n", what);
  std::abort();
}

/// Events, seeds, sleepers, and bodies of up to two capsules.
constexpr SceneOptions pile_options() {
  SceneOptions scene;
  scene.max_bodies = 4;
  scene.capsules_per_body = 2;
  scene.max_pairs = 12;
  scene.friction = true;
  scene.line_contact = true;
  scene.gravity = true;
  scene.sleep = true;
  scene.filters = true;
  scene.resting = RestingContact::kSettling;
  return scene;
}
using Pile = Scene<pile_options>;

/// A general world in which nothing turns.
constexpr SceneOptions sliders_options() {
  SceneOptions scene;
  scene.max_bodies = 3;
  scene.max_pairs = 3;
  scene.rotation = false;
  scene.gravity = true;
  scene.resting = RestingContact::kNone;
  return scene;
}
using Sliders = Scene<sliders_options, Translation<float>>;

/// What a step is given.
struct Push {
  Vec3<float> impulse = Vec3<float>::Zero();
  std::uint16_t slot = 0;

  void archive(Archive& ar) { ar(impulse, slot); }
};

constexpr float kStep = 1e-3F;

template <class SceneT>
void put_capsule(Actor<SceneT>& actor, float radius) {
  const Capsule<float> capsule{{{-0.2F, 0, 0}, {0.2F, 0, 0}}, radius};
  if constexpr (SceneT::Search::kForSpheres) {
    actor.radius = radius;
  } else if constexpr (SceneT::kCapsulesPerBody == 1) {
    actor.capsule_B = capsule;
  } else {
    (void)actor.capsules_B.push(capsule);
    (void)actor.capsules_B.push({{{0, -0.1F, 0}, {0, 0.1F, 0}}, radius});
  }
}

/// One above the other, the lowest of them fixed; the upper ones come down.
template <class SceneT>
Actor<SceneT> actor_at(int level) {
  Actor<SceneT> actor;
  put_capsule(actor, 0.02F);
  const Vec3<float> place(0.01F * static_cast<float>(level), 0, 0.041F * static_cast<float>(level));
  const float mass = level == 0 ? std::numeric_limits<float>::infinity() : 1.0F;
  if constexpr (SceneT::kRotation) {
    actor.body = make_body<float>({place, Quat<float>::Identity()}, mass,
                                  Vec3<float>::Constant(0.01F * mass))
                     .value;
    actor.body.momentum.linear_W = Vec3<float>(0, 0, level == 0 ? 0.0F : -0.3F);
  } else {
    actor.body = make_straight_body<float>(place, mass).value;
    actor.body.momentum_W = Vec3<float>(0, 0, level == 0 ? 0.0F : -0.3F);
  }
  actor.restitution = 0.3F;
  return actor;
}

/// After some steps: contacts are known, and seeds.
template <class SceneT>
std::unique_ptr<World<SceneT>> healthy_world() {
  auto world = std::make_unique<World<SceneT>>();
  const int bodies = min_of(SceneT::kMaxBodies, 3);
  for (int level = 0; level < bodies; ++level) {
    require(world->add(actor_at<SceneT>(level)).ok(), "a healthy body");
  }
  for (int i = 0; i < 40; ++i) require(world->step(kStep) == Status::kOk, "a healthy step");
  return world;
}

template <class SceneT>
std::unique_ptr<World<SceneT>> copy_of_healthy() {
  static const std::unique_ptr<World<SceneT>> healthy = healthy_world<SceneT>();
  auto copy = std::make_unique<World<SceneT>>();
  copy->restore(*healthy);
  return copy;
}

template <class SceneT>
void apply(World<SceneT>& world, const Push& push) {
  auto* const actor = world.get(world.id_at(push.slot));
  if (actor == nullptr) return;
  if constexpr (SceneT::kRotation) {
    actor->body.momentum.linear_W += push.impulse;
  } else {
    actor->body.momentum_W += push.impulse;
  }
}

/// The events of a step name what is there.
template <class SceneT>
void check_events(const World<SceneT>& world) {
  if constexpr (SceneT::kMaxEvents > 0) {
    for (const auto& event : world.events()) {
      const auto* const A = world.get(world.id_at(event.body_A));
      const auto* const B = world.get(world.id_at(event.body_B));
      require(A != nullptr && B != nullptr, "an event names bodies of the world");
      require(event.part_A < parts_of(*A) && event.part_B < parts_of(*B), "and parts of them");
    }
  }
}

template <class T>
Bytes saved(const T& state) {
  Bytes bytes(kSnapshotRoom<T>);
  const Result<int> size = save(state, bytes.data(), static_cast<int>(bytes.size()));
  require(size.ok(), "what was taken can be saved");
  bytes.resize(static_cast<std::size_t>(size.value));
  return bytes;
}

int size_of(const Bytes& bytes) {
  return static_cast<int>(bytes.size());
}

/// Takes forged bytes: they are refused or good for all that a world does.
template <class SceneT>
void check_snapshot(const Bytes& forged) {
  const auto world = copy_of_healthy<SceneT>();
  const Restored answer = restore(*world, forged.data(), size_of(forged));
  if (answer == Restored::kOk) {
    require(world->size() <= SceneT::kMaxBodies, "as many bodies as there is room for");
    const auto twin = std::make_unique<World<SceneT>>();
    const Bytes again = saved(*world);
    require(restore(*twin, again.data(), size_of(again)) == Restored::kOk, "saved, then restored");
    require(hash_of(*twin) == hash_of(*world), "to the same state");
    (void)world->step(kStep);
    (void)twin->step(kStep);
    require(hash_of(*twin) == hash_of(*world), "that goes on alike");
  }
  // A refusal may leave any mixture of good members.
  for (int i = 0; i < 3; ++i) {
    if (world->step(kStep) == Status::kOk) check_events(*world);
  }
  for (std::uint16_t slot = 0; slot < SceneT::kMaxBodies; ++slot) {
    (void)world->remove(world->id_at(slot));
  }
  require(world->size() == 0, "every body can be removed");
}

template <class SceneT>
Bytes healthy_recording() {
  const auto world = copy_of_healthy<SceneT>();
  std::array<std::uint8_t, Recorder::kRoom<World<SceneT>>> buffer{};
  Bytes bytes(buffer.size() + 1024);
  MemorySink sink(bytes.data(), size_of(bytes));
  Recorder recorder(sink, buffer.data(), static_cast<int>(buffer.size()));
  require(recorder.template begin<Push>(*world, 2) == Status::kOk, "a recording begins");
  for (int i = 0; i < 6; ++i) {
    const Push push{{0, 0, 0.01F * static_cast<float>(i)}, 2};
    apply(*world, push);
    (void)world->step(kStep);
    recorder.step(push, *world);
  }
  require(recorder.end(*world) == Status::kOk && recorder.flush(), "a recording ends");
  bytes.resize(static_cast<std::size_t>(sink.size()));
  return bytes;
}

/// Goes through forged bytes: it ends, and makes no more steps than there are bytes for.
template <class SceneT>
Playback check_recording(const Bytes& forged) {
  const auto world = std::make_unique<World<SceneT>>();
  std::array<std::uint8_t, Player::kRoom<World<SceneT>>> buffer{};
  MemorySource source(forged.data(), size_of(forged));
  Player player(source, buffer.data(), static_cast<int>(buffer.size()));
  Playback answer = Playback::kWaiting;
  std::size_t calls = 0;
  while (answer == Playback::kWaiting) {
    answer = player.template begin<Push>(*world);
    require(++calls <= forged.size() + 2, "a recording has an end");
  }
  while (answer <= Playback::kWaiting && answer != Playback::kEnd) {
    Push push;
    answer = player.next(push, *world);
    require(++calls <= 2 * forged.size() + 4, "a recording has an end");
    if (answer != Playback::kStep) continue;
    apply(*world, push);
    if (world->step(kStep) == Status::kOk) check_events(*world);
  }
  Push push;
  require(player.next(push, *world) == answer, "the end stays the answer");
  return answer;
}

/// A forgery: where (16 bits), how, with what.
constexpr std::size_t kForgery = 4;

void forge(Bytes& bytes, std::size_t from, const std::uint8_t* how) {
  const std::size_t at = from + (how[0] | std::size_t{how[1]} << 8) % (bytes.size() - from);
  if (how[2] % 4 == 3) return bytes.resize(at);  // torn off
  if (how[2] % 4 != 2) {
    bytes[at] = how[3];
    return;
  }
  const std::uint32_t number = test::kHostileWords[how[3] % test::kHostileWords.size()];
  for (std::size_t i = 0; i < 4 && at + i < bytes.size(); ++i) {
    bytes[at + i] = static_cast<std::uint8_t>(number >> (8 * i));
  }
}

Bytes forged(Bytes bytes, std::size_t from, const std::uint8_t* data, std::size_t size) {
  for (std::size_t i = 0; i + kForgery <= size && bytes.size() > from; i += kForgery) {
    forge(bytes, from, data + i);
  }
  return bytes;
}

/// @returns the bytes of a snapshot whose head and check sum are right for what is left of it
std::size_t sealed_snapshot(Bytes& bytes, std::size_t body) {
  const std::size_t whole = static_cast<std::size_t>(detail::kSnapshotHead) + body;
  if (bytes.size() < whole + detail::kCheckSum) return bytes.size();
  detail::seal(bytes.data(), static_cast<int>(whole));
  return whole + detail::kCheckSum;
}

void seal_records(Bytes& bytes, std::size_t from) {
  while (from + detail::kRecordHead + detail::kCheckSum <= bytes.size()) {
    const std::size_t body = bytes[from + 1] | std::size_t{bytes[from + 2]} << 8;
    if (body > bytes.size() - from - detail::kRecordHead - detail::kCheckSum) return;
    detail::seal(bytes.data() + from, detail::kRecordHead + static_cast<int>(body));
    from += detail::kRecordHead + body + detail::kCheckSum;
  }
}

template <class SceneT>
void check(bool whole_run, const std::uint8_t* data, std::size_t size) {
  static const Bytes snapshot = saved(*copy_of_healthy<SceneT>());
  static const Bytes recording = healthy_recording<SceneT>();
  const std::size_t state = snapshot.size() - detail::kSnapshotHead - detail::kCheckSum;
  Bytes bytes = forged(whole_run ? recording : snapshot, detail::kSnapshotHead, data, size);
  const std::size_t from = sealed_snapshot(bytes, state);
  if (!whole_run) return check_snapshot<SceneT>(bytes);
  seal_records(bytes, from);
  const Playback answer = check_recording<SceneT>(bytes);
  require(bytes != recording || answer == Playback::kEnd, "what was recorded can be played");
}

}  // namespace
}  // namespace batuta

/// The first byte: which world, and whether it is a recording.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace batuta;
  if (size == 0) return 0;
  const bool whole_run = data[0] >= 128;
  switch (data[0] % 4) {
    case 0:
      check<Pile>(whole_run, data + 1, size - 1);
      break;
    case 1:
      check<Sliders>(whole_run, data + 1, size - 1);
      break;
    case 2:
      check<TwoBlades>(whole_run, data + 1, size - 1);
      break;
    default:
      check<StraightSpheres>(whole_run, data + 1, size - 1);
      break;
  }
  return 0;
}
