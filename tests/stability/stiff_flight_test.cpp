// SPDX-License-Identifier: MIT
// A million steps of free flight, and an orientation after as many updates: nothing but rounding
// adds up. BATUTA_UPDATES=1000000000 in the environment turns for longer.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <memory>

#include "resting.hpp"

namespace batuta {
namespace {

#ifndef BATUTA_UPDATES
#define BATUTA_UPDATES 1000000
#endif

long updates_to_make() {
  const char* updates = std::getenv("BATUTA_UPDATES");
  return updates != nullptr ? std::atol(updates) : BATUTA_UPDATES;
}

template <class S>
using Space = Scene<two_blades, Advancement<S>>;

using Wide = Vec3<long double>;
using WideQuat = Eigen::Quaternion<long double>;

template <class S>
class StiffFlight : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(StiffFlight, Scalars);

/// The angle between two orientations, rad.
long double angle_between(const WideQuat& a, const WideQuat& b) {
  return 2 * (a.normalized().conjugate() * b.normalized()).vec().norm();
}

// A rod that flies and turns. Truth in long double, from the momenta as they are stored.
TYPED_TEST(StiffFlight, MillionSteps_AreExactToRounding) {
  using S = TypeParam;
  using SceneT = Space<S>;
  constexpr long kSteps = std::min(BATUTA_UPDATES, 1000000);
  constexpr auto u = static_cast<long double>(kRoundOff<S>);
  auto world = std::make_unique<World<SceneT>>();
  auto rod = test::rod_at<SceneT>({0.3, -0.2, 0.1}, Vec3<double>::UnitZ());
  rod.body.momentum.linear_W = test::vector<S>(3e-3, -2e-3, 1e-3);
  rod.body.momentum.angular_W = test::vector<S>(0.011, 0.017, -0.006);
  const auto id = world->add(rod).value;
  const Body<S> start = world->get(id)->body;
  const S dt = static_cast<S>(test::kTick);
  for (long i = 0; i < kSteps; ++i) ASSERT_EQ(world->step(dt), Status::kOk);

  const Body<S>& end = world->get(id)->body;
  EXPECT_EQ(end.momentum.linear_W, start.momentum.linear_W) << "to the last bit";
  EXPECT_EQ(end.momentum.angular_W, start.momentum.angular_W);
  const long double time = static_cast<long double>(dt) * kSteps;
  const Wide way = time * static_cast<long double>(start.inverse_mass) *
                   start.momentum.linear_W.template cast<long double>();
  const Wide place = start.X_WB.p_W.template cast<long double>() + way;
  const Wide off = end.X_WB.p_W.template cast<long double>() - place;
  // A step rounds the place once, and the way of a step three times.
  const long double most = u * (kSteps * (place.norm() + way.norm()) + 3 * way.norm());
  EXPECT_LE(off.norm(), most);

  const Wide spin = static_cast<long double>(start.inverse_moments.x()) *
                    start.momentum.angular_W.template cast<long double>();
  const long double angle = spin.norm() * time;
  const Wide axis = spin.normalized();
  const WideQuat turn(Eigen::AngleAxis<long double>(angle, axis));
  const long double turned_off = angle_between(turn * start.X_WB.q_WB.template cast<long double>(),
                                               end.X_WB.q_WB.template cast<long double>());
  // Each update rounds a product, a renewal and a small turn: 8 u, were all to one side.
  EXPECT_LE(turned_off, 8 * u * kSteps + 4 * u * angle);
  EXPECT_LE(std::abs(end.X_WB.q_WB.template cast<long double>().norm() - 1), 4 * u);
  std::printf("  place off by %.1e of %.1e m allowed, orientation by %.1e of %.1e rad\n",
              static_cast<double>(off.norm()), static_cast<double>(most),
              static_cast<double>(turned_off), static_cast<double>(8 * u * kSteps + 4 * u * angle));
}

// Turns of any size, one after the other; unit within 4 u after each of them.
TYPED_TEST(StiffFlight, OrientationAfterManyUpdates_IsStillUnit) {
  using S = TypeParam;
  constexpr auto u = static_cast<double>(kRoundOff<S>);
  Motion<S> motion;
  motion.duration = 1;
  const long updates = updates_to_make();
  double worst = 0;
  for (long i = 0; i < updates; ++i) {
    const auto k = static_cast<S>(i % 97);
    motion.twist.w_W = {S(0.011) * k, S(1e-3) - S(0.007) * k, S(0.5) / (1 + k)};
    motion.X_WB = pose_at(motion, motion.duration);
    const auto& q = motion.X_WB.q_WB;
    const long double square = q.coeffs().template cast<long double>().squaredNorm();
    worst = std::max(worst, static_cast<double>(std::abs(square - 1) / 2));
  }
  EXPECT_LE(worst, 4 * u);
  std::printf("  %ld updates: off unit length by %.2f u at most\n", updates, worst / u);
}

}  // namespace
}  // namespace batuta
