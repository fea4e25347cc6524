// SPDX-License-Identifier: MIT
// The world of a few bodies that fly straight: against the general one, and against what must hold.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "batuta/world/archive.hpp"
#include "batuta/world/scene_cost.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"

namespace batuta {
namespace {

/// All features that a lean scene can have.
template <template <class> class SearchT, class S>
struct LeanScene : StraightSpheres {
  using Scalar = S;
  using Search = SearchT<S>;
  static constexpr std::uint32_t kBudget = Search::kDefaultBudget;
  static constexpr int kMaxContacts = 64;
  static constexpr bool kOwners = true;
  static constexpr bool kFilters = true;
  static constexpr bool kGravity = true;
};
/// The same, in a general world.
template <class SceneT>
struct Told : SceneT {
  static constexpr int kMaxEvents = 64;
};

static_assert(kIsLean<StraightSpheres>);
static_assert(kIsLean<LeanScene<Translation, double>>);
static_assert(!kIsLean<Told<StraightSpheres>> && !kIsLean<TwoBlades>);
static_assert(std::is_base_of_v<LeanWorld<StraightSpheres>, World<StraightSpheres>>);
static_assert(scene_cost<StraightSpheres>.rounds == 8 + 8 + 1);
static_assert(scene_cost<StraightSpheres>.evaluations == 17 * 28);

template <class S>
Vec3<S> vec(double x, double y, double z) {
  return {static_cast<S>(x), static_cast<S>(y), static_cast<S>(z)};
}

template <class SceneT>
void put_shape(Actor<SceneT>& actor, const Vec3<double>& half, double radius) {
  using S = typename SceneT::Scalar;
  if constexpr (SceneT::Search::kForSpheres) {
    actor.radius = static_cast<S>(radius);
  } else {
    const Vec3<S> end = half.cast<S>();
    actor.capsule_B = {{-end, end}, static_cast<S>(radius)};
  }
}

/// On the x axis, C = 1.
template <class SceneT>
Actor<SceneT> ball(double x, double vx, double mass = 1) {
  using S = typename SceneT::Scalar;
  Actor<SceneT> actor;
  actor.body = make_straight_body<S>(vec<S>(x, 0, 0), static_cast<S>(mass)).value;
  if (std::isfinite(mass)) actor.body.momentum_W = vec<S>(mass * vx, 0, 0);
  actor.restitution = 1;
  put_shape(actor, {0, 0, 0.5}, 0.1);
  return actor;
}

template <class SceneT>
Segment<double> axis_of(const Actor<SceneT>& actor) {
  const Vec3<double> p = actor.body.p_W.template cast<double>();
  if constexpr (SceneT::Search::kForSpheres) {
    return {p, p};
  } else {
    return {p + actor.capsule_B.axis.a.template cast<double>(),
            p + actor.capsule_B.axis.b.template cast<double>()};
  }
}
template <class SceneT>
double radius_of(const Actor<SceneT>& actor) {
  if constexpr (SceneT::Search::kForSpheres) {
    return static_cast<double>(actor.radius);
  } else {
    return static_cast<double>(actor.capsule_B.radius);
  }
}

/// In double, by the distance of the axes.
template <class SceneT>
double gap_of(const Actor<SceneT>& A, const Actor<SceneT>& B) {
  return capsule_gap(Capsule<double>{axis_of(A), radius_of(A)},
                     Capsule<double>{axis_of(B), radius_of(B)})
      .gap;
}

template <class SceneT>
double least_gap(const World<SceneT>& world) {
  double least = INFINITY;
  for (std::uint16_t a = 0; a < SceneT::kMaxBodies; ++a) {
    for (std::uint16_t b = 0; b < a; ++b) {
      const auto* A = world.get(world.id_at(a));
      const auto* B = world.get(world.id_at(b));
      if (A == nullptr || B == nullptr || !may_meet(*A, *B)) continue;
      if (A->body.inverse_mass == 0 && B->body.inverse_mass == 0) continue;
      least = std::min(least, gap_of(*A, *B));
    }
  }
  return least;
}

/// Random bodies, none of which overlaps another.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}

