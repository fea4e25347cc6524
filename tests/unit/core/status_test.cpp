// SPDX-License-Identifier: MIT
#include "batuta/core/status.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <new>

#include "batuta/core/handle.hpp"
#include "batuta/core/types.hpp"

namespace batuta {
namespace {

static_assert(sizeof(Status) == 1);
static_assert(sizeof(Handle<int>) == 8);

TEST(Result, Success_HoldsTheValue) {
  constexpr Result<int> result = success(7);
  static_assert(result.ok() && result.value == 7);
  EXPECT_EQ(result.status, Status::kOk);
}

TEST(Result, Failure_HoldsADefaultValue) {
  constexpr auto result = failure<int>(Status::kPoolFull);
  static_assert(!result.ok());
  EXPECT_EQ(result.status, Status::kPoolFull);
  EXPECT_EQ(result.value, 0);
}

TEST(Result, Untouched_IsNotOk) {
  EXPECT_FALSE(Result<int>{}.ok());
}

/// Made where something else has been, as on a stack: a member left unset would show it.
TEST(Result, FailedVector_IsZero) {
  alignas(Result<Vec3<float>>) unsigned char place[sizeof(Result<Vec3<float>>)];
  std::memset(place, 0x5A, sizeof place);
  const auto* untouched = new (place) Result<Vec3<float>>();
  EXPECT_EQ(untouched->value, Vec3<float>::Zero());
  std::memset(place, 0x5A, sizeof place);
  const auto* failed = new (place) auto(failure<Vec3<float>>(Status::kPoolFull));
  EXPECT_EQ(failed->status, Status::kPoolFull);
  EXPECT_EQ(failed->value, Vec3<float>::Zero());
}

TEST(Handle, Default_IsNull) {
  EXPECT_TRUE(Handle<int>{}.is_null());
  EXPECT_FALSE((Handle<int>{1, 0, 1}.is_null()));
}

TEST(Handle, EveryPart_TellsHandlesApart) {
  const Handle<int> handle{1, 2, 3};
  EXPECT_EQ(handle, (Handle<int>{1, 2, 3}));
  EXPECT_NE(handle, (Handle<int>{9, 2, 3}));
  EXPECT_NE(handle, (Handle<int>{1, 9, 3}));
  EXPECT_NE(handle, (Handle<int>{1, 2, 9}));
}

}  // namespace
}  // namespace batuta
