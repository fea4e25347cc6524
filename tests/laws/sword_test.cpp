// SPDX-License-Identifier: MIT
// A sword in a world: blade, quillons and pommel, moments 7.0e-4, 0.112, 0.112 kg m^2. Whatever it
// swings at and however long the step: it flies a metre a second. And the unstable top, in a world.
#include <gtest/gtest.h>

#include <memory>

#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"
#include "euler_top.hpp"

namespace batuta::laws {
namespace {

constexpr SceneOptions armoury() {
  SceneOptions scene;
  scene.capsules_per_body = 3;
  scene.max_pairs = 9;
  return scene;
}
template <class Scalar>
using Armoury = Scene<armoury, Advancement<Scalar>>;

template <class Scalar>
class SwordIn : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SwordIn, Scalars);

struct Way {
  Real moved = 0;      ///< share of what it should be
  int incomplete = 0;  ///< steps
  Real energy = 0;     ///< largest relative change
};

/// A second of it, turning by `w_B`.
template <class Scalar>
Way fly_a_second(const Vec3<double>& w_B, double step) {
  using SceneT = Armoury<Scalar>;
  auto world = std::make_unique<World<SceneT>>();
  const auto shape = sword<Scalar>();
  Actor<SceneT> actor;
  actor.body = shape.body;
  actor.capsules_B = shape.capsules_B;
  const Twist<Scalar> twist = {Vec3<Scalar>::UnitX(), actor.body.X_WB.q_WB * w_B.cast<Scalar>()};
  actor.body.momentum = momentum_of(actor.body, twist);
  const auto id = world->add(actor).value;
  const Real before = turning_energy(top_of(world->get(id)->body));
  const auto start = static_cast<Real>(world->get(id)->body.X_WB.p_W.x());
  const auto steps = std::lround(1 / step);
  Way way;
  for (long i = 0; i < steps; ++i) {
    EXPECT_EQ(world->step(static_cast<Scalar>(step)), Status::kOk);
    way.incomplete += world->report().complete() ? 0 : 1;
    const Real now = turning_energy(top_of(world->get(id)->body));
    way.energy = std::max(way.energy, std::abs(now / before - 1));
  }
  const Real time = static_cast<Real>(steps) * static_cast<Real>(static_cast<Scalar>(step));
  way.moved = (static_cast<Real>(world->get(id)->body.X_WB.p_W.x()) - start) / time;
  return way;
}

/// About the axis of the largest moment, as in ../shared/cases, and about all three of them.
TYPED_TEST(SwordIn, EverySwingAndStep_MovesAMetreOfOne) {
  const Vec3<double> moments = moments_of_sword();
  int largest = 0;
  moments.maxCoeff(&largest);
  for (const double step : {1e-4, 1e-3, 5e-3, 1.0 / 60, 1.0 / 30}) {
    for (const double swing :
         {1.0, 2.0, 4.0, 5.0, 6.0, 8.0, 10.0, 20.0, 30.0, 60.0, 100.0, 180.0}) {
      if (swing * step > 3) continue;
      for (const Vec3<double>& axis :
           {Vec3<double>(Vec3<double>::Unit(largest)), Vec3<double>(0.6, 0.64, 0.48)}) {
        const Way way = fly_a_second<TypeParam>(swing * axis, step);
        const Real steps = 1 / step;
        EXPECT_NEAR(static_cast<double>(way.moved), 1,
                    static_cast<double>(2 + steps) * static_cast<double>(kRoundOff<TypeParam>))
            << swing << " rad/s, " << step << " s";
        EXPECT_EQ(way.incomplete, 0) << swing << " rad/s, " << step << " s";
        EXPECT_LE(way.energy, 1e-5L) << swing << " rad/s, " << step << " s";
      }
    }
  }
}

TYPED_TEST(SwordIn, UnstableTop_FlipsWhenItShould) {
  using SceneT = Armoury<TypeParam>;
  const UnstableTop top;
  const auto flips_at = top.flips();
  for (const double step : {1e-3, 1e-2}) {
    auto world = std::make_unique<World<SceneT>>();
    Actor<SceneT> actor;
    actor.body = turning<TypeParam>(top.moments, top.w_B);
    ASSERT_TRUE(actor.capsules_B.push(Capsule<TypeParam>::sphere({0, 0, 0}, TypeParam(0.1))));
    const auto id = world->add(actor).value;
    std::size_t flips = 0;
    Real last = 1;
    for (int i = 1; i * step < 20; ++i) {
      ASSERT_EQ(world->step(static_cast<TypeParam>(step)), Status::kOk);
      ASSERT_TRUE(world->report().complete());
      const Real now = top_of(std::as_const(*world).get(id)->body).b_B.y();
      if (now * last < 0) {
        ASSERT_LT(flips, flips_at.size());
        EXPECT_NEAR(i * step, flips_at[flips], 0.005 * flips_at[flips] + step) << step << " s";
        ++flips;
      }
      last = now;
    }
    EXPECT_EQ(flips, flips_at.size());
  }
}

}  // namespace
}  // namespace batuta::laws
