// SPDX-License-Identifier: MIT
// The chord of a bent turn (src/mechanics/motion.md, "The energy on the chord"): who leaves its
// flight between the ends of a step comes back to it, and a sword that is struck there wins next to
// no energy by it. Truths: both energies are computed from poses and momenta, in long double.
#include <gtest/gtest.h>

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
TYPED_TEST_SUITE(BentTurns, Scalars);

/// A body with three unlike moments that turns by `speed` about any axis.
template <class Scalar>
Body<Scalar> any_top(test::Choices& draw, double speed) {
  // Of matter: no moment is more than the sum of the other two.
  const Vec3<double> squares(draw.between(0.02, 1), draw.between(0.02, 1), draw.between(0.02, 1));
  const Vec3<double> moments = Vec3<double>::Constant(squares.sum()) - squares;
  Body<Scalar> body =
      make_body<Scalar>({{}, draw.rotation().cast<Scalar>()}, Scalar(1), moments.cast<Scalar>())
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

constexpr SceneOptions striking(RestingContact resting) {
  SceneOptions scene;
  scene.capsules_per_body = 3;
  scene.max_pairs = 9;
  scene.restitution = true;
  scene.resting = resting;
  return scene;
}
constexpr SceneOptions blows() {
  return striking(RestingContact::kNone);
}
constexpr SceneOptions settled() {
  return striking(RestingContact::kSettling);
}

template <class SceneT>
Real energy_of(const World<SceneT>& world) {
  Real energy = 0;
  for (std::uint16_t slot = 0; slot < 2; ++slot) {
    const auto& body = world.get(world.id_at(slot))->body;
    energy += turning_energy(top_of(body));
    energy += static_cast<Real>(body.inverse_mass) *
              body.momentum.linear_W.template cast<Real>().squaredNorm() / 2;
  }
  return energy;
}

struct Struck {
  int blows = 0;
  Real gained = 0;  ///< most of a step, of what there was
};

/// A sword that turns by `turn` in a step, and a ball somewhere in its way; one step of each.
template <class SceneT>
Struck strike_balls(double turn, int tries) {
  using Scalar = typename SceneT::Scalar;
  constexpr Scalar kStep = Scalar(0.01);
  Struck struck;
  test::Choices draw(7);
  for (int i = 0; i < tries; ++i) {
    auto world = std::make_unique<World<SceneT>>();
    const auto shape = sword<Scalar>();
    Actor<SceneT> actor;
    actor.body = shape.body;
    actor.capsules_B = shape.capsules_B;
    actor.restitution = 1;
    const Vec3<double> w_W = (turn / static_cast<double>(kStep)) * draw.in_cube().normalized();
    actor.body.X_WB.q_WB = draw.rotation().template cast<Scalar>();
    actor.body.momentum =
        momentum_of(actor.body, Twist<Scalar>{Vec3<Scalar>::Zero(), w_W.cast<Scalar>()});
    (void)world->add(actor).value;
    const Capsule<Scalar> round = {{Vec3<Scalar>::Zero(), Vec3<Scalar>::Zero()}, Scalar(0.1)};
    const Vec3<double> place = 0.5 * draw.in_cube();
    auto ball = make_actor<SceneT>(round, Scalar(50), {place.cast<Scalar>(), {1, 0, 0, 0}}, {});
    ball.value.restitution = 1;
    (void)world->add(ball.value).value;
    const Real before = energy_of(*world);
    EXPECT_EQ(world->step(kStep), Status::kOk);
    const bool is_struck = !world->events().empty() && world->report().overlaps_at_start == 0;
    if (!is_struck) continue;
    ++struck.blows;
    struck.gained = std::max(struck.gained, energy_of(*world) / before - 1);
  }
  return struck;
}

/// What law 3 allows of the energy of the turn, which is all that there is (src/world/world.md).
constexpr Real kOfChord = 1 / 1024.0L;

TYPED_TEST(BentTurns, StruckOnTheChord_NothingIsWon) {
  for (const double turn : {0.2, 0.6, 1.2, 2.0, 2.8}) {
    const Struck free = strike_balls<Scene<blows, Advancement<TypeParam>>>(turn, 3000);
    const Struck lasting = strike_balls<Scene<settled, Advancement<TypeParam>>>(turn, 3000);
    EXPECT_GE(std::min(free.blows, lasting.blows), 30) << turn;
    EXPECT_LE(free.gained, kOfChord) << turn << " rad";
    EXPECT_LE(lasting.gained, kOfChord) << turn << " rad";
  }
}

}  // namespace
}  // namespace batuta::laws
