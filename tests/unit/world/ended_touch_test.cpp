// SPDX-License-Identifier: MIT
// Two that touch and stand still: the caller puts one of them away, or makes it thin, and the end
// of the touch is told in the next step, whatever keeps contacts in the scene.
#include <gtest/gtest.h>

#include <memory>

#include "scenes.hpp"

namespace batuta {
namespace {

enum class Rule : std::uint8_t { kDetection, kNone, kSeparation, kSettling, kSleeping };

template <Rule rule>
constexpr SceneOptions options() {
  SceneOptions scene = rule == Rule::kDetection ? detection_only() : SceneOptions{};
  if (rule == Rule::kNone) scene.resting = RestingContact::kNone;
  if (rule == Rule::kSeparation) scene.resting = RestingContact::kSeparation;
  if (rule == Rule::kSettling) scene.resting = RestingContact::kSettling;
  if (rule == Rule::kSleeping) {
    scene.resting = RestingContact::kSettling;
    scene.sleep = scene.gravity = true;
  }
  return scene;
}

template <class RuleT>
class EndedTouch : public ::testing::Test {};
template <Rule rule>
using Of = std::integral_constant<Rule, rule>;
using Rules = ::testing::Types<Of<Rule::kDetection>, Of<Rule::kNone>, Of<Rule::kSeparation>,
                               Of<Rule::kSettling>, Of<Rule::kSleeping>>;
TYPED_TEST_SUITE(EndedTouch, Rules);

constexpr float kStep = 1e-3F;
constexpr float kRadius = 0.1F;

/// Two that touch along x, the right one led; sleepers lie on it.
template <Rule rule>
struct Touching {
  using SceneT = Scene<options<rule>, Advancement<float>,
                       AnyController<float, FreeFlight<float>, Fixed<float>>>;
  using Id = typename World<SceneT>::BodyId;

  std::unique_ptr<World<SceneT>> world = std::make_unique<World<SceneT>>();
  Id left, right;

  Touching() {
    if constexpr (SceneT::kGravity) {
      auto settings = world->settings();
      settings.gravity_W = {9.81F, 0, 0};
      EXPECT_EQ(world->configure(settings), Status::kOk);
    }
    auto A = test::rod<SceneT>(0, 0.1, kRadius);
    auto B = test::rod<SceneT>(2 * kRadius + 1e-3, 0.1, kRadius);
    B.controller = Fixed<float>{};
    A.body.momentum.linear_W.x() = 0.1F;
    left = world->add(A).value;
    right = world->add(B).value;
    steps(20);
    if constexpr (rule == Rule::kDetection) world->get(left)->body.momentum = {};
    steps(400);
    EXPECT_EQ(world->is_asleep(left), rule == Rule::kSleeping);
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) ASSERT_EQ(world->step(kStep), Status::kOk);
  }
  /// Ends that the next step tells.
  int ends() {
    steps(1);
    int count = 0;
    for (const auto& event : world->events()) count += event.kind == EventKind::kEnd ? 1 : 0;
    return count;
  }
};

TYPED_TEST(EndedTouch, WhoIsPutAway_IsToldInThatStep) {
  for (const bool is_led : {true, false}) {
    Touching<TypeParam::value> pair;
    ASSERT_EQ(pair.ends(), 0);
    pair.world->get(is_led ? pair.right : pair.left)->body.X_WB.p_W.x() += is_led ? 1.0F : -1.0F;
    EXPECT_EQ(pair.ends(), 1) << is_led;
  }
}

TYPED_TEST(EndedTouch, WhoIsMadeThin_IsToldInThatStep) {
  for (const bool is_led : {true, false}) {
    Touching<TypeParam::value> pair;
    ASSERT_EQ(pair.ends(), 0);
    pair.world->get(is_led ? pair.right : pair.left)->capsule_B.radius = kRadius / 2;
    EXPECT_EQ(pair.ends(), 1) << is_led;
  }
}

}  // namespace
}  // namespace batuta
