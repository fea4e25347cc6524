// SPDX-License-Identifier: MIT
// The small world at its limits: bad input, speeds beyond the numbers, and what does not fit.

#include "small_scenes.hpp"

namespace batuta {
namespace {

using namespace test;

template <class SceneT>
class SmallLimits : public Small<SceneT> {};
TYPED_TEST_SUITE(SmallLimits, SmallScenes);

TYPED_TEST(SmallLimits, BadInput_IsRefusedAndChangesNothing) {
  using S = typename TypeParam::Scalar;
  World<TypeParam> world;
  const auto id = world.add(ball<TypeParam>(0, 1)).value;
  const auto before = hash_of(world);
  const S bad = std::numeric_limits<S>::quiet_NaN();
  const S huge = std::numeric_limits<S>::infinity();
  for (const S dt : {S(0), S(-1), bad, huge}) {
    EXPECT_EQ(world.step(dt), Status::kInvalidArgument);
  }
  const auto refuses = [&world](const auto& change) {
    auto actor = ball<TypeParam>(1, 0);
    change(actor);
    return world.add(actor).status == Status::kInvalidArgument;
  };
  for (const S x : {bad, huge, -huge}) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_TRUE(refuses([&](auto& actor) { actor.body.p_W[i] = x; }));
      EXPECT_TRUE(refuses([&](auto& actor) { actor.body.momentum_W[i] = x; }));
    }
    EXPECT_TRUE(refuses([&](auto& actor) { actor.body.inverse_mass = x; }));
    EXPECT_TRUE(refuses([&](auto& actor) { actor.restitution = x; }));
  }
  EXPECT_TRUE(refuses([](auto& actor) { actor.body.inverse_mass = -1; }));
  constexpr S kNoInverse = std::numeric_limits<S>::denorm_min();
  EXPECT_TRUE(refuses([](auto& actor) { actor.body.inverse_mass = kNoInverse; }));
  EXPECT_TRUE(refuses([](auto& actor) { actor.restitution = S(1.5); }));
  EXPECT_TRUE(refuses([](auto& actor) { put_shape(actor, {0, 0, 0}, -1); }));
  WorldSettings<TypeParam> settings;
  settings.gravity_W.x() = bad;
  EXPECT_EQ(world.configure(settings), Status::kInvalidArgument);
  EXPECT_EQ(hash_of(world), before);
  EXPECT_EQ(world.remove({}), Status::kStaleHandle);
  EXPECT_FALSE(world.is_asleep(id));
}

TYPED_TEST(SmallLimits, BodyBrokenByTheCaller_IsLeftOutAndCounted) {
  using S = typename TypeParam::Scalar;
  World<TypeParam> world;
  const auto broken = world.add(ball<TypeParam>(0, 2)).value;
  const auto other = world.add(ball<TypeParam>(1, -2)).value;
  world.get(broken)->body.momentum_W.x() = std::numeric_limits<S>::quiet_NaN();
  ASSERT_EQ(world.step(1), Status::kOk);
  EXPECT_EQ(world.report().plans_invalid, 1U);
  EXPECT_FALSE(world.report().complete());
  EXPECT_EQ(world.get(broken)->body.p_W.x(), S(0));
  EXPECT_NEAR(world.get(other)->body.p_W.x(), -1, 1e-5);
}

// 1 kg at 1 m/s against what stands there: at 0.8 m they touch.
TYPED_TEST(SmallLimits, SpeedThatOverflows_IsRefusedOrHeldWhereOthersMeetIt) {
  using S = typename TypeParam::Scalar;
  World<TypeParam> world;
  WorldSettings<TypeParam> settings;
  settings.gravity_W.setZero();
  ASSERT_EQ(world.configure(settings), Status::kOk);
  auto fast = ball<TypeParam>(1, 0);
  fast.body.inverse_mass = fast.body.momentum_W.x() = std::sqrt(std::numeric_limits<S>::max()) * 2;
  EXPECT_EQ(world.add(fast).status, Status::kInvalidArgument);
  const auto held = world.add(ball<TypeParam>(1, 0)).value;
  const auto other = world.add(ball<TypeParam>(0, 1)).value;
  world.get(held)->body = fast.body;
  ASSERT_EQ(world.step(1), Status::kOk);
  EXPECT_EQ(world.report().plans_invalid, 1U);
  EXPECT_EQ(world.report().time_held, S(1));
  EXPECT_FALSE(world.report().complete());
  EXPECT_EQ(world.get(held)->body.p_W, fast.body.p_W);
  EXPECT_LT(world.get(other)->body.p_W.x(), S(0.80001)) << "not passed through";
  EXPECT_GT(least_gap(world), -TestFixture::kRounding);
}

