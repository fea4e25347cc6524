// SPDX-License-Identifier: MIT
// A rod that lies across a round floor rocks like a seesaw, and rolling resistance takes the same
// angle of its swing in every cycle: that decides how long such a rod stays awake. From 0.03 rad on
// a floor of 2 m, with 0.3 mm, it is 7 s.
#include <gtest/gtest.h>

#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::Settling;
using test::Vector;

constexpr double kG = 9.81;
constexpr double kFloor = 2;   // radius of the floor, m
constexpr double kRod = 0.03;  // of the rod, m

template <class S>
class Rocking : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Rocking, Scalars);

/// A rod of 0.3 m across the floor, level, that begins to turn by `spin`, rad/s.
template <class SceneT>
struct Seesaw {
  using S = typename SceneT::Scalar;
  std::unique_ptr<World<SceneT>> world = std::make_unique<World<SceneT>>();
  typename World<SceneT>::BodyId id;
  double k2 = 0;  ///< of the turn about the contact, m^2

  /// @param lever  of the rolling resistance, m
  Seesaw(double amplitude, double lever) {
    auto floor = test::fixed_rod<SceneT>(10, kFloor, {0, 0, -kFloor}, test::along_x());
    floor.friction = S(0.5);
    floor.rolling_resistance = static_cast<S>(lever);
    (void)world->add(floor);
    auto rod = test::solid_rod<SceneT>(0.3, kRod, {0, 0, kRod + 5e-5}, test::along_y(), 700);
    rod.friction = S(0.5);
    rod.rolling_resistance = static_cast<S>(lever);
    const double across = static_cast<double>(rod.body.inverse_moments.minCoeff());
    k2 = static_cast<double>(rod.body.inverse_mass) / across + kRod * kRod;
    test::throw_body(rod, Vector::Zero(), Vector(frequency() * amplitude, 0, 0));
    id = world->add(rod).value;
  }
  /// w of small swings: the centre's height is (R - r) angle^2 / 2 above its lowest, rad/s.
  double frequency() const { return std::sqrt(kG * (kFloor - kRod) / k2); }
  /// The largest swing in the next `duration`, from the fastest turn, rad.
  double amplitude(double dt, double duration) {
    double fastest = 0;
    const int count = static_cast<int>(std::lround(duration / dt));
    for (int i = 0; i < count; ++i) {
      EXPECT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
      const auto& body = std::as_const(*world).get(id)->body;
      fastest = max_of(fastest, std::abs(static_cast<double>(twist_of(body).w_W.x())));
    }
    return fastest / frequency();
  }
};

/// What a swing of 0.03 rad has lost after 2 s, rad.
template <class SceneT>
double lost(double lever, double dt) {
  Seesaw<SceneT> seesaw(0.03, lever);
  const double cycle = 2 * std::acos(-1.0) / seesaw.frequency();
  const double start = seesaw.amplitude(dt, cycle);
  (void)seesaw.amplitude(dt, 2 - cycle);
  return start - seesaw.amplitude(dt, cycle);
}

// In each cycle 4 b m g angle of the energy m g (R - r) angle^2 / 2: so 4 b / (R - r) of the angle.
// What contacts take without it is known from a rod without rolling resistance.
TYPED_TEST(Rocking, RollingResistance_TakesTheSameAngleOfEverySwing) {
  using SceneT = Settling<TypeParam, test::kRollingAwake>;
  const double dt = 1e-4;
  const double without = lost<SceneT>(0, dt);
  EXPECT_GT(without, 0);  // no swing grows
  const double frequency = Seesaw<SceneT>(0.03, 0).frequency();
  for (const double lever : {1e-4, 3e-4}) {
    const double cycles = 2 * frequency / (2 * std::acos(-1.0));
    const double want = cycles * 4 * lever / (kFloor - kRod);
    EXPECT_NEAR(lost<SceneT>(lever, dt) - without, want, 0.03 * want) << lever;
  }
}

}  // namespace
}  // namespace batuta
