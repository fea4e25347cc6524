// SPDX-License-Identifier: MIT
// What the flight of a body with three unlike moments keeps, on its chord and in any units.
#include <gtest/gtest.h>

#include "batuta/geometry/direction.hpp"
#include "samples.hpp"

namespace batuta {
namespace {

using samples::Real;
using samples::real;
using samples::Source;
using samples::u;

template <class Scalar>
class FlightOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(FlightOf, Scalars);

/// Of matter: no moment is above the sum of the others. It turns by `turn` rad in a second.
template <class Scalar>
Body<Scalar> unlike_body(Source<Scalar>& source, Scalar turn) {
  const Scalar a = source.uniform(0.5, 1);
  const Scalar b = source.uniform(1.1, 1.4);
  Body<Scalar> body;
  body.X_WB.q_WB = source.rotation();
  body.inverse_mass = 1;
  body.inverse_moments = {1 / a, 1 / b, 1 / source.uniform(1.5, 1.6)};
  body.momentum.angular_W = turn * source.direction();
  return body;
}

template <class Scalar>
Real energy(const Body<Scalar>& body) {
  const Vec3<Real> b_B =
      real(body.X_WB.q_WB).normalized().conjugate() * real(body.momentum.angular_W);
  return b_B.dot(real(body.inverse_moments).cwiseProduct(b_B)) / 2;
}

/// Units of mass are anybody's: with moments and momentum a power of two larger, all roundings are
/// the same.
TYPED_TEST(FlightOf, BodiesOfAnyMass_AreTheSameToTheLastBit) {
  Source<TypeParam> source(31);
  for (int i = 0; i < 500; ++i) {
    const Body<TypeParam> body = unlike_body(source, source.uniform(0.1, 1.2));
    for (const int power : {-20, 20}) {
      Body<TypeParam> own = body;
      Body<TypeParam> heavy = body;
      heavy.inverse_moments *= std::ldexp(TypeParam(1), -power);
      heavy.momentum.angular_W *= std::ldexp(TypeParam(1), power);
      for (int step = 0; step < 4; ++step) {
        const Motion<TypeParam> flight = free_flight(own, TypeParam(1));
        const Motion<TypeParam> of_heavy = free_flight(heavy, TypeParam(1));
        ASSERT_EQ(flight.twist.w_W, of_heavy.twist.w_W) << i << ' ' << step;
        const TypeParam end = step == 1 ? TypeParam(0.5) : TypeParam(1);
        move_along(own, flight, end);
        move_along(heavy, of_heavy, end);
      }
    }
  }
}

/// A correction to first order leaves the square of what was missing: of some 1e-5 of a splitting
/// of fourth order, over up to two radians.
TYPED_TEST(FlightOf, EnergyAtTheEnd_IsThatOfTheBeginning) {
  Source<TypeParam> source(32);
  for (int i = 0; i < 500; ++i) {
    Body<TypeParam> body = unlike_body(source, TypeParam(1));
    const Real before = energy(body);
    move_along(body, free_flight(body, TypeParam(1)), TypeParam(1));
    ASSERT_LE(std::abs(energy(body) / before - 1), 16 * u<TypeParam> + 1e-10) << i;
  }
}

/// The bounds are those of motion.md, "The energy on the chord".
TYPED_TEST(FlightOf, WhoIsLeftOnTheWay_ComesBackToTheEnergyOfItsFlight) {
  Source<TypeParam> source(33);
  const auto duration = static_cast<TypeParam>(0.25);
  const double bound = std::is_same_v<TypeParam, float> ? 1e-6 : 3e-12;
  for (int i = 0; i < 500; ++i) {
    Body<TypeParam> body = unlike_body(source, TypeParam(1));
    Body<TypeParam> arrived = body;
    const Real before = energy(body);
    const Motion<TypeParam> flight = free_flight(body, duration);
    move_along(arrived, flight, duration);
    ASSERT_FALSE(arrived.flight.is_on_chord);
    move_along(body, flight, duration / 2);
    ASSERT_TRUE(body.flight.is_on_chord);
    ASSERT_EQ(body.flight.excess, arrived.flight.excess);
    ASSERT_EQ(body.flight.axis, arrived.flight.axis);
    ASSERT_EQ(body.flight.angular_W, body.momentum.angular_W);
    move_along(body, free_flight(body, duration), duration);
    ASSERT_FALSE(body.flight.is_on_chord);
    ASSERT_LE(std::abs(energy(body) / before - 1), bound) << i;
  }
}

/// Turned by hand away from the axis that the flight was about: each flight leads back, and by no
/// more of the way than apart_i / (4 spread), the `most` of motion.md.
TYPED_TEST(FlightOf, WhoWasTurnedByHand_ComesBackByNoMoreThanAQuarterAFlight) {
  using S = TypeParam;
  for (const double apart : {0.25, 1.0, 2.0}) {
    Body<S> body;
    body.inverse_mass = 1;
    body.inverse_moments = Vec3<S>(1, S(4), S(1 + apart));
    body.momentum.angular_W = Vec3<S>::UnitX();
    body.flight.angular_W = body.momentum.angular_W;  // about x: without an excess
    const double tilt = 1.0 / 64;
    body.X_WB.q_WB = exp_map(Vec3<S>(0, 0, S(tilt)));  // towards the y axis of B
    double left = tilt;
    for (int flights = 0; flights < 3; ++flights) {
      move_along(body, free_flight(body, S(1e-5)), S(1e-5));
      left *= 1 - 3 / (4 * (3 + apart));
      const Vec3<Real> b_B =
          real(body.X_WB.q_WB).normalized().conjugate() * real(body.momentum.angular_W);
      // To first order: the next is the square of the tilt, and it flies by 3e-5 of it a flight.
      EXPECT_NEAR(static_cast<double>(std::abs(b_B.y())) / left, 1, 0.003) << apart;
    }
  }
}

/// To second order at t it is -t (T - t) / 2 (w x b) . J (w x b), and nothing at both ends.
TYPED_TEST(FlightOf, EnergyOnTheChord_IsOffAsTheSecondOrderSays) {
  Source<TypeParam> source(34);
  const auto duration = static_cast<TypeParam>(0.125);
  const double third_order = 0.25 * 0.25 * 0.25 / 256;  // of a turn of up to a quarter
  for (int i = 0; i < 500; ++i) {
    const Body<TypeParam> body = unlike_body(source, TypeParam(1));
    const Motion<TypeParam> flight = free_flight(body, duration);
    const Vec3<Real> J = real(body.inverse_moments);
    const Vec3<Real> b_B =
        real(body.X_WB.q_WB).normalized().conjugate() * real(body.momentum.angular_W);
    const Vec3<Real> c = J.cwiseProduct(b_B).cross(b_B);
    for (const int part : {0, 1, 2, 3, 4}) {
      const TypeParam t = static_cast<TypeParam>(part) * (duration / 4);
      const Real lost = Real(t) * Real(duration - t) / 2 * c.dot(J.cwiseProduct(c));
      const Real off = detail::off_flight_energy(body, flight, t);
      const Real bound = part % 4 == 0 ? 32 * u<TypeParam> : third_order;
      ASSERT_LE(std::abs(off + lost / energy(body)), bound) << i << ' ' << part;
    }
  }
}

/// Who stopped on its way is off its flight, and its next chord begins as far off: what counts is
/// the energy that it had when the flight began, not that of where it is.
TYPED_TEST(FlightOf, EnergyOfWhoStoppedOnTheChord_IsStillThatOfTheFlight) {
  Source<TypeParam> source(35);
  for (int i = 0; i < 500; ++i) {
    Body<TypeParam> body = unlike_body(source, TypeParam(1.2));
    const Real begun_with = energy(body);
    move_along(body, free_flight(body, TypeParam(1)), TypeParam(0.5));
    const Real off = energy(body) / begun_with - 1;
    const Motion<TypeParam> next = free_flight(body, TypeParam(1));
    ASSERT_LE(std::abs(detail::off_flight_energy(body, next, TypeParam(0)) - off),
              32 * u<TypeParam>)
        << i;
  }
}

/// However it lies beside the axis, and with which end: its turn about the axis is seen.
TYPED_TEST(FlightOf, CapsuleBesideTheAxis_ShowsTheSpin) {
  using S = TypeParam;
  for (int odd = 0; odd < 3; ++odd) {
    Body<S> body;
    body.inverse_moments = Vec3<S>::Ones();
    body.inverse_moments(odd) = 8;
    const Vec3<S> axis = Vec3<S>::Unit(odd);
    EXPECT_TRUE(detail::hides_spin(body, Capsule<S>{{-axis, 2 * axis}, S(0.1)}));
    for (int i = 1; i < 3; ++i) {
      for (const S off : {S(-0.001), S(0.001)}) {
        const Vec3<S> beside = off * Vec3<S>::Unit((odd + i) % 3);
        EXPECT_FALSE(detail::hides_spin(body, Capsule<S>{{beside - axis, axis}, S(0.1)}));
        EXPECT_FALSE(detail::hides_spin(body, Capsule<S>{{-axis, beside + axis}, S(0.1)}));
      }
    }
  }
}

}  // namespace
}  // namespace batuta
