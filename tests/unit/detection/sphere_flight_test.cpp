// SPDX-License-Identifier: MIT
// The claims of search_spheres() against the motion of the spheres themselves, in long double: its
// own rounding is 1/1000 of what the claims allow in double, and far less in float.
#include "batuta/detection/sphere_flight.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace batuta {
namespace {

using Exact = long double;

/// Two spheres; what the search is asked is rounded from it, as a scene would.
template <class Scalar>
struct Spheres {
  detail::StraightMotion<Scalar> A;
  detail::StraightMotion<Scalar> B;
  Scalar radius_A = 0;
  Scalar radius_B = 0;

  SphereFlight<Scalar> flight() const {
    return {B.p_W - A.p_W, B.v_W - A.v_W, radius_A + radius_B, A.duration};
  }
  Exact gap_at(Exact t) const {
    Exact square = 0;
    for (int i = 0; i < 3; ++i) {
      const Exact x = between(i) + speed(i) * t;
      square += x * x;
    }
    return std::sqrt(square) - (Exact{radius_A} + Exact{radius_B});
  }
  Exact least_gap(Exact until) const {
    Exact closing = 0;
    Exact square = 0;
    for (int i = 0; i < 3; ++i) {
      closing -= between(i) * speed(i);
      square += speed(i) * speed(i);
    }
    return gap_at(square > 0 ? std::clamp(closing / square, Exact{0}, until) : 0);
  }

 private:
  Exact between(int i) const { return Exact{B.p_W[i]} - Exact{A.p_W[i]}; }
  Exact speed(int i) const { return Exact{B.v_W[i]} - Exact{A.v_W[i]}; }
};

/// Whether all that is claimed is true.
template <class Scalar>
testing::AssertionResult is_true(const Spheres<Scalar>& spheres, Scalar contact_tolerance,
                                 const SphereResult<Scalar>& answer) {
  const Scalar duration = spheres.A.duration;
  const bool in_order = Scalar(0) <= answer.t_free && answer.t_free <= answer.t_hit;
  if (!in_order || answer.t_hit > duration) {
    return testing::AssertionFailure() << answer.t_free << " " << answer.t_hit;
  }
  const Exact until = Exact{answer.t_free};
  const Exact least = spheres.least_gap(until);
  const Exact now = spheres.gap_at(until);
  const auto contact = Exact{detail::contact_gap_of(spheres.flight(), contact_tolerance)};
  bool holds = false;
  if (answer.outcome == Outcome::kFree) holds = least > 0 && answer.t_free == duration;
  if (answer.outcome == Outcome::kContact) holds = least > 0 && now <= contact;
  if (answer.outcome == Outcome::kTouching) holds = now <= contact && answer.t_free == Scalar(0);
  if (holds) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "outcome " << int(answer.outcome) << ", least gap " << least
                                     << ", gap " << now << ", allowed " << contact;
}

template <class Scalar>
class Draw {
 public:
  Scalar in(Scalar low, Scalar high) {
    return low + (high - low) * Scalar(std::generate_canonical<double, 53>(source_));
  }
  Scalar ten_to(Scalar low, Scalar high) { return std::pow(Scalar(10), in(low, high)); }
  bool one_in(unsigned n) { return source_() % n == 0; }
  Vec3<Scalar> unit() {
    std::normal_distribution<double> component;
    Vec3<Scalar> v;
    for (int i = 0; i < 3; ++i) v[i] = Scalar(component(source_));
    return v.normalized();
  }

