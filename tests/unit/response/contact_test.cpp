// SPDX-License-Identifier: MIT
#include "batuta/response/contact.hpp"

#include <gtest/gtest.h>

namespace batuta {
namespace {

template <class Scalar>
class ContactOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ContactOf, Scalars);

TYPED_TEST(ContactOf, FromWitness_IsMidwayAndPointsTowardsA) {
  using V = Vec3<TypeParam>;
  const TypeParam r = TypeParam(0.25);
  const auto gap = capsule_gap(Capsule<TypeParam>::sphere(V(0, 0, 0), r),
                               Capsule<TypeParam>::sphere(V(1, 0, 0), r));
  const auto contact = contact_from(gap, V(8, 16, 32));
  EXPECT_EQ(contact.point_W, V(TypeParam(8.5), 16, 32));
  EXPECT_EQ(contact.normal_BA_W, V(-1, 0, 0));
  EXPECT_EQ(contact.gap, TypeParam(0.5));
}

TYPED_TEST(ContactOf, RelativeVelocity_IsNegativeForApproach) {
  using V = Vec3<TypeParam>;
  Contact<TypeParam> contact;
  contact.point_W = V(0, 2, 0);
  contact.normal_BA_W = V(-1, 0, 0);
  const Pose<TypeParam> X_WA;
  Pose<TypeParam> X_WB;
  X_WB.p_W = V(3, 0, 0);
  const Twist<TypeParam> still;
  const Twist<TypeParam> right{V(5, 0, 0), V::Zero()};
  EXPECT_EQ(relative_velocity(contact, X_WA, right, X_WB, still), TypeParam(-5));
  EXPECT_EQ(relative_velocity(contact, X_WA, still, X_WB, right), TypeParam(5));
  EXPECT_EQ(relative_velocity(contact, X_WA, right, X_WB, right), TypeParam(0));
  const Twist<TypeParam> turning{V::Zero(), V(0, 0, 3)};  // w x (0, 2, 0) = (-6, 0, 0)
  EXPECT_EQ(relative_velocity(contact, X_WA, turning, X_WB, still), TypeParam(6));
}

TYPED_TEST(ContactOf, Classify_FollowsTheThreeKinds) {
  const TypeParam eps = TypeParam(0.5);
  EXPECT_EQ(classify(TypeParam(-1), eps), ContactKind::kColliding);
  EXPECT_EQ(classify(TypeParam(-0.5), eps), ContactKind::kResting);
  EXPECT_EQ(classify(TypeParam(0), eps), ContactKind::kResting);
  EXPECT_EQ(classify(TypeParam(0.5), eps), ContactKind::kResting);
  EXPECT_EQ(classify(TypeParam(1), eps), ContactKind::kReceding);
}

}  // namespace
}  // namespace batuta
