// SPDX-License-Identifier: MIT
#include "batuta/detection/straight_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "batuta/detection/translation.hpp"

namespace batuta {
namespace {

template <class Scalar>
struct Drawn {
  Capsule<Scalar> capsule_B;
  detail::StraightMotion<Scalar> motion;

  MovingCapsule<Scalar> moving() const {
    return {capsule_B,
            linear<Scalar>({motion.p_W, Quat<Scalar>::Identity()}, motion.v_W, motion.duration)};
  }
};

template <class Scalar>
class Draw {
 public:
  Scalar in(Scalar low, Scalar high) {
    return low + (high - low) * Scalar(std::generate_canonical<double, 53>(source_));
  }
  Vec3<Scalar> vector(Scalar size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  Drawn<Scalar> body() {
    Drawn<Scalar> drawn;
    drawn.capsule_B = {{vector(1), vector(1)}, in(0, 1)};
    drawn.motion = {vector(4), vector(8), Scalar(0.5)};
    return drawn;
  }

 private:
  std::mt19937 source_{20061107};
};

template <class Scalar>
class StraightPair : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(StraightPair, Scalars);

template <class Scalar>
void expect_same_path(const detail::CapsulePath<Scalar>& P, const detail::CapsulePath<Scalar>& Q) {
  for (std::size_t end = 0; end < 2; ++end) {
    EXPECT_EQ(P.ends[end].start, Q.ends[end].start);
    EXPECT_EQ(P.ends[end].arm, Q.ends[end].arm);
    EXPECT_EQ(P.ends[end].side, Q.ends[end].side);
  }
  EXPECT_EQ(P.v, Q.v);
  EXPECT_EQ(P.turn_rate, Q.turn_rate);
  EXPECT_EQ(P.bounding_radius, Q.bounding_radius);
  EXPECT_EQ(P.longest_arm, Q.longest_arm);
  EXPECT_EQ(P.radius, Q.radius);
}

/// What has no rotation is a body that has one and does not turn.
TYPED_TEST(StraightPair, AnyPair_IsThatOfBodiesThatDoNotTurn) {
  Draw<TypeParam> draw;
  int met = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto A = draw.body();
    const auto B = draw.body();
    const auto pair = detail::make_straight_pair(A.capsule_B, A.motion, B.capsule_B, B.motion);
    const auto same = make_moving_pair(A.moving(), B.moving());
    ASSERT_TRUE(pair.ok() && same.ok());
    expect_same_path(pair.value.A, same.value.A);
    expect_same_path(pair.value.B, same.value.B);
    EXPECT_EQ(pair.value.origin_W, same.value.origin_W);
    EXPECT_EQ(pair.value.origin_v_W, same.value.origin_v_W);
    EXPECT_EQ(pair.value.duration, same.value.duration);
    EXPECT_EQ(pair.value.scale, same.value.scale);
    const auto answer = search_translation(pair.value, AdvancementOptions<TypeParam>{});
    ASSERT_NE(answer.outcome, Outcome::kInvalid);
    met += answer.outcome == Outcome::kContact ? 1 : 0;
  }
  EXPECT_GT(met, 100);
}

TYPED_TEST(StraightPair, BadInput_IsRefused) {
  using S = TypeParam;
  const Drawn<S> good = Draw<S>().body();
  const auto is_refused = [&](const Drawn<S>& bad) {
    const auto first =
        detail::make_straight_pair(bad.capsule_B, bad.motion, good.capsule_B, good.motion);
    const auto second =
        detail::make_straight_pair(good.capsule_B, good.motion, bad.capsule_B, bad.motion);
    return first.status == Status::kInvalidArgument && second.status == Status::kInvalidArgument;
  };
  EXPECT_FALSE(is_refused(good));
  const S infinity = std::numeric_limits<S>::infinity();
  for (const S value : {std::numeric_limits<S>::quiet_NaN(), infinity, -infinity}) {
    for (int i = 0; i < 3; ++i) {
      Drawn<S> bad = good;
      bad.capsule_B.axis.a[i] = value;
      EXPECT_TRUE(is_refused(bad));
      bad = good;
      bad.capsule_B.axis.b[i] = value;
      EXPECT_TRUE(is_refused(bad));
      bad = good;
      bad.motion.p_W[i] = value;
      EXPECT_TRUE(is_refused(bad));
      bad = good;
      bad.motion.v_W[i] = value;
      EXPECT_TRUE(is_refused(bad));
    }
    Drawn<S> bad = good;
    bad.capsule_B.radius = value;
    EXPECT_TRUE(is_refused(bad));
    bad = good;
    bad.motion.duration = value;
    EXPECT_TRUE(is_refused(bad));
  }
  Drawn<S> bad = good;
  bad.capsule_B.radius = -1;
  EXPECT_TRUE(is_refused(bad));
  bad = good;
  bad.motion.duration += 1;
  EXPECT_TRUE(is_refused(bad));
  bad = good;
  bad.motion.p_W.x() = kLargestCoordinate<S>;
  EXPECT_TRUE(is_refused(bad));
}

TYPED_TEST(StraightPair, NegativeDurations_AreRefused) {
  using S = TypeParam;
  Drawn<S> body = Draw<S>().body();
  body.motion.duration = -1;
  EXPECT_FALSE(
      detail::make_straight_pair(body.capsule_B, body.motion, body.capsule_B, body.motion).ok());
}

/// Against the extent in long double.
TYPED_TEST(StraightPair, Box_HoldsTheCapsuleAtEveryInstantAndNoMore) {
  using Exact = long double;
  Draw<TypeParam> draw;
  for (int i = 0; i < 50000; ++i) {
    const auto body = draw.body();
    const auto box = detail::straight_aabb(body.capsule_B, body.motion);
    const Segment<TypeParam>& axis = body.capsule_B.axis;
    const Exact radius = body.capsule_B.radius;
    for (int k = 0; k < 3; ++k) {
      const Exact start = body.motion.p_W[k];
      const Exact end = start + Exact{body.motion.v_W[k]} * Exact{body.motion.duration};
      const Exact low = std::min(start, end) + std::min(axis.a[k], axis.b[k]) - radius;
      const Exact high = std::max(start, end) + std::max(axis.a[k], axis.b[k]) + radius;
      const Exact slack =
          16 * Exact{kRoundOff<TypeParam>} * (std::abs(start) + std::abs(end) + 1 + radius);
      const auto place = static_cast<std::size_t>(k);
      ASSERT_LE(Exact{box.low[place]}, low);
      ASSERT_GE(Exact{box.high[place]}, high);
      ASSERT_GE(Exact{box.low[place]}, low - slack);
      ASSERT_LE(Exact{box.high[place]}, high + slack);
    }
  }
}

}  // namespace
}  // namespace batuta
