// SPDX-License-Identifier: MIT
// The chord of a bent turn (src/mechanics/motion.md, "The energy on the chord"): who leaves its
// flight between the ends of a step comes back to it, and a sword that is struck there wins next to
// no energy by it. Truths: both energies are computed from poses and momenta, in long double.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "batuta/world/make_actor.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"
#include "choices.hpp"
#include "euler_top.hpp"

namespace batuta::laws {
namespace {

template <class Scalar>
class BentTurns : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
constexpr double kStep = 0.01;  // s
TYPED_TEST_SUITE(BentTurns, Scalars);

/// A body with three unlike moments that turns by `speed` about any axis.
template <class Scalar>
Body<Scalar> any_top(test::Choices& draw, double speed) {
  // Of matter: no moment is more than the sum of the other two.
  const Vec3<double> squares(draw.between(0.02, 1), draw.between(0.02, 1), draw.between(0.02, 1));
  const Vec3<double> moments = Vec3<double>::Constant(squares.sum()) - squares;
  Body<Scalar> body = make_body<Scalar>({Vec3<Scalar>::Zero(), draw.rotation().cast<Scalar>()},
                                        Scalar(1), moments.cast<Scalar>())
                          .value;
  const Vec3<double> axis = draw.in_cube().normalized();
  body.momentum =
      momentum_of(body, Twist<Scalar>{Vec3<Scalar>::Zero(), (speed * axis).cast<Scalar>()});
  return body;
}

// Left on the chord of a turn of up to a quarter of a radian, as a world's are, a body comes back
// to the energy of its flight within as far a turn, and on the way it is never further off.
TYPED_TEST(BentTurns, LeftOnTheChord_FlightIsFoundAgain) {
  const Real most = sizeof(TypeParam) == 4 ? 1e-6L : 3e-12L;
  test::Choices draw(2026);
  for (int i = 0; i < 2000; ++i) {
    Body<TypeParam> body = any_top<TypeParam>(draw, 1);
    const Real before = turning_energy(top_of(body));
    const auto turn = static_cast<TypeParam>(draw.between(0.01, 0.25));
    const auto off = [&] { return std::abs(turning_energy(top_of(body)) / before - 1); };
    move_along(body, free_flight(body, turn),
               static_cast<TypeParam>(draw.between(0.1, 0.9)) * turn);
    for (int k = 0; k < 8; ++k) {
      const Real was = off();
      move_along(body, free_flight(body, turn / 8), turn / 8);
      EXPECT_LE(off(), std::max(was, most)) << i;
    }
    EXPECT_LE(off(), most) << i;
  }
}

template <RestingContact kResting, int kMaxContacts>
constexpr SceneOptions striking() {
  SceneOptions scene;
  scene.capsules_per_body = 3;
  scene.max_pairs = 9;
  scene.max_contacts = kMaxContacts;
  scene.restitution = true;
  scene.resting = kResting;
  return scene;
}
template <class Scalar, RestingContact kResting, int kMaxContacts = 8>
using Striking = Scene<striking<kResting, kMaxContacts>, Advancement<Scalar>>;

template <class SceneT>
Real energy_of(const World<SceneT>& world) {
  Real energy = 0;
  for (std::uint16_t slot = 0; slot < SceneT::kMaxBodies; ++slot) {
    const auto& body = world.get(world.id_at(slot))->body;
    energy += turning_energy(top_of(body));
    energy += static_cast<Real>(body.inverse_mass) *
              body.momentum.linear_W.template cast<Real>().squaredNorm() / 2;
  }
  return energy;
}

/// The sword of the laws, or the one capsule of its blade, that turns by `turn` in a step about any
/// axis.
/// @param thinness  times which its least moment is less than that of the laws
template <class SceneT>
Actor<SceneT> turning_sword(test::Choices& draw, double turn, double thinness) {
  using Scalar = typename SceneT::Scalar;
  const auto shape = sword<Scalar>();
  Actor<SceneT> actor;
  actor.body = shape.body;
  Eigen::Index thin = 0;
  actor.body.inverse_moments.maxCoeff(&thin);
  actor.body.inverse_moments[thin] *= static_cast<Scalar>(thinness);
  if constexpr (SceneT::kCapsulesPerBody > 1) {
    actor.capsules_B = shape.capsules_B;
  } else {
    actor.capsule_B = shape.capsules_B[0];
  }
  const Vec3<double> w_W = (turn / kStep) * draw.in_cube().normalized();
  actor.body.X_WB.q_WB = draw.rotation().template cast<Scalar>();
  actor.body.momentum =
      momentum_of(actor.body, Twist<Scalar>{Vec3<Scalar>::Zero(), w_W.cast<Scalar>()});
  return actor;
}

template <class SceneT>
Actor<SceneT> elastic_ball(double radius, double density, const Vec3<double>& place,
                           const Vec3<double>& speed) {
  using Scalar = typename SceneT::Scalar;
  const Capsule<Scalar> round = {{Vec3<Scalar>::Zero(), Vec3<Scalar>::Zero()},
                                 static_cast<Scalar>(radius)};
  auto ball =
      make_actor<SceneT>(round, static_cast<Scalar>(density), {place.cast<Scalar>(), {1, 0, 0, 0}},
                         {speed.cast<Scalar>(), Vec3<Scalar>::Zero()});
  ball.value.restitution = 1;
  return ball.value;
}

struct Struck {
  int blows = 0;     ///< steps with one
  int together = 0;  ///< steps in which the two went on together instead
  Real gained = 0;   ///< most of a step, of what there was
};

/// A sword that turns by `turn` in a step, and a ball somewhere in its way; one step of each.
template <class SceneT>
Struck strike_balls(double turn, int tries, double thinness) {
  Struck struck;
  test::Choices draw(7);
  for (int i = 0; i < tries; ++i) {
    auto world = std::make_unique<World<SceneT>>();
    auto actor = turning_sword<SceneT>(draw, turn, thinness);
    actor.restitution = 1;
    (void)world->add(actor).value;
    const Vec3<double> place = 0.5 * draw.in_cube();
    (void)world->add(elastic_ball<SceneT>(0.1, 50, place, Vec3<double>::Zero())).value;
    const Real before = energy_of(*world);
    EXPECT_EQ(world->step(static_cast<typename SceneT::Scalar>(kStep)), Status::kOk);
    const auto& report = world->report();
    const bool is_met = report.collisions > 0 || report.contacts_dropped > 0;
    if (!is_met || report.overlaps_at_start > 0) continue;
    struck.blows += report.collisions > 0 ? 1 : 0;
    struck.together += report.contacts_dropped > 0 ? 1 : 0;
    struck.gained = std::max(struck.gained, energy_of(*world) / before - 1);
  }
  return struck;
}

/// What law 3 allows of the energy of the turn, which is all that there is (src/world/world.md).
constexpr Real kOfChord = 1 / 1024.0L;

TYPED_TEST(BentTurns, StruckOnTheChord_NothingIsWon) {
  constexpr double kSword = 1;  // moments 1 : 160
  for (const double turn : {0.2, 0.6, 1.2, 2.0, 2.8}) {
    const Struck free =
        strike_balls<Striking<TypeParam, RestingContact::kNone>>(turn, 3000, kSword);
    const Struck lasting =
        strike_balls<Striking<TypeParam, RestingContact::kSettling>>(turn, 3000, kSword);
    EXPECT_GE(std::min(free.blows, lasting.blows), 30) << turn;
    EXPECT_LE(free.gained, kOfChord) << turn << " rad";
    EXPECT_LE(lasting.gained, kOfChord) << turn << " rad";
    EXPECT_LE(free.together + lasting.together, 40) << turn << " rad";
  }
}

// Where the cuts of a step do not suffice, because there are few or the body is thin, the two go on
// together from where the sword is still on its flight, and that is told.
TYPED_TEST(BentTurns, CutsUsedUp_NothingIsWonAndItIsTold) {
  using FewSeparated = Striking<TypeParam, RestingContact::kSeparation, 1>;
  using FewSettled = Striking<TypeParam, RestingContact::kSettling, 1>;
  for (const double thinness : {1.0, 10.0, 100.0}) {
    int together = 0;
    for (const double turn : {0.1, 0.4, 1.2, 2.0}) {
      const Struck separated = strike_balls<FewSeparated>(turn, 1000, thinness);
      const Struck settled = strike_balls<FewSettled>(turn, 1000, thinness);
      EXPECT_LE(separated.gained, kOfChord) << "1 : " << 160 * thinness << ", " << turn << " rad";
      EXPECT_LE(settled.gained, kOfChord) << "1 : " << 160 * thinness << ", " << turn << " rad";
      together += separated.together + settled.together;
    }
    EXPECT_GT(together, 0) << "1 : " << 160 * thinness;
  }
}

constexpr int kSwords = 4;
constexpr int kBalls = 4;

template <RestingContact kResting, int kCapsules>
constexpr SceneOptions crowd() {
  SceneOptions scene;
  scene.max_bodies = kSwords + kBalls;
  scene.capsules_per_body = kCapsules;
  scene.max_pairs = 256;
  scene.max_contacts = 16;
  scene.resting = kResting;
  return scene;
}
template <class Scalar, RestingContact kResting, int kCapsules>
using Crowd = Scene<crowd<kResting, kCapsules>, Advancement<Scalar>>;

/// Swords and balls that fly; one step of each crowd. @returns the most that a blow won, of what
/// there was, in steps that are complete
template <class SceneT>
Struck strike_each_other(double turn, int tries, double thinness) {
  Struck struck;
  test::Choices draw(7);
  for (int i = 0; i < tries; ++i) {
    auto world = std::make_unique<World<SceneT>>();
    for (int k = 0; k < kSwords; ++k) {
      auto actor = turning_sword<SceneT>(draw, turn, thinness);
      actor.restitution = static_cast<typename SceneT::Scalar>(draw.share());
      actor.body.X_WB.p_W = (0.6 * draw.in_cube()).cast<typename SceneT::Scalar>();
      (void)world->add(actor).value;
    }
    for (int k = 0; k < kBalls; ++k) {
      const Vec3<double> place = 0.6 * draw.in_cube();
      const Vec3<double> speed = 10 * turn * draw.in_cube();
      (void)world->add(elastic_ball<SceneT>(0.05, 500, place, speed)).value;
    }
    const Real before = energy_of(*world);
    EXPECT_EQ(world->step(static_cast<typename SceneT::Scalar>(kStep)), Status::kOk);
    const auto& report = world->report();
    const int blows = static_cast<int>(report.collisions);
    if (report.overlaps_at_start > 0 || !report.complete() || blows == 0) continue;
    ++struck.blows;
    struck.gained = std::max(struck.gained, (energy_of(*world) / before - 1) / blows);
  }
  return struck;
}

// Also who is met after others were, on a course that is older than the blow before, and who has
// one capsule only.
TYPED_TEST(BentTurns, ManyThatTurnFar_NothingIsWon) {
  for (const double thinness : {0.05, 1.0, 10.0}) {
    for (const double turn : {0.2, 0.6, 2.0, 2.8}) {
      const Struck some[] = {
          strike_each_other<Crowd<TypeParam, RestingContact::kNone, 3>>(turn, 400, thinness),
          strike_each_other<Crowd<TypeParam, RestingContact::kSettling, 3>>(turn, 400, thinness),
          strike_each_other<Crowd<TypeParam, RestingContact::kSeparation, 1>>(turn, 400, thinness)};
      for (const Struck& struck : some) {
        EXPECT_GE(struck.blows, 5) << "1 : " << 160 * thinness << ", " << turn << " rad";
        EXPECT_LE(struck.gained, kOfChord) << "1 : " << 160 * thinness << ", " << turn << " rad";
      }
    }
  }
}

constexpr SceneOptions two_needles() {
  SceneOptions scene;
  scene.max_contacts = 16;
  scene.resting = RestingContact::kSettling;
  return scene;
}
using Needles = Scene<two_needles, Advancement<float>>;

/// To the last bit: add() renews the quaternion.
void add_exactly(World<Needles>& world, const Body<float>& body, const Capsule<float>& capsule_B) {
  Actor<Needles> actor;
  actor.body = body;
  actor.capsule_B = capsule_B;
  actor.restitution = 0.313F;
  const auto id = world.add(actor);
  ASSERT_TRUE(id.ok());
  world.get(id.value)->body.X_WB = body.X_WB;
}

// A contact at the very end of a course that was cut for it: what was planned from there for no
// time is planned anew for the rest. (It flew on by the twist of the moment, and had 30 times its
// energy.)
TEST(BentTurnsOfNeedles, StruckWhereTheCourseEnds_GoOnOnTheirFlight) {
  World<Needles> world;
  Body<float> body;
  body.inverse_mass = 0x1.fffbe8p-1F;
  body.X_WB.p_W = {-0x1.3db55ap-5F, 0x1.30333p-5F, -0x1.985538p-4F};
  body.X_WB.q_WB = {0x1.de9e36p-1F, 0x1.fb23c6p-4F, -0x1.957b6ep-3F, -0x1.1209bcp-2F};
  body.momentum.angular_W = {0x1.2438c4p-2F, 0x1.2292a6p-1F, 0x1.c20888p-3F};
  body.inverse_moments = {0x1.f832eap+6F, 0x1.f8354cp+6F, 0x1.736856p+22F};
  add_exactly(world, body,
              {{{0x1.25f9c8p-2F, 0x1.59a458p-4F, -0x1.d29d9ep-3F},
                {-0x1.d2a6aap-4F, 0x1.35ab2ap-4F, 0x1.0f73c8p-3F}},
               0x1.664ccep-7F});
  body.inverse_mass = 0x1.fffb44p-1F;
  body.X_WB.p_W = {0x1.93eed2p-4F, -0x1.649754p-5F, -0x1.8e7814p-4F};
  body.X_WB.q_WB = {0x1.a275ep-3F, 0x1.a3659ap-1F, 0x1.7250e8p-2F, -0x1.95147ap-2F};
  body.momentum.angular_W = {0x1.8514e8p-4F, 0x1.9560bap-4F, -0x1.1e915p-3F};
  body.inverse_moments = {0x1.ae271ap+8F, 0x1.37512cp+18F, 0x1.ada2d4p+8F};
  add_exactly(world, body,
              {{{0x1.5212p-5F, 0x1.64942ap-7F, -0x1.258e5ap-3F},
                {0x1.5212p-5F, 0x1.64942ap-7F, 0x1.0bc6f6p-4F}},
               0x1.af9cdcp-7F});
  std::uint32_t blows = 0;
  for (int k = 0; k < 3; ++k) {
    const Real before = energy_of(world);
    ASSERT_EQ(world.step(0.01F), Status::kOk);
    blows += world.report().collisions;
    EXPECT_LE(energy_of(world) / before - 1, kOfChord) << k;
  }
  EXPECT_GT(blows, 0U);
}

}  // namespace
}  // namespace batuta::laws
