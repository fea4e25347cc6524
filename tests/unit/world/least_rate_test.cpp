// SPDX-License-Identifier: MIT
// How fast what touches may close and count as parting, where a load is carried without a contact
// that lasts: by what rounding makes of the velocities, and no more than the gap has room for.
#include "batuta/world/detail/pair_search.hpp"
#include "weld_rig.hpp"

namespace batuta {
namespace {

using namespace test;

constexpr SceneOptions carrying_options() {
  SceneOptions scene;
  scene.gravity = true;
  return scene;
}
template <class S>
using Carrying = Scene<carrying_options, Advancement<S>>;

template <class S>
class LeastRate : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(LeastRate, Scalars);

/// Of a query, all that is asked.
template <class S>
struct Resolved {
  S contact_gap;  ///< m
};

constexpr double kStep = 0x1p-6;

/// Of two bodies of 1 kg that fly at so many m/s each, where nothing weighs anything.
template <class S>
S rate_at(double speed, double gap) {
  WeldRig<Carrying<S>> rig;
  rig.bodies.settings.gravity_W.setZero();
  for (const double way : {-1.0, 1.0}) {
    Body<S> body = make_body<S>({}, S(1), {S(1), S(1), S(1)}).value;
    body.momentum.linear_W = {S(0), S(0), static_cast<S>(way * speed)};
    rig.add(body);
  }
  rig.begin(kStep);
  return detail::least_rate(rig.bodies, detail::ProxyPair{0, 1}, Resolved<S>{S(0)},
                            static_cast<S>(gap), false);
}

TYPED_TEST(LeastRate, FarFromContact_GoesWithTheSpeeds) {
  const TypeParam slow = rate_at<TypeParam>(0.5, 1);
  EXPECT_LT(slow, TypeParam(0));
  // Some roundings of the metre a second that both come to.
  EXPECT_GE(slow, -64 * kRoundOff<TypeParam>);
  EXPECT_LE(slow, -kRoundOff<TypeParam>);
  for (const double times : {0.25, 2.0, 16.0, 1024.0}) {
    EXPECT_EQ(rate_at<TypeParam>(0.5 * times, 1), static_cast<TypeParam>(times) * slow) << times;
  }
}

TYPED_TEST(LeastRate, NearContact_GoesNoFurtherThanTheGap) {
  const double tiny = static_cast<double>(kRoundOff<TypeParam>) / 1024;
  EXPECT_EQ(rate_at<TypeParam>(8, tiny), static_cast<TypeParam>(-tiny / kStep));
  EXPECT_EQ(rate_at<TypeParam>(8, 0), TypeParam(0));
  EXPECT_EQ(rate_at<TypeParam>(8, -1), TypeParam(0)) << "in each other";
}

}  // namespace
}  // namespace batuta
