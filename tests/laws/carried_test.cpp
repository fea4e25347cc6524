// SPDX-License-Identifier: MIT
// Law 2 where contacts do not last: who is carried, and carries another one, gives way across what
// carries it. A ball that lies on another pushes it out from under itself.
#include <gtest/gtest.h>

#include <random>

#include "law_worlds.hpp"

namespace batuta {
namespace {

using test::Vector;

constexpr double kG = 9.81;
constexpr double kFloor = 0.05;  // radius of the rod that is the floor, m

template <class S, RestingContact kRests>
using Turning = test::LawScene<S, kRests, test::kFalling>;
constexpr SceneOptions straight_options() {
  SceneOptions scene;
  scene.max_bodies = 4;
  scene.max_pairs = 6;
  scene.max_contacts = scene.max_events = 64;
  scene.rotation = false;
  scene.gravity = true;
  scene.resting = RestingContact::kNone;
  return scene;
}
template <class S>
using Straight = Scene<straight_options, Translation<S>>;
constexpr SceneOptions small_options() {
  SceneOptions scene = straight_spheres();
  scene.max_bodies = 4;
  scene.max_contacts = 64;
  scene.gravity = true;
  return scene;
}
template <class S>
using Small = Scene<small_options, Spheres<S>>;
/// The same engine on a floor that is level everywhere.
template <class S>
using SmallOnARod = Scene<small_options, Translation<S>>;

template <class S>
class Carried : public ::testing::Test {
 public:
  static constexpr double kRounding = std::is_same_v<S, float> ? 1e-5 : 1e-13;
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Carried, Scalars);

/// A ball of 1,000 kg/m^3.
template <class SceneT>
Actor<SceneT> ball(double radius, const Vector& place, bool is_fixed = false) {
  using S = typename SceneT::Scalar;
  const double mass = 4.0 / 3 * std::acos(-1.0) * radius * radius * radius * 1000;
  if constexpr (SceneT::kRotation) {
    return test::solid_ball<SceneT>(radius, place);
  } else {
    Actor<SceneT> made;
    made.body = make_straight_body<S>(place.template cast<S>(), static_cast<S>(mass)).value;
    if (is_fixed) made.body.inverse_mass = 0;
    if constexpr (SceneT::Search::kForSpheres) {
      made.radius = static_cast<S>(radius);
    } else {
      made.capsule_B = Capsule<S>::sphere(Vec3<S>::Zero(), static_cast<S>(radius));
    }
    return made;
  }
}
/// Level at x = 0 and y = 0; of balls alone a very large one.
template <class SceneT>
Actor<SceneT> ground() {
  using S = typename SceneT::Scalar;
  if constexpr (SceneT::kRotation) {
    return test::fixed_rod<SceneT>(4, kFloor, {0, 0, -kFloor}, test::along_x());
  } else if constexpr (SceneT::Search::kForSpheres) {
    return ball<SceneT>(5, {0, 0, -5}, true);
  } else {
    auto floor = ball<SceneT>(kFloor, {0, 0, -kFloor}, true);
    floor.capsule_B = {{{S(-2), 0, 0}, {S(2), 0, 0}}, static_cast<S>(kFloor)};
    return floor;
  }
}
template <class SceneT>
std::pair<Vector, Vector> place_and_velocity(const Actor<SceneT>& actor) {
  if constexpr (SceneT::kRotation) {
    return {actor.body.X_WB.p_W.template cast<double>(),
            twist_of(actor.body).v_W.template cast<double>()};
  } else {
    return {actor.body.p_W.template cast<double>(),
            (actor.body.inverse_mass * actor.body.momentum_W).template cast<double>()};
  }
}

/// One ball on the floor, another one on it, that leans by an angle.
template <class SceneT>
struct Leaning {
  using S = typename SceneT::Scalar;
  static constexpr double kLower = 0.1, kUpper = 0.06;  // radii, m
  static constexpr double kApart = kLower + kUpper;
  static constexpr double kFrom = 0.5;  // off the vertical, rad

