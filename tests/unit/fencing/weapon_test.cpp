// SPDX-License-Identifier: MIT
#include "batuta/fencing/weapon.hpp"

#include <gtest/gtest.h>

#include "batuta/fencing/fencer.hpp"

namespace batuta {
using namespace fencing;
namespace {

/// Mass, centre and transverse moment of the epee by sums over thin slices in long double, for the
/// parts on the x axis.
struct Sliced {
  long double mass = 0;
  long double center = 0;
  long double transverse = 0;
  long double axial = 0;
};

long double slice_area(const Capsule<double>& c, long double x) {
  const long double beyond = std::max<long double>({c.axis.a.x() - x, x - c.axis.b.x(), 0.0L});
  return std::max(0.0L,
                  static_cast<long double>(c.radius) * c.radius - beyond * beyond);  // over pi
}

Sliced slice(const Weapon<double>& weapon) {
  constexpr int kSlices = 20000;
  Sliced sum;
  long double second = 0;
  for (const auto& part : weapon.parts) {
    const auto& c = part.capsule_H;
    const long double x0 = c.axis.a.x() - c.radius;
    const long double dx = (c.axis.b.x() + c.radius - x0) / kSlices;
    long double volume = 0, first = 0, own_second = 0, across = 0;
    for (int i = 0; i < kSlices; ++i) {
      const long double x = x0 + (i + 0.5L) * dx;
      const long double area = slice_area(c, x);
      volume += area;
      first += area * x;
      own_second += area * (x * x + area / 4);
      across += area * area / 2;
    }
    sum.mass += part.mass;
    sum.center += part.mass * first / volume;
    second += part.mass * own_second / volume;
    sum.axial += part.mass * across / volume;
  }
  sum.center /= sum.mass;
  sum.transverse = second - sum.mass * sum.center * sum.center;
  return sum;
}

TEST(WeaponBody, OfTheEpee_MatchesSumsOverSlices) {
  const auto weapon = first_fencer<double>().weapon;
  const auto body = weapon_body(weapon);
  ASSERT_TRUE(body.ok());
  const Sliced truth = slice(weapon);
  EXPECT_NEAR(body.value.mass, 0.77, 1e-7);
  EXPECT_NEAR(body.value.X_HB.p_W.x(), static_cast<double>(truth.center), 1e-7);
  EXPECT_NEAR(body.value.moments.x(), static_cast<double>(truth.axial), 1e-7);
  EXPECT_NEAR(body.value.moments.y(), static_cast<double>(truth.transverse), 1e-6);
  EXPECT_NEAR(body.value.moments.z(), static_cast<double>(truth.transverse), 1e-6);
}

TEST(WeaponBody, Blade_IsTheSameCapsuleInBothFrames) {
  const auto weapon = second_fencer<double>().weapon;
  const auto body = weapon_body(weapon).value;
  const Capsule<double> back = to_world(body.X_HB, body.blade_B);
  EXPECT_LE((back.axis.a - weapon.parts[0].capsule_H.axis.a).norm(), 1e-15);
  EXPECT_LE((back.axis.b - weapon.parts[0].capsule_H.axis.b).norm(), 1e-15);
  EXPECT_EQ(back.radius, weapon.parts[0].capsule_H.radius);
}

TEST(WeaponBody, PointMassPart_Counts) {
  auto weapon = first_fencer<float>().weapon;
  weapon.parts[3].capsule_H.radius = 0;
  EXPECT_NEAR(weapon_body(weapon).value.mass, 0.77F, 1e-6F);
}

TEST(WeaponBody, BadParts_AreRefused) {
  for (std::size_t i = 0; i < 4; ++i) {
    auto weapon = first_fencer<double>().weapon;
    weapon.parts[i].mass = 0;
    EXPECT_EQ(weapon_body(weapon).status, Status::kInvalidArgument);
    weapon.parts[i].mass = std::numeric_limits<double>::infinity();
    EXPECT_EQ(weapon_body(weapon).status, Status::kInvalidArgument);
    weapon = first_fencer<double>().weapon;
    weapon.parts[i].capsule_H.radius = -1;
    EXPECT_EQ(weapon_body(weapon).status, Status::kInvalidArgument);
  }
}

TEST(Inverse, TakesAPoseBack) {
  const Pose<double> A{{1, -2, 3}, exp_map(Vec3<double>(0.3, -1, 0.7))};
  const Vec3<double> x(0.4, 5, -6);
  EXPECT_LE((to_world(inverse(A), to_world(A, x)) - x).norm(), 1e-14);
}

TEST(Chained, IsOnePoseAfterTheOther) {
  const Pose<double> A{{1, 2, 3}, exp_map(Vec3<double>(0.3, -0.2, 1))};
  const Pose<double> B{{-1, 0.5, 2}, exp_map(Vec3<double>(1.3, 0.2, -0.4))};
  const Vec3<double> x(0.7, -0.1, 0.2);
  EXPECT_LE((to_world(chained(A, B), x) - to_world(A, to_world(B, x))).norm(), 1e-15);
}

}  // namespace
}  // namespace batuta