TYPED_TEST(SmallLimits, GravityThatOverflows_HoldsTheBodyWithItsMomentum) {
  using S = typename TypeParam::Scalar;
  World<TypeParam> world;
  auto heavy = ball<TypeParam>(1, 0);
  heavy.body.inverse_mass = std::numeric_limits<S>::denorm_min();
  heavy.body.momentum_W.y() = 5;
  const auto held = world.add(ball<TypeParam>(1, 0)).value;
  const auto other = world.add(ball<TypeParam>(0, 1)).value;
  world.get(held)->body = heavy.body;
  ASSERT_EQ(world.step(1), Status::kOk);
  EXPECT_EQ(world.report().plans_invalid, 1U);
  EXPECT_EQ(world.get(held)->body.p_W, heavy.body.p_W);
  EXPECT_EQ(world.get(held)->body.momentum_W.y(), S(5));
  EXPECT_EQ(world.get(held)->body.momentum_W.z(), S(0));
  EXPECT_TRUE(std::isfinite(world.get(other)->body.p_W.norm()));
}

// A heavy one at the largest speed hits a light one, which would have to be twice as fast.
TYPED_TEST(SmallLimits, BlowBeyondTheNumbers_LeavesEveryPlaceANumber) {
  using S = typename TypeParam::Scalar;
  const S most = std::numeric_limits<S>::max();
  World<TypeParam> world;
  WorldSettings<TypeParam> settings;
  settings.gravity_W.setZero();
  ASSERT_EQ(world.configure(settings), Status::kOk);
  auto heavy = ball<TypeParam>(0, 0);
  heavy.body.inverse_mass = S(0.5);
  heavy.body.momentum_W.x() = most;
  auto light = ball<TypeParam>(1, 0);
  light.body.inverse_mass = 1024;
  ASSERT_TRUE(world.add(heavy).ok());
  ASSERT_TRUE(world.add(light).ok());
  ASSERT_TRUE(world.add(ball<TypeParam>(3, 0)).ok());
  ASSERT_EQ(world.step(S(4) / most), Status::kOk);
  for (std::uint16_t slot = 0; slot < 3; ++slot) {
    const auto& body = world.get(world.id_at(slot))->body;
    EXPECT_TRUE(std::isfinite(body.p_W.norm())) << slot;
  }
  EXPECT_GT(least_gap(world), -TestFixture::kRounding);
}

TYPED_TEST(SmallLimits, NinthBody_FindsNoRoom) {
  World<TypeParam> world;
  for (int i = 0; i < 8; ++i) ASSERT_TRUE(world.add(ball<TypeParam>(i, 0)).ok());
  EXPECT_EQ(world.add(ball<TypeParam>(9, 0)).status, Status::kPoolFull);
  const auto third = world.id_at(3);
  EXPECT_EQ(world.remove(third), Status::kOk);
  EXPECT_EQ(world.get(third), nullptr);
  EXPECT_EQ(world.size(), 7);
  EXPECT_TRUE(world.add(ball<TypeParam>(3, 0)).ok());
  EXPECT_EQ(world.get(third), nullptr);
  ASSERT_EQ(world.step(1), Status::kOk);
}

TYPED_TEST(SmallLimits, IdsOfAnotherWorld_NameNothing) {
  World<TypeParam> one(1);
  World<TypeParam> two(2);
  const auto id = one.add(ball<TypeParam>(0, 0)).value;
  ASSERT_TRUE(two.add(ball<TypeParam>(0, 0)).ok());
  EXPECT_NE(one.get(id), nullptr);
  EXPECT_EQ(two.get(id), nullptr);
}

TYPED_TEST(SmallLimits, RestoredOrRead_GoesOnWithTheSameBits) {
  using S = typename TypeParam::Scalar;
  std::uint32_t blows = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    World<TypeParam> first;
    for (const auto& actor : Draw(seed).actors<TypeParam>(8)) ASSERT_TRUE(first.add(actor).ok());
    ASSERT_EQ(first.remove(first.id_at(2)), Status::kOk);
    for (int i = 0; i < 2; ++i) ASSERT_EQ(first.step(S(0.005)), Status::kOk);
    World<TypeParam> restored(9);
    restored.restore(first);
    std::vector<std::uint8_t> bytes(sizeof(first));
    ArchiveWriter writer(bytes.data(), static_cast<int>(bytes.size()));
    writer.look_at(first);
    ASSERT_TRUE(writer.ok());
    World<TypeParam> read(8);
    ArchiveReader reader(bytes.data(), writer.position());
    reader(read);
    ASSERT_TRUE(reader.is_done(writer.position()));
    for (int i = 0; i < 20; ++i) {
      ASSERT_EQ(hash_of(first), hash_of(restored)) << i;
      ASSERT_EQ(hash_of(first), hash_of(read)) << i;
      for (auto* world : {&first, &restored, &read}) ASSERT_EQ(world->step(S(0.005)), Status::kOk);
      blows += first.report().collisions;
    }
  }
  EXPECT_GT(blows, 0U);
}

