// SPDX-License-Identifier: MIT
// A world saved between two steps and restored into another one goes on with the same bits, and its
// run can be recorded and played again.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "batuta/record/memory_stream.hpp"
#include "batuta/record/player.hpp"
#include "batuta/record/recorder.hpp"
#include "batuta/record/snapshot.hpp"
#include "batuta/record/world.hpp"
#include "batuta/world/scenes.hpp"
#include "scenes.hpp"

namespace batuta {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Everything of a scene that may be saved.
constexpr SceneOptions full_scene_options() {
  SceneOptions scene = test::flight_scene_options();
  scene.filters = true;
  scene.friction = true;
  scene.resting = RestingContact::kSettling;
  return scene;
}
template <class S>
using FullScene = Scene<full_scene_options, Advancement<S>, test::AnyFlight<S>>;

/// Six bodies between two posts: a hand that swings, balls that bounce, rods that turn.
template <class SceneT>
void fill(World<SceneT>& world) {
  using S = typename SceneT::Scalar;
  ASSERT_TRUE(world.add(test::post<SceneT>(-1, 0.1)).ok());
  ASSERT_TRUE(world.add(test::post<SceneT>(1, 0.1)).ok());
  ASSERT_TRUE(world.add(test::ball<SceneT>(-0.5, 0.1, 3)).ok());
  ASSERT_TRUE(world.add(test::ball<SceneT>(0, 0.1, -2)).ok());
  Actor<SceneT> rod = test::rod<SceneT>(0.4, 0.3, 0.02);
  rod.body.momentum.angular_W = test::vec<S>(0.01, 0.02, 0.005);
  rod.body.momentum.linear_W = test::vec<S>(-1, 0, 0);
  rod.restitution = 1;
  ASSERT_TRUE(world.add(rod).ok());
  Actor<SceneT> swung = test::rod<SceneT>(0.7, 0.3, 0.02);
  swung.controller = Hand<S>{};
  ASSERT_TRUE(world.add(swung).ok());
}

/// What the user does before a step: where the hand is to go. Opaque to the recording.
struct Command {
  float x = 0;
  std::uint16_t slot = 5;

