// SPDX-License-Identifier: MIT
// Law 2 where gaps are opened again and again: rods that a central force presses together, at rest
// and turning, keep their linear momentum and what angular momentum the force has not given them
// (its torque is summed here, from where the bodies are when it acts). What opens a gap shifts
// bodies that carry momentum: kept by nobody, that is 1e-4 ... 2e-3 of the summed |x| |p| + |b|.
#include <gtest/gtest.h>

#include "draws.hpp"
#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::Rotation;
using test::Sums;
using test::Vector;

constexpr int kRods = 12;
constexpr double kPull = 10;  ///< of the force over mass and distance, 1/s^2

template <class S>
class Pressed : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Pressed, Scalars);

template <class SceneT>
struct PressedRods {
  using S = typename SceneT::Scalar;

  std::unique_ptr<World<SceneT>> world = std::make_unique<World<SceneT>>();
  Vector given = Vector::Zero();  ///< angular momentum about the origin, by the force
  long contacts = 0;

  PressedRods(std::uint64_t seed, double turn, const Vector& middle = Vector::Zero(),
              double size = 1) {
    test::Draws draws(7, seed, 1);
    for (int i = 0; i < kRods; ++i) {
      const double half = 0.25 * (1 + 0.06 * i);
      const double x = draws.between(-half, half);
      const double y = draws.between(-half, half);
      const Vector place(x, y, draws.between(-half, half));
      Rotation q_WB = test::about(draws.direction(), draws.between(0, 3));
      auto rod = test::solid_rod<SceneT>(size * 0.3, size * 0.03, middle + size * place, q_WB, 700);
      rod.friction = S(0.5);
      rod.restitution = S(0.2);
      test::throw_body(rod, size * turn * Vector(-y, x, 0));
      EXPECT_TRUE(world->add(rod).ok());
    }
  }
  Sums sums() const { return test::sums_of(std::as_const(*world)); }
  void pull(double dt) { given += test::pull_together(*world, kPull, dt); }
};

/// 15 s of it. @param turn  of all about the z axis at first, rad/s
template <class S>
void press(std::uint64_t seed, double turn, double dt) {
  SCOPED_TRACE(::testing::Message() << "seed " << seed << ", " << turn << " rad/s, " << dt << " s");
  PressedRods<test::Settling<S, test::kFloating>> rods(seed, turn);
  const Vector start = rods.sums().spin;
  double spread = 0;
  double off = 0;
  double energy = 0;  // the most that a step added
  const int count = static_cast<int>(std::lround(15 / dt));
  for (int i = 0; i < count; ++i) {
    rods.pull(dt);
    const double before = rods.sums().kinetic;
    ASSERT_EQ(rods.world->step(static_cast<S>(dt)), Status::kOk);
    rods.contacts += rods.world->report().collisions;
    const Sums now = rods.sums();
    energy = max_of(energy, now.kinetic - before);
    spread = max_of(spread, now.spread);
    off = max_of(off, (now.spin - start - rods.given).norm());
  }
  // In double to rounding, but for steps in which a turning set is pressed narrower: it would be
  // faster, and what it would take is more than its rods have by moving among themselves.
  EXPECT_LE(off, (std::is_same_v<S, float> ? 1e-5 : 1e-6) * spread);
  // No step adds energy, to the rounding of what it had.
  EXPECT_LE(energy, 64 * static_cast<double>(kRoundOff<S>) * spread);
  EXPECT_GE(rods.contacts, 300) << "or nothing is seen";
}

TYPED_TEST(Pressed, RodsThatArePressedTogether_KeepAngularMomentum) {
  for (const double dt : {1e-3, 4e-3, 1.0 / 60, 1.0 / 30}) {
    for (const double turn : {0.0, 1.0}) {
      press<TypeParam>(1, turn, dt);
      if (dt > 1e-3) press<TypeParam>(2, turn, dt);
    }
  }
}

/// Places are rounded to 512 u of a metre there, and the common centre with them.
TYPED_TEST(Pressed, FarFromTheOrigin_LinearMomentumIsKept) {
  using S = TypeParam;
  const Vector far(1000, 0, 0);
  for (const double size : {1.0, 0.1}) {
    PressedRods<test::Settling<S, test::kFloating>> rods(3, 1, far, size);
    for (int i = 0; i < 8000; ++i) {
      rods.pull(1e-3);
      const Sums before = rods.sums();
      ASSERT_EQ(rods.world->step(S(1e-3)), Status::kOk);
      const Sums now = rods.sums();
      const double rounding =
          8 * static_cast<double>(kRoundOff<S>) * (1 + rods.world->report().collisions + 2 * kRods);
      EXPECT_LE((now.momentum - before.momentum).norm(),
                rounding * max_of(before.pushes, now.pushes))
          << "size " << size << ", step " << i;
      rods.contacts += rods.world->report().collisions;
    }
    EXPECT_GE(rods.contacts, 50) << "or nothing is seen";
  }
}

}  // namespace
}  // namespace batuta
