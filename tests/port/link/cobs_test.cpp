// SPDX-License-Identifier: MIT
#include "shared/link/cobs.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "wire.hpp"

namespace batuta::link::test {
namespace {

Bytes encoded(const Bytes& bytes) {
  Bytes out(bytes.size() + 1);
  const int count = cobs_encode(bytes.data(), static_cast<int>(bytes.size()), out.data());
  EXPECT_EQ(count, static_cast<int>(out.size()));
  return out;
}

/// Bytes of which about `share` of 4 are zero.
rc::Gen<Bytes> bytes_with_zeros(int most) {
  const auto byte = rc::gen::weightedElement<std::uint8_t>({{3, 0}, {1, 1}, {2, 2}, {3, 0xFF}});
  return rc::gen::resize(most, rc::gen::container<Bytes>(byte));
}

TEST(Cobs, ExamplesFromItsPaper_Agree) {
  EXPECT_EQ(encoded({}), (Bytes{1}));
  EXPECT_EQ(encoded({0}), (Bytes{1, 1}));
  EXPECT_EQ(encoded({0, 0}), (Bytes{1, 1, 1}));
  EXPECT_EQ(encoded({0x11, 0x22, 0, 0x33}), (Bytes{3, 0x11, 0x22, 2, 0x33}));
  EXPECT_EQ(encoded({0x11, 0, 0, 0}), (Bytes{2, 0x11, 1, 1, 1}));
}

TEST(Cobs, LongestBlock_AgreesWithDefinition) {
  const Bytes longest(kMaxCobsInput, 0x55);
  EXPECT_EQ(encoded(longest), stuffed(longest));
}

RC_GTEST_PROP(Cobs, AnyBytes_AgreeWithDefinitionAndHoldNoZero, ()) {
  const Bytes bytes = *bytes_with_zeros(kMaxCobsInput);
  const Bytes out = encoded(bytes);
  RC_ASSERT(out == stuffed(bytes));
  RC_ASSERT(std::find(out.begin(), out.end(), 0) == out.end());
}

}  // namespace
}  // namespace batuta::link::test
