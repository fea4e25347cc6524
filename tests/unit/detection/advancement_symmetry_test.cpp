// SPDX-License-Identifier: MIT
// What may not change an answer: which capsule comes first, which end, the frame, the unit of
// length, full turns. And what a far origin may.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "advancement_cases.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

template <class Scalar>
class AdvancementSymmetry : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(AdvancementSymmetry, Scalars);

template <class Scalar>
using Change = std::function<void(MovingCapsule<Scalar>&)>;

/// How far the gap can be from the truth at t_free, on either side of a change.
template <class Scalar>
double doubt(const Asked<Scalar>& asked) {
  const Scalar eps = detail::kInflation<Scalar> * test::query_length_of(asked.pair);
  return static_cast<double>(contact_tolerance_of(asked.pair, asked.options) + 2 * eps);
}

/// Both answers are free up to their t_free, and the gap there is within the contact tolerance.
template <class Scalar>
void expect_same(const Case& c, const Asked<Scalar>& asked, const SearchResult<Scalar>& found,
                 const SearchResult<Scalar>& changed) {
  const bool slight = c.t == kNever && std::is_same_v<Scalar, float>;
  EXPECT_TRUE(slight || changed.outcome == found.outcome) << c.name;
  if (changed.outcome != Outcome::kContact || found.outcome != Outcome::kContact) return;
  const test::Reference<double> truth(asked.A, asked.B);
  EXPECT_LE(truth.gap(static_cast<double>(changed.t_free)), 2 * doubt(asked)) << c.name;
  EXPECT_LE(truth.gap(static_cast<double>(found.t_free)), 2 * doubt(asked)) << c.name;
}

template <class Scalar>
void expect_unmoved_by(const Change<Scalar>& change) {
  for (const Case& c : robust_cases()) {
    const auto asked = ask<Scalar>(c);
    auto A = asked.A;
    auto B = asked.B;
    change(A);
    change(B);
    const auto again = ask<Scalar>(A, B);
    expect_same(c, asked, search_truly(asked, c.name), search_truly(again, c.name));
  }
}

TYPED_TEST(AdvancementSymmetry, CapsulesSwapped_SameAnswer) {  // T45
  for (const Case& c : robust_cases()) {
    const auto asked = ask<TypeParam>(c);
    const auto swapped = ask<TypeParam>(asked.B, asked.A);
    expect_same(c, asked, search_truly(asked, c.name), search_truly(swapped, c.name));
  }
}

TYPED_TEST(AdvancementSymmetry, EndsSwapped_SameAnswer) {  // T45
  expect_unmoved_by<TypeParam>([](auto& m) { std::swap(m.capsule_B.axis.a, m.capsule_B.axis.b); });
}

/// A mirror at the plane x = 0 turns vectors, and angular velocities the other way.
template <class Scalar>
void mirror(MovingCapsule<Scalar>& m) {
  m.capsule_B.axis.a.x() *= -1;
  m.capsule_B.axis.b.x() *= -1;
  m.motion.X_WB.p_W.x() *= -1;
  m.motion.twist.v_W.x() *= -1;
  m.motion.twist.w_W.y() *= -1;
  m.motion.twist.w_W.z() *= -1;
}
TYPED_TEST(AdvancementSymmetry, Mirrored_SameAnswer) {  // T45
  expect_unmoved_by<TypeParam>(mirror<TypeParam>);
}

template <class Scalar>
void rotate(MovingCapsule<Scalar>& m, const Quat<Scalar>& q) {
  m.motion.X_WB.p_W = q * m.motion.X_WB.p_W;
  m.motion.X_WB.q_WB = renewed<Scalar>(q * m.motion.X_WB.q_WB);
  m.motion.twist.v_W = q * m.motion.twist.v_W;
  m.motion.twist.w_W = q * m.motion.twist.w_W;
}
TYPED_TEST(AdvancementSymmetry, TurnedAnyHow_SameAnswer) {  // T45
  std::mt19937 random(45);
  for (int i = 0; i < 40; ++i) {  // Bound: 40 rotations
    const Vec3<double> r = random_vector(random, 3);
    const Quat<TypeParam> q = exp_map<TypeParam>(r.cast<TypeParam>());
    expect_unmoved_by<TypeParam>([&](auto& m) { rotate(m, q); });
  }
}