  /// Flights that meet, miss and graze (by 1e-7 and more), start in and out of contact, end before,
  /// at and after it; slow and fast, small and large, far from the origin or not.
  Spheres<Scalar> spheres() {
    Spheres<Scalar> drawn;
    const Scalar scale = ten_to(-6, 6);
    drawn.radius_A = one_in(20) ? Scalar(0) : scale * ten_to(-3, 0);
    drawn.radius_B = one_in(5) ? Scalar(0) : scale * ten_to(-3, 0);
    const Scalar radii = drawn.radius_A + drawn.radius_B;
    const Vec3<Scalar> along = unit();
    const Vec3<Scalar> aside = along.cross(unit()).normalized();
    const Scalar miss = radii * miss_in_radii();
    const Scalar run_up = scale * ten_to(-4, 1);
    const Scalar speed = scale * ten_to(-3, 3);
    const Scalar origin = one_in(2) ? Scalar(0) : scale;
    drawn.A.p_W = origin * unit();
    drawn.B.p_W = drawn.A.p_W + miss * aside - run_up * along;
    drawn.A.v_W = one_in(2) ? Vec3<Scalar>(Vec3<Scalar>::Zero()) : Vec3<Scalar>(speed * unit());
    drawn.B.v_W = drawn.A.v_W + (one_in(10) ? -speed : speed) * along;
    if (one_in(50)) drawn.B.v_W = drawn.A.v_W;
    drawn.A.duration = one_in(50) ? Scalar(0) : run_up / speed * in(0, 2);
    drawn.B.duration = drawn.A.duration;
    return drawn;
  }
  Scalar contact_tolerance(const SphereFlight<Scalar>& flight) {
    return one_in(2) ? Scalar(0) : flight.radii * ten_to(-7, -2);
  }