  void archive(Archive& ar) {
    auto& [a, b] = *this;
    ar(a, b);
  }
};

Command command_at(int step) {
  return {0.7F + 0.001F * static_cast<float>(step % 40), 5};
}

template <class SceneT>
void advance(World<SceneT>& world, const Command& command) {
  using S = typename SceneT::Scalar;
  constexpr S kDt = S(0.005F);
  if (auto* actor = world.get(world.id_at(command.slot))) {
    if (auto* hand = actor->controller.template as<Hand<S>>()) {
      hand->target_W.p_W = test::vec<S>(static_cast<double>(command.x), 0, 0);
      hand->step = kDt;
    }
  }
  ASSERT_EQ(world.step(kDt), Status::kOk);
}

/// What a user sees, without the archive.
template <class SceneT>
std::vector<double> seen(const World<SceneT>& world) {
  std::vector<double> all = {static_cast<double>(world.report().evaluations),
                             static_cast<double>(world.report().collisions),
                             static_cast<double>(world.events().size())};
  const auto add = [&all](const auto& v) {
    for (int i = 0; i < v.size(); ++i) all.push_back(static_cast<double>(v.data()[i]));
  };
  for (std::uint16_t slot = 0; slot < SceneT::kMaxBodies; ++slot) {
    const auto* actor = world.get(world.id_at(slot));
    if (actor == nullptr) continue;
    add(actor->body.X_WB.p_W);
    add(actor->body.X_WB.q_WB.coeffs());
    add(actor->body.momentum.linear_W);
    add(actor->body.momentum.angular_W);
  }
  for (const auto& event : world.events()) {
    all.push_back(static_cast<double>(event.kind));
    all.push_back(static_cast<double>(event.time));
    add(event.contact.point_W);
  }
  return all;
}

template <class SceneT>
class WorldArchive : public ::testing::Test {
 protected:
  static Bytes saved(const World<SceneT>& world) {
    Bytes bytes(kSnapshotRoom<World<SceneT>>);
    const Result<int> size = save(world, bytes.data(), static_cast<int>(bytes.size()));
    EXPECT_EQ(size.status, Status::kOk);
    bytes.resize(static_cast<std::size_t>(size.value));
    return bytes;
  }
};

using Scenes = ::testing::Types<test::FlightScene<float>, test::FlightScene<double>,
                                FullScene<float>, test::FlightScene<float, Stepping>>;
TYPED_TEST_SUITE(WorldArchive, Scenes);

constexpr int kSteps = 400;

TYPED_TEST(WorldArchive, SavedAnywhere_GoesOnWithTheSameBits) {
  auto world = std::make_unique<World<TypeParam>>();
  fill(*world);
  std::vector<Bytes> snapshots;
  std::vector<std::vector<double>> course;
  std::uint32_t collisions = 0;
  for (int step = 0; step < kSteps; ++step) {
    if (step % 50 == 0) snapshots.push_back(this->saved(*world));
    advance(*world, command_at(step));
    course.push_back(seen(*world));
    collisions += world->report().collisions;
  }
  EXPECT_GE(collisions, 5U) << "or nothing much is seen";
  for (std::size_t i = 0; i < snapshots.size(); ++i) {
    auto other = std::make_unique<World<TypeParam>>();
    const Bytes& bytes = snapshots[i];
    ASSERT_EQ(restore(*other, bytes.data(), static_cast<int>(bytes.size())), Restored::kOk);
    for (std::size_t step = 50 * i; step < course.size(); ++step) {
      advance(*other, command_at(static_cast<int>(step)));
      ASSERT_EQ(seen(*other), course[step]) << "saved at " << 50 * i << ", step " << step;
    }
  }
}

TYPED_TEST(WorldArchive, RecordedAndPlayed_Agrees) {
  using WorldT = World<TypeParam>;
  auto world = std::make_unique<WorldT>();
  fill(*world);
  Bytes file(1 << 20);
  MemorySink sink(file.data(), 1 << 20);
  Bytes buffer(Recorder::kRoom<WorldT>);
  Recorder recorder(sink, buffer.data(), static_cast<int>(buffer.size()));
  ASSERT_EQ(recorder.template begin<Command>(*world, 10), Status::kOk);
  for (int step = 0; step < kSteps; ++step) {
    advance(*world, command_at(step));
    recorder.step(command_at(step), *world);
  }
  ASSERT_EQ(recorder.end(*world), Status::kOk);
  ASSERT_TRUE(recorder.flush());

  MemorySource source(file.data(), sink.size());
  Player player(source, buffer.data(), static_cast<int>(buffer.size()));
  auto again = std::make_unique<WorldT>();
  Command command;
  Playback answer = player.template begin<Command>(*again);
  ASSERT_EQ(answer, Playback::kReady);
  while ((answer = player.next(command, *again)) == Playback::kStep) advance(*again, command);
  EXPECT_EQ(answer, Playback::kEnd);
  EXPECT_EQ(player.agreed(), kSteps / 10 + 1U);
  EXPECT_EQ(seen(*again), seen(*world));
}

constexpr SceneOptions lying_scene_options() {
  SceneOptions scene = full_scene_options();
  scene.gravity = true;
  return scene;
}
using LyingScene = Scene<lying_scene_options, Advancement<double>, test::AnyFlight<double>>;

// A ball that lies on a fixed one and turns: what presses, and with what friction, is saved too.
TEST(WorldArchive, SavedWhileItLies_GoesOnWithTheSameBits) {
  using WorldT = World<LyingScene>;
  const auto make = [] {
    auto world = std::make_unique<WorldT>();
    auto settings = world->settings();
    settings.gravity_W = {-10, 0, 0};
    EXPECT_EQ(world->configure(settings), Status::kOk);
    return world;
  };
  auto world = make();
  auto ground = test::ball<LyingScene>(0, 0.1, 0);
  ground.body.inverse_mass = 0;
  ground.body.inverse_moments.setZero();
  auto lying = test::ball<LyingScene>(0.2 + 5e-5, 0.1, 0);
  lying.restitution = 0;
  lying.body.momentum.angular_W.z() = 1e-5 / lying.body.inverse_moments.z();
  for (auto* actor : {&ground, &lying}) {
    actor->friction = 0.5;
    ASSERT_TRUE(world->add(*actor).ok());
  }
  for (int step = 0; step < 20; ++step) advance(*world, {});
  const double x = world->get(world->id_at(1))->body.X_WB.p_W.x();
  ASSERT_LT(std::abs(x - 0.2), 1e-3) << "it lies no more";
  Bytes bytes(kSnapshotRoom<WorldT>);
  const auto size = save(*world, bytes.data(), static_cast<int>(bytes.size()));
  ASSERT_EQ(size.status, Status::kOk);
  auto other = make();
  ASSERT_EQ(restore(*other, bytes.data(), size.value), Restored::kOk);
  for (int step = 0; step < 20; ++step) {
    advance(*world, {});
    advance(*other, {});
    ASSERT_EQ(seen(*other), seen(*world)) << step;
  }
}

template <class SceneT>
Bytes saved_empty() {
  Bytes bytes(65536);
  const auto size =
      save(*std::make_unique<World<SceneT>>(), bytes.data(), static_cast<int>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(size.value));
  return bytes;
}
template <class SceneT>
Restored taken(const Bytes& bytes) {
  return restore(*std::make_unique<World<SceneT>>(), bytes.data(), static_cast<int>(bytes.size()));
}

TEST(WorldArchive, OtherFeaturesOrScalar_AreRefused) {
  using Plain = test::FlightScene<float>;
  EXPECT_EQ(taken<Plain>(saved_empty<Plain>()), Restored::kOk);
  EXPECT_EQ(taken<Plain>(saved_empty<FullScene<float>>()), Restored::kOtherScene);
  EXPECT_EQ(taken<Plain>(saved_empty<test::FlightScene<double>>()), Restored::kOtherScalar);
}

template <int kContacts>
constexpr SceneOptions small_options() {
  SceneOptions scene = straight_spheres();
  scene.max_contacts = kContacts;
  return scene;
}
template <int kContacts>
using Small = Scene<small_options<kContacts>, Spheres<float>>;

TEST(WorldArchive, SmallWorldOfOtherConstants_IsRefused) {
  const Bytes bytes = saved_empty<Small<4>>();
  EXPECT_EQ(taken<Small<4>>(bytes), Restored::kOk);
  EXPECT_EQ(taken<Small<5>>(bytes), Restored::kOtherScene);
}

constexpr SceneOptions plain_options() {
  return {};
}

TEST(WorldArchive, AnotherController_IsRefused) {
  using Flying = Scene<plain_options, Advancement<float>, FreeFlight<float>>;
  using Standing = Scene<plain_options, Advancement<float>, Fixed<float>>;
  EXPECT_EQ(taken<Standing>(saved_empty<Standing>()), Restored::kOk);
  EXPECT_EQ(taken<Flying>(saved_empty<Standing>()), Restored::kOtherScene);
}

}  // namespace
}  // namespace batuta
