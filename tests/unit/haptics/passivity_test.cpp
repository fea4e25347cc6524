// SPDX-License-Identifier: MIT
#include "batuta/haptics/passivity.hpp"

#include <gtest/gtest.h>

#include "draws.hpp"

namespace batuta {
using namespace haptics;
namespace {

template <class S>
class Passive : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Passive, Scalars);

/// Powers of two: sums below are exact.
template <class S>
PassivitySettings<S> simple() {
  PassivitySettings<S> settings;
  settings.period = S(1) / S(1024);
  settings.most_credit = S(4);
  settings.most_debt = S(1);
  settings.largest_damping = S(1) / S(2);
  settings.largest_force = S(100);
  return settings;
}

template <class S>
PassivityObserver<S> observer_with(const PassivitySettings<S>& settings) {
  PassivityObserver<S> observer;
  EXPECT_EQ(observer.configure(settings), Status::kOk);
  EXPECT_EQ(observer.restart({S(0), S(0)}), Status::kOk);
  return observer;
}

TYPED_TEST(Passive, HeldForce_IsBookedAsForceTimesWay) {
  using S = TypeParam;
  auto observer = observer_with(simple<S>());
  ASSERT_EQ(observer.observe({S(-2), S(1)}, {S(0.5), S(0.25)}), Status::kOk);
  EXPECT_EQ(observer.credit(), S(0.75));  // the hand paid 2 / 2, and got 1 / 4
  EXPECT_EQ(observer.state(), Passivity::kPassive);
  ASSERT_EQ(observer.observe({S(4), S(0)}, {S(0.75), S(0.25)}), Status::kOk);
  EXPECT_EQ(observer.credit(), S(-0.25));
  EXPECT_EQ(observer.state(), Passivity::kDissipating);
  EXPECT_EQ(observer.moved(), Vec2<S>(S(0.25), S(0)));
}

// A spring that is not along the axes hands over energy from one to the other all the time.
TYPED_TEST(Passive, EnergyThatChangesAxes_IsNotMade) {
  using S = TypeParam;
  auto observer = observer_with(simple<S>());
  ASSERT_EQ(observer.observe({S(-2), S(2)}, {S(0.5), S(0.5)}), Status::kOk);
  EXPECT_EQ(observer.credit(), S(0));
}

TYPED_TEST(Passive, Device_TakesWhatItSurelyDamps) {
  using S = TypeParam;
  PassivitySettings<S> settings = simple<S>();
  settings.device_damping = S(1) / S(512);
  auto observer = observer_with(settings);
  // b way^2 / T = 2 way^2 for both axes
  ASSERT_EQ(observer.observe({S(0), S(0)}, {S(0.5), S(-0.25)}), Status::kOk);
  EXPECT_EQ(observer.credit(), S(2) * (S(0.25) + S(0.0625)));
  // An encoder may show up to a step that was not gone.
  settings.encoder_step = S(0.25);
  observer = observer_with(settings);
  ASSERT_EQ(observer.observe({S(0), S(0)}, {S(0.5), S(-0.25)}), Status::kOk);
  EXPECT_EQ(observer.credit(), S(2) * S(0.0625));
}

TYPED_TEST(Passive, Credit_StaysWithinItsEnds) {
  using S = TypeParam;
  auto observer = observer_with(simple<S>());
  ASSERT_EQ(observer.observe({S(-32), S(0)}, {S(1), S(0)}), Status::kOk);
  EXPECT_EQ(observer.credit(), S(4));
  ASSERT_EQ(observer.observe({S(32), S(0)}, {S(2), S(0)}), Status::kOk);
  EXPECT_EQ(observer.credit(), S(-1));
  EXPECT_EQ(observer.state(), Passivity::kCannot);
  EXPECT_EQ(observer.cannot_count(), 1U);
  ASSERT_EQ(observer.observe({S(0), S(0)}, {S(2), S(0)}), Status::kOk);
  EXPECT_EQ(observer.state(), Passivity::kDissipating);  // at its most, and not beyond
  EXPECT_EQ(observer.cannot_count(), 1U);
}

TYPED_TEST(Passive, Supply_PaysForABlow) {
  using S = TypeParam;
  auto observer = observer_with(simple<S>());
  EXPECT_EQ(observer.supply(S(0.5)), Status::kOk);
  ASSERT_EQ(observer.observe({S(1), S(0)}, {S(0.5), S(0)}), Status::kOk);
  EXPECT_EQ(observer.state(), Passivity::kPassive);
  EXPECT_EQ(observer.credit(), S(0));
  EXPECT_EQ(observer.supply(S(100)), Status::kOk);
  EXPECT_EQ(observer.credit(), S(4));
}

TYPED_TEST(Passive, Restart_BooksNothing) {
  using S = TypeParam;
  auto observer = observer_with(simple<S>());
  EXPECT_EQ(observer.restart({S(1), S(1)}, S(3)), Status::kOk);
  ASSERT_EQ(observer.observe({S(50), S(50)}, {S(1), S(1)}, S(3)), Status::kOk);
  EXPECT_EQ(observer.credit(), S(0));
  EXPECT_EQ(observer.restart({S(1), S(1)}), Status::kOk);
  ASSERT_EQ(observer.observe({S(50), S(50)}, {S(1), S(1)}), Status::kOk);
  EXPECT_EQ(observer.credit(), S(0));
}

TYPED_TEST(Passive, FirstSample_SaysWhereTheStickIsAndIsNotBooked) {
  using S = TypeParam;
  PassivityObserver<S> observer;
  ASSERT_EQ(observer.configure(simple<S>()), Status::kOk);
  ASSERT_EQ(observer.observe({S(50), S(0)}, {S(1), S(0)}, S(2)), Status::kOk);
  EXPECT_EQ(observer.credit(), S(0));
  EXPECT_EQ(observer.moved(), Vec2<S>::Zero().eval());
  ASSERT_EQ(observer.observe({S(-1), S(0)}, {S(1.5), S(0)}, S(2)), Status::kOk);
  EXPECT_EQ(observer.credit(), S(0.5));  // from there on
}

TYPED_TEST(Passive, Stored_IsReservedForTheSpring) {
  using S = TypeParam;
  auto observer = observer_with(simple<S>());
  // A hand bends a spring by 1 and pays 2; 1.5 of that is stored.
  ASSERT_EQ(observer.observe({S(-2), S(0)}, {S(1), S(0)}, S(1.5)), Status::kOk);
  EXPECT_EQ(observer.credit(), S(0.5));
  // It lets go of all of it: nothing is owed. Of more than that, the difference.
  auto other = observer;
  ASSERT_EQ(observer.observe({S(-1.5), S(0)}, {S(0), S(0)}, S(0)), Status::kOk);
  EXPECT_EQ(observer.credit(), S(0.5));
  ASSERT_EQ(other.observe({S(-2.25), S(0)}, {S(0), S(0)}, S(0)), Status::kOk);
  EXPECT_EQ(other.credit(), S(-0.25));
  EXPECT_EQ(other.state(), Passivity::kDissipating);
}

TYPED_TEST(Passive, Damping_TakesBackWhatIsOwedInOnePeriod) {
  using S = TypeParam;
  auto observer = observer_with(simple<S>());
  ASSERT_EQ(observer.observe({S(1), S(0)}, {S(0.0625), S(0)}), Status::kOk);  // owes 1 / 16
  const S d = owed_damping(observer);
  EXPECT_EQ(d, S(1) / S(64));  // d way^2 / T = 4 d = 1 / 16
  const auto force = passive_force(observer, {S(3), S(2)});
  ASSERT_EQ(force.status, Status::kOk);
  EXPECT_EQ(force.value.force, Vec2<S>(S(3) - S(1), S(2)));  // d way / T = 1
  // Going on like that, without the demanded force, the debt is paid.
  ASSERT_EQ(observer.observe({S(-1), S(0)}, {S(0.125), S(0)}), Status::kOk);
  EXPECT_EQ(observer.credit(), S(0));
  EXPECT_EQ(owed_damping(observer), S(0));
}

TYPED_TEST(Passive, DamperThatNobodyChose_IsNone) {
  using S = TypeParam;
  PassivitySettings<S> settings;
  settings.period = S(1) / S(1024);
  settings.most_debt = S(1);
  settings.largest_force = S(100);
  auto observer = observer_with(settings);
  ASSERT_EQ(observer.observe({S(1), S(0)}, {S(0.5), S(0)}), Status::kOk);
  EXPECT_EQ(observer.credit(), S(-0.5)) << "neither does the device damp, unless that is said";
  EXPECT_EQ(owed_damping(observer), S(0));
}

TYPED_TEST(Passive, DebtOfAStickAtRest_Waits) {
  using S = TypeParam;
  auto observer = observer_with(simple<S>());
  ASSERT_EQ(observer.observe({S(1), S(0)}, {S(0.5), S(0)}), Status::kOk);
  ASSERT_EQ(observer.observe({S(1), S(0)}, {S(0.5), S(0)}), Status::kOk);
  EXPECT_EQ(owed_damping(observer), S(0.5));  // the most: nothing is divided by no motion
  const auto force = passive_force(observer, {S(3), S(2)});
  EXPECT_EQ(force.value.force, Vec2<S>(S(3), S(2)));
  EXPECT_EQ(observer.credit(), S(-0.5));
  // The least motion there is does not blow it up either.
  const S least = std::numeric_limits<S>::denorm_min();
  ASSERT_EQ(observer.observe({S(1), S(0)}, {S(0.5), least}), Status::kOk);
  EXPECT_EQ(owed_damping(observer), S(0.5));
}

TYPED_TEST(Passive, Force_IsCutWithItsDirectionKept) {
  using S = TypeParam;
  auto observer = observer_with(simple<S>());
  const auto force = passive_force(observer, {S(-300), S(400)});
  EXPECT_NEAR(static_cast<double>(force.value.force.x()), -60, 1e-4);
  EXPECT_NEAR(static_cast<double>(force.value.force.y()), 80, 1e-4);
  EXPECT_NEAR(static_cast<double>(force.value.excess), 4, 1e-6);  // 500 of 100
  EXPECT_EQ(passive_force(observer, {S(60), S(80)}).value.excess, S(0));
  EXPECT_EQ(passive_force(observer, {S(60), S(80)}).value.force, Vec2<S>(S(60), S(80)));
}

/// The promise: what went out beyond what came in and what the device took is at most the debt,
/// while nobody said kCannot. Whatever is done: here forces and ways are noise.
TYPED_TEST(Passive, Noise_NeverGetsMoreThanTheDebtUnlessItSays) {
  using S = TypeParam;
  PassivitySettings<S> settings = simple<S>();
  settings.device_damping = S(1) / S(8192);
  test::Draws draws(41, 0, 0);
  int said = 0;
  for (int run = 0; run < 200; ++run) {
    auto observer = observer_with(settings);
    double out = 0;
    double most_out = 0;
    Vec2<S> place(0, 0);
    for (int i = 0; i < 50 && observer.cannot_count() == 0; ++i) {
      const Vec2<S> held(static_cast<S>(draws.between(-1, 1)),
                         static_cast<S>(draws.between(-1, 1)));
      const Vec2<S> way(static_cast<S>(draws.between(-0.5, 0.5)),
                        static_cast<S>(draws.between(-0.5, 0.5)));
      place += way;
      ASSERT_EQ(observer.observe(held, place), Status::kOk);
      if (observer.cannot_count() > 0) break;
      out += static_cast<double>(held.dot(way)) - static_cast<double>(way.squaredNorm()) / 8;
      most_out = std::max(most_out, out);
    }
    said += observer.cannot_count() > 0 ? 1 : 0;
    EXPECT_LE(most_out, 1 + 1e-4);
  }
  EXPECT_GT(said, 0);
  EXPECT_LT(said, 200);
}

TYPED_TEST(Passive, OutOfRange_IsRefusedAndChangesNothing) {
  using S = TypeParam;
  constexpr S kNan = std::numeric_limits<S>::quiet_NaN();
  constexpr S kInfinity = std::numeric_limits<S>::infinity();
  using Settings = PassivitySettings<S>;
  using Field = S Settings::*;
  auto observer = observer_with(simple<S>());
  ASSERT_EQ(observer.observe({S(1), S(0)}, {S(0.5), S(0)}), Status::kOk);
  for (const Field field : {&Settings::period, &Settings::device_damping, &Settings::encoder_step,
                            &Settings::most_credit, &Settings::most_debt,
                            &Settings::largest_damping, &Settings::largest_force}) {
    for (const S bad : {S(-1), kNan, kInfinity}) {
      Settings settings = simple<S>();
      settings.*field = bad;
      EXPECT_EQ(observer.configure(settings), Status::kInvalidArgument);
    }
  }
  for (const Field field : {&Settings::period, &Settings::most_debt, &Settings::largest_force}) {
    Settings settings = simple<S>();
    settings.*field = S(0);
    EXPECT_EQ(validate(settings), Status::kInvalidArgument);
  }
  for (const S bad : {kNan, kInfinity}) {
    EXPECT_EQ(observer.observe({bad, S(0)}, {S(0), S(0)}), Status::kInvalidArgument);
    EXPECT_EQ(observer.observe({S(0), S(0)}, {S(0), bad}), Status::kInvalidArgument);
    EXPECT_EQ(observer.restart({bad, S(0)}), Status::kInvalidArgument);
    EXPECT_EQ(observer.supply(bad), Status::kInvalidArgument);
    EXPECT_EQ(passive_force(observer, {bad, S(0)}).status, Status::kInvalidArgument);
  }
  EXPECT_EQ(observer.supply(S(-1)), Status::kInvalidArgument);
  for (const S bad : {S(-1), kNan, kInfinity}) {
    EXPECT_EQ(observer.observe({S(0), S(0)}, {S(0), S(0)}, bad), Status::kInvalidArgument);
    EXPECT_EQ(observer.restart({S(0), S(0)}, bad), Status::kInvalidArgument);
  }
  EXPECT_EQ(observer.credit(), S(-0.5));
  EXPECT_EQ(observer.moved(), Vec2<S>(S(0.5), S(0)));
}

TYPED_TEST(Passive, NotConfigured_IsUnavailableAndGivesNoForce) {
  using S = TypeParam;
  PassivityObserver<S> observer;
  EXPECT_EQ(observer.observe({S(1), S(0)}, {S(1), S(0)}), Status::kUnavailable);
  EXPECT_EQ(passive_force(observer, {S(1), S(1)}).value.force, Vec2<S>(S(0), S(0)));
}

}  // namespace
}  // namespace batuta
