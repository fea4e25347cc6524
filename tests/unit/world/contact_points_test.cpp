// SPDX-License-Identifier: MIT
// Where two rods that lie along each other touch: at both ends of what they share, or at one.
#include <gtest/gtest.h>

#include "batuta/world/detail/lasting_contact.hpp"

namespace batuta {
namespace {

template <class S>
class ContactPoints : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ContactPoints, Scalars);

constexpr double kRadius = 0.125;
constexpr double kD = 0x1p-9;  // of about 2 mm: what counts as resting

/// Along x, 2 m between the ends of its axis, at these heights.
template <class S>
Capsule<S> rod(double z_first, double z_last) {
  return {{{S(-1), S(0), static_cast<S>(z_first)}, {S(1), S(0), static_cast<S>(z_last)}},
          static_cast<S>(kRadius)};
}

/// The upper rod D / 2 above the lower one at the first end, and so far at the last one.
template <class S>
auto points_of(double last_gap) {
  detail::LastingContact<detail::ContactTraits<S, true, false, true>> contact;
  contact.rest_gap = static_cast<S>(kD);
  const Capsule<S> lower = rod<S>(0, 0);
  const Capsule<S> upper = rod<S>(2 * kRadius + kD / 2, 2 * kRadius + last_gap);
  find_points(contact, lower, upper, closest_points(lower.axis, upper.axis), Vec3<S>(0, 0, 0),
              S(0));
  return contact;
}

TYPED_TEST(ContactPoints, BothEndsWithinDOfTheNearest_AreTwo) {
  // Lengths of 1 m, some roundings of each; the axes are off parallel by 1e-3, squared.
  const double bound = 32 * static_cast<double>(kRoundOff<TypeParam>) + 4e-6;
  for (const double last_gap : {kD / 2, kD, 1.25 * kD}) {
    const auto contact = points_of<TypeParam>(last_gap);
    ASSERT_EQ(contact.count, 2) << last_gap;
    const auto& first = contact.points[0].arm_A_W.x() < 0 ? contact.points[0] : contact.points[1];
    const auto& last = contact.points[0].arm_A_W.x() < 0 ? contact.points[1] : contact.points[0];
    EXPECT_NEAR(first.gap, kD / 2, bound);
    EXPECT_NEAR(last.gap, last_gap, bound);
    EXPECT_NEAR(first.arm_A_W.x(), -1, 1e-3);
    EXPECT_NEAR(last.arm_A_W.x(), 1, 1e-3);
  }
}

TYPED_TEST(ContactPoints, EndFurtherThanDFromTheNearest_IsNone) {
  for (const double last_gap : {1.75 * kD, 3 * kD, 8 * kD}) {
    const auto contact = points_of<TypeParam>(last_gap);
    ASSERT_EQ(contact.count, 1) << last_gap;
    EXPECT_NEAR(contact.points[0].arm_A_W.x(), -1, 2e-2) << last_gap;
    EXPECT_NEAR(contact.points[0].gap, kD / 2, 4e-5) << last_gap;
  }
}

}  // namespace
}  // namespace batuta
