// SPDX-License-Identifier: MIT
// Shapes, motions and searches with a hostile number in every place: no search calls free what it
// cannot tell, none runs beyond its budget, and whatever is answered is a number.
#include "batuta/detection/search.hpp"
#include "batuta/detection/speed_bound.hpp"
#include "batuta/detection/straight_pair.hpp"
#include "batuta/detection/swept_volume.hpp"
#include "batuta/geometry/direction.hpp"
#include "hostile.hpp"

namespace batuta {
namespace {

template <class S>
class Searches : public testing::Test {};
TYPED_TEST_SUITE(Searches, test::Scalars);

constexpr int kDraws = 5000;

/// Two that meet in the middle of a step; B turns.
template <class S>
struct Two {
  MovingCapsule<S> A;
  MovingCapsule<S> B;
};
template <class S>
Two<S> good_two(S turn) {
  Two<S> two;
  two.A.capsule_B = {{{0, -1, 0}, {0, 1, 0}}, S(0.125)};
  two.A.motion.X_WB.p_W = {-1, 0, 0};
  two.A.motion.twist.v_W = {2, 0, 0};
  two.A.motion.duration = 1;
  two.B = two.A;
  two.B.capsule_B.axis = {{-1, 0, 0}, {1, 0, S(0.5)}};
  two.B.motion.X_WB.p_W = {2, S(0.25), 0};
  two.B.motion.twist = {{-2, 0, 0}, {0, 0, turn}};
  return two;
}

template <class S>
void judge(const SearchResult<S>& found, std::uint32_t most, S duration) {
  ASSERT_LE(found.evaluations, most);
  if (found.outcome == Outcome::kInvalid) return;
  EXPECT_TRUE(is_finite(found.t_free) && is_finite(found.t_hit));
  EXPECT_TRUE(S(0) <= found.t_free && found.t_free <= found.t_hit && found.t_hit <= duration);
  if (found.outcome == Outcome::kFree) {
    EXPECT_EQ(found.t_free, duration);
  }
}

template <class Search, class S>
void judge_search(const MovingPair<S>& pair, const typename Search::Options& options) {
  const auto most = static_cast<std::uint32_t>(Search::most_evaluations(options));
  judge(Search::search(pair, options, Vec3<S>::Zero()), most, pair.duration);
  judge(Search::search(pair, options, Vec3<S>::UnitX()), most, pair.duration);
}

template <class S>
void search_all(const MovingPair<S>& pair) {
  judge_search<Advancement<S>>(pair, {});
  judge_search<Translation<S>>(pair, {});
  SteppingOptions<S> few;
  few.max_steps = 16;
  judge_search<Stepping<S>>(pair, few);
}

TYPED_TEST(Searches, HostileMotion_IsNoPairOrIsSearched) {
  using S = TypeParam;
  for (const S turn : {S(0), S(1)}) {
    const Two<S> good = good_two(turn);
    ASSERT_TRUE(make_moving_pair(good.A, good.B).ok());
    test::for_each_spoiled<S>(good, kDraws, [](const Two<S>& two, bool is_number) {
      const auto made = make_moving_pair(two.A, two.B);
      if (!is_number) {
        EXPECT_EQ(made.status, Status::kInvalidArgument);
      }
      if (!made.ok()) return;
      EXPECT_TRUE(made.value.scale <= kLargestCoordinate<S>);
      search_all(made.value);
    });
  }
}

// A pair that nobody made, but somebody spoiled: refused, or searched within the budget.
TYPED_TEST(Searches, HostilePair_IsNeverCalledFreeForWantOfNumbers) {
  using S = TypeParam;
  const Two<S> two = good_two(S(1));
  const auto good = make_moving_pair(two.A, two.B).value;
  test::for_each_spoiled<S>(good, kDraws, [](const MovingPair<S>& pair, bool is_number) {
    for (const S contact_tolerance : {S(0), S(1e-6), S(1)}) {
      const auto found = search_advancement<S>(pair, {contact_tolerance, 64});
      ASSERT_LE(found.evaluations, 64U);
      EXPECT_TRUE(is_number || found.outcome != Outcome::kFree || is_finite(found.t_free));
    }
  });
}

TYPED_TEST(Searches, HostileOptions_AreRefused) {
  using S = TypeParam;
  const Two<S> two = good_two(S(1));
  const auto pair = make_moving_pair(two.A, two.B).value;
  for (const S number : test::kHostile<S>) {
    const bool good = number >= S(0) && number <= S(1);
    EXPECT_EQ(validate(AdvancementOptions<S>{number, 64}) == Status::kOk, good) << number;
    SteppingOptions<S> options;
    options.epsilon = number;
    EXPECT_EQ(validate(options) == Status::kOk, is_positive(number)) << number;
    options.max_steps = 8;
    judge_search<Stepping<S>>(pair, options);
    if (good) {
      judge_search<Advancement<S>>(pair, {number, 64});
    } else {
      EXPECT_EQ(search_advancement<S>(pair, {number, 64}).outcome, Outcome::kInvalid);
      EXPECT_EQ(search_translation<S>(pair, {number, 64}).outcome, Outcome::kInvalid);
    }
  }
  for (const std::uint32_t budget : {0U, 1U, kMaxBudget, kMaxBudget + 1, ~0U}) {
    const auto found = search_advancement<S>(pair, {S(0), budget});
    EXPECT_EQ(found.outcome == Outcome::kInvalid, budget > kMaxBudget) << budget;
    EXPECT_LE(found.evaluations, min_of(budget, kMaxBudget));
  }
  for (const int halvings : {-1, detail::kMaxHalvings + 1, std::numeric_limits<int>::max()}) {
    SteppingOptions<S> options;
    options.halvings = halvings;
    EXPECT_EQ(search_stepping(pair, options).outcome, Outcome::kInvalid) << halvings;
  }
}

TYPED_TEST(Searches, UnitOfEpsilonOutOfRange_IsRefused) {
  using S = TypeParam;
  SteppingOptions<S> options;
  for (const int unit : {2, 127, 255}) {
    options.unit = static_cast<EpsilonIn>(unit);
    EXPECT_EQ(validate(options), Status::kInvalidArgument) << unit;
  }
}

template <class S>
struct Straight {
  Capsule<S> A = {{{0, -1, 0}, {0, 1, 0}}, S(0.25)};
  detail::StraightMotion<S> motion_A = {{-1, 0, 0}, {1, 0, 0}, 1};
  Capsule<S> B = {{{0, 0, -1}, {0, 0, 1}}, S(0.25)};
  detail::StraightMotion<S> motion_B = {{1, 0, 0}, {-1, 0, 0}, 1};
};

TYPED_TEST(Searches, HostileStraightPair_IsRefusedOrSearched) {
  using S = TypeParam;
  test::for_each_spoiled<S>(Straight<S>{}, kDraws, [](const Straight<S>& s, bool is_number) {
    const auto made = detail::make_straight_pair(s.A, s.motion_A, s.B, s.motion_B);
    if (!is_number) {
      EXPECT_EQ(made.status, Status::kInvalidArgument);
    }
    if (made.ok()) {
      judge_search<Translation<S>>(made.value, {});
    }
  });
}

TYPED_TEST(Searches, HostileSpheres_AreRefusedOrSearched) {
  using S = TypeParam;
  struct Flight {
    SphereFlight<S> flight = {{2, S(0.25), 0}, {-2, 0, 0}, S(0.5), 1};
    S contact_tolerance = S(1e-4);
  };
  test::for_each_spoiled<S>(Flight{}, kDraws, [](const Flight& f, bool is_number) {
    const auto found = search_spheres(f.flight, f.contact_tolerance);
    const bool all_touch = f.contact_tolerance == std::numeric_limits<S>::infinity();
    if (!is_number && !all_touch) {
      EXPECT_EQ(found.outcome, Outcome::kInvalid);
    }
    if (found.outcome == Outcome::kInvalid) return;
    EXPECT_TRUE(S(0) <= found.t_free && found.t_free <= found.t_hit &&
                found.t_hit <= f.flight.duration);
    EXPECT_NE(found.outcome, Outcome::kBudget);
  });
}

template <class S>
struct TwoShapes {
  Capsule<S> A = {{{0, -1, 0}, {0, 1, 0}}, S(0.25)};
  Capsule<S> B = {{{1, 0, -1}, {1, 0, 1}}, S(0.25)};
  Vec3<S> point = {1, 2, 3};
};

TYPED_TEST(Searches, HostileShapes_AreInvalidOrAnswered) {
  using S = TypeParam;
  test::for_each_spoiled<S>(TwoShapes<S>{}, kDraws, [](const TwoShapes<S>& two, bool is_number) {
    const auto gap = capsule_gap(two.A, two.B);
    const bool valid = is_valid(two.A) && is_valid(two.B);
    EXPECT_EQ(gap.proximity == Proximity::kInvalid, !valid);
    if (!is_number && is_finite(two.point)) {
      EXPECT_FALSE(valid);
    }
    if (valid) {
      EXPECT_TRUE(is_finite(gap.gap) && is_finite(gap.surface_A) && is_finite(gap.surface_B));
      EXPECT_NEAR(static_cast<double>(gap.axes.normal_AB.norm()), 1,
                  8 * static_cast<double>(kRoundOff<S>));
    } else {
      EXPECT_FALSE(overlaps(two.A, two.B));
      EXPECT_EQ(penetration_depth(two.A, two.B), S(0));
    }
    const auto normal = surface_normal(two.A, two.point);
    if (normal.status == Status::kInvalidArgument) return;
    EXPECT_TRUE(is_valid(two.A) && is_finite(two.point));
    EXPECT_NEAR(static_cast<double>(normal.value.norm()), 1, 8 * static_cast<double>(kRoundOff<S>));
  });
}

// Volumes are asked for by a world before the search is: where a capsule's way cannot be bounded
// they hold everything, and never end in NaN, which overlaps nothing.
TYPED_TEST(Searches, VolumesOfValidMotions_HoldTheirEnds) {
  using S = TypeParam;
  const Two<S> good = good_two(S(1));
  test::for_each_spoiled<S>(good.B, kDraws, [](const MovingCapsule<S>& moving, bool) {
    if (!is_valid(moving.motion) || !is_valid(moving.capsule_B)) return;
    const S norm = moving.motion.X_WB.q_WB.norm();
    if (!(std::abs(norm - S(1)) < S(1e-3))) return;  // @pre unit
    const auto at_end = to_world(pose_at(moving.motion, moving.motion.duration), moving.capsule_B);
    for (const auto& box : {swept_aabb(moving), detail::coarse_swept_aabb(moving)}) {
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LE(box.low[i], box.high[i]);
        const S end = at_end.axis.a[static_cast<int>(i)];
        EXPECT_TRUE(!is_finite(end) || (box.low[i] <= end && end <= box.high[i])) << end;
      }
    }
    const S bound = speed_bound(moving);
    EXPECT_FALSE(bound < detail::largest_component(moving.motion.twist.v_W));
  });
}

}  // namespace
}  // namespace batuta
