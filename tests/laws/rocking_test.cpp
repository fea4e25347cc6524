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
  double k2 = 0;    ///< of the turn about the contact, m^2
  double time = 0;  ///< in to_next_end(), s

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
  struct Swing {
    double end = 0;      ///< s
    double fastest = 0;  ///< turn, rad/s
  };
  /// Until its turn changes its sign: when is known between two steps in a straight line.
  Swing to_next_end(double dt) {
    Swing swing;
    for (double before = spin(); swing.end == 0;) {  // Bound: 2 s
      EXPECT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
      const double now = spin();
      if (now * before < 0) swing.end = time + before / (before - now) * dt;
      time += dt;
      if (time > 2) return swing;
      swing.fastest = max_of(swing.fastest, std::abs(before));
      before = now;
    }
    return swing;
  }
  double spin() const {
    return static_cast<double>(twist_of(std::as_const(*world).get(id)->body).w_W.x());
  }
  /// The largest swing in the next `duration`, from the fastest turn, rad.
  double amplitude(double dt, double duration) {
    double fastest = 0;
    const int count = static_cast<int>(std::lround(duration / dt));
    for (int i = 0; i < count; ++i) {
      EXPECT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
      fastest = max_of(fastest, std::abs(spin()));
    }
    return fastest / frequency();
  }
  /// Half a swing, from one end to the other: how long it takes, s, by energy. Off the middle,
  /// where it lies on the floor (R - r) angle^2 / 2 higher and R angle from its centre, (k2 + R^2
  /// angle^2) w^2 = g (R - r) (amplitude^2 - angle^2).
  double half_swing(double amplitude) const {
    constexpr int kParts = 1000;
    const double right = std::acos(-1.0) / 2;
    double sum = 0;
    for (int i = 0; i < kParts; ++i) {
      const double far = kFloor * amplitude * std::sin((i + 0.5) / kParts * right);
      sum += std::sqrt(k2 + far * far) * right / kParts;
    }
    return 2 * sum / std::sqrt(kG * (kFloor - kRod));
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

// By the amplitude that the fastest turn of each half swing has.
TYPED_TEST(Rocking, Period_IsThatOfItsInertia) {
  using SceneT = Settling<TypeParam, test::kRollingAwake>;
  for (const double lever : {0.0, 1e-4}) {
    for (const double dt : {1e-4, 1e-3}) {
      Seesaw<SceneT> seesaw(0.03, lever);
      double start = seesaw.to_next_end(dt).end;
      for (int i = 0; i < 6; ++i) {
        const auto swing = seesaw.to_next_end(dt);
        const double want = seesaw.half_swing(swing.fastest / seesaw.frequency());
        EXPECT_NEAR(swing.end - start, want, 0.01 * want) << i << ": " << lever << ' ' << dt;
        start = swing.end;
      }
    }
  }
}

}  // namespace
}  // namespace batuta
