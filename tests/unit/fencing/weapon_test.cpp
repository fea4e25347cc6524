// SPDX-License-Identifier: MIT
#include "batuta/fencing/weapon.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

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
  const auto weapon = epee<double>();
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
  const auto weapon = epee<double>();
  const auto body = weapon_body(weapon).value;
  const Capsule<double> back = to_world(body.X_HB, body.blade_B);
  EXPECT_LE((back.axis.a - weapon.parts[0].capsule_H.axis.a).norm(), 1e-15);
  EXPECT_LE((back.axis.b - weapon.parts[0].capsule_H.axis.b).norm(), 1e-15);
  EXPECT_EQ(back.radius, weapon.parts[0].capsule_H.radius);
}

// Against the capsules as they are given, each moved by X_HB.
TEST(WeaponBody, GuardAndHand_AreTheSameCapsulesInBothFrames) {
  auto weapon = epee<double>();
  weapon.parts[1].capsule_H = {{{0.06, 0.01, -0.02}, {0.08, -0.03, 0.01}}, 0.05};  // off the axis
  weapon.hand_H = {{{-0.04, 0.02, 0.01}, {0.03, 0, -0.02}}, 0.035};
  const auto body = weapon_body(weapon).value;
  EXPECT_GT(body.X_HB.q_WB.angularDistance(Quat<double>::Identity()), 1e-3) << "B is turned";
  for (const auto& [capsule_B, capsule_H] :
       {std::pair{body.guard_B, weapon.parts[1].capsule_H}, {body.hand_B, weapon.hand_H}}) {
    const Mat3<double> R = body.X_HB.q_WB.toRotationMatrix();
    EXPECT_LE((body.X_HB.p_W + R * capsule_B.axis.a - capsule_H.axis.a).norm(), 1e-15);
    EXPECT_LE((body.X_HB.p_W + R * capsule_B.axis.b - capsule_H.axis.b).norm(), 1e-15);
    EXPECT_EQ(capsule_B.radius, capsule_H.radius);
  }
}

// The hand is the arm's: it has a shape and no mass.
TEST(WeaponBody, Hand_WeighsNothing) {
  auto weapon = epee<double>();
  const auto before = weapon_body(weapon).value;
  weapon.hand_H.radius *= 2;
  const auto after = weapon_body(weapon).value;
  EXPECT_EQ(after.mass, before.mass);
  EXPECT_EQ(after.moments, before.moments);
  EXPECT_EQ(after.X_HB.p_W, before.X_HB.p_W);
}

TEST(WeaponBody, BadHand_IsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](auto change) {
    auto weapon = epee<double>();
    change(weapon.hand_H);
    return weapon_body(weapon).status == Status::kInvalidArgument;
  };
  EXPECT_TRUE(refused([](auto& hand_H) { hand_H.radius = -0.01; }));
  EXPECT_TRUE(refused([nan](auto& hand_H) { hand_H.radius = nan; }));
  EXPECT_TRUE(refused([nan](auto& hand_H) { hand_H.axis.a.y() = nan; }));
  EXPECT_TRUE(
      refused([](auto& hand_H) { hand_H.axis.b.z() = std::numeric_limits<double>::infinity(); }));
  EXPECT_FALSE(refused([](auto& hand_H) { hand_H.radius = 0; }));
}

TEST(WeaponBody, PointMassPart_Counts) {
  auto weapon = epee<float>();
  weapon.parts[3].capsule_H.radius = 0;
  EXPECT_NEAR(weapon_body(weapon).value.mass, 0.77F, 1e-6F);
}

TEST(WeaponBody, BadParts_AreRefused) {
  for (std::size_t i = 0; i < 4; ++i) {
    auto weapon = epee<double>();
    weapon.parts[i].mass = 0;
    EXPECT_EQ(weapon_body(weapon).status, Status::kInvalidArgument);
    weapon.parts[i].mass = std::numeric_limits<double>::infinity();
    EXPECT_EQ(weapon_body(weapon).status, Status::kInvalidArgument);
    weapon = epee<double>();
    weapon.parts[i].capsule_H.radius = -1;
    EXPECT_EQ(weapon_body(weapon).status, Status::kInvalidArgument);
  }
}

template <class S>
class ReadyMadeWeapon : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ReadyMadeWeapon, Scalars);

/// Every number of it, by its bits.
template <class S>
std::vector<S> numbers_of(const WeaponBody<S>& weapon) {
  std::vector<S> numbers{weapon.mass, weapon.restitution};
  const auto add = [&numbers](const auto& v) {
    for (int i = 0; i < v.size(); ++i) numbers.push_back(v[i]);
  };
  add(weapon.moments);
  add(weapon.X_HB.p_W);
  add(weapon.X_HB.q_WB.coeffs());
  for (const auto& capsule : {weapon.blade_B, weapon.guard_B, weapon.hand_B}) {
    add(capsule.axis.a);
    add(capsule.axis.b);
    numbers.push_back(capsule.radius);
  }
  return numbers;
}

// fencer.cpp has the numbers; here they are made of the parts.
TYPED_TEST(ReadyMadeWeapon, OfTheFencers_IsThatOfTheEpeeToTheLastBit) {
  using S = TypeParam;
  const auto made = weapon_body(epee<S>());
  ASSERT_TRUE(made.ok());
  const std::vector<S> truth = numbers_of(made.value);
  for (const Fencer<S>& fencer : {first_fencer<S>(), second_fencer<S>()}) {
    const std::vector<S> kept = numbers_of(fencer.weapon);
    ASSERT_EQ(kept.size(), truth.size());
    EXPECT_EQ(std::memcmp(kept.data(), truth.data(), truth.size() * sizeof(S)), 0)
        << ::testing::PrintToString(truth) << ", kept: " << ::testing::PrintToString(kept);
  }
}

TEST(Validate, WeaponBodyOutOfRange_IsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const auto refused = [](auto change) {
    WeaponBody<double> weapon = first_fencer<double>().weapon;
    change(weapon);
    return validate(weapon) == Status::kInvalidArgument;
  };
  EXPECT_FALSE(refused([](auto&) {}));
  EXPECT_EQ(validate(WeaponBody<double>{}), Status::kInvalidArgument);
  for (const double bad : {nan, inf, 0.0, -1.0}) {
    EXPECT_TRUE(refused([bad](auto& w) { w.mass = bad; })) << bad;
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(refused([bad, i](auto& w) { w.moments[i] = bad; }));
  }
  for (const double bad : {nan, inf, -0.1, 1.1}) {
    EXPECT_TRUE(refused([bad](auto& w) { w.restitution = bad; })) << bad;
  }
  for (const double bad : {nan, inf}) {
    EXPECT_TRUE(refused([bad](auto& w) { w.X_HB.p_W.y() = bad; }));
    EXPECT_TRUE(refused([bad](auto& w) { w.X_HB.q_WB.x() = bad; }));
    EXPECT_TRUE(refused([bad](auto& w) { w.blade_B.axis.b.z() = bad; }));
    EXPECT_TRUE(refused([bad](auto& w) { w.hand_B.radius = bad; }));
  }
  EXPECT_TRUE(refused([](auto& w) { w.X_HB.q_WB.w() = 1.01; }));
  EXPECT_TRUE(refused([](auto& w) { w.X_HB.q_WB.w() = 0; }));
  EXPECT_TRUE(refused([](auto& w) { w.guard_B.radius = -1; }));
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
