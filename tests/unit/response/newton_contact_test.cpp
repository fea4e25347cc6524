// SPDX-License-Identifier: MIT
#include "newton_contact.hpp"

#include <gtest/gtest.h>

namespace batuta::test {
namespace {

constexpr int kCount = 20'000;
constexpr std::uint64_t kSeed = 14;

TEST(NewtonContact, WithoutFriction_IsThePapersImpulse) {
  int collided = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Strike strike = random_strike(kSeed, i);
    const auto hit = collision_impulse(strike.A, strike.B, strike.contact, 0.5);
    if (hit.value.v_rel >= 0) continue;
    ++collided;
    const TwistPair after = newton_contact(strike, 0.5, 0, 1);
    EXPECT_LE((after.A.v_W - hit.value.twist_A.v_W).norm(), 1e-12);
    EXPECT_LE((after.B.w_W - hit.value.twist_B.w_W).norm(), 1e-11);
  }
  EXPECT_GT(collided, 300);
}

TEST(NewtonContact, ElasticWithFriction_InventsEnergyThatTheClosedFormDoesNot) {
  const EnergyTally engines = tally_newton(1, 0.5, 50, kCount, kSeed);
  EXPECT_GT(engines.cases, kCount / 4);
  EXPECT_GT(engines.gains, engines.cases / 1000);
  EXPECT_GT(engines.worst_gain, 0.01);
  for (const double e : {0.0, 0.5, 1.0}) {
    for (const double e_t : {-1.0, 0.0, 0.5, 1.0}) {
      const EnergyTally closed = tally_closed_form({e, 0.5, e_t}, kCount, kSeed);
      EXPECT_EQ(closed.cases, engines.cases);
      EXPECT_EQ(closed.gains, 0) << closed.worst_gain;
    }
  }
  RecordProperty("newton_gains", engines.gains);
  RecordProperty("newton_cases", engines.cases);
}

}  // namespace
}  // namespace batuta::test
