// SPDX-License-Identifier: MIT
#include "batuta/fencing/feet.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "draws.hpp"

namespace batuta {
using namespace fencing;
namespace {

template <class S>
class FeetOf : public ::testing::Test {
 protected:
  static constexpr FeetRoom<S> kWide{S(100), S(100)};
  const FeetSettings<S> settings;
  Feet<S> feet;
  void run(double order, int steps, const FeetRoom<S>& room = kWide) {
    for (int i = 0; i < steps; ++i)
      feet.advance(this->settings, static_cast<S>(order), room, S(1e-3));
  }
  double way() const { return static_cast<double>(feet.way()); }
  double velocity() const { return static_cast<double>(feet.velocity()); }
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(FeetOf, Scalars);

// From rest to a speed v with acceleration a: v^2 / 2a in v / a; from then on steadily.
TYPED_TEST(FeetOf, AdvanceAndRetreat_AreThoseOfConstantAcceleration) {
  for (const auto& [order, speed] : {std::pair{1.0, 1.5}, {-1.0, -1.8}, {0.5, 0.75}}) {
    this->feet.stand();
    const double ramp = std::abs(speed) / 14;
    this->run(order, 50);
    EXPECT_NEAR(this->velocity(), speed > 0 ? std::min(14 * 0.05, speed) : -14 * 0.05, 1e-5);
    this->run(order, 450);
    EXPECT_NEAR(this->velocity(), speed, 1e-6);
    EXPECT_NEAR(this->way(), speed * (0.5 - ramp / 2), 2e-5 + std::abs(speed) * 1e-3);
  }
}

TYPED_TEST(FeetOf, LetGo_TheyStandAfterTheirStoppingWay) {
  this->run(1, 300);
  const double before = this->way();
  const auto stopping = static_cast<double>(this->feet.stopping_way(this->settings));
  EXPECT_NEAR(stopping, 1.5 * 1.5 / 28, 1e-6);
  this->run(0, 200);
  EXPECT_EQ(this->velocity(), 0);
  EXPECT_NEAR(this->way() - before, stopping, 1e-3) << "and what a step adds";
  this->run(-1, 10);
  EXPECT_EQ(this->feet.stopping_way(this->settings), 0) << "backward is not forward";
}

/// The room on a strip shrinks as the feet go: never beyond it, never slowed down harder than they
/// can, whatever the orders and the steps are.
TYPED_TEST(FeetOf, AnyOrders_StayInTheRoom_WithBoundedAcceleration) {
  using S = TypeParam;
  test::Draws draws(11, 12, 13);
  for (int round = 0; round < 200; ++round) {
    this->feet.stand();
    const double ahead = draws.between(0, 0.4);
    const double behind = draws.between(0, 0.4);
    const double dt = draws.between(1e-4, 20e-3);
    double order = 0;
    for (int i = 0; i < 400; ++i) {
      if (i % 37 == 0) order = draws.unit() < 0.5 ? -1 : 1;
      if (i % 61 == 0) order = draws.signed_unit();
      const double before = this->velocity();
      const double from = this->way();
      const FeetRoom<S> room{static_cast<S>(ahead - from), static_cast<S>(behind + from)};
      this->feet.advance(this->settings, static_cast<S>(order), room, static_cast<S>(dt));
      ASSERT_LE(std::abs(this->velocity() - before), 14 * dt * (1 + 1e-3) + 1e-4);
      ASSERT_LE(this->way(), ahead + 1e-6);
      ASSERT_GE(this->way(), -behind - 1e-6);
      ASSERT_LE(this->velocity(), 1.5);
      ASSERT_GE(this->velocity(), -1.8);
      // C1: the way is that of the mean velocity, but for what stops within a step.
      ASSERT_LE(std::abs(this->way() - from - (before + this->velocity()) * dt / 2),
                14 * dt * dt / 8 + 1e-6);
    }
  }
}

TYPED_TEST(FeetOf, AllTheRoom_IsUsed) {
  double left = 0.5;
  for (int i = 0; i < 2000; ++i) {
    const double before = this->way();
    this->run(1, 1, {static_cast<TypeParam>(left), TypeParam(0)});
    left -= this->way() - before;
  }
  EXPECT_NEAR(left, 0, 1e-5);
  EXPECT_NEAR(this->velocity(), 0, 1e-2);
}

TYPED_TEST(FeetOf, NoRoom_TheyStand) {
  this->run(1, 100, {});
  this->run(-1, 100, {});
  this->run(1, 100, {TypeParam(-3), TypeParam(-2)});
  EXPECT_EQ(this->way(), 0);
  EXPECT_EQ(this->velocity(), 0);
}

/// Two who do as they like, and never come nearer than they may; nor does either brake harder than
/// he can, though each learns of the other's steps only afterwards.
TYPED_TEST(FeetOf, TwoFencers_NeverPassEachOther) {
  using S = TypeParam;
  test::Draws draws(21, 22, 23);
  double closest = 1;
  for (int round = 0; round < 100; ++round) {
    std::array<Feet<S>, 2> both;
    const double dt = draws.between(1e-4, 20e-3);
    std::array<double, 2> orders{1, 1};
    for (int i = 0; i < 600; ++i) {
      if (i % 43 == 0) orders = {draws.unit() < 0.7 ? 1.0 : -1.0, draws.unit() < 0.7 ? 1.0 : -1.0};
      const std::array<double, 2> before = {static_cast<double>(both[0].velocity()),
                                            static_cast<double>(both[1].velocity())};
      const S between = S(0.75) - both[0].way() - both[1].way();
      ASSERT_GE(static_cast<double>(between), -2e-6);
      closest = std::min(closest, static_cast<double>(between));
      const auto rooms =
          rooms_of<S>(both, this->settings, between, {S(5) + both[0].way(), S(5) + both[1].way()});
      for (std::size_t k = 0; k < 2; ++k) {
        both[k].advance(this->settings, static_cast<S>(orders[k]), rooms[k], static_cast<S>(dt));
        ASSERT_LE(std::abs(static_cast<double>(both[k].velocity()) - before[k]),
                  14 * dt * (1 + 1e-3) + 1e-4);
      }
    }
  }
  EXPECT_LT(closest, 1e-3) << "or they never met";
}

TYPED_TEST(FeetOf, SettingsOutOfRange_AreRefused) {
  using S = TypeParam;
  const S nan = std::numeric_limits<S>::quiet_NaN();
  const auto refused = [](auto change) {
    FeetSettings<S> bad;
    change(bad);
    return validate(bad) == Status::kInvalidArgument;
  };
  EXPECT_EQ(validate(this->settings), Status::kOk);
  for (const S bad : {S(0), S(-1), nan, S(1e6)}) {
    EXPECT_TRUE(refused([bad](auto& s) { s.forward_speed = bad; }));
    EXPECT_TRUE(refused([bad](auto& s) { s.backward_speed = bad; }));
    EXPECT_TRUE(refused([bad](auto& s) { s.acceleration = bad; }));
  }
}

}  // namespace
}  // namespace batuta
