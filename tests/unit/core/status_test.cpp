// SPDX-License-Identifier: MIT
#include "batuta/core/status.hpp"

#include <gtest/gtest.h>

#include "batuta/core/handle.hpp"

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
