// SPDX-License-Identifier: MIT
// Heaps of bodies of several capsules that fall on a floor of rods: light ones are struck again and
// again between heavy ones, late in a step. Every law holds. With openings that have no end
// (furthest_way) some of these eighty heaps throw a body by 1 m to 8 km in a step.
#include <gtest/gtest.h>

#include "choices.hpp"
#include "law_worlds.hpp"
#include "six_laws.hpp"

namespace batuta {
namespace {

using test::Vector;

template <class S>
class RandomHeap : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(RandomHeap, Scalars);

constexpr int kFloor = 11;

/// A rod; with an arm at one end or at both. Light or forty times as dense.
template <class SceneT>
Actor<SceneT> body_of(test::Choices& draw, double height) {
  using S = typename SceneT::Scalar;
  const double s = 0.06 + 0.04 * draw.of(3);
  const Vec3<S> low = Vector(0, 0, -s).cast<S>();
  const Vec3<S> high = Vector(0, 0, s).cast<S>();
  const S density = draw.of(2) == 0 ? S(200) : S(8000);
  const S radius = static_cast<S>(s / 4);
  const CapsulePart<S> parts[] = {{{{low, high}, radius}, density},
                                  {{{high, Vector(0, s, s).cast<S>()}, radius}, density},
                                  {{{low, Vector(s, 0, -s).cast<S>()}, radius}, density}};
  const Vector place(0.4 * draw.signed_share(), 0.3 * draw.signed_share(), height);
  const Pose<S> X_WB = {place.cast<S>(), draw.rotation().template cast<S>()};
  const auto made = make_compound<3>(&parts[0], 1 + draw.of(3), X_WB).value;
  Actor<SceneT> actor;
  actor.body = made.body;
  for (const auto& capsule : made.capsules_B) (void)actor.capsules_B.push(capsule);
  actor.friction = S(0.5);
  actor.restitution = static_cast<S>(0.3 * draw.of(2));
  test::throw_body(actor, draw.in_cube(), 3 * draw.in_cube());
  return actor;
}

template <class SceneT>
test::Seen seen_of(const World<SceneT>& world) {
  test::Seen seen;
  for (int i = 0; i < SceneT::kMaxBodies; ++i) {
    const auto* actor = world.get(world.id_at(static_cast<std::uint16_t>(i)));
    if (actor == nullptr) continue;
    seen.push_back(test::see(*actor));
    seen.back().led = i < kFloor;
  }
  return seen;
}

TYPED_TEST(RandomHeap, LightBodiesBetweenHeavyOnes_KeepEveryLaw) {
  using SceneT = test::Settling<TypeParam, test::kHeaps>;
  for (std::uint64_t seed = 64; seed < 104; ++seed) {
    test::Choices draw(seed);
    auto world = std::make_unique<World<SceneT>>();
    for (int i = 0; i < kFloor; ++i) {
      auto rod = test::fixed_rod<SceneT>(2, 0.1, {0, (i - 5) * 0.12, -0.1}, test::along_x());
      rod.friction = TypeParam(0.6);
      (void)world->add(rod);
    }
    for (int i = 0; i < 16; ++i) (void)world->add(body_of<SceneT>(draw, 0.2 + 0.25 * i));
    test::Seen before = seen_of(*world);
    for (int i = 0; i < 150; ++i) {
      const double dt = i % 3 == 2 ? 1e-3 : 1.0 / 60;
      ASSERT_EQ(world->step(static_cast<TypeParam>(dt)), Status::kOk);
      test::Seen after = seen_of(*world);
      const auto told = test::told_by(std::as_const(*world), dt, Vector(0, 0, -9.81));
      for (const auto& breach : test::broken_laws(before, after, told)) {
        ADD_FAILURE() << breach.law << ' ' << breach.what << ": " << static_cast<double>(breach.by)
                      << ", at most " << static_cast<double>(breach.may_be) << "; seed " << seed
                      << ", step " << i;
      }
      before = std::move(after);
    }
  }
}

}  // namespace
}  // namespace batuta
