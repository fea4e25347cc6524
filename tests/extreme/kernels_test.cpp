// SPDX-License-Identifier: MIT
// Every kernel that answers with a status or an outcome, with a hostile number in every place of
// its arguments: a number that is not finite is refused; whatever is not refused is answered with
// finite numbers; what is refused gives the default value and changes nothing.
#include "batuta/mechanics/compound.hpp"
#include "batuta/mechanics/straight.hpp"
#include "batuta/response/friction.hpp"
#include "batuta/response/line_contact.hpp"
#include "batuta/response/separation.hpp"
#include "batuta/response/straight_impulse.hpp"
#include "hostile.hpp"

namespace batuta {
namespace {

template <class S>
class Kernels : public testing::Test {};
TYPED_TEST_SUITE(Kernels, test::Scalars);

constexpr int kDraws = 20000;

/// What every Result has to keep.
template <class S, class T>
void judge(const Result<T>& answer, bool is_number) {
  if (!is_number) {
    EXPECT_EQ(answer.status, Status::kInvalidArgument);
  }
  if (answer.ok()) {
    EXPECT_TRUE((test::all_finite<S>(answer.value)));
  }
  const T none{};
  if (answer.status == Status::kInvalidArgument) {
    EXPECT_TRUE(test::same_bytes(answer.value, none));
  }
}

template <class S>
struct Blow {
  Collider<S> A;
  Collider<S> B;
  Contact<S> contact;
  FrictionLaw<S> law;
};
template <class S>
Blow<S> good_blow() {
  Blow<S> blow;
  blow.A.X_WB.p_W = {-1, S(0.25), 0};
  blow.A.twist = {{2, S(0.5), 0}, {0, 1, S(0.5)}};
  blow.A.inverse_mass = 2;
  blow.A.inverse_moments = {1, 2, 4};
  blow.B = blow.A;
  blow.B.X_WB.p_W = {1, 0, S(0.125)};
  blow.B.twist.v_W = {-1, 0, 1};
  blow.contact = {Vec3<S>::Zero(), -Vec3<S>::UnitX(), S(1e-6)};
  blow.law = {S(0.5), S(0.25), 0};
  return blow;
}

TYPED_TEST(Kernels, CollisionImpulse) {
  const auto call = [](const auto& blow) {
    return collision_impulse(blow.A, blow.B, blow.contact, blow.law.restitution);
  };
  const Blow<TypeParam> good = good_blow<TypeParam>();
  ASSERT_GT(call(good).value.magnitude, 0);
  test::for_each_spoiled<TypeParam>(
      good, kDraws, [&](const auto& blow, bool) { judge<TypeParam>(call(blow), true); });
}

TYPED_TEST(Kernels, FrictionImpulse) {
  const Blow<TypeParam> good = good_blow<TypeParam>();
  const auto call = [](const auto& blow) {
    return friction_impulse(blow.A, blow.B, blow.contact, blow.law);
  };
  ASSERT_GT(call(good).value.magnitude, 0);
  test::for_each_spoiled<TypeParam>(
      good, kDraws, [&](const auto& blow, bool) { judge<TypeParam>(call(blow), true); });
}

template <class S>
struct Rest {
  Vec3<S> point = Vec3<S>::Zero();
  Vec3<S> normal = Vec3<S>::UnitX();
  S gap = S(-1e-3);
  S v_rel = S(-0.01);
  S inverse_mass_A = 1;
  S inverse_mass_B = 2;
  SeparationOptions<S> options;
};

TYPED_TEST(Kernels, Separate) {
  using S = TypeParam;
  Rest<S> good;
  good.options = {S(1e-3), S(0.01), S(1e-3), 1, 1};
  test::for_each_spoiled<S>(good, kDraws, [](const Rest<S>& rest, bool) {
    judge<S>(separate<S>({rest.point, rest.normal, rest.gap}, rest.v_rel, rest.inverse_mass_A,
                         rest.inverse_mass_B, rest.options),
             true);
  });
}

template <class S>
struct StraightBlow {
  StraightBody<S> A;
  StraightBody<S> B;
  S restitution = 1;
};

TYPED_TEST(Kernels, StraightImpulse_ChangesNothingOrLeavesNumbers) {
  using S = TypeParam;
  StraightBlow<S> good;
  good.A = {{-1, 0, 0}, {1, 0, 0}, 1};
  good.B = {{1, 0, 0}, {-1, 0, 0}, 2};
  test::for_each_spoiled<S>(good, kDraws, [](StraightBlow<S> blow, bool) {
    const StraightBlow<S> before = blow;
    const auto hit =
        detail::straight_impulse<S>(blow.A, blow.B, -Vec3<S>::UnitX(), blow.restitution);
    EXPECT_TRUE((test::all_finite<S>(hit.impulse)));
    const bool changed = !test::same_bytes(blow, before);
    const Vec3<S> sizes = before.A.momentum_W.cwiseAbs() + before.B.momentum_W.cwiseAbs();
    if (changed && sizes.maxCoeff() <= std::numeric_limits<S>::max() / 4) {
      EXPECT_TRUE(is_finite(blow.A.momentum_W) && is_finite(blow.B.momentum_W));
    }
    if (hit.impulse == S(0)) {
      EXPECT_FALSE(changed);
    }
  });
}

template <class S>
struct Placed {
  Pose<S> X_WB;
  S mass = 2;
  Vec3<S> moments = {1, 2, 3};
};

TYPED_TEST(Kernels, MakeBody) {
  using S = TypeParam;
  test::for_each_spoiled<S>(Placed<S>{}, kDraws, [](const Placed<S>& p, bool) {
    const auto made = make_body(p.X_WB, p.mass, p.moments);
    if (!made.ok()) return;
    EXPECT_NE(p.X_WB.q_WB.coeffs().cwiseAbs().maxCoeff(), S(0));
    const Body<S>& body = made.value;
    EXPECT_TRUE(is_finite(body.X_WB.p_W) && is_finite(body.inverse_mass) &&
                is_finite(body.inverse_moments) && body.inverse_moments.minCoeff() >= S(0));
    EXPECT_NEAR(static_cast<double>(body.X_WB.q_WB.norm()), 1,
                8 * static_cast<double>(kRoundOff<S>));
  });
}

template <class S>
struct Pushed {
  Pose<S> X_WB;
  Momentum<S> momentum;
  S inverse_mass = 1;
  Vec3<S> inverse_moments = {1, 2, 3};
  Vec3<S> force = {1, 2, 3};
  Vec3<S> torque = {3, 2, 1};
  S dt = S(0.5);
};
template <class S>
Body<S> body_of(const Pushed<S>& p) {
  return {p.X_WB, p.momentum, p.inverse_mass, p.inverse_moments, false};
}

TYPED_TEST(Kernels, ApplyAndApplyImpulse_ChangeNothingWhereRefused) {
  using S = TypeParam;
  test::for_each_spoiled<S>(Pushed<S>{}, kDraws, [](const Pushed<S>& p, bool) {
    for (const bool by_impulse : {false, true}) {
      Body<S> body = body_of(p);
      const Status status = by_impulse ? apply_impulse(body, p.force, p.torque)
                                       : apply(body, p.force, p.torque, p.dt);
      const bool same = test::same_bytes(body.momentum, p.momentum);
      if (status != Status::kOk) {
        EXPECT_TRUE(same);
      }
      if (!same) {
        EXPECT_TRUE((test::all_finite<S>(body.momentum)));
      }
      const bool inputs = is_finite(p.force) && is_finite(p.torque) && is_finite(p.dt);
      if (!inputs && !by_impulse) {
        EXPECT_EQ(status, Status::kInvalidArgument);
      }
    }
  });
}

template <class S>
struct Shaped {
  Capsule<S> capsule = {{{-1, 0, 0}, {1, S(0.5), 0}}, S(0.25)};
  S density = 1000;
};

TYPED_TEST(Kernels, SolidCapsule_HasMassAndMoments) {
  using S = TypeParam;
  test::for_each_spoiled<S>(Shaped<S>{}, kDraws, [](const Shaped<S>& shape, bool is_number) {
    const auto made = solid_capsule(shape.capsule, shape.density);
    judge<S>(made, is_number);
    if (made.ok()) {
      EXPECT_GT(made.value.inertia_S.trace(), S(0));
    }
  });
}

TYPED_TEST(Kernels, SolidCapsule_MomentsThatVanishBeforeTheMass_AreRefused) {
  using S = TypeParam;
  int refused = 0;
  for (S radius = 1; radius > std::numeric_limits<S>::min(); radius /= 2) {
    for (const S length : {S(0), radius, S(1)}) {
      const Capsule<S> capsule{{{0, 0, 0}, {length, 0, 0}}, radius};
      const auto made = solid_capsule(capsule, S(1));
      if (made.ok()) {
        const Mat3<S>& inertia = made.value.inertia_S;
        const bool needle = inertia(0, 0) <= 4 * kRoundOff<S> * inertia(1, 1);
        EXPECT_TRUE(inertia(0, 0) > S(0) || needle) << radius << " " << length;
        EXPECT_GT(inertia(1, 1), S(0)) << radius << " " << length;
      }
      refused += made.ok() ? 0 : 1;
    }
  }
  EXPECT_GT(refused, 50);
}

TYPED_TEST(Kernels, Apply_StepThatIsNotANumberIsRefusedForWhatIsFixedToo) {
  using S = TypeParam;
  Body<S> wall;
  const Vec3<S> force(1, 0, 0);
  for (const S dt :
       {std::numeric_limits<S>::infinity(), std::numeric_limits<S>::quiet_NaN(), S(-1)}) {
    EXPECT_EQ(apply(wall, force, force, dt), Status::kInvalidArgument);
  }
  EXPECT_EQ(apply(wall, force, force, std::numeric_limits<S>::max()), Status::kOk);
}

TYPED_TEST(Kernels, MassOfParts_AndPlaceCompound) {
  using S = TypeParam;
  struct Two {
    CapsulePart<S> parts[2] = {{{{{-1, 0, 0}, {1, 0, 0}}, S(0.25)}, 1000},
                               {{{{0, -1, 0}, {0, 1, 0}}, S(0.125)}, 500}};
    Pose<S> X_WS;
  };
  test::for_each_spoiled<S>(Two{}, kDraws, [](const Two& two, bool) {
    const auto mass = detail::mass_of_parts(&two.parts[0], 2);
    judge<S>(mass, true);
    const auto made = make_compound(two.parts, two.X_WS);
    if (!made.ok()) return;
    const Body<S>& body = made.value.body;
    EXPECT_TRUE(is_finite(body.X_WB.p_W) && is_finite(body.inverse_moments));
    EXPECT_TRUE(is_valid(made.value.capsules_B[0]) && is_valid(made.value.capsules_B[1]));
  });
  Capsule<S> capsule = Capsule<S>::sphere(Vec3<S>::Zero(), 1);
  const auto mass = solid_capsule(capsule, S(1)).value;
  for (const int count : {0, -1, std::numeric_limits<int>::min()}) {
    EXPECT_EQ(detail::mass_of_parts<S>(nullptr, count).status, Status::kInvalidArgument);
    EXPECT_EQ(detail::place_compound<S>(mass, {}, &capsule, count).status,
              Status::kInvalidArgument);
    EXPECT_EQ((make_compound<1>(mass, &capsule, count, Pose<S>{}).status),
              Status::kInvalidArgument);
  }
}

TYPED_TEST(Kernels, PointMassAndStraightBody) {
  using S = TypeParam;
  struct Point {
    Vec3<S> place = {1, 2, 3};
    S mass = 2;
  };
  test::for_each_spoiled<S>(Point{}, kDraws, [](const Point& p, bool is_number) {
    judge<S>(point_mass(p.mass, p.place), is_number);
    const auto body = make_straight_body(p.place, p.mass);
    const bool fixed = p.mass == std::numeric_limits<S>::infinity();
    judge<S>(body, is_number || fixed);
    if (fixed && body.ok()) {
      EXPECT_EQ(body.value.inverse_mass, S(0));
    }
  });
}

TYPED_TEST(Kernels, PrincipalAndSettledFrame_AreFrames) {
  using S = TypeParam;
  MassProperties<S> good;
  good.mass = 1;
  good.inertia_S << 3, S(0.5), 0, S(0.5), 2, S(0.25), 0, S(0.25), 4;
  test::for_each_spoiled<S>(good, kDraws, [](const MassProperties<S>& mass, bool) {
    for (const auto& frame : {principal_frame(mass), detail::settled_frame(mass)}) {
      EXPECT_NEAR(static_cast<double>(frame.q_SB.norm()), 1,
                  16 * static_cast<double>(kRoundOff<S>));
      EXPECT_FALSE(frame.moments.minCoeff() < S(0));
    }
  });
}

template <class S>
struct Lines {
  Blow<S> blow = good_blow<S>();
  Capsule<S> A = {{{-1, 0, 0}, {1, 0, 0}}, S(0.25)};
  Capsule<S> B = {{{-1, S(0.5), 0}, {1, S(0.5), 0}}, S(0.25)};
  S slack = S(1e-3);
};

TYPED_TEST(Kernels, PressureContact_IsFiniteOrTheNearest) {
  using S = TypeParam;
  Lines<S> good;
  good.blow.contact.normal_BA_W = -Vec3<S>::UnitY();
  test::for_each_spoiled<S>(good, kDraws, [](const Lines<S>& lines, bool) {
    const Contact<S>& nearest = lines.blow.contact;
    const auto at =
        pressure_contact(lines.blow.A, lines.blow.B, lines.A, lines.B, nearest, lines.slack);
    EXPECT_TRUE((test::all_finite<S>(at.point_W)) || test::same_bytes(at, nearest));
  });
}

TYPED_TEST(Kernels, MassOfTheRange_IsTakenOrRefusedBySize) {  // 1e-6 ... 1e6 m, needle and plate
  using S = TypeParam;
  for (int power = -6; power <= 6; ++power) {
    const S size = static_cast<S>(std::pow(10.0, power));
    for (const S slenderness : {S(0), S(1), S(1e3)}) {  // ball, rod, needle
      const Capsule<S> capsule{{{0, 0, 0}, {slenderness * size, 0, 0}}, size};
      const auto mass = solid_capsule(capsule, S(1));
      ASSERT_TRUE(mass.ok()) << size << " " << slenderness;
      const Vec3<S> moments = principal_frame(mass.value).moments;
      EXPECT_GT(moments.minCoeff(), S(0)) << size;
      EXPECT_TRUE(make_body(Pose<S>{}, mass.value.mass, moments).ok()) << size;
    }
  }
}

}  // namespace
}  // namespace batuta
