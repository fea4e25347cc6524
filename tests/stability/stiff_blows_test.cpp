// SPDX-License-Identifier: MIT
// A million random contacts of stiff pairs, half of them in double: finite, momentum kept to 4 ulp
// of the largest term of its sum, energy never more than before but for the rounding that
// src/response/friction.md states. BATUTA_CONTACTS=1000000000 in the environment takes more.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "stiff_blow.hpp"

namespace batuta {
namespace {

long contacts_to_take() {
#ifdef BATUTA_CONTACTS
  constexpr long kContacts = BATUTA_CONTACTS;
#else
  constexpr long kContacts = 500000;
#endif
  const char* contacts = std::getenv("BATUTA_CONTACTS");
  return contacts != nullptr ? std::atol(contacts) : kContacts;
}

/// Of momentum, in the sums of what each body keeps; of energy, as in friction.md.
constexpr double kMostUlps = 4;

template <class S>
class StiffBlows : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(StiffBlows, Scalars);

TYPED_TEST(StiffBlows, AnyMassRatioInertiaAndLaw_KeepMomentumAndGainNoEnergy) {
  using S = TypeParam;
  const long wanted = contacts_to_take();
  test::StiffError worst;
  long contacts = 0;
  for (std::uint64_t number = 0; contacts < wanted; ++number) {
    test::Draws draw(6, 1, number);
    const auto blow = test::stiff_blow<S>(number, test::drawn_power(draw, -9, 9));
    const test::StiffError error = test::judge(blow);
    ASSERT_TRUE(error.finite) << number;
    ASSERT_LE(error.energy, kMostUlps) << number;
    ASSERT_LE(error.linear, kMostUlps) << number;
    ASSERT_LE(error.angular, kMostUlps) << number;
    ASSERT_TRUE(test::separates_to_distance(blow)) << number;
    contacts += error.took_part ? 1 : 0;
    worst.merge(error);
  }
  std::printf("  %ld contacts: energy %.2f of 4 u, momentum %.2f and %.2f of 4 ulp at most\n",
              contacts, worst.energy, worst.linear, worst.angular);
}

}  // namespace
}  // namespace batuta
