// SPDX-License-Identifier: MIT
// A Rack has room for the 64 bodies that it is named for: every step of a heap that falls and of a
// stack that stands is complete.
#include <gtest/gtest.h>

#include <random>

#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::Rotation;
using test::Vector;

template <class S>
class RackOf : public ::testing::Test {
 public:
  using SceneT = Scene<rack, Advancement<S>>;
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(RackOf, Scalars);

/// Eight fixed logs side by side.
template <class SceneT>
void add_logs(World<SceneT>& world) {
  for (int i = 0; i < 8; ++i) {
    auto log = test::fixed_rod<SceneT>(1, 0.03, {0.1 * (i - 3.5), 0, 0}, test::along_y());
    log.friction = 0.5F;
    ASSERT_TRUE(world.add(log).ok());
  }
}

/// Layers of eight bars on them, each across the one below.
template <class SceneT>
void stack(World<SceneT>& world) {
  add_logs(world);
  for (int i = 8; i < SceneT::kMaxBodies; ++i) {
    const int layer = i / 8 - 1;
    const double side = 0.1 * (i % 8 - 3.5);
    const double height = 0.05 + 0.04 * layer + 5e-5 * (layer + 1);
    const bool is_even = layer % 2 == 0;
    auto bar = test::solid_rod<SceneT>(1, 0.02,
                                       is_even ? Vector(0, side, height) : Vector(side, 0, height),
                                       is_even ? test::along_x() : test::along_y(), 700);
    bar.friction = 0.5F;
    ASSERT_TRUE(world.add(bar).ok());
  }
}

/// The rack that is priced (tests/measure/price/scene/actors.hpp): the same, 5 mm apart.
template <class SceneT>
void price(World<SceneT>& world) {
  using S = typename SceneT::Scalar;
  for (int i = 0; i < SceneT::kMaxBodies; ++i) {
    const int row = i / 8;
    const double across = 0.1 * (i % 8 - 3.5);
    const double height = 0.055 * row;
    const bool is_along_x = row % 2 == 1;
    const double radius = row == 0 ? 0.03 : 0.02;
    const Vector place = is_along_x ? Vector(0, across, height) : Vector(across, 0, height);
    const Rotation turned = is_along_x ? test::along_x() : test::along_y();
    auto bar = test::fixed_rod<SceneT>(1, radius, place, turned);
    if (row > 0) {
      bar.body.inverse_mass = S(2);
      bar.body.inverse_moments = {S(30), S(30), S(3000)};
    }
    bar.friction = S(0.3);
    ASSERT_TRUE(world.add(bar).ok());
  }
}

/// Short bars that fall on them, turned at random.
template <class SceneT>
void let_fall(World<SceneT>& world, unsigned seed) {
  add_logs(world);
  std::mt19937 random(seed);
  const auto draw = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  for (int i = 8; i < SceneT::kMaxBodies; ++i) {
    const double x = draw(-0.2, 0.2);
    const Vector place(x, draw(-0.2, 0.2), 0.1 + 0.07 * (i - 8));
    const Rotation tilt = test::about(Vector::UnitX(), draw(1.5, 1.64));
    const Rotation yaw = test::about(Vector::UnitZ(), draw(0, 3));
    auto bar = test::solid_rod<SceneT>(0.25, 0.025, place, yaw * tilt, 700);
    bar.friction = 0.5F;
    bar.restitution = 0.3F;
    ASSERT_TRUE(world.add(bar).ok());
  }
}

struct Room {
  int events = 0;
  int asleep = 0;
};
template <class SceneT>
Room run(World<SceneT>& world, double dt, double duration) {
  using S = typename SceneT::Scalar;
  Room most;
  const int count = static_cast<int>(std::lround(duration / dt));
  for (int i = 0; i < count; ++i) {
    EXPECT_EQ(world.step(static_cast<S>(dt)), Status::kOk);
    const auto& report = world.report();
    EXPECT_TRUE(report.complete())
        << "step " << i << " of " << dt << " s: frozen " << report.frozen << ", pairs "
        << report.pairs_dropped << ", contacts " << report.contacts_dropped << ", events "
        << report.events_dropped << ", cut " << report.searches_cut << ", invalid "
        << report.searches_invalid << ", touches " << report.contacts_untracked;
    most.events = max_of(most.events, world.events().size());
    most.asleep = max_of(most.asleep, static_cast<int>(report.asleep));
    if (::testing::Test::HasFailure()) return most;
  }
  return most;
}

TYPED_TEST(RackOf, StackThatStands_EveryStepIsComplete) {
  for (const double dt : {1e-3, 1.0 / 60}) {
    auto world = std::make_unique<World<typename TestFixture::SceneT>>();
    stack(*world);
    const Room most = run(*world, dt, 2);
    EXPECT_EQ(most.asleep, 56) << dt;
  }
}

TYPED_TEST(RackOf, RackThatIsPriced_EveryStepIsComplete) {
  for (const double dt : {1e-3, 1.0 / 60}) {
    auto world = std::make_unique<World<typename TestFixture::SceneT>>();
    price(*world);
    const Room most = run(*world, dt, 1);
    EXPECT_GT(most.events, 50) << "or nothing has met";
    EXPECT_EQ(most.asleep, 56) << dt;
  }
}

// At 1/60 s bars that turn by a third of a radian in a step and press on each other ask for more
// answers than a step has: a tenth of the steps is told as incomplete.
TYPED_TEST(RackOf, HeapThatFalls_EveryStepIsComplete) {
  for (const unsigned seed : {1U, 2U}) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    auto world = std::make_unique<World<typename TestFixture::SceneT>>();
    let_fall(*world, seed);
    const Room most = run(*world, 1e-3, 1.5);
    EXPECT_GT(most.events, 20) << "or nothing has met";
  }
}

}  // namespace
}  // namespace batuta