// --- what does not fit

template <class SceneT>
constexpr SceneOptions narrow_options() {
  SceneOptions scene = SceneT::kStated;
  scene.max_contacts = 1;
  return scene;
}
template <class SceneT>
using Narrow = Scene<narrow_options<SceneT>, typename SceneT::Search>;

// 0 hits 1; 1 hits 2, for which there is no room: both go on together. Then 0, which has stopped,
// stays.
TYPED_TEST(SmallLimits, SecondContactOfOne_GoesOnTogetherAndIsCounted) {
  using Scene = Narrow<TypeParam>;
  using S = typename TypeParam::Scalar;
  World<Scene> world;
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(world.add(ball<Scene>(0.5 * i, i == 0 ? 1 : 0)).ok());
  ASSERT_EQ(world.step(1), Status::kOk);
  EXPECT_EQ(world.report().collisions, 1U);
  EXPECT_EQ(world.report().contacts_dropped, 1U);
  EXPECT_FALSE(world.report().complete());
  EXPECT_NEAR(world.report().time_held, 0.4, 1e-4);
  EXPECT_NEAR(world.get(world.id_at(1))->body.p_W.x(), 0.8 + 0.2, 1e-4);
  EXPECT_NEAR(world.get(world.id_at(2))->body.p_W.x(), 1 + 0.2, 1e-4);
  EXPECT_GT(least_gap(world), -TestFixture::kRounding);
  ASSERT_EQ(world.step(S(0.1)), Status::kOk) << "and goes on";
  EXPECT_TRUE(world.report().complete());
  EXPECT_NEAR(world.get(world.id_at(2))->body.p_W.x(), 1.25, 1e-4);
}

TYPED_TEST(SmallLimits, CrowdsWithRoomForOneContact_NeverOverlapAndEnd) {
  using Scene = Narrow<TypeParam>;
  using S = typename TypeParam::Scalar;
  std::uint32_t dropped = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    World<Scene> world;
    for (const auto& actor : Draw(seed).actors<Scene>(8)) ASSERT_TRUE(world.add(actor).ok());
    for (int step = 0; step < 20; ++step) {
      ASSERT_EQ(world.step(S(0.05)), Status::kOk);
      ASSERT_GT(least_gap(world), -TestFixture::kRounding) << "seed " << seed << " step " << step;
      ASSERT_LE(world.report().collisions, 1U);
      dropped += world.report().contacts_dropped;
    }
  }
  EXPECT_GT(dropped, 5U);
}

/// Summed momentum, mass times place, and mass of what moves.
template <class SceneT>
struct SmallSums {
  Vec3<double> momentum = Vec3<double>::Zero();
  Vec3<double> moment = Vec3<double>::Zero();
  double mass = 0;
  double pushes = 0;
  double energy = 0;
  explicit SmallSums(const World<SceneT>& world) {
    for (std::uint16_t i = 0; i < SceneT::kMaxBodies; ++i) {
      const auto* actor = world.get(world.id_at(i));
      if (actor == nullptr) continue;
      const Vec3<double> p = actor->body.momentum_W.template cast<double>();
      const double m = 1 / static_cast<double>(actor->body.inverse_mass);
      momentum += p;
      moment += m * actor->body.p_W.template cast<double>();
      mass += m;
      pushes += p.norm();
      energy += p.squaredNorm() / (2 * m);
    }
  }
};

