// SPDX-License-Identifier: MIT
// Sizes from 1e-6 to 1e6 m, and places far from the origin. Truth: a power of two changes no digit,
// so every answer at another scale is the same bits, scaled; far away, the exact distance of what
// was rounded, and a world in double.
#include "batuta/detection/advancement.hpp"
#include "batuta/response/friction.hpp"
#include "batuta/response/separation.hpp"
#include "exact_distance.hpp"
#include "world_scenes.hpp"

namespace batuta {
namespace {

template <class S>
class Scales : public testing::Test {};
TYPED_TEST_SUITE(Scales, test::Scalars);

/// 2^-20 m is 1e-6 m, 2^20 m is 1e6 m.
constexpr std::array<int, 6> kPowers = {-20, -13, -1, 1, 13, 20};

template <class S>
Vec3<S> drawn(test::Draws& draw, double size) {
  return draw.in_ball(size).template cast<S>();
}

template <class S>
Capsule<S> drawn_capsule(test::Draws& draw) {
  const Vec3<S> a = drawn<S>(draw, 1);
  const Vec3<S> b = draw.chance(0.2) ? a : drawn<S>(draw, 1);  // a ball, now and then
  const S radius = draw.chance(0.2) ? S(0) : static_cast<S>(0.2 * draw.unit());
  return {{a, b}, radius};
}

template <class S>
Capsule<S> scaled(const Capsule<S>& capsule, S k) {
  return {{k * capsule.axis.a, k * capsule.axis.b}, k * capsule.radius};
}
template <class S>
MovingCapsule<S> scaled(const MovingCapsule<S>& moving, S k) {
  MovingCapsule<S> other = moving;
  other.capsule_B = scaled(moving.capsule_B, k);
  other.motion.X_WB.p_W *= k;
  other.motion.twist.v_W *= k;
  return other;
}

template <class S>
MovingCapsule<S> drawn_motion(test::Draws& draw) {
  MovingCapsule<S> moving;
  moving.capsule_B = drawn_capsule<S>(draw);
  moving.motion.X_WB.p_W = (1.2 * draw.direction()).template cast<S>();
  moving.motion.X_WB.q_WB = renewed(Quat<S>(draw.rotation().cast<S>()));
  moving.motion.twist.v_W = Vec3<S>(-4 * moving.motion.X_WB.p_W) + drawn<S>(draw, 2);
  moving.motion.twist.w_W = drawn<S>(draw, 3);
  moving.motion.duration = S(0.5);
  return moving;
}

TYPED_TEST(Scales, GapOfCapsules_IsTheSameBitsScaled) {
  using S = TypeParam;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    test::Draws draw(1, 1, i);
    const auto A = drawn_capsule<S>(draw);
    const auto B = drawn_capsule<S>(draw);
    const auto gap = capsule_gap(A, B);
    for (const int power : kPowers) {
      const S k = std::ldexp(S(1), power);
      const auto other = capsule_gap(scaled(A, k), scaled(B, k));
      ASSERT_EQ(other.gap, k * gap.gap) << i;
      ASSERT_EQ(other.axes.normal_AB, gap.axes.normal_AB) << i;
      ASSERT_EQ(other.surface_A, Vec3<S>(k * gap.surface_A)) << i;
    }
  }
}

TYPED_TEST(Scales, SearchedPair_MeetsAtTheSameTime) {
  using S = TypeParam;
  int contacts = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    test::Draws draw(1, 2, i);
    const auto A = drawn_motion<S>(draw);
    const auto B = drawn_motion<S>(draw);
    const auto found = search_advancement<S>(make_moving_pair(A, B).value, {});
    contacts += found.outcome == Outcome::kContact ? 1 : 0;
    for (const int power : kPowers) {
      const S k = std::ldexp(S(1), power);
      const auto other =
          search_advancement<S>(make_moving_pair(scaled(A, k), scaled(B, k)).value, {});
      ASSERT_EQ(other.outcome, found.outcome) << i << " at 2^" << power;
      ASSERT_EQ(other.t_free, found.t_free) << i;
      ASSERT_EQ(other.t_hit, found.t_hit) << i;
      ASSERT_EQ(other.evaluations, found.evaluations) << i;
      ASSERT_EQ(other.witness.gap, k * found.witness.gap) << i;
    }
  }
  EXPECT_GT(contacts, 100);
}