 private:
  Scalar miss_in_radii() {
    if (one_in(3)) return Scalar(1) + (one_in(2) ? -ten_to(-7, -3) : ten_to(-7, -3));
    return one_in(5) ? Scalar(0) : in(0, Scalar(1.5));
  }
  std::mt19937 source_{20061107};
};

template <class Scalar>
class SphereFlightOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(SphereFlightOf, Scalars);

TYPED_TEST(SphereFlightOf, AnyFlight_NothingMissedNothingLate) {
  Draw<TypeParam> draw;
  std::array<int, 5> outcomes{};
  int grazes = 0;
  for (int i = 0; i < 150000; ++i) {
    const auto spheres = draw.spheres();
    const auto contact_tolerance = draw.contact_tolerance(spheres.flight());
    const auto answer = search_spheres(spheres.flight(), contact_tolerance);
    ASSERT_TRUE(is_true(spheres, contact_tolerance, answer)) << "query " << i;
    ++outcomes[static_cast<std::size_t>(answer.outcome)];
    const Exact least = spheres.least_gap(Exact{spheres.A.duration});
    grazes += std::abs(least) < Exact{1e-5} * Exact{spheres.flight().radii} ? 1 : 0;
  }
  EXPECT_GT(outcomes[static_cast<std::size_t>(Outcome::kFree)], 20000);
  EXPECT_GT(outcomes[static_cast<std::size_t>(Outcome::kContact)], 20000);
  EXPECT_GT(outcomes[static_cast<std::size_t>(Outcome::kTouching)], 1000);
  EXPECT_EQ(outcomes[static_cast<std::size_t>(Outcome::kBudget)], 0);
  EXPECT_GT(grazes, 5000);
}

/// t_hit is off by no more than what the contact tolerance bends: it is within the contact
/// tolerance of the surfaces.
TYPED_TEST(SphereFlightOf, HeadOn_ForeseesTheInstant) {
  Draw<TypeParam> draw;
  for (int i = 0; i < 10000; ++i) {
    const TypeParam radii = draw.in(TypeParam(0.1), 1);
    const TypeParam apart = radii + draw.in(TypeParam(0.1), 1);
    const Vec3<TypeParam> along = draw.unit();
    const SphereFlight<TypeParam> flight{apart * along, -along, radii, 3};
    const auto answer = search_spheres(flight, TypeParam(0));
    ASSERT_EQ(answer.outcome, Outcome::kContact);
    ASSERT_NEAR(double(answer.t_hit), double(apart - radii), 64 * double(kRoundOff<TypeParam>));
  }
}

/// @param x, y  of B from A; @param v  along x
template <class Scalar>
SphereResult<Scalar> pass(Scalar x, Scalar y, Scalar v, Scalar radii, Scalar contact_tolerance,
                          Scalar duration = 1) {
  return search_spheres<Scalar>({{x, y, 0}, {v, 0, 0}, radii, duration}, contact_tolerance);
}

TYPED_TEST(SphereFlightOf, CasesOfTheTable_OutcomeOfTheTable) {
  using S = TypeParam;
  const S contact_tolerance = S(1e-6);
  const auto bullet = pass<S>(-50, 0, 1000, S(0.02), contact_tolerance);
  EXPECT_EQ(bullet.outcome, Outcome::kContact);
  EXPECT_NEAR(double(bullet.t_hit), 0.04998, 1e-6);
  EXPECT_NE(pass<S>(-2, S(0.2), 4, S(0.2), contact_tolerance).outcome, Outcome::kFree);
  EXPECT_EQ(pass<S>(-2, S(0.2001), 4, S(0.2), contact_tolerance).outcome, Outcome::kFree);
  const auto near_graze = pass<S>(-2, S(0.1999), 4, S(0.2), contact_tolerance);
  EXPECT_EQ(near_graze.outcome, Outcome::kContact);
  EXPECT_LE(double(near_graze.t_free), 0.498419058825);
  EXPECT_NEAR(double(near_graze.t_hit), 0.498419058825, 1e-3);
  const auto points = pass<S>(2, 0, -4, 0, contact_tolerance);
  EXPECT_EQ(points.outcome, Outcome::kContact);
  EXPECT_NEAR(double(points.t_hit), 0.5, 1e-5);
  const auto slow = pass<S>(S(0.2001), 0, S(-1e-3), S(0.2), contact_tolerance);
  EXPECT_EQ(slow.outcome, Outcome::kContact);
  EXPECT_NEAR(double(slow.t_hit), 0.1, 2e-4);
  EXPECT_EQ(pass<S>(S(0.2001), 0, S(-1e-3), S(0.2), S(1e-3)).outcome, Outcome::kTouching);
}

TYPED_TEST(SphereFlightOf, NothingMovesOrNoTime_FreeOrTouching) {
  using S = TypeParam;
  EXPECT_EQ(pass<S>(1, 0, -100, S(0.5), 0, 0).outcome, Outcome::kFree);
  EXPECT_EQ(pass<S>(S(0.4), 0, -100, S(0.5), 0, 0).outcome, Outcome::kTouching);
  EXPECT_EQ(pass<S>(1, 0, 0, S(0.5), 0).outcome, Outcome::kFree);
  EXPECT_EQ(pass<S>(0, 0, 0, S(0.5), 0).outcome, Outcome::kTouching);
  EXPECT_EQ(pass<S>(0, 0, 0, 0, 0).outcome, Outcome::kTouching);
  EXPECT_EQ(pass<S>(S(0.499), 0, 1, S(0.5), 0).outcome, Outcome::kTouching);
  const auto beyond = pass<S>(1, 0, S(-0.25), S(0.5), 0);
  EXPECT_EQ(beyond.outcome, Outcome::kFree);
  EXPECT_EQ(beyond.t_free, S(1));
}

TYPED_TEST(SphereFlightOf, ScaledQuery_ScaledAnswer) {
  using S = TypeParam;
  const auto usual = pass<S>(-2, S(0.1), 4, S(0.2), 0);
  for (const S scale : {S(0x1p-20), S(0x1p-6), S(0x1p20)}) {
    const auto scaled = pass<S>(-2 * scale, S(0.1) * scale, 4 * scale, S(0.2) * scale, 0);
    EXPECT_EQ(scaled.outcome, Outcome::kContact);
    EXPECT_NEAR(double(scaled.t_free), double(usual.t_free), 1e-5);
  }
}

/// Lengths whose squares underflow or overflow: refused, or nothing that is not true.
TYPED_TEST(SphereFlightOf, ExtremeSizes_NothingMissedNothingLate) {
  Draw<TypeParam> draw;
  constexpr auto kLow = TypeParam(std::numeric_limits<TypeParam>::min_exponent10);
  constexpr auto kHigh = TypeParam(std::numeric_limits<TypeParam>::max_exponent10);
  int told = 0;
  for (int i = 0; i < 20000; ++i) {
    Spheres<TypeParam> spheres;
    spheres.B.p_W = draw.ten_to(kLow, kHigh / 2) * draw.unit();
    spheres.B.v_W = draw.ten_to(kLow, kHigh / 2) * -spheres.B.p_W.normalized();
    spheres.radius_B = draw.one_in(2) ? TypeParam(0) : spheres.B.p_W.norm() * draw.in(0, 1);
    spheres.A.duration = spheres.B.duration = draw.ten_to(-6, 6);
    const auto answer = search_spheres<TypeParam>(spheres.flight(), 0);
    if (answer.outcome == Outcome::kInvalid) continue;
    ++told;
    ASSERT_TRUE(is_true(spheres, TypeParam(0), answer)) << "query " << i;
  }
  EXPECT_GT(told, 10000);
}

TYPED_TEST(SphereFlightOf, BadInput_IsRefused) {
  using S = TypeParam;
  const auto is_refused = [](const SphereFlight<S>& flight, S contact_tolerance) {
    return search_spheres(flight, contact_tolerance).outcome == Outcome::kInvalid;
  };
  const SphereFlight<S> good{{1, 0, 0}, {-1, 0, 0}, S(0.5), 1};
  EXPECT_FALSE(is_refused(good, 0));
  EXPECT_TRUE(is_refused(good, S(-1)));
  const S nan = std::numeric_limits<S>::quiet_NaN();
  const S infinity = std::numeric_limits<S>::infinity();
  EXPECT_TRUE(is_refused(good, nan));
  for (const S bad : {nan, infinity, -infinity}) {
    for (int i = 0; i < 3; ++i) {
      auto flight = good;
      flight.between[i] = bad;
      EXPECT_TRUE(is_refused(flight, 0));
      flight = good;
      flight.v[i] = bad;
      EXPECT_TRUE(is_refused(flight, 0));
      flight.duration = 0;
      EXPECT_TRUE(is_refused(flight, 0));
    }
    auto flight = good;
    flight.radii = bad;
    EXPECT_TRUE(is_refused(flight, 0));
    flight = good;
    flight.duration = bad;
    EXPECT_TRUE(is_refused(flight, 0));
  }
  auto flight = good;
  flight.radii = S(-0.1);
  EXPECT_TRUE(is_refused(flight, 0));
  flight = good;
  flight.duration = -1;
  EXPECT_TRUE(is_refused(flight, 0));
}

/// Over its whole motion, at instants and in directions of all kinds.
TYPED_TEST(SphereFlightOf, Box_HoldsTheSphereAtEveryInstantAndNoMore) {
  Draw<TypeParam> draw;
  for (int i = 0; i < 20000; ++i) {
    const auto spheres = draw.spheres();
    const auto box = detail::sphere_aabb(spheres.B, spheres.radius_B);
    for (int k = 0; k < 3; ++k) {
      const Exact start = spheres.B.p_W[k];
      const Exact end = start + Exact{spheres.B.v_W[k]} * Exact{spheres.B.duration};
      const Exact low = std::min(start, end) - Exact{spheres.radius_B};
      const Exact high = std::max(start, end) + Exact{spheres.radius_B};
      const Exact slack = 16 * Exact{kRoundOff<TypeParam>} *
                          (std::abs(low) + std::abs(high) + 2 * Exact{spheres.radius_B});
      const auto axis = static_cast<std::size_t>(k);
      ASSERT_LE(Exact{box.low[axis]}, low);
      ASSERT_GE(Exact{box.high[axis]}, high);
      ASSERT_GE(Exact{box.low[axis]}, low - slack);
      ASSERT_LE(Exact{box.high[axis]}, high + slack);
    }
  }
}

}  // namespace
}  // namespace batuta
