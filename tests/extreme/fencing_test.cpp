// SPDX-License-Identifier: MIT
// Settings and data of fencers with a hostile number in every place: refused, with the bout that
// runs as it was, or a bout that goes on with numbers. Sides, parts and kinds that there are not.
#include <algorithm>
#include <memory>

#include "batuta/record/duel.hpp"
#include "hostile.hpp"

namespace batuta {
using namespace fencing;
namespace {

template <class S>
class Fencing : public testing::Test {};
TYPED_TEST_SUITE(Fencing, test::Scalars);

template <class S>
struct Ready {
  Duel<DuelScene<two_fencers, Advancement<S>>> duel;
  Fencer<S> left = first_fencer<S>();
  Fencer<S> right = second_fencer<S>();

  Status configure(const DuelSettings<DuelScene<two_fencers, Advancement<S>>>& settings =
                       duel_settings<DuelScene<two_fencers, Advancement<S>>>()) {
    return duel.configure(settings, left, right);
  }
};

/// The numbers of a grip: for_each_spoiled() takes what is numbers and nothing else.
template <class S>
using GripNumbers = std::array<S, 10>;
template <class S>
constexpr std::array<S GripSettings<S>::*, 10> kGripMembers = {
    &GripSettings<S>::torque,     &GripSettings<S>::force,        &GripSettings<S>::min_regain,
    &GripSettings<S>::max_regain, &GripSettings<S>::recover_time, &GripSettings<S>::largest_turn,
    &GripSettings<S>::forte,      &GripSettings<S>::composure,    &GripSettings<S>::settle_torque,
    &GripSettings<S>::max_lost};

template <class S>
GripSettings<S> grip_of(const GripNumbers<S>& numbers) {
  GripSettings<S> grip;
  for (std::size_t i = 0; i < numbers.size(); ++i) grip.*kGripMembers<S>[i] = numbers[i];
  return grip;
}
template <class S>
GripNumbers<S> numbers_of(const GripSettings<S>& grip) {
  GripNumbers<S> numbers;
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = grip.*kGripMembers<S>[i];
  return numbers;
}

/// Two sticks thrown about for a few steps; all that can be seen stays a number.
template <class S>
void fence(Duel<DuelScene<two_fencers, Advancement<S>>>& duel, std::uint32_t steps) {
  for (std::uint32_t k = 0; k < steps; ++k) {
    InputSample sample;
    sample.time = 4000U * k;
    sample.x = k / 60 % 2 == 0 ? -1.0F : 1.0F;
    sample.y = k % 3 == 0 ? -0.2F : -0.4F;
    const Status status = duel.step(&sample, &sample);
    if (status == Status::kUnavailable) return;
    ASSERT_EQ(status, Status::kOk);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const auto blade = duel.blade_W(side);
      const bool sound = is_finite(blade.axis.a) && is_finite(blade.axis.b);
      EXPECT_TRUE(sound || duel.report().incomplete_steps > 0);
    }
  }
}

TYPED_TEST(Fencing, HostileFencer_IsRefusedOrFences) {
  using S = TypeParam;
  const auto ready = std::make_unique<Ready<S>>();
  ASSERT_EQ(ready->configure(), Status::kOk);
  // Without its map, which is no number: HostileMap_IsRefusedOrHasHandsAndFeet.
  struct Data {
    WeaponBody<S> weapon;
    GripNumbers<S> grip;
    FencerBuild<S> build;
  };
  const Data good{ready->left.weapon, numbers_of(ready->left.grip), ready->left.build};
  int fenced = 0;
  test::for_each_spoiled<S>(good, 500, [&](const Data& data, bool is_number) {
    ready->left = {library_map<S>(), data.weapon, grip_of(data.grip), data.build};
    const auto before = hash_of(ready->duel);
    const Status status = ready->configure();
    if (!is_number) {
      ASSERT_EQ(status, Status::kInvalidArgument);
    }
    if (status != Status::kOk) {
      EXPECT_EQ(hash_of(ready->duel), before);
      return;
    }
    ++fenced;
    if (fenced % 4 == 0) fence(ready->duel, 6);
  });
  EXPECT_GT(fenced, 500);
}

TYPED_TEST(Fencing, HostileGrip_IsRefusedOrHolds) {
  using S = TypeParam;
  struct Held {
    GripNumbers<S> grip = numbers_of(GripSettings<S>{});
    GripLoad<S> load{60, S(0.1), S(0.05), 2};
    HandBlow<S> blow{S(0.7), S(0.5)};
  };
  test::for_each_spoiled<S>(Held{}, 5000, [&](const Held& held, bool) {
    const GripSettings<S> grip = grip_of(held.grip);
    const bool good = validate(grip) == Status::kOk;
    EXPECT_TRUE(!good || test::all_finite<S>(held.grip));
    if (!good) return;
    const bool asked = held.load.effort > S(0) && held.load.blow >= S(0) && held.load.lag >= S(0) &&
                       held.load.inverse_inertia >= S(0) && held.blow.reach >= S(0) &&
                       held.blow.moment >= S(0);
    if (!asked) return;  // @pre
    const S time = regain_time(grip, held.load);
    EXPECT_TRUE(time >= grip.min_regain && time <= grip.max_regain);
    const S lost = lost_time(grip, held.blow);
    EXPECT_TRUE(lost >= S(0) && lost <= grip.max_lost);
  });
}

/// Efforts, times and limits at their ends, through blows.
TYPED_TEST(Fencing, GripAtItsEnds_Fences) {
  using S = TypeParam;
  const auto ready = std::make_unique<Ready<S>>();
  for (const S end : {std::numeric_limits<S>::denorm_min(), std::numeric_limits<S>::min(), S(1e-30),
                      S(1e3), kLargestGrip<S>}) {
    for (std::size_t member = 0; member < kGripMembers<S>.size(); ++member) {
      GripSettings<S> grip;
      grip.*kGripMembers<S>[member] = end;
      grip.max_regain = max_of(grip.min_regain, grip.max_regain);
      SCOPED_TRACE(testing::Message() << "end " << end << " member " << member);
      ready->left.grip = ready->right.grip = grip;
      ASSERT_EQ(ready->configure(), Status::kOk);
      fence(ready->duel, 300);
      EXPECT_GT(ready->duel.report().blows + ready->duel.report().rests, 0U);
    }
    GripSettings<S> quick;
    quick.min_regain = quick.max_regain = end;
    ready->left.grip = ready->right.grip = quick;
    ASSERT_EQ(ready->configure(), Status::kOk);
    fence(ready->duel, 300);
  }
}

TYPED_TEST(Fencing, HostileWeapon_HasABodyOrIsRefused) {
  using S = TypeParam;
  const Weapon<S> good = epee<S>();
  test::for_each_spoiled<S>(good, 5000, [](const Weapon<S>& weapon, bool is_number) {
    const auto body = weapon_body(weapon);
    if (!is_number) {
      EXPECT_EQ(body.status, Status::kInvalidArgument);
    }
    if (body.ok()) {
      EXPECT_TRUE((test::all_finite<S>(body.value)));
    }
  });
}

TYPED_TEST(Fencing, HostileMap_IsRefusedOrHasHandsAndFeet) {
  using S = TypeParam;
  struct Keys {
    std::array<MapKey<S>, 6> keys;
  };
  Keys good{};
  std::copy_n(library_map<S>().keys, good.keys.size(), good.keys.begin());
  const auto ready = std::make_unique<Ready<S>>();
  ASSERT_EQ(ready->configure(), Status::kOk);
  const auto before = hash_of(ready->duel);
  test::for_each_spoiled<S>(good, 2000, [&](const Keys& spoiled, bool is_number) {
    const FencerMap<S> map{spoiled.keys.data(), 2, 3};
    const Status status = validate(map);
    if (!is_number) {
      EXPECT_EQ(status, Status::kInvalidArgument);
    }
    if (status != Status::kOk) {
      ready->right.map = map;
      EXPECT_EQ(ready->configure(), Status::kInvalidArgument);
      EXPECT_EQ(hash_of(ready->duel), before);
      return;
    }
    for (const S x : {S(-1), S(-0.3), S(0), S(0.7), S(1), S(2), std::numeric_limits<S>::max()}) {
      const Vec2<S> stick(x, -x);
      EXPECT_TRUE((test::all_finite<S>(hand_at(map, stick)))) << x;
      EXPECT_LE(std::abs(feet_at(map, stick)), S(1)) << x;
    }
  });
  constexpr auto kMost = test::kHighest<std::int32_t>[0];
  constexpr auto kLeast = test::kLowest<std::int32_t>[0];
  for (const std::int32_t bad : {kLeast, -2, 0, 1, kMostMapKeys + 1, kMost}) {
    EXPECT_EQ(validate(FencerMap<S>{good.keys.data(), bad, 2}), Status::kInvalidArgument) << bad;
    EXPECT_EQ(validate(FencerMap<S>{good.keys.data(), 2, bad}), Status::kInvalidArgument) << bad;
  }
}

/// Also for programs that have a grid of their own.
TYPED_TEST(Fencing, HostileKeys_AreRefusedAndTheOldStay) {
  using S = TypeParam;
  KeyframeGrid<S, 3, 2> grid;
  typename KeyframeGrid<S, 3, 2>::Keys good;
  for (std::size_t k = 0; k < good.size(); ++k) {
    const Vec2<S> stick(S(-1) + static_cast<S>(k % 3), S(-1) + S(2) * static_cast<S>(k / 3));
    good[k] = hand_at(library_map<S>(), stick).X_WH;
  }
  ASSERT_EQ(grid.set_keys(good), Status::kOk);
  test::for_each_spoiled<S>(good, 2000, [&](const auto& keys, bool is_number) {
    const KeyframeGrid<S, 3, 2> before = grid;
    const Status status = grid.set_keys(keys);
    if (!is_number) {
      EXPECT_EQ(status, Status::kInvalidArgument);
    }
    if (status != Status::kOk) {
      EXPECT_TRUE(test::same_bytes(grid, before));
    }
    for (const S x : {S(-1), S(-0.3), S(0), S(0.7), S(1), S(2), std::numeric_limits<S>::max()}) {
      const auto pose = grid.at({x, -x});
      EXPECT_TRUE((test::all_finite<S>(pose))) << x;
    }
    ASSERT_EQ(grid.set_keys(good), Status::kOk);
  });
}

TYPED_TEST(Fencing, HostileBuild_IsRefusedOrStands) {
  using S = TypeParam;
  const FencerBuild<S> good = first_fencer<S>().build;
  test::for_each_spoiled<S>(good, 2000, [](const FencerBuild<S>& build, bool is_number) {
    const Status status = validate(build);
    if (!is_number) {
      EXPECT_EQ(status, Status::kInvalidArgument);
    }
    if (status != Status::kOk) return;
    Pose<S> X_WH;
    for (const S x : {S(0), S(0.5), S(-2000)}) {
      X_WH.p_W.x() = x;
      EXPECT_TRUE((test::all_finite<S>(pose_body(build, Pose<S>{}, X_WH))));
    }
  });
}

TYPED_TEST(Fencing, HostileFeet_AreRefusedOrStayInTheirRoom) {
  using S = TypeParam;
  for (const S number : test::kHostile<S>) {
    for (int member = 0; member < 3; ++member) {
      FeetSettings<S> settings;
      if (member == 0) settings.forward_speed = number;
      if (member == 1) settings.backward_speed = number;
      if (member == 2) settings.acceleration = number;
      BothFeet<S> feet;
      if (validate(settings) != Status::kOk) continue;
      for (const S room : {S(0), S(1e-30), S(0.01), S(1000)}) {
        feet[0].stand();
        for (int i = 0; i < 300; ++i) {
          const S behind = S(1) + feet[0].way();
          const auto rooms = rooms_of<S>(feet, settings, room - feet[0].way(), {behind, S(1)});
          feet[0].advance(settings, i < 200 ? S(1) : S(-1), rooms[0], S(1e-3));
          ASSERT_TRUE(is_finite(feet[0].way()) && is_finite(feet[0].velocity())) << number;
          ASSERT_LE(feet[0].way(), room * (1 + 8 * kRoundOff<S>)) << number << " " << room;
          ASSERT_GE(feet[0].way(), S(-1 - 1e-5));
        }
      }
    }
  }
  // Lengths beyond all strips: nobody can go anywhere that has no number.
  const auto ready = std::make_unique<Ready<S>>();
  for (const S number : test::kHostile<S>) {
    auto settings = duel_settings<DuelScene<two_fencers, Advancement<S>>>();
    settings.strip.length = number;
    settings.strip.least_distance = number;
    if (ready->configure(settings) != Status::kOk) continue;
    fence(ready->duel, 50);
    EXPECT_TRUE(is_finite(ready->duel.X_WF(Side::kLeft).p_W)) << number;
  }
}

TYPED_TEST(Fencing, HostileDuelSettings_AreRefusedAndTheBoutGoesOn) {
  using S = TypeParam;
  const auto ready = std::make_unique<Ready<S>>();
  ASSERT_EQ(ready->configure(), Status::kOk);
  fence(ready->duel, 5);
  const auto before = hash_of(ready->duel);
  constexpr auto kLeast = test::kLowest<std::int32_t>[0];
  constexpr auto kMost = test::kHighest<std::int32_t>[0];
  for (const std::int32_t bad : {kLeast, -1, 0, 99, 20001, kMost}) {
    auto settings = duel_settings<DuelScene<two_fencers, Advancement<S>>>();
    settings.step_us = bad;
    EXPECT_EQ(ready->configure(settings), Status::kInvalidArgument) << bad;
  }
  for (const std::int32_t bad : {kLeast, -1, 10000001, kMost}) {
    auto settings = duel_settings<DuelScene<two_fencers, Advancement<S>>>();
    settings.double_window_us = bad;
    EXPECT_EQ(ready->configure(settings), Status::kInvalidArgument) << bad;
  }
  for (const std::int32_t bad : {kLeast, -1, 0, kMostTouches + 1, kMost}) {
    auto settings = duel_settings<DuelScene<two_fencers, Advancement<S>>>();
    settings.touches = bad;
    EXPECT_EQ(ready->configure(settings), Status::kInvalidArgument) << bad;
  }
  for (const std::int32_t bad : {kLeast, -1, 10000001, kMost}) {
    auto settings = duel_settings<DuelScene<two_fencers, Advancement<S>>>();
    settings.halt_us = bad;
    EXPECT_EQ(ready->configure(settings), Status::kInvalidArgument) << bad;
  }
  for (const S number : test::kHostile<S>) {
    auto settings = duel_settings<DuelScene<two_fencers, Advancement<S>>>();
    settings.salle.distance = number;
    if (number > S(0) && number <= kLargestReach<S>) continue;
    EXPECT_EQ(ready->configure(settings), Status::kInvalidArgument) << number;
  }
  EXPECT_EQ(hash_of(ready->duel), before);
  EXPECT_EQ(ready->duel.step(nullptr, nullptr), Status::kOk);
}

TYPED_TEST(Fencing, SideThatThereIsNot_IsTheRightOne) {
  using S = TypeParam;
  const auto ready = std::make_unique<Ready<S>>();
  ASSERT_EQ(ready->configure(), Status::kOk);
  for (const int value : {2, 3, 127, 255}) {
    const auto side = static_cast<Side>(value);
    EXPECT_EQ(index_of(side), 1U);
    EXPECT_EQ(other(side), Side::kLeft);
    EXPECT_EQ(&ready->duel.stick(side), &ready->duel.stick(Side::kRight));
    EXPECT_EQ(&ready->duel.grip(side), &ready->duel.grip(Side::kRight));
    EXPECT_EQ(&ready->duel.feet(side), &ready->duel.feet(Side::kRight));
    EXPECT_EQ(ready->duel.X_WF(side).p_W, ready->duel.X_WF(Side::kRight).p_W);
    EXPECT_EQ(&ready->duel.body_W(side), &ready->duel.body_W(Side::kRight));
    EXPECT_EQ(ready->duel.blade_W(side).axis.a, ready->duel.blade_W(Side::kRight).axis.a);
  }
}

TEST(FencingEnums, PartThatThereIsNot_HasNoBitAndNoPlace) {
  Target<float> target;
  for (const int value : {12, 13, 31, 32, 255}) {
    const auto part = static_cast<BodyPart>(value);
    EXPECT_EQ(mask_of(part), 0U);
    EXPECT_STREQ(name_of(part), "unknown");
    EXPECT_DEATH((void)target.part(part), "");  // @pre, as an index is
    EXPECT_DEATH((void)target.hull(part), "");
  }
}

TYPED_TEST(Fencing, HostileBladeMotion_IsLeftAsItIsOrStopped) {
  using S = TypeParam;
  const Fencer<S> fencer = first_fencer<S>();
  const Pose<S> here{Vec3<S>::Zero(), Quat<S>::Identity()};
  Target<S> target;
  target.place(pose_body(fencer.build, here, hand_at(fencer.map, Vec2<S>(0, 0), here).X_WH));
  const Capsule<S> blade_B = {{{S(-0.4), 0, 0}, {S(0.4), 0, 0}}, S(0.01)};
  const Vec3<S> torso_W = target.start_of(BodyPart::kTorso).axis.at(S(0.5));
  const Pose<S> X_WB{torso_W + Vec3<S>(0, 0, S(0.5)), Quat<S>::Identity()};
  const auto blade = make_body<S>(X_WB, S(0.5), {S(1e-4), S(0.03), S(0.03)}).value;
  const Motion<S> good{X_WB, {{0, 0, -40}, {0, 1, 0}}, S(0.01)};
  Motion<S> motion = good;
  ASSERT_TRUE(target.stop(blade, blade_B, 0, kAllParts, motion));
  test::for_each_spoiled<S>(good, 1000, [&](const Motion<S>& spoiled, bool is_number) {
    Motion<S> changed = spoiled;
    const bool is_stopped = target.stop(blade, blade_B, 0, kAllParts, changed);
    EXPECT_TRUE(is_number || !is_stopped);
    EXPECT_TRUE(is_stopped || test::same_bytes(changed, spoiled));
  });
}

TEST(FencingEnums, PartsThatThereAreNot_AreNotTouched) {
  const auto ready = std::make_unique<Ready<float>>();
  auto settings = duel_settings();
  settings.target = ~kAllParts;
  ASSERT_EQ(ready->configure(settings), Status::kOk);
  fence(ready->duel, 500);
  EXPECT_FALSE(ready->duel.bout().is_over());
}

TYPED_TEST(Fencing, LongestSilence_IsReachedInTheShortestSteps) {
  using S = TypeParam;
  StickTracker<S> stick;
  StickSettings settings;
  for (const std::int32_t us : {kLongestSilenceUs + 1, std::numeric_limits<std::int32_t>::max()}) {
    settings.stale_after_us = us;
    EXPECT_EQ(stick.configure(settings), Status::kInvalidArgument);
  }
  settings.stale_after_us = kLongestSilenceUs;
  ASSERT_EQ(stick.configure(settings), Status::kOk);
  ASSERT_EQ(stick.accept({}), SampleUse::kRestart);
  std::int32_t steps = 0;
  for (stick.advance(S(1e-6)); !stick.is_stale() && steps < 2 * kLongestSilenceUs; ++steps) {
    stick.advance(S(1e-6));
  }
  EXPECT_NEAR(static_cast<double>(steps) / kLongestSilenceUs, 1, 0.06);
}

}  // namespace
}  // namespace batuta