template <class S>
Collider<S> drawn_collider(test::Draws& draw) {
  Collider<S> body;
  body.X_WB.p_W = drawn<S>(draw, 1);
  body.X_WB.q_WB = renewed(Quat<S>(draw.rotation().cast<S>()));
  body.twist = {drawn<S>(draw, 2), drawn<S>(draw, 4)};
  body.inverse_mass = static_cast<S>(draw.power_of_two(-3, 3));
  for (int i = 0; i < 3; ++i) {
    body.inverse_moments(i) = static_cast<S>(draw.power_of_two(-3, 3));
  }
  return body;
}
template <class S>
Collider<S> scaled(const Collider<S>& body, S k) {
  Collider<S> other = body;
  other.X_WB.p_W *= k;
  other.twist.v_W *= k;
  other.inverse_moments /= k * k;
  return other;
}

TYPED_TEST(Scales, Blow_IsTheSameBitsScaled) {
  using S = TypeParam;
  int blows = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    test::Draws draw(1, 3, i);
    const auto A = drawn_collider<S>(draw);
    const auto B = drawn_collider<S>(draw);
    Contact<S> contact{drawn<S>(draw, 1), draw.direction().cast<S>(), S(1e-4)};
    const FrictionLaw<S> law{static_cast<S>(draw.unit()), static_cast<S>(draw.unit()), 0};
    const auto hit = friction_impulse(A, B, contact, law);
    blows += hit.value.magnitude > S(0) ? 1 : 0;
    for (const int power : kPowers) {
      const S k = std::ldexp(S(1), power);
      Contact<S> far = contact;
      far.point_W *= k;
      far.gap *= k;
      const auto other = friction_impulse(scaled(A, k), scaled(B, k), far, law);
      ASSERT_EQ(other.status, hit.status);
      ASSERT_EQ(other.value.magnitude, k * hit.value.magnitude) << i;
      ASSERT_EQ(other.value.twist_A.w_W, hit.value.twist_A.w_W) << i;
      ASSERT_EQ(other.value.twist_B.v_W, Vec3<S>(k * hit.value.twist_B.v_W)) << i;
      ASSERT_EQ(other.value.on_B.angular_W, Vec3<S>(k * k * hit.value.on_B.angular_W)) << i;
    }
  }
  EXPECT_GT(blows, 500);
}

/// A settings' lengths and velocities at another scale.
template <class SceneT>
WorldSettings<SceneT> settings_at(double k) {
  using S = typename SceneT::Scalar;
  WorldSettings<SceneT> settings;
  if constexpr (detail::kKnowsRest<SceneT>) {
    settings.rest_speed = S(0.01) * static_cast<S>(k);
    settings.separation = S(1e-4) * static_cast<S>(k);
  }
  if constexpr (SceneT::kGravity) settings.gravity_W.setZero();
  return settings;
}

/// Two that meet, in a world of their own.
template <class SceneT>
struct TwoFlyers {
  World<SceneT> world;

  explicit TwoFlyers(double k, double offset = 0) {
    using S = typename SceneT::Scalar;
    EXPECT_EQ(world.configure(settings_at<SceneT>(k)), Status::kOk);
    for (const double side : {-1.0, 1.0}) {
      auto actor = test::flyer<SceneT>(side, -side, k);
      test::own_place_of(actor).y() = static_cast<S>(side * k / 16);
      test::own_place_of(actor).x() += static_cast<S>(offset);
      taken = taken && world.add(actor).ok();
    }
  }
  /// @returns blows
  std::uint32_t run(int steps, double dt) {
    std::uint32_t blows = 0;
    for (int i = 0; i < steps; ++i) {
      EXPECT_EQ(world.step(static_cast<typename SceneT::Scalar>(dt)), Status::kOk);
      blows += world.report().collisions;
    }
    return blows;
  }
  auto& place(std::uint16_t slot) { return test::own_place_of(*world.get(world.id_at(slot))); }
  bool taken = true;
};

template <class SceneT>
class WorldScales : public testing::Test {};
TYPED_TEST_SUITE(WorldScales, test::Worlds);

TYPED_TEST(WorldScales, TwoThatMeet_DoSoFrom1e6thToAMillionMetres) {
  using S = typename TypeParam::Scalar;
  TwoFlyers<TypeParam> plain(1);
  const std::uint32_t blows = plain.run(2000, 1e-3);
  EXPECT_GT(blows, 0U);
  for (const int power : kPowers) {
    const double k = std::ldexp(1, power);
    TwoFlyers<TypeParam> other(k);
    ASSERT_TRUE(other.taken) << k;
    EXPECT_EQ(other.run(2000, 1e-3), blows) << k;
    EXPECT_EQ(other.world.report().complete(), plain.world.report().complete()) << k;
    for (const std::uint16_t slot : {std::uint16_t{0}, std::uint16_t{1}}) {
      const Vec3<S> expected = static_cast<S>(k) * plain.place(slot);
      if (TypeParam::Search::kForSpheres) {  // its least length is stated in metres
        EXPECT_LE((other.place(slot) - expected).norm(), S(1e-3 * k)) << k;
      } else {
        EXPECT_EQ(other.place(slot), expected) << k;
      }
    }
  }
}

