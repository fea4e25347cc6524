// SPDX-License-Identifier: MIT
// Law 5: rods on round floors of any size and at any yaw, rods in a groove, and piles, come to rest
// with a few touches, whatever the step.
//
// How long a rod may rock: it lies across the floor with the inertia m k2 about the contact
// (k2 = I / m + r^2), and swings with energy E above that at rest. Rolling resistance b takes
// b N |w| of it, N = m g; the mean of |w| over a swing is 2 / pi of its most, sqrt(2 E / (m k2)).
// So
//   dE / dt = -(2 / pi) b m g sqrt(2 E / (m k2)),  and all of E takes  pi / (2 b g) sqrt(2 E k2 /
//   m),
// whatever the radius of the floor. A rod that lands from 0.3 m with 10 mJ has 7 s for that: where
// the ends meet the floor blows take more, between (R of 1 ... 5 m) they do not. Contacts may take
// more, so the time is the longest that a rod may take.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::Settling;
using test::Vector;

constexpr double kG = 9.81;
constexpr double kRod = 0.03;        ///< radius of a rod, m
constexpr double kLever = 3e-4;      ///< of its rolling resistance, m
constexpr double kSleepTime = 0.25;  ///< SceneOptions::sleep_time, s
constexpr double kSteps[] = {1e-4, 1e-3, 4e-3, 1.0 / 60, 1.0 / 30};

template <class S>
class Lying : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Lying, Scalars);

/// A rod that is dropped, and what it came to. @tparam SceneT  with or without sleep
template <class SceneT>
struct Dropped {
  using S = typename SceneT::Scalar;
  static constexpr double kWindow = 0.25;  ///< s

  std::unique_ptr<World<SceneT>> world = std::make_unique<World<SceneT>>();
  typename World<SceneT>::BodyId id;
  double mu = 0.5;
  double mass = 0;
  double k2 = 0;          ///< of a turn about the contact, m^2
  double scale = 0;       ///< of the sizes and places of a pair, m
  double time = 0;        ///< s
  double asleep = -1;     ///< s; -1: never
  double may_rock = 3;    ///< the longest time until it sleeps, s
  double most_gain = -1;  ///< of the energy in a window, above what an opening may give, J
  double highest = 0;     ///< of the energy, in this window, J
  double highest_before = std::numeric_limits<double>::max();
  double window_end = kWindow;
  long begins = 0;
  long incomplete = 0;

  void fix(Actor<SceneT> thing, double restitution) {
    thing.friction = static_cast<S>(mu);
    thing.restitution = static_cast<S>(restitution);
    ASSERT_TRUE(world->add(thing).ok());
  }
  /// A round floor along x.
  void add_floor(double radius) {
    fix(test::fixed_rod<SceneT>(10, radius, {0, 0, -radius}, test::along_x()), 0.3);
    scale = 4 * radius + 6;
  }
  /// Logs along y.
  void add_groove() {
    for (int i = -8; i < 8; ++i) {
      fix(test::fixed_rod<SceneT>(3, 0.06, {0.1 * (i + 0.5), 0, -0.06}, test::along_y()), 0.2);
    }
    scale = 4;
  }
  /// A rod of 0.3 m.
  void drop(double yaw, double tilt, const Vector& place, double restitution) {
    auto rod = test::solid_rod<SceneT>(
        0.3, kRod, place,
        test::about(Vector::UnitZ(), yaw) * test::about(Vector::UnitY(), tilt) * test::along_x(),
        700);
    rod.restitution = static_cast<S>(restitution);
    rod.friction = static_cast<S>(mu);
    rod.rolling_resistance = static_cast<S>(kLever);
    mass = 1 / static_cast<double>(rod.body.inverse_mass);
    k2 = 1 / (mass * static_cast<double>(rod.body.inverse_moments.minCoeff())) + kRod * kRod;
    id = world->add(rod).value;
  }
  Vector place() const {
    return std::as_const(*world).get(id)->body.X_WB.p_W.template cast<double>();
  }
  double energy() const {
    return test::sums_of(std::as_const(*world)).kinetic + mass * kG * place().z();
  }
  /// What the search cannot tell from contact, twice (src/world/detail/margin.md), m.
  double margin() const { return 2 * (1e-6 + 72 * static_cast<double>(kRoundOff<S>)) * scale; }
  /// The length that rules rest, m.
  double D(double dt) const { return max_of(max_of(1e-4, 2 * margin()), kG * dt * dt / 4); }