/// The search sees lengths over S only: a power of two changes no digit.
TYPED_TEST(AdvancementSymmetry, LengthsTimesPowerOfTwo_SameBits) {  // T38
  for (const Case& c : all_cases()) {
    const auto asked = ask<TypeParam>(c);
    const auto found = search_advancement(asked.pair, asked.options);
    for (const int exponent : {-20, 20}) {
      const auto scaled = [&](MovingCapsule<TypeParam> m) {
        const TypeParam k = std::ldexp(TypeParam(1), exponent);
        m.capsule_B.axis = {k * m.capsule_B.axis.a, k * m.capsule_B.axis.b};
        m.capsule_B.radius *= k;
        m.motion.X_WB.p_W *= k;
        m.motion.twist.v_W *= k;
        return m;
      };
      const auto again =
          ask<TypeParam>(scaled(asked.A), scaled(asked.B), std::ldexp(kContactTolerance, exponent));
      const auto same = search_advancement(again.pair, again.options);
      EXPECT_EQ(same.outcome, found.outcome) << c.name;
      EXPECT_EQ(same.t_free, found.t_free) << c.name;
      EXPECT_EQ(same.t_hit, found.t_hit) << c.name;
      EXPECT_EQ(same.evaluations, found.evaluations) << c.name;
    }
  }
}

Case bar_and_post(double scale, double rate = kPi) {
  return {"T08",
          {kO, {-scale, 0, 0}, {scale, 0, 0}, .05 * scale, kO, {0, 0, rate}},
          {{0, .8 * scale, 0}, {0, 0, -scale}, {0, 0, scale}, .05 * scale},
          0.460106912325};
}

TYPED_TEST(AdvancementSymmetry, LengthsTimesMillion_SameTime) {  // T38
  for (const double scale : {1e-6, 1e6}) {
    const auto found =
        search_truly(ask<TypeParam>(bar_and_post(scale), kContactTolerance * scale), "T38");
    const auto plain = search_truly(ask<TypeParam>(bar_and_post(1)), "T08");
    ASSERT_EQ(found.outcome, Outcome::kContact);
    EXPECT_NEAR(found.t_free, plain.t_free, 8 * kRoundOff<TypeParam>);
  }
}

TEST(AdvancementSymmetry, FarFromOrigin_TrueOfTheRoundedNumbers) {  // T44
  const Vec3<float> shift(1e4F, -1e4F, 1e4F);
  for (const Case& c : all_cases()) {
    auto A = moving<float>(c.A);
    auto B = moving<float>(c.B);
    A.motion.X_WB.p_W += shift;
    B.motion.X_WB.p_W += shift;
    const auto asked = ask<float>(A, B);
    EXPECT_LT(asked.pair.scale, 2000) << c.name << ": S is local";
    search_truly(asked, c.name);
  }
}

/// T57: an orientation that hundreds of turns led to is worth the same as the reduced one.
TYPED_TEST(AdvancementSymmetry, OrientationAfterManyTurns_SameAnswer) {
  const Case c = bar_and_post(1);
  const auto plain = search_truly(ask<TypeParam>(c), c.name);
  auto A = moving<TypeParam>(c.A);
  Motion<TypeParam> winding = A.motion;
  constexpr int kTurns = 300;
  winding.twist.w_W = {0, 0, static_cast<TypeParam>(2 * kPi * kTurns)};
  A.motion.X_WB = pose_at(winding, TypeParam(1));
  const auto found = search_truly(ask<TypeParam>(A, moving<TypeParam>(c.B)), "T57");
  ASSERT_EQ(found.outcome, Outcome::kContact);
  EXPECT_NEAR(found.t_free, plain.t_free, 4 * kTurns * 2 * kPi * kRoundOff<TypeParam>);
}

}  // namespace
}  // namespace batuta
