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

template <class S>
using RollingContact = detail::LastingContact<detail::ContactTraits<S, true, true, true>>;

/// The upper rod D / 2 above the lower one at the first end, and so far at the last one.
template <class S>
void find_again(RollingContact<S>& contact, double last_gap) {
  contact.rest_gap = static_cast<S>(kD);
  const Capsule<S> lower = rod<S>(0, 0);
  const Capsule<S> upper = rod<S>(2 * kRadius + kD / 2, 2 * kRadius + last_gap);
  find_points(contact, lower, upper, closest_points(lower.axis, upper.axis), Vec3<S>(0, 0, 0),
              S(0));
}
template <class S>
auto points_of(double last_gap) {
  RollingContact<S> contact;
  find_again(contact, last_gap);
  return contact;
}

/// What the points of a contact hold, summed.
struct Held {
  double normal = 0, spent_normal = 0;               // N s
  Vec3<double> across = Vec3<double>::Zero();        // N s, friction
  Vec3<double> spent_across = Vec3<double>::Zero();  // N s
  Vec3<double> rolling = Vec3<double>::Zero();       // N m s
};
template <class S>
Held sum_of(const RollingContact<S>& contact) {
  Held sum;
  for (std::size_t i = 0; i < contact.count; ++i) {
    const auto& point = contact.points[i];
    const auto to = detail::tangents_of(point.normal_W);
    const Vec3<S> across = point.along * to.along_W + point.across * to.across_W;
    const Vec3<S> spent = point.spent_along * to.along_W + point.spent_across * to.across_W;
    sum.normal += static_cast<double>(point.normal);
    sum.spent_normal += static_cast<double>(point.spent_normal);
    sum.across += across.template cast<double>();
    sum.spent_across += spent.template cast<double>();
    sum.rolling += point.rolling_W.template cast<double>();
  }
  return sum;
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

/// Two points that become one, one that becomes two, and as many as before: they hold what the old
/// ones held. The rods turn by up to 3e-3 rad, and the directions of friction with them.
TYPED_TEST(ContactPoints, FoundAgain_HoldTheSameImpulses) {
  using S = TypeParam;
  for (const double from : {kD / 2, 3 * kD}) {
    for (const double to : {kD / 2, 3 * kD}) {
      auto contact = points_of<S>(from);
      contact.is_new = false;
      for (std::size_t i = 0; i < contact.count; ++i) {
        auto& point = contact.points[i];
        point.normal = S(2) + static_cast<S>(i);
        point.spent_normal = S(1);
        point.along = S(0.5) + static_cast<S>(i);
        point.across = S(-0.75);
        point.spent_along = S(0.25);
        point.spent_across = S(1) + static_cast<S>(i);
        point.rolling_W = Vec3<S>(S(0.5), S(-0.25) + static_cast<S>(i), S(1));
      }
      const Held before = sum_of(contact);
      find_again(contact, to);
      ASSERT_EQ(contact.count, to > kD ? 1 : 2);
      const Held after = sum_of(contact);
      EXPECT_NEAR(after.normal, before.normal, 1e-5);
      EXPECT_NEAR(after.spent_normal, before.spent_normal, 1e-5);
      EXPECT_LT((after.across - before.across).norm(), 0.01);
      EXPECT_LT((after.spent_across - before.spent_across).norm(), 0.01);
      EXPECT_LT((after.rolling - before.rolling).norm(), 1e-5);
    }
  }
}

}  // namespace
}  // namespace batuta
