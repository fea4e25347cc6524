// SPDX-License-Identifier: MIT
// Laws 2 and 6 where contacts do not last: what slides along what is fixed, level and without
// friction, keeps its speed along it, because no contact has anything to give in that direction;
// and it makes each step. So does what lies still. A weld with what is fixed would take its speed.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::Vector;

constexpr double kSteps[] = {1e-4, 1e-3, 1.0 / 60, 1.0 / 30};
constexpr double kAbove = 1e-3;  ///< of what it lies on, where it is let go, m

/// What carries, along y, and what slides along it.
enum class Slide { kBallOnRod, kBallInGroove, kRodOnRails, kRodAskewOnRails };
constexpr Slide kSlides[] = {Slide::kBallOnRod, Slide::kBallInGroove, Slide::kRodOnRails,
                             Slide::kRodAskewOnRails};

template <class S>
class Sliding : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Sliding, Scalars);

template <class S>
struct Slider {
  using SceneT = test::LawScene<S, RestingContact::kNone, test::kFalling>;

  std::unique_ptr<World<SceneT>> world = std::make_unique<World<SceneT>>();
  typename World<SceneT>::BodyId id;
  double answers = 0;
  double least = 0;  ///< gap, m
  int incomplete = 0;

  Slider(Slide what, double speed) {
    constexpr double kRadius = 0.05;  // of all rods
    constexpr double kBall = 0.1;
    const double apart = what == Slide::kBallOnRod ? 0 : what == Slide::kBallInGroove ? 0.08 : 0.3;
    (void)world->add(test::fixed_rod<SceneT>(8, kRadius, {apart, 0, 0}, test::along_y()));
    if (apart > 0) {
      (void)world->add(test::fixed_rod<SceneT>(8, kRadius, {-apart, 0, 0}, test::along_y()));
    }
    const bool is_ball = what == Slide::kBallOnRod || what == Slide::kBallInGroove;
    const double reach = kRadius + (is_ball ? kBall : kRadius);
    const double z = kAbove + (is_ball ? std::sqrt(reach * reach - apart * apart) : reach);
    const bool is_askew = what == Slide::kRodAskewOnRails;
    auto body = is_ball ? test::solid_ball<SceneT>(kBall, {0, 0, z})
                        : test::solid_rod<SceneT>(
                              1, kRadius, {is_askew ? 0.1 : 0.0, 0, z},
                              test::about(Vector::UnitZ(), is_askew ? 0.3 : 0) * test::along_x());
    test::throw_body(body, {0, speed, 0});
    id = world->add(body).value;
  }
  void run(double dt, double duration) {
    least = std::numeric_limits<double>::max();
    for (double t = 0; t < duration; t += dt) {
      ASSERT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
      answers += world->report().collisions;
      incomplete += !world->report().complete();
      least = std::min(least, test::smallest_gap(std::as_const(*world)));
    }
  }
  double speed() const {
    return static_cast<double>(twist_of(std::as_const(*world).get(id)->body).v_W.y());
  }
};

/// Each answer adds an impulse whose part along y is a rounding of the normal; and to m v, which it
/// rounds.
TYPED_TEST(Sliding, WithoutFriction_KeepsItsSpeed) {
  constexpr double kRoundings = 8;  // in an answer, and in what it adds
  constexpr double kUnit = std::numeric_limits<TypeParam>::epsilon();
  for (const double speed : {0.0, 0.5, -2.0}) {
    for (const double dt : kSteps) {
      for (const Slide what : kSlides) {
        Slider<TypeParam> slider(what, speed);
        slider.run(dt, 1);
        const double given = 9.81 * dt;  // m/s, by a step's support
        EXPECT_EQ(slider.incomplete, 0) << speed << ' ' << dt << ' ' << static_cast<int>(what);
        EXPECT_NEAR(slider.speed(), speed,
                    slider.answers * kRoundings * kUnit * (std::abs(speed) + given))
            << dt << ' ' << static_cast<int>(what);
        EXPECT_GT(slider.least, 0) << speed << ' ' << dt << ' ' << static_cast<int>(what);
        EXPECT_GT(slider.answers, 10);
      }
    }
  }
}

}  // namespace
}  // namespace batuta
