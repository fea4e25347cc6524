// SPDX-License-Identifier: MIT
#include "batuta/detection/budget_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace batuta {
namespace {

template <class Scalar>
class BudgetLaw : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(BudgetLaw, Scalars);

template <class Scalar>
constexpr double kUlp = static_cast<double>(kRoundOff<Scalar>);

TYPED_TEST(BudgetLaw, CubeRoot_IsTheRootOverItsWholeRange) {
  for (double x = 1e-30; x < 1e15; x *= 1.7) {
    const auto rounded = static_cast<TypeParam>(x);
    const double truth = std::cbrt(static_cast<double>(rounded));
    const auto root = static_cast<double>(detail::cube_root(rounded));
    EXPECT_NEAR(root / truth, 1, 8 * kUlp<TypeParam>) << x;
  }
  EXPECT_EQ(detail::cube_root(TypeParam(0)), TypeParam(0));
}

// The figures of the note, from the formula in long double.
TYPED_TEST(BudgetLaw, Tolerance_IsTheFormula) {
  for (const double turn : {1e-3, 0.02, 0.785, 1.571, 3.142, 25.1}) {
    for (const std::uint32_t budget : {1U, 16U, 32U, 64U, 4096U}) {
      const long double ratio = 3.4L * static_cast<long double>(turn) / budget;
      const long double truth = ratio * ratio * ratio / 6;
      const auto contact_tolerance = contact_tolerance_for(static_cast<TypeParam>(turn), budget);
      EXPECT_NEAR(static_cast<double>(contact_tolerance / static_cast<TypeParam>(truth)), 1,
                  64 * kUlp<TypeParam>);
    }
  }
}

// Whatever two are stated, the third obeys the law; and the next smaller budget does not.
TYPED_TEST(BudgetLaw, EachOfTheThree_FollowsFromTheOthers) {
  using S = TypeParam;
  for (const double turn_of_step : {1e-3, 0.02, 0.3, 0.785, 3.142}) {
    for (std::uint32_t budget = 9; budget < 300; budget += 7) {
      const auto turn = static_cast<S>(turn_of_step);
      const S contact_tolerance = contact_tolerance_for(turn, budget);
      EXPECT_NEAR(static_cast<double>(turn_for(budget, contact_tolerance) / turn), 1, 64 * kUlp<S>);
      EXPECT_LE(turn_for(budget, contact_tolerance), turn * (S(1) + S(16) * kRoundOff<S>));
      const std::uint32_t again = budget_for(turn, contact_tolerance);
      EXPECT_GE(again, budget - 1);
      EXPECT_LE(again, budget + 1);
      EXPECT_GT(contact_tolerance_for(turn, again - 1), contact_tolerance * S(0.9999));
    }
  }
}

TYPED_TEST(BudgetLaw, NothingTurns_TheLeastBudgetIsEnough) {
  EXPECT_EQ(contact_tolerance_for(TypeParam(0), 1), TypeParam(0));
  EXPECT_EQ(budget_for(TypeParam(0), TypeParam(1e-6)), detail::kLeastLawBudget);
  EXPECT_EQ(budget_for(TypeParam(0.001), TypeParam(0.1)), detail::kLeastLawBudget);
}

TYPED_TEST(BudgetLaw, NoTolerance_NoBudgetIsEnough) {
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  EXPECT_EQ(budget_for(TypeParam(1), TypeParam(0)), kMost);
  EXPECT_EQ(budget_for(TypeParam(1e9), TypeParam(1e-12)), kMost);
  EXPECT_EQ(turn_for(64U, TypeParam(0)), TypeParam(0));
}

// At compile time: a blade of one metre at 45 degrees a step.
static_assert(budget_for(0.785F, 8e-4F) == 16);
static_assert(contact_tolerance_for(3.14159F, 64) < 8e-4F);
static_assert(turn_for(32U, 1e-6F) > 0.17F);

}  // namespace
}  // namespace batuta
