// SPDX-License-Identifier: MIT
// Who sleeps costs nothing, and wakes when something happens to it.
#include <gtest/gtest.h>

#include "resting.hpp"

namespace batuta {
namespace {

template <class S>
class Asleep : public ::testing::Test {
 protected:
  World<test::SleepyScene<S>> world;

  void SetUp() override {
    test::pile_up(world, test::Pile::kAcross, 1e-4);
    run(static_cast<int>(2 * static_cast<double>(SceneOptions{}.sleep_time) / test::kTick));
    ASSERT_TRUE(sleeps(0));
  }
  void run(int steps) {
    for (int i = 0; i < steps; ++i) {
      ASSERT_EQ(world.step(static_cast<S>(test::kTick)), Status::kOk);
      ASSERT_TRUE(world.report().complete());
      ASSERT_GT(test::least_gap<test::SleepyScene<S>>(world), 0);
    }
  }
  bool sleeps(int slot) const {
    return world.is_asleep(world.id_at(static_cast<std::uint16_t>(slot)));
  }
  Body<S>& body(int slot) { return world.get(world.id_at(static_cast<std::uint16_t>(slot)))->body; }
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Asleep, Scalars);

TYPED_TEST(Asleep, Undisturbed_CostsNoSearchAndStaysToTheLastBit) {
  const auto before = this->body(0).X_WB;
  this->run(1);
  for (int i = 0; i < 1000; ++i) {
    this->run(1);
    ASSERT_EQ(this->world.report().asleep, 1U);
    ASSERT_EQ(this->world.report().pairs, 0U);
    ASSERT_EQ(this->world.report().evaluations, 0U);
    ASSERT_EQ(this->world.events().size(), 0);
  }
  EXPECT_EQ(this->body(0).X_WB.p_W, before.p_W);
  EXPECT_EQ(this->body(0).X_WB.q_WB.coeffs(), before.q_WB.coeffs());
}

TYPED_TEST(Asleep, Hit_Wakes) {
  auto ball = test::ball_at<test::SleepyScene<TypeParam>>({0, 0, 0.2}, 0.05);
  ball.body.momentum.linear_W = test::vector<TypeParam>(0, 0.1, -1);
  ASSERT_TRUE(this->world.add(ball).ok());
  this->run(50);
  EXPECT_TRUE(this->sleeps(0));  // not there yet
  this->run(150);
  EXPECT_FALSE(this->sleeps(0));
}

TYPED_TEST(Asleep, SupportRemoved_WakesAndFalls) {
  ASSERT_EQ(this->world.remove(this->world.id_at(1)), Status::kOk);
  EXPECT_FALSE(this->sleeps(0));
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(this->world.step(static_cast<TypeParam>(test::kTick)), Status::kOk);
  }
  EXPECT_LT(test::seen(*this->world.get(this->world.id_at(0))).axis.a.z(), 0.01);  // tilts down
}

TYPED_TEST(Asleep, SupportMovedAway_WakesAndFalls) {
  this->body(1).X_WB.p_W.z() -= TypeParam(0.1);
  this->body(2).X_WB.p_W.z() -= TypeParam(0.1);
  this->run(100);
  EXPECT_FALSE(this->sleeps(0));
  EXPECT_NEAR(this->body(0).momentum.linear_W.z(), -9.81 * 0.1, 2 * 9.81 * test::kTick);
}

TYPED_TEST(Asleep, GivenAMomentum_WakesAndGoes) {
  this->body(0).momentum.linear_W.z() = TypeParam(1);
  this->run(20);
  EXPECT_FALSE(this->sleeps(0));
  EXPECT_GT(this->body(0).X_WB.p_W.z(), TypeParam(0.02 + 0.015));
}

TYPED_TEST(Asleep, SetElsewhere_WakesAndFalls) {
  this->body(0).X_WB.p_W.z() += TypeParam(0.1);
  this->run(20);
  EXPECT_FALSE(this->sleeps(0));
  EXPECT_LT(this->body(0).momentum.linear_W.z(), TypeParam(-0.15));
}

}  // namespace
}  // namespace batuta
