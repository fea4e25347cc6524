// SPDX-License-Identifier: MIT
#include "batuta/geometry/kdop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <tuple>

namespace batuta {
namespace {

template <class S, int N>
struct Kind {
  using Scalar = S;
  static constexpr int K = N;
};

/// Type-parametrised over both scalars and every k.
template <class T>
class KdopTest : public testing::Test {
 protected:
  using Number = typename T::Scalar;
  using Point = Vec3<Number>;

  Number number() { return Number(engine_() % 20001) / 10000 - 1; }
  Point point() { return {number(), number(), number()}; }
  Capsule<Number> capsule() {
    const Number size = std::ldexp(Number(1), static_cast<int>(engine_() % 60) - 30);
    const Point offset = engine_() % 2 == 0 ? Point(0, 0, 0) : Point(100 * point());
    const Segment<Number> axis{size * (offset + point()), size * (offset + point())};
    return {axis, engine_() % 4 == 0 ? Number(0) : size * std::abs(number())};
  }

  std::mt19937 engine_{11};
};
using Kinds = testing::Types<Kind<float, 6>, Kind<float, 14>, Kind<float, 18>, Kind<float, 26>,
                             Kind<double, 6>, Kind<double, 14>, Kind<double, 18>, Kind<double, 26>>;
TYPED_TEST_SUITE(KdopTest, Kinds);

TYPED_TEST(KdopTest, Directions_AreDifferentAndOfTheStatedKinds) {
  using Scalar = typename TypeParam::Scalar;
  constexpr int kCount = TypeParam::K / 2;
  std::set<std::tuple<Scalar, Scalar, Scalar>> seen;
  std::array<int, 4> of_length{};
  for (int i = 0; i < kCount; ++i) {
    const Vec3<Scalar> d = detail::kdop_direction<Scalar, TypeParam::K>(i);
    seen.insert({d.x(), d.y(), d.z()});
    seen.insert({-d.x(), -d.y(), -d.z()});
    ++of_length[static_cast<std::size_t>(d.squaredNorm())];
  }
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(TypeParam::K)) << "no two parallel";
  EXPECT_EQ(of_length[1], 3);
  EXPECT_EQ(of_length[2], TypeParam::K >= 18 ? 6 : 0);
  EXPECT_EQ(of_length[3], TypeParam::K == 14 || TypeParam::K == 26 ? 4 : 0);
}

TYPED_TEST(KdopTest, OfACapsule_HoldsItAndIsTightToEightRoundOffs) {
  using Scalar = typename TypeParam::Scalar;
  constexpr int K = TypeParam::K;
  long double worst = 0;
  for (int n = 0; n < 3000; ++n) {
    const Capsule<Scalar> c = this->capsule();
    const Kdop<Scalar, K> dop = detail::kdop_of<Scalar, K>(c);
    for (int i = 0; i < K / 2; ++i) {
      const auto d = detail::kdop_direction<Scalar, K>(i).template cast<long double>().eval();
      const long double at_a = d.dot(c.axis.a.template cast<long double>());
      const long double at_b = d.dot(c.axis.b.template cast<long double>());
      const long double reach = d.norm() * c.radius;
      const long double above =
          dop.high[static_cast<std::size_t>(i)] - (std::max(at_a, at_b) + reach);
      const long double below = std::min(at_a, at_b) - reach - dop.low[static_cast<std::size_t>(i)];
      ASSERT_GE(above, 0);
      ASSERT_GE(below, 0);
      const long double size = std::max(c.axis.a.template cast<long double>().norm(),
                                        c.axis.b.template cast<long double>().norm()) +
                               c.radius;
      worst = std::max(worst, std::max(above, below) / (d.norm() * size * kRoundOff<Scalar>));
    }
  }
  EXPECT_LE(worst, 8);
  this->RecordProperty("worst_slack_uS", std::to_string(static_cast<double>(worst)));
}

// Against the exact extents of both axes with a radius that is a sum: nothing sticks out.
TYPED_TEST(KdopTest, OfTwoAxesAndASumAsRadius_HoldsBothAndIsTight) {
  using Scalar = typename TypeParam::Scalar;
  constexpr int K = TypeParam::K;
  for (int n = 0; n < 1000; ++n) {
    const std::array<Capsule<Scalar>, 2> both = {this->capsule(), this->capsule()};
    const Scalar margin = n % 3 == 0 ? Scalar(0) : Scalar(0.01) * static_cast<Scalar>(n);
    const Scalar thickness = both[0].radius;
    const Kdop<Scalar, K> dop =
        detail::kdop_of<Scalar, K>(both[0].axis, both[1].axis, thickness + margin);
    for (int i = 0; i < K / 2; ++i) {
      const auto d = detail::kdop_direction<Scalar, K>(i).template cast<long double>().eval();
      long double high = std::numeric_limits<long double>::lowest();
      long double size = 0;
      for (const auto& c : both) {
        for (const auto& end : {c.axis.a, c.axis.b}) {
          const auto x = end.template cast<long double>().eval();
          const long double radius = static_cast<long double>(thickness) + margin;
          high = std::max(high, d.dot(x) + d.norm() * radius);
          size = std::max(size, x.norm() + radius);
        }
      }
      const long double above = dop.high[static_cast<std::size_t>(i)] - high;
      ASSERT_GE(above, 0);
      ASSERT_LE(above, 10 * d.norm() * size * kRoundOff<Scalar>);
    }
  }
}

TYPED_TEST(KdopTest, OfACapsule_ContainsItsPoints) {
  using Scalar = typename TypeParam::Scalar;
  constexpr int K = TypeParam::K;
  for (int n = 0; n < 1000; ++n) {
    const Capsule<Scalar> c = this->capsule();
    const Kdop<Scalar, K> dop = detail::kdop_of<Scalar, K>(c);
    EXPECT_TRUE(contains(dop, c.axis.a));
    EXPECT_TRUE(contains(dop, c.axis.b));
    if (c.radius == 0) continue;
    const Vec3<Scalar> middle = c.axis.at(Scalar(0.5));
    EXPECT_TRUE(contains(dop, middle));
    const Scalar beyond = (c.axis.b - c.axis.a).norm() + 3 * c.radius;
    EXPECT_FALSE(contains<Scalar>(dop, middle + beyond * Vec3<Scalar>::UnitY()));
    EXPECT_FALSE(contains<Scalar>(dop, middle - beyond * Vec3<Scalar>::UnitY()));
  }
}

TYPED_TEST(KdopTest, OverlappingCapsules_HaveOverlappingDops) {
  using Scalar = typename TypeParam::Scalar;
  constexpr int K = TypeParam::K;
  int apart = 0;
  int together = 0;
  for (int n = 0; n < 3000; ++n) {
    const Capsule<Scalar> A{{this->point(), this->point()}, Scalar(0.1)};
    const Capsule<Scalar> B{{this->point(), this->point()}, Scalar(0.1)};
    const bool maybe = overlaps(detail::kdop_of<Scalar, K>(A), detail::kdop_of<Scalar, K>(B));
    if (overlaps(A, B)) {
      ++together;
      EXPECT_TRUE(maybe);
    }
    apart += maybe ? 0 : 1;
  }
  EXPECT_GT(together, 100);
  EXPECT_GT(apart, 100);
}

TYPED_TEST(KdopTest, Touching_CountsAsOverlap) {
  using Scalar = typename TypeParam::Scalar;
  Kdop<Scalar, TypeParam::K> P;
  P.low.fill(0);
  P.high.fill(1);
  Kdop<Scalar, TypeParam::K> Q = P;
  Q.low[1] = 1;
  Q.high[1] = 2;
  EXPECT_TRUE(overlaps(P, Q));
  EXPECT_TRUE(overlaps(Q, P));
  Q.low[1] = 1 + 2 * kRoundOff<Scalar>;
  EXPECT_FALSE(overlaps(P, Q));
  EXPECT_FALSE(overlaps(Q, P));
}

TYPED_TEST(KdopTest, Merge_IsTheLeastThatHoldsBothAndEmptyIsNeutral) {
  using Scalar = typename TypeParam::Scalar;
  using Dop = Kdop<Scalar, TypeParam::K>;
  const Dop P = detail::kdop_of<Scalar, TypeParam::K>(this->capsule());
  const Dop Q = detail::kdop_of<Scalar, TypeParam::K>(this->capsule());
  const Dop both = merge(P, Q);
  for (std::size_t i = 0; i < both.low.size(); ++i) {
    EXPECT_EQ(both.low[i], std::min(P.low[i], Q.low[i]));
    EXPECT_EQ(both.high[i], std::max(P.high[i], Q.high[i]));
  }
  EXPECT_EQ(merge(P, Dop()).low, P.low);
  EXPECT_EQ(merge(Dop(), P).high, P.high);
  EXPECT_FALSE(overlaps(P, Dop()));
  EXPECT_FALSE(contains(Dop(), Vec3<Scalar>(0, 0, 0)));
}

TYPED_TEST(KdopTest, Inflated_HoldsTheFatterCapsuleAndEmptyStaysEmpty) {
  using Scalar = typename TypeParam::Scalar;
  constexpr int K = TypeParam::K;
  for (int n = 0; n < 1000; ++n) {
    const Capsule<Scalar> c = this->capsule();
    const Scalar margin = std::abs(this->number());
    const Kdop<Scalar, K> P = detail::kdop_of<Scalar, K>(c);
    const Kdop<Scalar, K> fat = inflated(P, margin);
    for (int k = 0; k < K / 2; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const auto d = detail::kdop_direction<Scalar, K>(k).template cast<long double>().eval();
      const long double move = d.norm() * margin;
      EXPECT_GE(fat.high[i] - (P.high[i] + move), 0);
      EXPECT_LE(fat.low[i] - (P.low[i] - move), 0);
      const long double allowed = 8 * kRoundOff<Scalar> * (move + std::abs(P.high[i]));
      EXPECT_LE(fat.high[i] - (P.high[i] + move), allowed);
    }
  }
  const Kdop<Scalar, K> empty = inflated(Kdop<Scalar, K>(), Scalar(1));
  EXPECT_EQ(empty.low, (Kdop<Scalar, K>().low));
  EXPECT_EQ(empty.high, (Kdop<Scalar, K>().high));
}

TEST(KdopDeathTest, CallersMistakes_AreTrapped) {
  EXPECT_DEATH((detail::kdop_direction<float, 6>(3)), "assertion failed");
  EXPECT_DEATH((detail::kdop_direction<float, 6>(-1)), "assertion failed");
  EXPECT_DEATH(inflated(Kdop<float, 6>(), -1.0F), "assertion failed");
}

}  // namespace
}  // namespace batuta
