// SPDX-License-Identifier: MIT
// The ready-made scenes, each with bodies that meet, turn, rub, pile up and sleep. A step is a
// query: where two runs part, the first step that differs is named.
#include "batuta/world/scenes.hpp"

#include "sections.hpp"
#include "world_fields.hpp"

namespace batuta::digest {
namespace {

constexpr float kStep = 1e-3F;  // s
constexpr std::uint32_t kSteps = 1500;

/// The same numbers everywhere.
class Draw {
 public:
  explicit Draw(std::uint32_t seed) : state_(seed) {}
  /// In [low, high).
  float in(float low, float high) {
    state_ = state_ * 1664525U + 1013904223U;
    return low + (high - low) * (static_cast<float>(state_ >> 8U) / 16777216.0F);
  }
  Vec3<float> vector(float size) {
    const float x = in(-size, size);
    const float y = in(-size, size);
    return {x, y, in(-size, size)};
  }

 private:
  std::uint32_t state_;
};

template <class SceneT>
void add_state(Answer& answer, const Actor<SceneT>& actor) {
  if constexpr (SceneT::kRotation) {
    add(answer, actor.body.X_WB);
    add(answer, actor.body.momentum);
  } else {
    answer.add("p_W", actor.body.p_W);
    answer.add("momentum_W", actor.body.momentum_W);
  }
}

template <class SceneT>
void run(World<SceneT>& world, std::uint32_t number, Recorder& recorder) {
  const std::uint32_t last = recorder.shortened(kSteps);
  for (std::uint32_t step = 0; step < last; ++step) {  // Bound: kSteps
    Answer answer = recorder.begin(Section::kScenes, index_in(number, step));
    answer.add("status", world.step(kStep));
    add(answer, world.report());
    answer.add("asleep", world.report().asleep);
    answer.add("frozen", world.report().frozen);
    for (std::uint16_t slot = 0; slot < SceneT::kMaxBodies; ++slot) {  // Bound: kMaxBodies
      const auto* actor = world.get(world.id_at(slot));
      if (actor != nullptr) add_state(answer, *actor);
    }
    if constexpr (SceneT::kMaxEvents > 0) {
      for (const auto& event : world.events()) add(answer, event);  // Bound: kMaxEvents
    }
    recorder.end(Section::kScenes, index_in(number, step), answer);
  }
}

/// Six balls in flight, and two that are fixed.
void fly_straight(std::uint32_t number, Recorder& recorder) {
  static World<StraightSpheres> world;
  Draw draw(1);
  for (int i = 0; i < StraightSpheres::kMaxBodies; ++i) {  // Bound: kMaxBodies
    Actor<StraightSpheres> actor;
    actor.radius = 0.1F;
    actor.restitution = draw.in(0.5F, 1.0F);
    actor.body.p_W = Vec3<float>(0.3F * static_cast<float>(i % 2), 0.3F * static_cast<float>(i / 2),
                                 draw.in(-0.05F, 0.05F));
    if (i < StraightSpheres::kMaxBodies - 2) {
      actor.body.inverse_mass = draw.in(0.5F, 4.0F);
      actor.body.momentum_W = draw.vector(1.0F);
    }
    (void)world.add(actor);
  }
  run(world, number, recorder);
}

template <class SceneT>
Actor<SceneT> rod(const Pose<float>& X_WB, float length, float radius) {
  Actor<SceneT> actor;
  actor.capsule_B = {{{0, 0, -length / 2}, {0, 0, length / 2}}, radius};
  actor.body.X_WB = X_WB;
  return actor;
}

template <class SceneT>
void set_free(Actor<SceneT>& actor) {
  constexpr float kDensity = 1000;
  const auto mass = solid_capsule(actor.capsule_B, kDensity).value;
  const Vec3<float> moments = mass.inertia_S.diagonal();
  actor.body = make_body<float>(actor.body.X_WB, mass.mass, moments).value;
}

/// Two rods that turn, through or off each other.
template <class SceneT>
void meet(World<SceneT>& world, std::uint32_t number, Recorder& recorder) {
  Draw draw(2);
  for (const float side : {-0.4F, 0.4F}) {
    auto actor = rod<SceneT>({{side, 0, 0}, Quat<float>::Identity()}, 1, 0.02F);
    set_free(actor);
    const float mass = 1 / actor.body.inverse_mass;
    actor.body.momentum.linear_W = mass * Vec3<float>(-side, 0.05F, 0.02F);
    actor.body.momentum.angular_W = 0.2F * mass * draw.vector(1.0F);
    if constexpr (SceneT::kRestitution) actor.restitution = 0.8F;
    (void)world.add(actor);
  }
  run(world, number, recorder);
}

/// A heap that falls onto a grate, rubs and comes to rest.
void pile_up(std::uint32_t number, Recorder& recorder) {
  static World<Rack> world;
  Draw draw(3);
  constexpr int kBars = 8;
  for (int i = 0; i < kBars; ++i) {  // Bound: kBars
    const float y = 0.12F * (static_cast<float>(i) - 3.5F);
    const Quat<float> along_x = renewed(Quat<float>(1, 0, 1, 0));
    auto bar = rod<Rack>({{0, y, 0}, along_x}, 2, 0.03F);
    bar.controller = {};
    bar.friction = 0.5F;
    (void)world.add(bar);
  }
  for (int i = kBars; i < Rack::kMaxBodies; ++i) {  // Bound: kMaxBodies
    const float height = 0.1F + 0.07F * static_cast<float>(i - kBars);
    const Vec3<float> place = draw.vector(0.2F);  // arguments have no order, statements do
    const Vec3<float> turn = draw.vector(1.0F);
    const Quat<float> turned = renewed(Quat<float>(1, turn.x(), turn.y(), 0));
    auto body = rod<Rack>({{place.x(), place.y(), height}, turned}, 0.25F, 0.02F);
    set_free(body);
    body.restitution = 0.3F;
    body.friction = 0.6F;
    (void)world.add(body);
  }
  run(world, number, recorder);
}

}  // namespace

void play_scenes(Recorder& recorder) {
  if (!recorder.takes(Section::kScenes)) return;
  static World<DetectionOnly> seen;
  static World<TwoBlades> blades;
  fly_straight(0, recorder);
  meet(seen, 1, recorder);
  meet(blades, 2, recorder);
  pile_up(3, recorder);
}

}  // namespace batuta::digest
