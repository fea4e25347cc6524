// SPDX-License-Identifier: MIT
// Law 4: without contact the orientation of any body is the exact one up to a stated order, at any
// turn below half a turn a step.
#include <gtest/gtest.h>

#include "draws.hpp"
#include "euler_top.hpp"

namespace batuta::laws {
namespace {

template <class Scalar>
class FreeFlightOf : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(FreeFlightOf, Scalars);

constexpr double kHalfTurn = 3.14159265358979;
const std::array<double, 5> kSteps = {1e-4, 1e-3, 1e-2, 1.0 / 60, 1.0 / 30};

/// Rounding of the orientation at most: 8 u a step, were all to one side; and what u |b| of the
/// momentum along the lightest axis is in rate about it (body.md).
template <class Scalar>
Real rounding(const Body<Scalar>& body, Real steps, Real time) {
  const auto u = static_cast<Real>(kRoundOff<Scalar>);
  const Real rate = static_cast<Real>(body.inverse_moments.maxCoeff()) *
                    body.momentum.angular_W.template cast<Real>().norm();
  return u * (8 * steps + 8 * rate * time);
}

struct Swing {
  const char* name;
  Vec3<double> moments;
  Vec3<double> w_B;  ///< 10 rad/s
};

std::vector<Swing> swings() {
  const Vec3<double> sword = moments_of_sword();
  const Vec3<double> all(5, 7, 5.099), middle(0.2, 9.9, 0.3), lightest(9.9, 0.5, 0.5);
  return {{"1 : 2 : 3", {1, 2, 3}, all},
          {"1 : 2 : 3, tumbling", {1, 2, 3}, middle},
          {"plate", {1, 1.9, 2.8}, all},
          {"sword", sword, all},
          {"sword, tumbling", sword, middle},
          {"sword, spinning", sword, lightest},
          {"nearly round", {1, 1.0001, 1.0002}, all}};
}

/// How far the orientation is off after a second of steps, rad.
template <class Scalar>
Real error_after_a_second(const Swing& swing, double step) {
  Body<Scalar> body = turning<Scalar>(swing.moments, swing.w_B);
  const Top start = top_of(body);
  const auto steps = std::lround(1 / step);
  const auto dt = static_cast<Scalar>(step);
  for (long i = 0; i < steps; ++i) EXPECT_TRUE(fly(body, dt)) << swing.name;
  const Top truth = turned(start, static_cast<Real>(dt) * static_cast<Real>(steps));
  const Real error = angle_between(body.X_WB.q_WB, truth.q_WB);
  EXPECT_LE(error, 3e-9L * std::pow(static_cast<Real>(step) * 1e3L, 4.0L) +
                       rounding(body, static_cast<Real>(steps), 1))
      << swing.name << ", " << step << " s";
  return error;
}

// One second at 10 rad/s: of fourth order, and 3e-9 rad at 1 ms.
TYPED_TEST(FreeFlightOf, Orientation_IsOfFourthOrderAtEveryStep) {
  for (const Swing& swing : swings()) {
    for (const double step : kSteps) {
      const Real error = error_after_a_second<TypeParam>(swing, step);
      if (step == 1e-3 && sizeof(TypeParam) == 8) {
        EXPECT_LE(error, 1e-5L) << swing.name;
      }
    }
  }
}

TEST(FreeFlightOrder, HalfTheStep_LeavesASixteenthOfTheError) {
  for (const Swing& swing : swings()) {
    if (swing.name == std::string("nearly round")) continue;  // its error is below rounding
    const Real whole = error_after_a_second<double>(swing, 1e-2);
    const Real half = error_after_a_second<double>(swing, 5e-3);
    EXPECT_GT(whole / half, 13) << swing.name;
    EXPECT_LT(whole / half, 19) << swing.name;
  }
}

/// When the angular momentum along the middle axis changes its sign, s. Bound: steps.
template <class Scalar>
std::vector<double> flips(double step) {
  Body<Scalar> top = turning<Scalar>(UnstableTop{}.moments, UnstableTop{}.w_B);
  std::vector<double> times;
  Real last = 1;
  for (int i = 1; i * step < 20; ++i) {
    EXPECT_TRUE(fly(top, static_cast<Scalar>(step)));
    const Real now = top_of(top).b_B.y();
    if (now * last < 0) times.push_back(i * step);
    last = now;
  }
  return times;
}

TYPED_TEST(FreeFlightOf, UnstableTop_FlipsWhenItShould) {
  const auto flips_at = UnstableTop{}.flips();
  for (const double step : {1e-3, 1e-2, 1.0 / 30}) {
    const std::vector<double> times = flips<TypeParam>(step);
    ASSERT_EQ(times.size(), flips_at.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
      EXPECT_NEAR(times[i], flips_at[i], 0.005 * flips_at[i] + step) << i << ", " << step << " s";
    }
  }
}

/// Moments that a body can have: none above the sum of the others; up to 1e4 apart.
Vec3<double> draw_moments(test::Draws& draws) {
  const auto square = [&draws] { return std::exp(4.6 * draws.signed_unit()); };
  const double x = square(), y = square(), z = square();
  return {y + z, z + x, x + y};
}

// Up to half a turn nothing is refused and the answer is the right one; beyond, nothing is
// answered.
TYPED_TEST(FreeFlightOf, AnyBody_IsRefusedFromHalfATurnOnAndNotBefore) {
  test::Draws draws(14, 1, 4);
  int below = 0, beyond = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3<double> moments = draw_moments(draws);
    const double speed = draws.between(0.1, 3.6);
    Body<TypeParam> body = turning<TypeParam>(moments, speed * draws.direction());
    const Top truth = turned(top_of(body), 1);
    const auto turn = static_cast<double>(2 * std::acos(truth.q_WB.w()));  // from the identity on
    const Motion<TypeParam> flight = free_flight(body, TypeParam(1));
    if (turn > 3.13 && turn < 3.15) continue;
    ASSERT_EQ(is_valid(flight), turn < kHalfTurn) << text(moments) << ", turn " << turn;
    (turn < kHalfTurn ? below : beyond) += 1;
    if (!is_valid(flight)) continue;
    move_along(body, flight, TypeParam(1));
    const Real ratio = static_cast<Real>(moments.maxCoeff() / moments.minCoeff());
    EXPECT_LE(angle_between(body.X_WB.q_WB, truth.q_WB),
              2e-3L + 64 * static_cast<Real>(kRoundOff<TypeParam>) * ratio)
        << text(moments) << ", turn " << turn;
  }
  EXPECT_GT(below, 250);
  EXPECT_GT(beyond, 20);
}

// What is refused turns by half a turn or more; steady turns about the three axes tell.
TYPED_TEST(FreeFlightOf, TurnBeyondHalfATurn_IsRefused) {
  for (const Vec3<double>& moments : {Vec3<double>(1, 2, 3), moments_of_sword()}) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto body = turning<TypeParam>(moments, Vec3<double>::Unit(axis));
      for (const double turn : {0.1, 1.0, 3.0, 3.14}) {
        const auto flight = free_flight(body, static_cast<TypeParam>(turn));
        ASSERT_TRUE(is_valid(flight)) << axis << ", turn " << turn;
        EXPECT_NEAR(static_cast<double>(flight.twist.w_W[axis]), 1, 1e-5);
      }
      for (const double turn : {3.15, 4.0, 6.2, 6.4, 13.0, 1e6}) {
        EXPECT_FALSE(is_valid(free_flight(body, static_cast<TypeParam>(turn)))) << axis << turn;
      }
    }
  }
}

