// SPDX-License-Identifier: MIT
// Law 3 for a free body of any moments: its energy stays, for an hour and in every step; and what
// it remembers of its flight ends where the flight does.
#include <gtest/gtest.h>

#include "batuta/record/snapshot.hpp"
#include "batuta/record/world.hpp"
#include "draws.hpp"
#include "euler_top.hpp"

namespace batuta::laws {
namespace {

template <class Scalar>
class FlightEnergyOf : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(FlightEnergyOf, Scalars);

#ifndef BATUTA_REST_SECONDS
#define BATUTA_REST_SECONDS 3600
#endif
constexpr long kHour = 1000L * BATUTA_REST_SECONDS;  ///< steps of 1 ms

/// Relative to the start; the mean of each tenth of the time.
struct Drift {
  Real worst = 0;
  std::array<Real, 10> tenths{};
};

template <class Scalar>
Drift fly_for_an_hour(Body<Scalar> body) {
  Drift drift;
  const Real before = turning_energy(top_of(body));
  for (long i = 0; i < kHour; ++i) {
    if (!fly(body, Scalar(1e-3))) return {1, {}};
    const Real change = turning_energy(top_of(body)) / before - 1;
    drift.worst = std::max(drift.worst, std::abs(change));
    drift.tenths[static_cast<std::size_t>(i * 10 / kHour)] += change * 10 / kHour;
  }
  return drift;
}

// An hour at 1 kHz and 10 rad/s. No trend: no tenth of it has another mean than the first, to
// within what the energy of one rounded orientation is known to.
TYPED_TEST(FlightEnergyOf, Hour_LeavesIt) {
  const Real most = sizeof(TypeParam) == 4 ? 1e-4L : 1e-9L;
  const Vec3<double> all(5, 7, 5.099);
  for (const Vec3<double>& moments : {Vec3<double>(1, 2, 3), moments_of_sword()}) {
    const Drift drift = fly_for_an_hour(turning<TypeParam>(moments, all));
    EXPECT_LE(drift.worst, most) << text(moments);
    for (const Real mean : drift.tenths) {
      EXPECT_LE(std::abs(mean - drift.tenths[0]), 2 * static_cast<Real>(kRoundOff<TypeParam>));
    }
  }
}

// Whatever the moments, no step that turns by 0.1 rad or less changes the energy by more than 1e-5,
// nor does the way it came to that step.
TYPED_TEST(FlightEnergyOf, EveryStep_LeavesIt) {
  test::Draws draws(3, 1, 4);
  for (int i = 0; i < 3000; ++i) {
    Vec3<double> part;
    for (int k = 0; k < 3; ++k) part[k] = std::exp(draws.between(-2.5, 2.5));
    const Vec3<double> moments = Vec3<double>::Constant(part.sum()) - part;  // those of a body
    auto body = turning<TypeParam>(moments, draws.between(0.001, 0.1) * draws.direction());
    for (int step = 0; step < 5; ++step) {
      const Real before = turning_energy(top_of(body));
      ASSERT_TRUE(fly(body, TypeParam(1)));
      EXPECT_NEAR(static_cast<double>(turning_energy(top_of(body)) / before), 1, 1e-5)
          << text(moments);
    }
  }
}

// A weak push a step, far below what a flight would be told from another one by its energy alone:
// the body is as fast as the pushes made it.
TYPED_TEST(FlightEnergyOf, WeakPushes_AreNotForgotten) {
  auto body = turning<TypeParam>({1, 2, 3}, {5, 7, 5});
  const Real before = turning_energy(top_of(body));
  Real factor = 1;
  for (int i = 0; i < 1000; ++i) {
    const WideVec b = body.momentum.angular_W.template cast<Real>();
    body.momentum.angular_W *= TypeParam(1) + TypeParam(2e-6);
    factor *= body.momentum.angular_W.template cast<Real>().norm() / b.norm();
    ASSERT_TRUE(fly(body, TypeParam(1e-3)));
  }
  EXPECT_GT(factor, 1.0019L);
  EXPECT_NEAR(static_cast<double>(turning_energy(top_of(body)) / before / (factor * factor)), 1,
              1000 * 4 * static_cast<double>(kRoundOff<TypeParam>));
}

// Somebody takes the body and puts it down turned: it flies on from there.
TYPED_TEST(FlightEnergyOf, BodyTurnedByHand_HasTheEnergyOfItsNewOrientation) {
  auto body = turning<TypeParam>({1, 2, 3}, {5, 7, 5});
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(fly(body, TypeParam(1e-3)));
  const Quat<TypeParam> by_hand = exp_map(Vec3<TypeParam>(0, TypeParam(0.3), 0));
  body.X_WB.q_WB = renewed(Quat<TypeParam>(by_hand * body.X_WB.q_WB));
  const Top start = top_of(body);
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(fly(body, TypeParam(1e-3)));
  const Top truth = turned(start, 1000 * static_cast<Real>(TypeParam(1e-3)));
  EXPECT_LE(angle_between(body.X_WB.q_WB, truth.q_WB), sizeof(TypeParam) == 4 ? 1e-4L : 1e-8L);
}

// A contact within a step: the body is on the twist that joins both ends then, off its energy by
// the second order. Where it goes on with the same momentum it is on it again at the end, to the
// square of that.
TYPED_TEST(FlightEnergyOf, StepInTwoPieces_EndsWithTheEnergyOfTheFlight) {
  auto body = turning<TypeParam>({1, 2, 3}, {5, 7, 5});
  const Real before = turning_energy(top_of(body));
  const auto step = TypeParam(0.01);
  Real off = 0;
  for (int i = 0; i < 100; ++i) {
    const Motion<TypeParam> motion = free_flight(body, step);
    move_along(body, motion, TypeParam(0.4) * step);
    off = std::max(off, std::abs(turning_energy(top_of(body)) / before - 1));
    ASSERT_TRUE(fly(body, TypeParam(0.6) * step));
    EXPECT_NEAR(static_cast<double>(turning_energy(top_of(body)) / before), 1, 1e-6);
  }
  EXPECT_GT(off, 1e-5L) << "nothing to be made good";
}

// What is saved goes on with the same bits.
TYPED_TEST(FlightEnergyOf, RestoredBody_FliesOnWithTheSameBits) {
  struct State {
    Body<TypeParam> body;
    void archive(Archive& ar) { ar(body); }
  };
  for (const Vec3<double>& moments : {Vec3<double>(1, 2, 3), Vec3<double>(1, 2, 2)}) {
    State state = {turning<TypeParam>(moments, {5, 7, 5})};
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(fly(state.body, TypeParam(1e-3)));
    std::array<std::uint8_t, kSnapshotRoom<State>> bytes{};
    const auto size = save(state, bytes.data(), static_cast<int>(bytes.size()));
    ASSERT_TRUE(size.ok());
    State other;
    ASSERT_EQ(restore(other, bytes.data(), size.value), Restored::kOk);
    for (int i = 0; i < 100; ++i) {
      ASSERT_TRUE(fly(state.body, TypeParam(1e-3)));
      ASSERT_TRUE(fly(other.body, TypeParam(1e-3)));
      EXPECT_EQ(state.body.X_WB.q_WB.coeffs(), other.body.X_WB.q_WB.coeffs());
    }
    EXPECT_EQ(hash_of(state), hash_of(other));
  }
}

// Moments that no body of matter has (one more than the other two together), and an axis that is
// locked: the flight keeps its energy as well as it does elsewhere, or is none.
TYPED_TEST(FlightEnergyOf, MomentsOfNoMatter_WinNothing) {
  constexpr int kTries = 20000;
  constexpr Real kMost = 1 / 1024.0L;
  test::Draws draws(3, 1, 6);
  int flown = 0;
  int refused = 0;
  for (int i = 0; i < kTries; ++i) {
    const double second = draws.power_of_two(-6, 0);
    const double third =
        draws.chance(0.5) ? std::numeric_limits<double>::infinity() : draws.power_of_two(1, 4);
    const Vec3<double> moments(1, second, third);
    Body<TypeParam> body = make_body<TypeParam>({}, TypeParam(1), moments.cast<TypeParam>()).value;
    const double turn = draws.between(0.01, 1.5);
    const Vec3<double> momentum = turn * moments.cwiseMin(4).cwiseProduct(draws.direction());
    body.momentum.angular_W = momentum.cast<TypeParam>();
    const Real before = turning_energy(top_of(body));
    if (fly(body, TypeParam(1))) {
      ++flown;
      ASSERT_LE(turning_energy(top_of(body)) / before - 1, kMost + 1e-5L) << text(moments);
    } else {
      ++refused;
    }
  }
  EXPECT_GT(flown, kTries / 4);
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace batuta::laws
