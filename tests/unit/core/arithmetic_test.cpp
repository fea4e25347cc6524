// SPDX-License-Identifier: MIT
#include "batuta/core/arithmetic.hpp"

#include <gtest/gtest.h>

#include <cfenv>

#include "contracted.hpp"

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace batuta {
namespace {

template <class Scalar>
class Arithmetic : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Arithmetic, Scalars);

/// Rounds another way for as long as it lives.
class RoundingMode {
 public:
  explicit RoundingMode(int mode) : before_(std::fegetround()) { (void)std::fesetround(mode); }
  ~RoundingMode() { (void)std::fesetround(before_); }
  RoundingMode(const RoundingMode&) = delete;
  RoundingMode& operator=(const RoundingMode&) = delete;

 private:
  int before_;
};

TYPED_TEST(Arithmetic, AsTheProjectCompiles_IsRight) {
  EXPECT_TRUE(detail::rounds_products<TypeParam>());
  EXPECT_TRUE(detail::rounds_to_nearest_even<TypeParam>());
  EXPECT_TRUE(detail::keeps_denormals<TypeParam>());
  EXPECT_TRUE(rounds_each_operation<TypeParam>());
}

TYPED_TEST(Arithmetic, AnyOtherRoundingMode_IsSeen) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    bool nearest = true;
    bool all = true;
    {
      const RoundingMode other(mode);
      nearest = detail::rounds_to_nearest_even<TypeParam>();
      all = rounds_each_operation<TypeParam>();
    }
    EXPECT_FALSE(nearest) << mode;
    EXPECT_FALSE(all) << mode;
  }
  EXPECT_TRUE(rounds_each_operation<TypeParam>());
}

#ifdef __SSE2__
constexpr unsigned kFlushToZero = 0x8000;
constexpr unsigned kDenormalsAreZero = 0x0040;

/// Sets bits of the SSE control register for as long as it lives.
class ControlBits {
 public:
  explicit ControlBits(unsigned bits) : before_(_mm_getcsr()) { _mm_setcsr(before_ | bits); }
  ~ControlBits() { _mm_setcsr(before_); }
  ControlBits(const ControlBits&) = delete;
  ControlBits& operator=(const ControlBits&) = delete;

 private:
  unsigned before_;
};

TYPED_TEST(Arithmetic, FlushedDenormals_AreSeen) {
  for (const unsigned bits : {kFlushToZero, kDenormalsAreZero}) {
    bool kept = true;
    bool all = true;
    {
      const ControlBits flushed(bits);
      kept = detail::keeps_denormals<TypeParam>();
      all = rounds_each_operation<TypeParam>();
    }
    EXPECT_FALSE(kept) << bits;
    EXPECT_FALSE(all) << bits;
  }
  EXPECT_TRUE(rounds_each_operation<TypeParam>());
}
#endif

#ifdef BATUTA_TEST_CONTRACTED
TEST(ContractedArithmetic, FusedProducts_AreSeenInTheFileThatFuses) {
  if (!test::can_run_contracted()) GTEST_SKIP() << "this processor has no fused multiply-add";
  EXPECT_FALSE(test::contracted_rounds_products(0.0F));
  EXPECT_FALSE(test::contracted_rounds_products(0.0));
  EXPECT_FALSE(test::contracted_rounds_each_operation(0.0F));
  EXPECT_FALSE(test::contracted_rounds_each_operation(0.0));
  EXPECT_TRUE(rounds_each_operation<float>()) << "the flags of one file are not those of another";
}

TEST(ContractedArithmetic, WithoutAFlag_HeadersForbidIt) {
  if (!test::can_run_contracted()) GTEST_SKIP() << "this processor has no fused multiply-add";
  EXPECT_TRUE(test::unflagged_rounds_each_operation());
  EXPECT_TRUE(test::unflagged_rounds_dot_products());
}
#endif

}  // namespace
}  // namespace batuta