// Axisymmetric, the spin showing: exact at any step, also where the spin is a million times what
// the turn across is, and continuous with bodies whose moments are nearly equal.
TYPED_TEST(FreeFlightOf, TopWhoseSpinShows_IsExact) {
  for (const double axial : {3e-6, 0.01, 0.4, 1.9}) {
    for (const double spin : {0.0, 1.0, 20.0}) {
      Body<TypeParam> top = turning<TypeParam>({1, 1, axial}, {3, -2, spin});
      top.spin_shows = true;
      const Top start = top_of(top);
      for (int i = 0; i < 100; ++i) ASSERT_TRUE(fly(top, TypeParam(1e-2))) << axial << " " << spin;
      const Real time = 100 * static_cast<Real>(TypeParam(1e-2));
      // The closed form of EulerTop.AxisymmetricOrientation.
      const WideVec steady = start.inverse_moments[0] * time * start.b_B;
      const WideQuat about_b(Eigen::AngleAxis<Real>(steady.norm(), steady.normalized()));
      const Real own = (start.inverse_moments[2] - start.inverse_moments[0]) * start.b_B[2] * time;
      const WideQuat about_axis(Eigen::AngleAxis<Real>(own, WideVec::UnitZ()));
      EXPECT_LE(angle_between(top.X_WB.q_WB, WideQuat(about_b * start.q_WB * about_axis)),
                rounding(top, 100, time))
          << axial << " " << spin;
    }
  }
}

}  // namespace
}  // namespace batuta::laws