// The closest points answer for the numbers that they are given, wherever those lie: to 5 u S of
// the lengths in the query, not of the offset.
TYPED_TEST(Scales, DistanceFarFromTheOrigin_IsThatOfTheRoundedEnds) {
  using S = TypeParam;
  for (double offset = 1; offset < 1e12; offset *= 10) {
    for (std::uint64_t i = 0; i < 100; ++i) {
      test::Draws draw(1, 4, i);
      const Vec3<S> far = (offset * draw.direction()).template cast<S>();
      auto A = drawn_capsule<S>(draw).axis;
      auto B = drawn_capsule<S>(draw).axis;
      for (Vec3<S>* end : {&A.a, &A.b, &B.a, &B.b}) *end += far;
      const auto found = closest_points(A, B);
      const auto truth = exact::least_distance(A, B);
      const auto bound = 5 * static_cast<long double>(kRoundOff<S>) * exact::visible_length(A, B);
      ASSERT_LE(std::abs(static_cast<long double>(found.distance) - truth), bound)
          << offset << " " << i;
    }
  }
}

template <class SceneT>
class WorldOffsets : public testing::Test {};
using InFloat = testing::Types<test::Rich<float>, test::Balls<float>, test::Straight<float>>;
TYPED_TEST_SUITE(WorldOffsets, InFloat);

// Where the numbers are too far apart for the body, it is refused. Nearer to the origin, places are
// known to their spacing, and the two end where two in double do, to that for every step.
TYPED_TEST(WorldOffsets, AnyOffset_IsAnsweredToItsSpacingOrRefused) {
  constexpr double kDt = 0.0625;
  constexpr int kSteps = 16;
  int refused = 0;
  for (int power = 0; power < 40; ++power) {
    const double offset = std::ldexp(1, power);
    const double spacing = offset * 0x1p-23;
    TwoFlyers<TypeParam> two(1, offset);
    if (!two.taken) {
      EXPECT_GE(spacing, 0.25) << offset;  // twice the radius of a ball
      ++refused;
      continue;
    }
    EXPECT_LE(spacing, 1) << offset;
    (void)two.run(kSteps, kDt);
    // Meeting at offset, they part again within twice their way: nobody is further out than that.
    const double reach = 1 + 2 * kDt * kSteps + kSteps * 64 * spacing;
    EXPECT_LT(std::abs(static_cast<double>(two.place(0).x()) - offset), reach) << offset;
    EXPECT_LE(static_cast<double>(two.place(0).x()), static_cast<double>(two.place(1).x()));
  }
  EXPECT_GT(refused, 10);
}

TYPED_TEST(WorldOffsets, BodyThatGetsTooFar_IsLeftOutAndCounted) {
  World<TypeParam> world;
  ASSERT_EQ(world.configure(settings_at<TypeParam>(1)), Status::kOk);
  const auto id = world.add(test::flyer<TypeParam>(0, 1));
  ASSERT_TRUE(id.ok());
  ASSERT_EQ(world.step(0.25F), Status::kOk);
  EXPECT_TRUE(world.report().complete());
  test::own_place_of(*world.get(id.value)).z() = 1e9F;
  const auto before = test::own_place_of(*world.get(id.value));
  ASSERT_EQ(world.step(0.25F), Status::kOk);
  EXPECT_EQ(world.report().plans_invalid, 1U);
  EXPECT_EQ(test::own_place_of(*world.get(id.value)), before);
}

TEST(Sizes, Point_IsHeldAnywhereAndABallWhereItsSizeIs) {
  const float most = std::numeric_limits<float>::max() / 16;
  for (const float place : {0.0F, 1.0F, 1e7F, 1e30F, most}) {
    EXPECT_TRUE(can_hold<float>({0, place, 0}, 0.0F));
    EXPECT_TRUE(can_hold<float>({0, 0, -place}, place * 0x1p-23F));
    EXPECT_EQ(can_hold<float>({-place, 0, 0}, place * 0x1p-25F), place == 0.0F);
  }
}

}  // namespace
}  // namespace batuta