/// A crowd that nobody holds and that has room for one contact a step, all faster by `speed`.
/// @returns places as seen from the common centre after the first step with a weld
template <class SceneT>
std::vector<Vec3<double>> drop_contacts(unsigned seed, double speed, double fall) {
  using S = typename SceneT::Scalar;
  const double u = static_cast<double>(kRoundOff<S>);
  World<SceneT> world;
  WorldSettings<SceneT> settings;
  settings.gravity_W = vec<S>(0, 0, -fall);
  EXPECT_EQ(world.configure(settings), Status::kOk);
  for (auto actor : Draw(seed).template actors<SceneT>(8)) {
    if (!(actor.body.inverse_mass > S(0))) continue;
    actor.body.momentum_W.y() += S(speed) / actor.body.inverse_mass;
    EXPECT_TRUE(world.add(actor).ok());
  }
  const S dt = S(0.05);
  const SmallSums<SceneT> first(world);
  double energy = first.energy;
  for (int step = 1; step <= 20; ++step) {
    EXPECT_EQ(world.step(dt), Status::kOk);
    const SmallSums<SceneT> now(world);
    const double time = step * static_cast<double>(dt);
    const Vec3<double> g(0, 0, -fall),
        gained = now.momentum - first.momentum - time * first.mass * g;
    const double size = first.pushes + now.pushes + first.mass * (std::abs(speed) + fall);
    EXPECT_LE(gained.norm(), 16 * u * size * step) << step;
    const Vec3<double> way = time * first.momentum + time * time / 2 * first.mass * g;
    EXPECT_LE((now.moment - first.moment - way).norm(), 16 * u * step * (size + now.moment.norm()));
    EXPECT_TRUE(fall != 0 || now.energy <= energy * (1 + 32 * u)) << step;
    energy = now.energy;
    if (world.report().contacts_dropped == 0) continue;
    EXPECT_FALSE(world.report().complete());
    std::vector<Vec3<double>> places;
    for (std::uint16_t i = 0; i < SceneT::kMaxBodies; ++i) {
      const auto* actor = world.get(world.id_at(i));
      if (actor == nullptr) continue;
      places.push_back(actor->body.p_W.template cast<double>() - now.moment / now.mass);
    }
    return places;
  }
  return {};
}

// What no answer is had for goes on together: laws 1, 2 and 3.
TYPED_TEST(SmallLimits, CrowdsWithRoomForOneContact_KeepTheirMomentumAtEverySpeed) {
  using Scene = Narrow<TypeParam>;
  const double same = std::is_same_v<typename Scene::Scalar, float> ? 1e-4 : 1e-9;
  int dropped = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    (void)drop_contacts<Scene>(seed, 3, Scene::kGravity ? 9.81 : 0);
    const auto at_rest = drop_contacts<Scene>(seed, 0, 0);
    const auto in_flight = drop_contacts<Scene>(seed, 25, 0);
    ASSERT_EQ(at_rest.size(), in_flight.size());
    for (std::size_t i = 0; i < at_rest.size(); ++i) {
      EXPECT_LE((at_rest[i] - in_flight[i]).norm(), same) << i;
    }
    dropped += at_rest.empty() ? 0 : 1;
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(dropped, 5);
}

// One of two that go on together meets what is fixed: both stand.
TYPED_TEST(SmallLimits, GroupThatMeetsAWall_Stands) {
  using Scene = Narrow<TypeParam>;
  using S = typename TypeParam::Scalar;
  World<Scene> world;
  WorldSettings<Scene> settings;
  settings.gravity_W.setZero();
  ASSERT_EQ(world.configure(settings), Status::kOk);
  ASSERT_TRUE(world.add(ball<Scene>(0, 1)).ok());    // hits 1 at 0.1 s
  ASSERT_TRUE(world.add(ball<Scene>(0.3, 0)).ok());  // meets 2 at 0.2 s: together at 0.5 m/s
  ASSERT_TRUE(world.add(ball<Scene>(0.6, 0)).ok());  // meets the wall at 0.4 s
  ASSERT_TRUE(world.add(ball<Scene>(0.9, 0, INFINITY)).ok());
  ASSERT_EQ(world.step(1), Status::kOk);
  EXPECT_EQ(world.report().contacts_dropped, 2U);
  EXPECT_NEAR(world.report().time_held, 0.8, 1e-4);
  EXPECT_NEAR(world.get(world.id_at(1))->body.p_W.x(), 0.4 + 0.1, 1e-4);
  EXPECT_NEAR(world.get(world.id_at(2))->body.p_W.x(), 0.7, 1e-4);
  EXPECT_EQ(world.get(world.id_at(1))->body.momentum_W.x(), S(0));
  EXPECT_EQ(world.get(world.id_at(2))->body.momentum_W.x(), S(0));
}

// Placed in each other by the caller and driven together: stopped by the blow, and told.
TYPED_TEST(SmallLimits, OverlapAtTheStart_IsToldWithItsDepth) {
  World<TypeParam> world;
  ASSERT_TRUE(world.add(ball<TypeParam>(0, 1)).ok());
  ASSERT_TRUE(world.add(ball<TypeParam>(0.15, -1)).ok());
  ASSERT_EQ(world.step(1), Status::kOk);
  EXPECT_EQ(world.report().overlaps_at_start, 1U);
  EXPECT_NEAR(world.report().deepest_overlap, 0.05, 1e-5);
  EXPECT_EQ(world.report().collisions, 1U);
  EXPECT_NEAR(world.get(world.id_at(0))->body.p_W.x(), -1, 1e-5);
}

}  // namespace
}  // namespace batuta
