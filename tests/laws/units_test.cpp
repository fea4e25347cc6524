// SPDX-License-Identifier: MIT
// A heap is the same to the last bit in units of length and time that are powers of two of others:
// then every length, speed and energy in it is, and no number of the library may be of one unit.
#include <gtest/gtest.h>

#include "choices.hpp"
#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::Vector;

template <class S>
class OtherUnits : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(OtherUnits, Scalars);

constexpr int kFloor = 7;
constexpr int kRods = 12;

/// How many of the new units an old one is.
struct Factors {
  double length = 1;
  double time = 1;
};

template <class SceneT>
auto heap_in(const Factors& in, std::uint64_t seed) {
  using S = typename SceneT::Scalar;
  auto world = std::make_unique<World<SceneT>>();
  auto settings = world->settings();
  settings.rest_speed *= static_cast<S>(in.length / in.time);
  settings.separation *= static_cast<S>(in.length);
  settings.min_separation_time *= static_cast<S>(in.time);
  settings.gravity_W *= static_cast<S>(in.length / (in.time * in.time));
  EXPECT_EQ(world->configure(settings), Status::kOk);
  for (int i = 0; i < kFloor; ++i) {
    const Vector place(0, in.length * (i - 3) * 0.12, in.length * -0.1);
    auto rod = test::fixed_rod<SceneT>(in.length * 2, in.length * 0.1, place, test::along_x());
    rod.friction = S(0.6);
    (void)world->add(rod);
  }
  test::Choices draw(seed);
  for (int i = 0; i < kRods; ++i) {
    const double half = 0.05 + 0.05 * draw.of(3);
    const Vector place(0.4 * draw.signed_share(), 0.3 * draw.signed_share(), 0.2 + 0.2 * i);
    auto rod = test::solid_rod<SceneT>(in.length * half, in.length * 0.04, in.length * place,
                                       draw.rotation());
    rod.friction = S(0.5);
    rod.restitution = static_cast<S>(0.3 * draw.of(2));
    test::throw_body(rod, (in.length / in.time) * draw.in_cube(), (3 / in.time) * draw.in_cube());
    (void)world->add(rod);
  }
  return world;
}

TYPED_TEST(OtherUnits, HeapThatFalls_IsTheSameToTheLastBit) {
  using S = TypeParam;
  using SceneT = test::Settling<S, test::kHeaps>;
  constexpr int kSteps = 120;
  // The last two: speeds, and what impulses change of them, far below and above 1.
  const Factors others[] = {{0x1p7, 0x1p2}, {0x1p-6, 0x1p-3}, {1, 0x1p24}, {1, 0x1p-24}};
  for (const Factors& in : others) {
    for (std::uint64_t seed = 1; seed < 9; ++seed) {
      const auto here = heap_in<SceneT>({}, seed);
      const auto there = heap_in<SceneT>(in, seed);
      std::uint32_t contacts = 0;
      for (int i = 0; i < kSteps; ++i) {
        const double dt = 1.0 / 60;
        ASSERT_EQ(here->step(static_cast<S>(dt)), Status::kOk);
        ASSERT_EQ(there->step(static_cast<S>(dt * in.time)), Status::kOk);
        contacts += static_cast<std::uint32_t>(here->report().collisions);
        ASSERT_EQ(here->report().evaluations, there->report().evaluations)
            << seed << ", step " << i;
        for (int k = kFloor; k < kFloor + kRods; ++k) {
          const auto slot = static_cast<std::uint16_t>(k);
          const auto& A = here->get(here->id_at(slot))->body;
          const auto& B = there->get(there->id_at(slot))->body;
          const Vec3<S> off = B.X_WB.p_W - static_cast<S>(in.length) * A.X_WB.p_W;
          ASSERT_TRUE(off.isZero(0)) << "body " << k << ", seed " << seed << ", step " << i;
        }
      }
      EXPECT_GT(contacts, 50U);
    }
  }
}

}  // namespace
}  // namespace batuta
