// SPDX-License-Identifier: MIT
// Queries that an earlier version of the search answered wrongly, or not at all. Every one stands
// for a gap in the proof that has been closed (src/detection/advancement.md).
#include <gtest/gtest.h>

#include "batuta/detection/translation.hpp"
#include "claims.hpp"
#include "moving.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

/// Two capsules about their middles, A at rest at the origin; T = 1.
template <class S>
struct ShortEdges {
  Vec3<S> a;
  S radius_A;
  Vec3<S> b;
  S radius_B;
  S x;  ///< of B's centre
  S vx;
  Vec3<S> w;
  Vec3<S> seed;
  S contact_tolerance;

  MovingCapsule<S> A() const { return body(a, radius_A, 0, 0, Vec3<S>::Zero()); }
  MovingCapsule<S> B() const { return body(b, radius_B, x, vx, w); }

 private:
  static MovingCapsule<S> body(const Vec3<S>& end, S radius, S x, S vx, const Vec3<S>& w) {
    MovingCapsule<S> m;
    m.capsule_B = {{end, -end}, radius};
    m.motion.X_WB.p_W.x() = x;
    m.motion.twist.v_W.x() = vx;
    m.motion.twist.w_W = w;
    m.motion.duration = 1;
    return m;
  }
};

template <class S>
void expect_true(const ShortEdges<S>& query) {
  const MovingPair<S> pair = make_moving_pair(query.A(), query.B()).value;
  AdvancementOptions<S> options;
  options.contact_tolerance = query.contact_tolerance;
  options.budget = 2048;
  const auto found = search_advancement(pair, options, query.seed);
  const test::Truth truth(query.A(), query.B());
  const test::Findings findings = test::judge(test::claim_of(pair, options, found), truth);
  EXPECT_FALSE(findings.wrong()) << "overlap " << findings.overlap;
  EXPECT_GE(found.witness.gap, S(0));
}

// Two short edges that hold, with the normal in their plane: nearly all of the rate of the normal
// lay along the normal, which grew.
TEST(AdvancementSoundness, NormalInThePlaneOfTheEdges_NotLate) {
  expect_true<float>({{-0x1.af164ap-24F, -0x1.020d7cp-13F, 0},
                      0x1.5e9706p-1F,
                      {0, -0x1.cddf58p-11F, 0},
                      0x1.42d1f4p-2F,
                      0x1.002634p+0F,
                      -0x1.16a8ccp-10F,
                      {0, 0, -0x1.51f53p+1F},
                      {0, 1, 0},
                      0});
  expect_true<float>({{0x1.18bc4ap-23F, 0x1.ae8f3cp-15F, 0x1.763bfep-13F},
                      0x1.b0707p-3F,
                      {0, 0x1.607becp-13F, 0x1.325f64p-11F},
                      0x1.93e3e4p-1F,
                      0x1.0026dep+0F,
                      -0x1.a8919ap-10F,
                      {0, 0x1.05037ap-1F, -0x1.2c4c54p-3F},
                      {0, -0x1.1b0ddep-2F, -0x1.ec0d08p-1F},
                      1e-6F});
  expect_true<double>({{-0x1.c1a855ee7b716p-53, 0x1.53ca521b02d25p-28, -0x1.fee5e20a2aba7p-30},
                       0x1.9503b9dca7f16p-1,
                       {0, 0x1.493f012d345acp-25, -0x1.ef0b46cb36c3bp-27},
                       0x1.abf1188d603a8p-3,
                       0x1.0000000001513p+0,
                       -0x1.7375af7732f31p-40,
                       {0, 0x1.1463cb98abce8p-2, 0x1.6fa5297a2b933p-1},
                       {0, -0x1.df428423e1648p-1, 0x1.684cca9e00682p-2},
                       0});
}

template <class S>
class AdvancementSoundness : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(AdvancementSoundness, Scalars);

/// Two thin rods of length 2, nearly parallel at a distance `apart`, B coming from above.
template <class S>
MovingPair<S> thin_rods(double tilt, double apart, std::mt19937& random) {
  const Capsule64 A{Vec3<double>::Zero(), {-1, 0, 0}, {1, 0, 0}, 1e-4};
  Capsule64 B = A;
  B.center = {0.5 * signed_unit(random), 0.1 * apart * signed_unit(random), apart};
  B.end_a += tilt * random_vector(random, 1);
  B.end_b += tilt * random_vector(random, 1);
  B.v = {signed_unit(random), 0, -2 * apart};
  B.w = random_vector(random, 0.1);
  return make_moving_pair(moving<S>(A), moving<S>(B)).value;
}

/// Query `i` of nearly parallel rods; false: it was not answered.
template <class S>
bool is_answered(std::mt19937& random) {
  const double tilt = std::ldexp(1.0, -static_cast<int>(random() % 24U));
  const double apart = 3e-4 * (1 + std::ldexp(1.0, static_cast<int>(random() % 10U)));
  const Outcome outcome = search_advancement(thin_rods<S>(tilt, apart, random), {}).outcome;
  return outcome != Outcome::kBudget && outcome != Outcome::kInvalid;
}

// The normal of thin, nearly parallel rods is mostly rounding: every evaluation must still prove
// something, and the budget suffice.
TYPED_TEST(AdvancementSoundness, ThinAndNearlyParallel_NeverStalls) {
  std::mt19937 random(7);
  for (int i = 0; i < 4000; ++i) ASSERT_TRUE(is_answered<TypeParam>(random)) << "query " << i;
}

/// Of two balls apart from each other at rest.
template <class S>
Outcome outcome_for(S duration, S size) {
  MovingCapsule<S> ball;
  ball.capsule_B.radius = size;
  ball.motion.duration = duration;
  MovingCapsule<S> other = ball;
  other.motion.X_WB.p_W.x() = 4 * size;
  const auto pair = make_moving_pair(ball, other).value;
  const Outcome outcome = search_advancement(pair, {}).outcome;
  return outcome == search_translation(pair, {}).outcome ? outcome : Outcome::kBudget;
}

// Below the least normal number over u the rounding of t = theta T is no longer relative.
TYPED_TEST(AdvancementSoundness, TimesAndLengthsWithoutDigits_AreRefused) {
  constexpr TypeParam kLeast = std::numeric_limits<TypeParam>::min() / kRoundOff<TypeParam>;
  EXPECT_EQ(outcome_for<TypeParam>(1, 1), Outcome::kFree);
  EXPECT_EQ(outcome_for<TypeParam>(0, 1), Outcome::kFree);
  EXPECT_EQ(outcome_for<TypeParam>(kLeast, 1), Outcome::kFree);
  EXPECT_EQ(outcome_for<TypeParam>(kLeast / 2, 1), Outcome::kInvalid);
  EXPECT_EQ(outcome_for<TypeParam>(1, kLeast), Outcome::kFree);
  EXPECT_EQ(outcome_for<TypeParam>(1, kLeast / 16), Outcome::kInvalid);
}

}  // namespace
}  // namespace batuta