  double in(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec3<double> vector(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  bool one_in(int n) { return std::uniform_int_distribution<int>(1, n)(random_) == 1; }

  template <class SceneT>
  Actor<SceneT> actor(bool bouncy) {
    using S = typename SceneT::Scalar;
    Actor<SceneT> actor;
    const S mass = one_in(5) ? S(INFINITY) : static_cast<S>(in(0.5, 3));
    actor.body = make_straight_body<S>(vector(0.35).cast<S>(), mass).value;
    actor.body.momentum_W = (in(0.5, 3) * vector(4)).cast<S>();
    actor.restitution = bouncy ? S(1) : static_cast<S>(in(0, 1));
    if (one_in(8)) actor.owner = 7;
    if (one_in(8)) actor.filter = {2, 1};
    put_shape(actor, vector(0.15), in(0.03, 0.1) * (SceneT::Search::kForSpheres ? 1.5 : 1));
    return actor;
  }
  template <class SceneT>
  std::vector<Actor<SceneT>> actors(int count, bool bouncy = false) {
    std::vector<Actor<SceneT>> all;
    while (static_cast<int>(all.size()) < count) {
      const auto next = actor<SceneT>(bouncy);
      bool fits = true;
      for (const auto& other : all) fits = fits && gap_of(next, other) > 0.01;
      if (fits) all.push_back(next);
    }
    return all;
  }

 private:
  std::mt19937 random_;
};

template <class SceneT>
Actor<Told<SceneT>> told(const Actor<SceneT>& actor) {
  Actor<Told<SceneT>> same;
  static_cast<ShapeOf<SceneT>&>(same) = actor;
  static_cast<Owned&>(same) = actor;
  static_cast<Filtered&>(same) = actor;
  same.restitution = actor.restitution;
  same.body = actor.body;
  return same;
}

template <class SceneT>
class Lean : public ::testing::Test {
 protected:
  static constexpr bool kIsFloat = std::is_same_v<typename SceneT::Scalar, float>;
  static constexpr double kRounding = kIsFloat ? 1e-6 : 1e-14;
  /// Capsules are answered within a slab, and not at one instant.
  static constexpr double kSame = kIsFloat ? 2e-3 : SceneT::Search::kForSpheres ? 1e-9 : 1e-4;
};
using LeanScenes = ::testing::Types<LeanScene<Spheres, float>, LeanScene<Spheres, double>,
                                    LeanScene<Translation, float>, LeanScene<Translation, double>>;
TYPED_TEST_SUITE(Lean, LeanScenes);

// A blow amplifies rounding by no more than a few times, and few follow each other in a step.
TYPED_TEST(Lean, ThousandScenes_SameBlowsAsInTheGeneralWorld) {
  using S = typename TypeParam::Scalar;
  std::uint32_t blows = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    Draw draw(seed);
    World<TypeParam> lean;
    World<Told<TypeParam>> general;
    for (const auto& actor : draw.actors<TypeParam>(2 + static_cast<int>(seed % 7))) {
      ASSERT_TRUE(lean.add(actor).ok());
      ASSERT_TRUE(general.add(told(actor)).ok());
    }
    ASSERT_EQ(lean.step(S(0.1)), Status::kOk);
    ASSERT_EQ(general.step(S(0.1)), Status::kOk);
    ASSERT_TRUE(lean.report().complete());
    ASSERT_EQ(lean.report().collisions, general.report().collisions) << "seed " << seed;
    blows += lean.report().collisions;
    for (std::uint16_t slot = 0; slot < lean.size(); ++slot) {
      const auto& mine = lean.get(lean.id_at(slot))->body;
      const auto& theirs = general.get(general.id_at(slot))->body;
      ASSERT_NEAR((mine.p_W - theirs.p_W).norm(), 0, TestFixture::kSame) << "seed " << seed;
      ASSERT_NEAR((mine.momentum_W - theirs.momentum_W).norm(), 0, 10 * TestFixture::kSame)
          << "seed " << seed;
    }
  }
  EXPECT_GT(blows, 200U);
}

// The gap at a contact is at least what a search resolves; then every pose is rounded.
TYPED_TEST(Lean, CrowdOfEight_NeverOverlaps) {
  using S = typename TypeParam::Scalar;
  for (unsigned seed = 0; seed < 50; ++seed) {
    Draw draw(seed);
    World<TypeParam> world;
    for (const auto& actor : draw.actors<TypeParam>(8)) ASSERT_TRUE(world.add(actor).ok());
    for (int step = 0; step < 100; ++step) {
      ASSERT_EQ(world.step(S(0.01)), Status::kOk);
      ASSERT_GT(least_gap(world), -TestFixture::kRounding) << "seed " << seed << " step " << step;
    }
  }
}

TYPED_TEST(Lean, ElasticCrowdWithoutGravity_KeepsMomentumAndEnergy) {
  using S = typename TypeParam::Scalar;
  for (unsigned seed = 0; seed < 50; ++seed) {
    World<TypeParam> world;
    WorldSettings<TypeParam> settings;
    settings.gravity_W.setZero();
    ASSERT_EQ(world.configure(settings), Status::kOk);
    for (auto actor : Draw(seed).actors<TypeParam>(8, true)) {
      if (actor.body.inverse_mass == S(0)) actor.body.inverse_mass = 1;
      ASSERT_TRUE(world.add(actor).ok());
    }
    const auto sums = [&world] {
      std::pair<Vec3<double>, double> all = {Vec3<double>::Zero(), 0};
      for (std::uint16_t slot = 0; slot < world.size(); ++slot) {
        const auto& body = world.get(world.id_at(slot))->body;
        const Vec3<double> p = body.momentum_W.template cast<double>();
        all.first += p;
        all.second += p.squaredNorm() * static_cast<double>(body.inverse_mass) / 2;
      }
      return all;
    };
    const auto before = sums();
    for (int step = 0; step < 20; ++step) ASSERT_EQ(world.step(S(0.02)), Status::kOk);
    EXPECT_NEAR((sums().first - before.first).norm(), 0, 100 * TestFixture::kRounding);
    EXPECT_NEAR(sums().second / before.second, 1, 100 * TestFixture::kRounding);
  }
}

// Elastic, 1 kg against 3 kg: v1' = -v / 2, v3' = v / 2.
TYPED_TEST(Lean, ElasticBlow_FollowsTheTextbook) {
  World<TypeParam> world;
  WorldSettings<TypeParam> settings;
  settings.gravity_W.setZero();
  ASSERT_EQ(world.configure(settings), Status::kOk);
  const auto light = world.add(ball<TypeParam>(0, 2)).value;
  const auto heavy = world.add(ball<TypeParam>(1, 0, 3)).value;
  ASSERT_EQ(world.step(1), Status::kOk);
  EXPECT_EQ(world.report().collisions, 1U);
  EXPECT_NEAR(world.get(light)->body.momentum_W.x(), -1, 1e-5);
  EXPECT_NEAR(world.get(heavy)->body.momentum_W.x(), 3, 1e-5);
  EXPECT_NEAR(world.get(light)->body.p_W.x(), 0.8 - 0.6, 1e-4) << "touch at 0.4 s";
  EXPECT_NEAR(world.get(heavy)->body.p_W.x(), 1 + 0.6, 1e-4);
}

// Falls by g dt^2 n (n + 1) / 2; what is fixed does not.
TYPED_TEST(Lean, FreeFall_IsTheSumOfTheSteps) {
  using S = typename TypeParam::Scalar;
  World<TypeParam> world;
  const auto falling = world.add(ball<TypeParam>(0, 0, 2)).value;
  const auto fixed = world.add(ball<TypeParam>(5, 0, INFINITY)).value;
  for (int i = 0; i < 100; ++i) ASSERT_EQ(world.step(S(1e-2)), Status::kOk);
  EXPECT_NEAR(world.get(falling)->body.p_W.z(), -9.81e-4 * 100 * 101 / 2, 1e-4);
  EXPECT_NEAR(world.get(falling)->body.momentum_W.z(), -2 * 9.81, 1e-4);
  EXPECT_EQ(world.get(fixed)->body.p_W.z(), 0);
}

// The middle one is hit from both sides at once: the lower pair first, whatever the last bits say.
// 1 kg at 1 m/s, 1 kg, 3 kg at -1 m/s: 0 gives all to 1; 1 takes all from 2, and gives it to 0.
TYPED_TEST(Lean, ContactsAtTheSameTime_AreAnsweredByTheirNames) {
  using S = typename TypeParam::Scalar;
  for (const int ulps : {-1, 0, 1}) {
    World<TypeParam> world;
    for (int i = 0; i < 3; ++i) {
      auto actor = ball<TypeParam>(i - 1, 1 - i, i == 2 ? 3 : 1);
      S& x = actor.body.p_W.x();
      if (i == 2 && ulps != 0) x = std::nextafter(x, ulps > 0 ? S(2) : S(0));
      ASSERT_TRUE(world.add(actor).ok());
    }
    ASSERT_EQ(world.step(1), Status::kOk);
    EXPECT_TRUE(world.report().complete());
    EXPECT_EQ(world.report().collisions, 3U);
    EXPECT_NEAR(world.get(world.id_at(0))->body.momentum_W.x(), -2, 1e-4) << ulps;
    EXPECT_NEAR(world.get(world.id_at(1))->body.momentum_W.x(), 0, 1e-4) << ulps;
    EXPECT_NEAR(world.get(world.id_at(2))->body.momentum_W.x(), 0, 1e-4) << ulps;
  }
}

TYPED_TEST(Lean, TouchingAndParting_IsLeftAlone) {
  World<TypeParam> world;
  ASSERT_TRUE(world.add(ball<TypeParam>(0, -1)).ok());
  ASSERT_TRUE(world.add(ball<TypeParam>(0.2, 1)).ok());
  ASSERT_EQ(world.step(1), Status::kOk);
  EXPECT_EQ(world.report().collisions, 0U);
  EXPECT_TRUE(world.report().complete());
}

TYPED_TEST(Lean, BadInput_IsRefusedAndChangesNothing) {
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
  EXPECT_TRUE(refuses([](auto& actor) { actor.restitution = S(1.5); }));
  EXPECT_TRUE(refuses([](auto& actor) { put_shape(actor, {0, 0, 0}, -1); }));
  WorldSettings<TypeParam> settings;
  settings.gravity_W.x() = bad;
  EXPECT_EQ(world.configure(settings), Status::kInvalidArgument);
  EXPECT_EQ(hash_of(world), before);
  EXPECT_EQ(world.remove({}), Status::kStaleHandle);
  EXPECT_FALSE(world.is_asleep(id));
}

TYPED_TEST(Lean, BodyBrokenByTheCaller_IsLeftOutAndCounted) {
  using S = typename TypeParam::Scalar;
  World<TypeParam> world;
  const auto broken = world.add(ball<TypeParam>(0, 2)).value;
  const auto other = world.add(ball<TypeParam>(1, -2)).value;
  world.get(broken)->body.momentum_W.x() = std::numeric_limits<S>::quiet_NaN();
  ASSERT_EQ(world.step(1), Status::kOk);
  EXPECT_EQ(world.report().courses_invalid, 1U);
  EXPECT_FALSE(world.report().complete());
  EXPECT_EQ(world.get(broken)->body.p_W.x(), S(0));
  EXPECT_NEAR(world.get(other)->body.p_W.x(), -1, 1e-5);
}

// 1 kg at 1 m/s against what stands there: at 0.8 m they touch.
TYPED_TEST(Lean, SpeedThatOverflows_IsRefusedOrHeldWhereOthersMeetIt) {
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
  EXPECT_EQ(world.report().courses_invalid, 1U);
  EXPECT_EQ(world.report().time_held, S(1));
  EXPECT_FALSE(world.report().complete());
  EXPECT_EQ(world.get(held)->body.p_W, fast.body.p_W);
  EXPECT_LT(world.get(other)->body.p_W.x(), S(0.80001)) << "not passed through";
  EXPECT_GT(least_gap(world), -TestFixture::kRounding);
}

TYPED_TEST(Lean, GravityThatOverflows_HoldsTheBodyWithItsMomentum) {
  using S = typename TypeParam::Scalar;
  World<TypeParam> world;
  auto heavy = ball<TypeParam>(1, 0);
  heavy.body.inverse_mass = std::numeric_limits<S>::denorm_min();
  heavy.body.momentum_W.y() = 5;
  const auto held = world.add(heavy).value;
  const auto other = world.add(ball<TypeParam>(0, 1)).value;
  ASSERT_EQ(world.step(1), Status::kOk);
  EXPECT_EQ(world.report().courses_invalid, 1U);
  EXPECT_EQ(world.get(held)->body.p_W, heavy.body.p_W);
  EXPECT_EQ(world.get(held)->body.momentum_W.y(), S(5));
  EXPECT_EQ(world.get(held)->body.momentum_W.z(), S(0));
  EXPECT_TRUE(std::isfinite(world.get(other)->body.p_W.norm()));
}

// A heavy one at the largest speed hits a light one, which would have to be twice as fast.
TYPED_TEST(Lean, BlowBeyondTheNumbers_LeavesEveryPlaceANumber) {
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

TYPED_TEST(Lean, NinthBody_FindsNoRoom) {
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

TYPED_TEST(Lean, IdsOfAnotherWorld_NameNothing) {
  World<TypeParam> one(1);
  World<TypeParam> two(2);
  const auto id = one.add(ball<TypeParam>(0, 0)).value;
  ASSERT_TRUE(two.add(ball<TypeParam>(0, 0)).ok());
  EXPECT_NE(one.get(id), nullptr);
  EXPECT_EQ(two.get(id), nullptr);
}

TYPED_TEST(Lean, RestoredOrRead_GoesOnWithTheSameBits) {
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
struct Narrow : SceneT {
  static constexpr int kMaxContacts = 1;
};

// 0 hits 1; 1 hits 2, for which there is no room: both stop there. Then 0, which has stopped,
// stays.
TYPED_TEST(Lean, SecondContactOfOne_HoldsItsPairAndIsCounted) {
  using Scene = Narrow<TypeParam>;
  using S = typename TypeParam::Scalar;
  World<Scene> world;
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(world.add(ball<Scene>(0.5 * i, i == 0 ? 1 : 0)).ok());
  ASSERT_EQ(world.step(1), Status::kOk);
  EXPECT_EQ(world.report().collisions, 1U);
  EXPECT_EQ(world.report().contacts_dropped, 1U);
  EXPECT_FALSE(world.report().complete());
  EXPECT_NEAR(world.report().time_held, 0.4, 1e-4);
  EXPECT_NEAR(world.get(world.id_at(1))->body.p_W.x(), 0.8, 1e-4);
  EXPECT_EQ(world.get(world.id_at(2))->body.p_W.x(), S(1));
  EXPECT_GT(least_gap(world), 0);
  ASSERT_EQ(world.step(S(0.1)), Status::kOk) << "and goes on";
  EXPECT_EQ(world.report().collisions, 1U);
  EXPECT_NEAR(world.get(world.id_at(2))->body.p_W.x(), 1.1, 1e-4);
}

TYPED_TEST(Lean, CrowdsWithRoomForOneContact_NeverOverlapAndEnd) {
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

// Placed in each other by the caller and driven together: stopped by the blow, and told.
TYPED_TEST(Lean, OverlapAtTheStart_IsToldWithItsDepth) {
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
