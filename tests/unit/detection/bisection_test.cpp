// SPDX-License-Identifier: MIT
#include "batuta/detection/bisection.hpp"

#include <gtest/gtest.h>

#include "moving.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

template <class Scalar>
class BisectionOf : public testing::Test {
 protected:
  /// Two spheres of radius 1/4 from 3 m apart at 4 m/s: contact at 0.625 s, an exact number.
  MovingPair<Scalar> pair_ =
      make_moving_pair(moving<Scalar>({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0.25}),
                       moving<Scalar>({{3, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0.25, {-4, 0, 0}}))
          .value;
  detail::Bracket<Scalar> start_{Scalar(0), Scalar(0.75), gap_at(pair_, Scalar(0)), 0};
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BisectionOf, Scalars);

TYPED_TEST(BisectionOf, EachHalving_HalvesTheBracketAndCostsOneEvaluation) {
  for (int halvings = 0; halvings <= 20; ++halvings) {
    const auto bracket = detail::bisect(this->pair_, this->start_, halvings);
    EXPECT_EQ(bracket.t_hit - bracket.t_free, TypeParam(0.75) / TypeParam(1 << halvings));
    EXPECT_EQ(bracket.evaluations, static_cast<std::uint32_t>(halvings));
    EXPECT_LT(bracket.t_free, TypeParam(0.625));
    EXPECT_GE(bracket.t_hit, TypeParam(0.625));
    EXPECT_EQ(bracket.witness.gap, gap_at(this->pair_, bracket.t_free).gap);
    EXPECT_GT(bracket.witness.gap, TypeParam(0));
  }
}

TYPED_TEST(BisectionOf, MostHalvings_EndAtNeighbouringNumbers) {
  const auto bracket = detail::bisect(this->pair_, this->start_, detail::kMaxHalvings);
  EXPECT_EQ(bracket.t_hit, std::nextafter(bracket.t_free, TypeParam(1)));
  EXPECT_LT(bracket.evaluations, static_cast<std::uint32_t>(detail::kMaxHalvings));
  EXPECT_NEAR(static_cast<double>(bracket.t_hit), 0.625,
              4 * static_cast<double>(kRoundOff<TypeParam>));
}

TYPED_TEST(BisectionOf, MoreThanAllowed_IsCut) {
  const auto bracket = detail::bisect(this->pair_, this->start_, 1000);
  EXPECT_LE(bracket.evaluations, static_cast<std::uint32_t>(detail::kMaxHalvings));
}

TYPED_TEST(BisectionOf, GapThatCannotBeTold_StopsAndIsNotValid) {
  auto pair = this->pair_;
  pair.B.v.x() = std::numeric_limits<TypeParam>::max();  // beyond kLargestCoordinate at 0.375 s
  const auto bracket = detail::bisect(pair, this->start_, 20);
  EXPECT_FALSE(bracket.valid);
  EXPECT_EQ(bracket.t_free, this->start_.t_free);
  EXPECT_EQ(bracket.t_hit, this->start_.t_hit);
  EXPECT_EQ(bracket.evaluations, 1U);
  EXPECT_TRUE(detail::bisect(this->pair_, this->start_, 20).valid);
}

}  // namespace
}  // namespace batuta