  /// Within a swing its energy sways, because a step goes straight; of two windows, which are
  /// longer than any swing here, the later one has no more.
  void step(double dt) {
    ASSERT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
    time += dt;
    for (const auto& event : world->events()) {
      begins += event.kind == EventKind::kBegin ? 1 : 0;
    }
    incomplete += world->report().complete() ? 0 : 1;
    if (world->is_asleep(id)) asleep = time;
    highest = max_of(highest, energy());
    if (time < window_end) return;
    most_gain = max_of(most_gain, highest - highest_before - mass * kG * D(dt));
    highest_before = highest;
    highest = std::numeric_limits<double>::lowest();
    window_end = time + kWindow;
  }
  void run(double dt, double until) {
    while (time < until && asleep < 0) step(dt);  // Bound: until / dt
  }
  /// From its energy now, how long it may rock.
  void look_how_long(double height_at_rest) {
    const double above = max_of(0.0, energy() - mass * kG * height_at_rest);
    const double rocks = std::acos(-1.0) / (2 * kLever * kG) * std::sqrt(2 * above * k2 / mass);
    may_rock = max_of(3.0, time + rocks + kSleepTime);
  }
};

template <class S>
using Sleeps = Dropped<Settling<S, test::kRolling>>;

// Along a floor a rod rests on two points, and has nothing to rock on.
TYPED_TEST(Lying, RodAlongARoundFloor_SleepsWithin1500ms) {
  for (const double R : {0.05, 0.2, 1.0, 2.0, 10.0, 100.0, 1000.0}) {
    for (const double dt : kSteps) {
      SCOPED_TRACE(::testing::Message() << "R " << R << ", " << dt << " s");
      Sleeps<TypeParam> rod;
      rod.add_floor(R);
      rod.drop(0, 0.3, {0, 0, 0.3}, 0.3);
      rod.run(dt, 1.5);
      EXPECT_GE(rod.asleep, 0);
      EXPECT_LE(rod.begins, 12);
      EXPECT_EQ(rod.incomplete, 0);
      EXPECT_LE(rod.most_gain, 0);
    }
  }
}

// From a floor of a metre and less, whoever is not along it may roll off its side.
TYPED_TEST(Lying, RodOnARoundFloor_SleepsAtAnyYaw) {
  for (const double R : {0.05, 0.2, 1.0, 2.0, 5.0, 10.0, 100.0, 1000.0}) {
    for (const double yaw : {0.2, 0.7, 1.3, 1.57}) {
      for (const double dt : kSteps) {
        SCOPED_TRACE(::testing::Message() << "R " << R << ", yaw " << yaw << ", " << dt << " s");
        Sleeps<TypeParam> rod;
        rod.add_floor(R);
        rod.drop(yaw, 0.3, {0, 0, 0.3}, 0.3);
        rod.run(dt, 1);
        rod.look_how_long(kRod);
        const double off = -0.2;  // it has rolled off
        while (rod.time < rod.may_rock && rod.asleep < 0 && rod.place().z() > off) rod.step(dt);
        EXPECT_LE(rod.begins, 12);
        EXPECT_EQ(rod.incomplete, 0);
        EXPECT_LE(rod.most_gain, 0);
        if (R > 1) {
          EXPECT_GE(rod.asleep, 0);
        }
      }
    }
  }
}

TYPED_TEST(Lying, RodInAGroove_SleepsWithin3SecondsAtAnyYaw) {
  for (const double yaw : {0.0, 0.1, 0.2, 0.4, 0.7, 1.0, 1.3, 1.57}) {
    for (const double dt : {1e-4, 1e-3, 4e-3, 1.0 / 120, 1.0 / 60, 1.0 / 30}) {
      SCOPED_TRACE(::testing::Message() << "yaw " << yaw << ", " << dt << " s");
      Sleeps<TypeParam> rod;
      rod.add_groove();
      rod.drop(yaw, 0.05, {0.01, 0, 0.15}, 0.2);
      rod.run(dt, 3);
      EXPECT_GE(rod.asleep, 0);
      EXPECT_LE(rod.begins, 12);
      EXPECT_EQ(rod.incomplete, 0);
      EXPECT_LE(rod.most_gain, 0);
    }
  }
}

/// A rod that falls on the logs and is thrown along them. It slides for v / (mu g) at most, as a
/// groove presses harder than a plane; then it may roll: with 2/3 of v, braked by b g / r / (3/2),
/// for v r / (b g). Who sleeps is not woken by anything.
template <class S>
void throw_into_groove(double yaw, double speed, double mu, double restitution, double dt) {
  SCOPED_TRACE(::testing::Message() << "yaw " << yaw << ", " << speed << " m/s, mu " << mu << ", C "
                                    << restitution << ", " << dt << " s");
  Sleeps<S> rod;
  rod.mu = mu;
  rod.add_groove();
  rod.drop(yaw, 0.3, {0.01, 0, 0.15}, restitution);
  test::throw_body(*rod.world->get(rod.id), {0, speed, 0});
  rod.run(dt, 3 + speed / (mu * kG) + speed * kRod / (kLever * kG));
  ASSERT_GE(rod.asleep, 0);
  const long begins = rod.begins;
  const double until = rod.time + 1;
  while (rod.time < until) {  // Bound: 1 / dt
    rod.step(dt);
    ASSERT_EQ(rod.asleep, rod.time) << "woken";
  }
  EXPECT_EQ(rod.begins, begins);
  EXPECT_EQ(rod.incomplete, 0);
}

