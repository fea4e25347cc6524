// SPDX-License-Identifier: MIT
// A run is recorded into memory (the state at its start, what each step was given, and hashes) and
// played again in another world, bit for bit. The same bytes replay on another machine or in a
// debugger: with a recording of its input, a bug of a firmware happens again on the desk.
#include <array>
#include <cstdio>

#include "batuta/record/memory_stream.hpp"
#include "batuta/record/player.hpp"
#include "batuta/record/recorder.hpp"
#include "batuta/record/world.hpp"
#include "batuta/world/make_actor.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"
using namespace batuta;

using Blades = World<TwoBlades>;
constexpr int kMilliseconds = 500;

// What comes from outside in a step, and all that is recorded of it.
struct Push {
  Vec3<float> force_W = Vec3<float>::Zero();  // on the first blade, and the opposite on the second

  void archive(Archive& ar) { ar(force_W); }
};

bool add_blade(Blades& world, const Vec3<float>& center) {
  const Capsule<float> steel = {{{0, 0, -0.45F}, {0, 0, 0.45F}}, 0.005F};
  auto blade = make_actor<TwoBlades>(steel, 7850.0F, {center, Quat<float>::Identity()});
  blade.value.restitution = 0.6F;
  return blade.ok() && world.add(blade.value).ok();
}

// The same step for both runs.
bool step(Blades& world, const Push& push) {
  const Vec3<float> opposite_W = -push.force_W;
  const Vec3<float> torque_W = Vec3<float>::Zero();
  return apply(world.get(world.id_at(0))->body, push.force_W, torque_W, 1e-3F) == Status::kOk &&
         apply(world.get(world.id_at(1))->body, opposite_W, torque_W, 1e-3F) == Status::kOk &&
         world.step(1e-3F) == Status::kOk && world.report().complete();
}

int main() {
  static std::array<std::uint8_t, 32'768> bytes;                       // the recording
  static std::array<std::uint8_t, Recorder::kRoom<Blades> + 64> room;  // what waits for the sink
  MemorySink sink(bytes.data(), static_cast<int>(bytes.size()));
  Recorder recorder(sink, room.data(), static_cast<int>(room.size()));
  Blades world;
  if (!add_blade(world, {0, 0, 1}) || !add_blade(world, {0.1F, 0, 1.3F}) ||
      recorder.begin<Push>(world, 100) != Status::kOk) {  // a hash every 100 steps
    return 1;
  }
  std::uint32_t beats = 0;
  for (int millisecond = 0; millisecond < kMilliseconds; ++millisecond) {
    const Push push = {{6, 0, 0.02F * static_cast<float>(millisecond % 7)}};  // from a hand, say
    if (!step(world, push)) return 1;
    beats += world.report().collisions;
    recorder.step(push, world);
    (void)recorder.flush();  // what the sink does not take now is offered again in the next step
  }
  if (recorder.end(world) != Status::kOk || !recorder.flush() || recorder.lost() > 0) return 1;
  std::printf("recorded %u steps with %u blows in %d bytes, hash %016llx\n", recorder.steps(),
              beats, sink.size(), static_cast<unsigned long long>(hash_of(world)));

  MemorySource source(bytes.data(), sink.size());
  static std::array<std::uint8_t, Player::kRoom<Blades>> read;
  Player player(source, read.data(), static_cast<int>(read.size()));
  Blades again;
  Push push;
  if (player.begin<Push>(again) != Playback::kReady) return 1;
  Playback answer = player.next(push, again);
  while (answer == Playback::kStep) {  // until the end mark, or what parts from the recording
    if (!step(again, push)) return 1;
    answer = player.next(push, again);
  }
  std::printf("replayed %u steps, %u hashes agreed, hash %016llx\n", player.steps(),
              player.agreed(), static_cast<unsigned long long>(hash_of(again)));
  return answer == Playback::kEnd ? 0 : 1;
}
