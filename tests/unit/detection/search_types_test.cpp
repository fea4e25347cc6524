// SPDX-License-Identifier: MIT
// What the types behind one shape say of themselves, and whether they do it.
#include <gtest/gtest.h>

#include "batuta/detection/search.hpp"
#include "moving.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

/// A number that was given once stays.
TEST(SearchNumbers, AreThoseByWhichSavedStatesNameThem) {
  EXPECT_EQ(Stepping<float>::kNumber, 1U);
  EXPECT_EQ(Advancement<float>::kNumber, 2U);
  EXPECT_EQ(Translation<float>::kNumber, 3U);
  EXPECT_EQ(Spheres<float>::kNumber, 4U);
  EXPECT_EQ(Stepping<double>::kNumber, 1U);
  EXPECT_EQ(Advancement<double>::kNumber, 2U);
  EXPECT_EQ(Translation<double>::kNumber, 3U);
  EXPECT_EQ(Spheres<double>::kNumber, 4U);
}

/// Two rods of 2 m side by side, so far apart, at rest.
template <class Scalar>
MovingPair<Scalar> standing(double gap) {
  const Vec3<double> half(1, 0, 0);
  const double radius = 0.125;
  const auto A = moving<Scalar>({Vec3<double>::Zero(), -half, half, radius});
  const auto B = moving<Scalar>({Vec3<double>(0, 0, 2 * radius + gap), -half, half, radius});
  const auto pair = make_moving_pair(A, B);
  EXPECT_EQ(pair.status, Status::kOk);
  return pair.value;
}

/// Those that take capsules.
template <class Search>
class SearchType : public testing::Test {};
using Searches = testing::Types<Stepping<float>, Stepping<double>, Advancement<float>,
                                Advancement<double>, Translation<float>, Translation<double>>;
TYPED_TEST_SUITE(SearchType, Searches);

TYPED_TEST(SearchType, GapWithinTheTolerance_IsContactForThoseThatSaySo) {
  using Scalar = typename TypeParam::Scalar;
  constexpr double kTolerance = 1e-2;  // over a size of some metres
  const auto options =
      TypeParam::options(TypeParam::kDefaultBudget, static_cast<Scalar>(kTolerance));
  const auto near = standing<Scalar>(kTolerance / 8);
  const auto found = TypeParam::search(near, options, Vec3<Scalar>(0, 0, 0));
  const Outcome wanted = TypeParam::kHasContactTolerance ? Outcome::kTouching : Outcome::kFree;
  EXPECT_EQ(found.outcome, wanted);
  EXPECT_EQ(TypeParam::contact_gap(near, options) > Scalar(0), TypeParam::kHasContactTolerance);
  const auto far = TypeParam::search(standing<Scalar>(1), options, Vec3<Scalar>(0, 0, 0));
  EXPECT_EQ(far.outcome, Outcome::kFree);
  const auto within = TypeParam::search(standing<Scalar>(-0.1), options, Vec3<Scalar>(0, 0, 0));
  EXPECT_EQ(within.outcome, Outcome::kTouching);
}

TYPED_TEST(SearchType, Budget_BoundsItsEvaluations) {
  using Scalar = typename TypeParam::Scalar;
  for (const std::uint32_t budget : {TypeParam::kLeastBudget, TypeParam::kDefaultBudget}) {
    const auto options = TypeParam::options(budget, Scalar(0));
    EXPECT_LE(TypeParam::most_evaluations(options), budget);
    const auto found = TypeParam::search(standing<Scalar>(0.5), options, Vec3<Scalar>(0, 0, 0));
    EXPECT_LE(found.evaluations, budget);
  }
}

/// Of nothing that turns: what says that it serves nothing else says so of a pair that does.
TYPED_TEST(SearchType, PairThatTurns_IsRefusedByThoseForStraightFlight) {
  using Scalar = typename TypeParam::Scalar;
  const Vec3<double> half(1, 0, 0);
  const auto A = moving<Scalar>({Vec3<double>::Zero(), -half, half, 0.125});
  const auto B = moving<Scalar>(
      {Vec3<double>(0, 0, 5), -half, half, 0.125, Vec3<double>::Zero(), Vec3<double>(0, 1, 0)});
  const auto pair = make_moving_pair(A, B);
  ASSERT_EQ(pair.status, Status::kOk);
  const auto options = TypeParam::options(TypeParam::kDefaultBudget, Scalar(0));
  const auto found = TypeParam::search(pair.value, options, Vec3<Scalar>(0, 0, 0));
  EXPECT_EQ(found.outcome == Outcome::kInvalid, TypeParam::kForStraightFlight);
}

}  // namespace
}  // namespace batuta