TYPED_TEST(Lying, RodThrownIntoAGroove_SleepsAndSleepsOn) {
  for (const double yaw : {0.0, 0.7, 1.57}) {
    for (const double speed : {0.0, 0.3}) {
      for (const double mu : {0.2, 0.9}) {
        for (const double dt : {1e-3, 1.0 / 60}) {
          throw_into_groove<TypeParam>(yaw, speed, mu, 0, dt);
          throw_into_groove<TypeParam>(yaw, speed, mu, 0.5, dt);
        }
      }
    }
  }
}

/// The most that the centre is from where it was, for a second.
template <class DroppedT>
double jitter(DroppedT& rod, double dt) {
  const Vector from = rod.place();
  const double until = rod.time + 1;
  double most = 0;
  while (rod.time < until) {  // Bound: 1 / dt
    rod.step(dt);
    most = max_of(most, (rod.place() - from).norm());
  }
  return most;
}

// Where nobody sleeps, what has come to rest stays within D.
TYPED_TEST(Lying, RodThatRests_StaysWithinD) {
  using Awake = Dropped<Settling<TypeParam, test::kRollingAwake>>;
  for (const double dt : kSteps) {
    for (const double R : {0.05, 2.0, 100.0, 1000.0}) {
      Awake rod;
      rod.add_floor(R);
      rod.drop(0, 0.3, {0, 0, 0.3}, 0.3);
      for (int i = 0; i < std::lround(2 / dt); ++i) rod.step(dt);
      EXPECT_LE(jitter(rod, dt), rod.D(dt)) << "R " << R << ", " << dt << " s";
    }
    for (const double yaw : {0.0, 0.7, 1.57}) {
      Awake rod;
      rod.add_groove();
      rod.drop(yaw, 0.05, {0.01, 0, 0.15}, 0.2);
      for (int i = 0; i < std::lround(4 / dt); ++i) rod.step(dt);
      EXPECT_LE(jitter(rod, dt), rod.D(dt)) << "yaw " << yaw << ", " << dt << " s";
    }
  }
}

/// Layers of four bars, 2 mm apart, each across the one below, on four fixed logs.
template <class SceneT>
void pile(int bars, double dt) {
  using S = typename SceneT::Scalar;
  auto world = std::make_unique<World<SceneT>>();
  for (int i = 0; i < bars + 4; ++i) {
    const int layer = i / 4;
    const double side = 0.12 * (i % 4 - 1.5);
    const double height = 0.042 * layer;
    const bool is_even = layer % 2 == 0;
    const Vector place = is_even ? Vector(side, 0, height) : Vector(0, side, height);
    const auto turned = is_even ? test::along_y() : test::along_x();
    auto bar = layer == 0 ? test::fixed_rod<SceneT>(0.6, 0.02, place, turned)
                          : test::solid_rod<SceneT>(0.6, 0.02, place, turned, 700);
    bar.friction = S(0.5);
    bar.restitution = S(0.2);
    bar.rolling_resistance = S(3e-4);
    ASSERT_TRUE(world->add(bar).ok());
  }
  const int count = static_cast<int>(std::lround(5 / dt));
  double deepest = 1;
  int steps = 0;
  for (; steps < count && static_cast<int>(world->report().asleep) < bars; ++steps) {
    ASSERT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
    ASSERT_TRUE(world->report().complete()) << "step " << steps;
    if (steps % 8 == 0) deepest = std::min(deepest, test::smallest_gap(*world));
  }
  EXPECT_EQ(static_cast<int>(world->report().asleep), bars);
  EXPECT_GT(deepest, -test::margin_of<S>(2, 0));
}

TYPED_TEST(Lying, PilesOf20And32_SleepWithin5Seconds) {
  for (const int bars : {20, 32}) {
    for (const double dt : {1e-3, 1.0 / 60}) {
      SCOPED_TRACE(::testing::Message() << bars << " bars, " << dt << " s");
      pile<Settling<TypeParam, test::kRolling>>(bars, dt);
    }
  }
}

}  // namespace
}  // namespace batuta