  Leaning() {
    auto settings = world->settings();
    settings.gravity_W = Vec3<S>(0, 0, static_cast<S>(-kG));
    EXPECT_EQ(world->configure(settings), Status::kOk);
    EXPECT_TRUE(world->add(ground<SceneT>()).ok());
    lower = world->add(ball<SceneT>(kLower, {0, 0, kLower + 1e-6})).value;
    const Vector way(std::sin(kFrom), 0, std::cos(kFrom));
    upper =
        world->add(ball<SceneT>(kUpper, Vector(0, 0, kLower + 1e-6) + (kApart + 1e-6) * way)).value;
  }
  /// Along the floor, of both, and what both are summed of, kg m/s.
  std::pair<double, double> momentum() const {
    double sum = 0, size = 0;
    for (const auto id : {lower, upper}) {
      const auto* actor = std::as_const(*world).get(id);
      const double p = place_and_velocity<SceneT>(*actor).second.x() /
                       static_cast<double>(actor->body.inverse_mass);
      sum += p;
      size += std::abs(p);
    }
    return {sum, size};
  }

  std::unique_ptr<World<SceneT>> world = std::make_unique<World<SceneT>>();
  typename World<SceneT>::BodyId lower, upper;
};

/// How fast the lower one is when the other leans by an angle, from energy and momentum: with
/// c = m / (M + m), v = -c R cos(a) a', and T = m/2 R^2 a'^2 (1 - c cos^2 a).
double speed_of_lower(double angle, double m, double M, double R, double from) {
  const double c = m / (M + m);
  const double cosine = std::cos(angle);
  const double square = 2 * kG * (std::cos(from) - cosine) / (R * (1 - c * cosine * cosine));
  return -c * R * cosine * std::sqrt(square);
}

/// @param rounding  of momenta, of what they are summed of; @param share  of the speed, of its
/// truth
template <class SceneT>
void push_out(double dt, double rounding, double share) {
  using Setup = Leaning<SceneT>;
  Setup scene;
  double time = 0, angle = Setup::kFrom;
  bool is_complete = true;
  for (; time < 0.2 && angle < 0.8; time += dt) {
    ASSERT_EQ(scene.world->step(static_cast<typename SceneT::Scalar>(dt)), Status::kOk);
    is_complete = is_complete && std::as_const(*scene.world).report().complete();
    const auto [sum, size] = scene.momentum();
    ASSERT_LE(std::abs(sum), rounding * (size + 1e-3)) << dt << " at " << time;
    const Vector way = place_and_velocity<SceneT>(*scene.world->get(scene.upper)).first -
                       place_and_velocity<SceneT>(*scene.world->get(scene.lower)).first;
    angle = std::atan2(way.x(), way.z());
  }
  EXPECT_TRUE(is_complete) << dt;
  if (!(share < 1)) return;
  const auto& lower = *std::as_const(*scene.world).get(scene.lower);
  const auto& upper = *std::as_const(*scene.world).get(scene.upper);
  const double want =
      speed_of_lower(angle, 1 / static_cast<double>(upper.body.inverse_mass),
                     1 / static_cast<double>(lower.body.inverse_mass), Setup::kApart, Setup::kFrom);
  EXPECT_NEAR(place_and_velocity<SceneT>(lower).second.x(), want, share * std::abs(want)) << dt;
}

TYPED_TEST(Carried, BallUnderABall_IsPushedOut) {
  const double rounding = TestFixture::kRounding;
  for (const double dt : {1e-3, 1e-2}) {
    const double share = 2 * dt / 0.05;  // first order in the step: it falls by 0.3 rad in 0.1 s
    push_out<Turning<TypeParam, RestingContact::kNone>>(dt, rounding, share);
    push_out<Straight<TypeParam>>(dt, rounding, share);
    push_out<Small<TypeParam>>(dt, 2e-2, share);  // the floor's normal: 0.1 m on 5 m
    push_out<Turning<TypeParam, RestingContact::kSeparation>>(dt, rounding, 1);
  }
}

/// Balls one on another, each leaning by an angle, on the floor: nothing pushes along it.
struct Chain {
  std::array<double, 2> leans;   ///< of the second and of the third one, rad
  std::array<double, 3> masses;  ///< kg
};

struct Tally {
  int complete = 0;
  int steps = 0;
};

/// A step that is complete keeps the sum of their momenta along the floor.
template <class SceneT>
void let_fall(const Chain& chain, double dt, int steps, double rounding, Tally& tally) {
  using S = typename SceneT::Scalar;
  constexpr double kRadius = 0.1, kApart = 2 * kRadius + 1e-6;
  auto world = std::make_unique<World<SceneT>>();
  auto settings = world->settings();
  settings.gravity_W = Vec3<S>(0, 0, static_cast<S>(-kG));
  ASSERT_EQ(world->configure(settings), Status::kOk);
  ASSERT_TRUE(world->add(ground<SceneT>()).ok());
  Vector place(0, 0, kRadius + 1e-6);
  std::array<typename World<SceneT>::BodyId, 3> balls;
  for (std::size_t i = 0; i < 3; ++i) {
    const double lean = i == 0 ? 0 : chain.leans[i - 1];
    if (i > 0) place += kApart * Vector(std::sin(lean), 0, std::cos(lean));
    auto actor = ball<SceneT>(kRadius, place);
    const double heavier = chain.masses[i] * static_cast<double>(actor.body.inverse_mass);
    actor.body.inverse_mass = static_cast<S>(1 / chain.masses[i]);
    if constexpr (SceneT::kRotation) actor.body.inverse_moments /= static_cast<S>(heavier);
    balls[i] = world->add(actor).value;
  }
  const auto sums = [&world, &balls, &chain, dt] {
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& actor = *std::as_const(*world).get(balls[i]);
      const double p = chain.masses[i] * place_and_velocity<SceneT>(actor).second.x();
      sum += p;
      size += std::abs(p) + chain.masses[i] * kG * dt;
    }
    return std::pair(sum, size);
  };
  for (int n = 0; n < steps; ++n) {
    const double before = sums().first;
    ASSERT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
    ++tally.steps;
    if (!std::as_const(*world).report().complete()) continue;
    ++tally.complete;
    EXPECT_NEAR(sums().first, before, rounding * sums().second)
        << "leans " << chain.leans[0] << ' ' << chain.leans[1] << ", step " << n << " of " << dt;
  }
}

// Found from outside: what the third one presses along the support of the second one goes on to the
// first one, and is given to nobody. Told (world.md, "Known faults"); and no step is told wrong.
TYPED_TEST(Carried, ThreeThatLeanOnEachOther_KeepTheirMomentumOrSayThatTheyDoNot) {
  const double rounding = std::is_same_v<TypeParam, float> ? 1e-4 : 1e-8;
  Tally none, separation, straight, small;
  for (const double low : {0.0, 0.01, 0.3, -0.6}) {
    for (const double high : {0.0, 0.3, 0.8}) {
      for (const auto& masses :
           {std::array{1.0, 1.0, 1.0}, {1.0, 1.0, 100.0}, {100.0, 1.0, 0.01}}) {
        const Chain chain = {{low, high}, masses};
        for (const double dt : {1e-4, 1e-3, 1e-2}) {
          let_fall<Turning<TypeParam, RestingContact::kNone>>(chain, dt, 20, rounding, none);
          let_fall<Turning<TypeParam, RestingContact::kSeparation>>(chain, dt, 20, rounding,
                                                                    separation);
          let_fall<Straight<TypeParam>>(chain, dt, 20, rounding, straight);
          let_fall<SmallOnARod<TypeParam>>(chain, dt, 20, rounding, small);
        }
      }
    }
  }
  EXPECT_GT(none.complete, none.steps / 5);
  EXPECT_GT(separation.complete, separation.steps / 5);
  EXPECT_GT(straight.complete, straight.steps / 5);
  EXPECT_GT(small.complete, small.steps / 5);
}

// One right above the other, nothing goes aside: no step is told for nothing.
TYPED_TEST(Carried, ThreeUpright_AreComplete) {
  const double rounding = std::is_same_v<TypeParam, float> ? 1e-4 : 1e-8;
  Tally tally;
  for (const double dt : {1e-4, 1e-3, 1e-2}) {
    const Chain upright = {{0, 0}, {1, 2, 3}};
    let_fall<Turning<TypeParam, RestingContact::kNone>>(upright, dt, 20, rounding, tally);
    let_fall<Straight<TypeParam>>(upright, dt, 20, rounding, tally);
  }
  EXPECT_GE(tally.complete, tally.steps - 6) << "the first step of each brings them together";
}

/// Two balls above two rails.
struct OverRails {
  double apart;  ///< half of the way between the rails, m
  double radii[2];
  Vector places[2];
  double speeds[2];  ///< along the rails, m/s
};
// Found from outside, and to the last digit: both are struck while both are carried, and their
// loads go back to them. A body that takes what it was before its partner gives back loses that.
const OverRails kFound = {0.065003260645884992,
                          {0.031246869531792027, 0.048959610315864308},
                          {{0, -0.013214095543778309, 0.20546351495477061},
                           {-0.066095508427638922, 0.033873074153302152, 0.23493461531544529}},
                          {-0.13550213336916855, 0.11392652053482805}};
constexpr double kFoundSeparation = 1e-4;  // D, m

OverRails drawn(std::mt19937_64& random) {
  const auto draw = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  OverRails drawn = {draw(0.04, 0.09), {draw(0.03, 0.1), draw(0.03, 0.1)}, {}, {}};
  for (int i = 0; i < 2; ++i) {
    drawn.places[i] = Vector(i * draw(-0.12, 0.12), draw(-0.08, 0.08), 0.18 + 0.22 * i);
    drawn.speeds[i] = draw(-0.2, 0.2);
  }
  return drawn;
}

/// They fall onto the rails and each other: nothing pushes along the rails.
/// @returns steps that were complete
template <class SceneT>
int fall_onto_rails(const OverRails& scene, double dt, double rounding) {
  using S = typename SceneT::Scalar;
  auto world = std::make_unique<World<SceneT>>();
  auto settings = world->settings();
  settings.gravity_W = Vec3<S>(0, 0, static_cast<S>(-kG));
  settings.separation = static_cast<S>(kFoundSeparation);
  EXPECT_EQ(world->configure(settings), Status::kOk);
  for (const double side : {-1.0, 1.0}) {
    const Vector place(0, side * scene.apart, 0);
    (void)world->add(test::fixed_rod<SceneT>(8, 0.05, place, test::along_x()));
  }
  typename World<SceneT>::BodyId balls[2];
  for (int i = 0; i < 2; ++i) {
    auto ball = test::solid_ball<SceneT>(scene.radii[i], scene.places[i]);
    test::throw_body(ball, {scene.speeds[i], 0, 0});
    balls[i] = world->add(ball).value;
  }
  int complete = 0;
  // And what the step's impulses are summed of: the weight's as well.
  const auto sums = [&world, &balls, dt] {
    double sum = 0, size = 0;
    for (const auto id : balls) {
      const auto& body = std::as_const(*world).get(id)->body;
      const auto p = static_cast<double>(body.momentum.linear_W.x());
      sum += p;
      size += std::abs(p) + kG * dt / static_cast<double>(body.inverse_mass);
    }
    return std::pair(sum, size);
  };
  for (int n = 0; n < 60; ++n) {
    const double before = sums().first;
    EXPECT_EQ(world->step(static_cast<S>(dt)), Status::kOk);
    if (!std::as_const(*world).report().complete()) continue;
    ++complete;
    EXPECT_NEAR(sums().first, before, rounding * sums().second) << dt << ", step " << n;
  }
  return complete;
}

TYPED_TEST(Carried, BallsOnRails_KeepTheirMomentumAlongThem) {
  const double rounding = std::is_same_v<TypeParam, float> ? 1e-4 : 1e-9;
  std::mt19937_64 random(7);
  int complete = 0;
  for (int i = 0; i < 100; ++i) {
    const OverRails scene = i == 0 ? kFound : drawn(random);
    const double dt = i % 2 == 0 ? 1.0 / 30 : 1.0 / 60;
    complete += fall_onto_rails<Turning<TypeParam, RestingContact::kNone>>(scene, dt, rounding);
    complete +=
        fall_onto_rails<Turning<TypeParam, RestingContact::kSeparation>>(scene, dt, rounding);
  }
  EXPECT_GT(complete, 9000) << "of 12,000 steps: in steep grooves answers are used up, and told";
}

}  // namespace
}  // namespace batuta
