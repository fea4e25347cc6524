// SPDX-License-Identifier: MIT
// Coupling, hand, pulses, gain advisor and energy book with hostile numbers in every place:
// settings that make no sense are refused and change nothing; what is answered is finite and within
// its limit, or refused; in which unit a length or a time is told changes nothing.

#include "batuta/haptics/duel_hand.hpp"
#include "batuta/haptics/gain_advisor.hpp"
#include "batuta/haptics/passivity.hpp"
#include "hostile.hpp"

namespace batuta {
using namespace haptics;
using namespace fencing;
namespace {

template <class S>
class Haptics : public testing::Test {};
TYPED_TEST_SUITE(Haptics, test::Scalars);

constexpr int kDraws = 20000;

TYPED_TEST(Haptics, HostileHapticSettings_AreRefused) {
  using S = TypeParam;
  const auto by_validate = [](const auto& settings) { return validate(settings); };
  test::expect_taken<S>(CouplingSettings<S>{}, {true, true, true, true, false, false}, by_validate);
  const PassivitySettings<S> book{1, 1, 1, 1, 1, 1, 1};
  test::expect_taken<S>(book, {false, true, true, true, false, true, false}, by_validate);
  TransientSettings<S> pulse;
  for (const S number : test::kHostile<S>) {
    const bool taken = validate(TransientSettings<S>{1, S(0.5), number, 1}) == Status::kOk;
    EXPECT_EQ(taken, number >= S(0.5) && number <= kLongestPulse<S>) << number;
  }
  pulse.longest = kLongestPulse<S>;
  test::expect_taken<S>(pulse, {true, false, false, false}, [](TransientSettings<S> settings) {
    if (is_positive(settings.longest)) settings.longest = kLongestPulse<S>;
    if (is_positive(settings.duration)) settings.duration = kLongestPulse<S>;
    return validate(settings);
  });
}

TYPED_TEST(Haptics, RefusedSettings_ChangeNothing) {
  using S = TypeParam;
  ImpactTransient<S> pulse;
  PassivityObserver<S> book;
  HandForce<S> hand;
  ASSERT_EQ(pulse.configure({}), Status::kOk);
  ASSERT_EQ(pulse.strike({1, -1}), Status::kOk);
  ASSERT_EQ(book.configure({1, 1, 0, 10, 1, 1, 1}), Status::kOk);
  ASSERT_EQ(book.supply(3), Status::kOk);
  ASSERT_EQ(hand.configure({}), Status::kOk);
  HandState<S> state;
  state.commanded.jacobian.setOnes();
  state.held_W.p_W.x() = S(0.01);
  const S felt = hand.advance(state, S(0.001)).x();
  ASSERT_GT(felt, S(0));
  for (const S bad : {std::numeric_limits<S>::quiet_NaN(), std::numeric_limits<S>::infinity()}) {
    EXPECT_EQ(pulse.configure({bad, 1, 1, 1}), Status::kInvalidArgument);
    EXPECT_EQ(pulse.strike({0, bad}), Status::kInvalidArgument);
    EXPECT_EQ(book.configure({1, 1, 0, 10, bad, 1, 1}), Status::kInvalidArgument);
    EXPECT_EQ(book.supply(bad), Status::kInvalidArgument);
    EXPECT_EQ(book.restart({0, bad}), Status::kInvalidArgument);
    EXPECT_EQ(book.restart({0, 0}, bad), Status::kInvalidArgument);
    EXPECT_EQ(book.observe({bad, 0}, {0, 0}), Status::kInvalidArgument);
    EXPECT_EQ(book.observe({0, 0}, {0, bad}), Status::kInvalidArgument);
    HandForceSettings<S> settings;
    settings.coupling.stiffness = bad;
    EXPECT_EQ(hand.configure(settings), Status::kInvalidArgument);
  }
  EXPECT_EQ(pulse.left(), Vec2<S>(1, -1));
  EXPECT_EQ(book.credit(), S(3));
  EXPECT_EQ(hand.advance(state, S(0.001)).x(), felt);
}

/// No longer than `limit`, to rounding. Told in long double, which has the range.
template <class S>
bool is_within(const Vec3<S>& v, S limit) {
  const auto square = v.template cast<long double>().squaredNorm();
  return std::sqrt(square) <= static_cast<long double>(limit) * (1 + 16 * kRoundOff<S>)+4 *
                                  std::numeric_limits<S>::denorm_min();
}

template <class S>
struct Coupled {
  CouplingSettings<S> settings;
  MovingFrame<S> commanded = {{{S(0.5), 1, 0}}, {{1, 0, -1}, {0, 2, 0}}};
  MovingFrame<S> actual = {{{0, 1, S(0.25)}}, {{0, 1, 0}, {1, 0, 0}}};
};

TYPED_TEST(Haptics, HostileCoupling_IsAWrenchWithinItsLimits) {
  using S = TypeParam;
  test::for_each_spoiled<S>(Coupled<S>{}, kDraws, [](const Coupled<S>& c, bool is_number) {
    if (validate(c.settings) != Status::kOk) return;
    const Wrench<S> felt = coupling_wrench(c.settings, c.commanded, c.actual);
    EXPECT_TRUE((test::all_finite<S>(felt)));
    EXPECT_TRUE(is_within(felt.force_W, c.settings.max_force));
    EXPECT_TRUE(is_within(felt.moment_W, c.settings.max_moment));
    const S energy = stored_energy(c.settings, c.commanded.X_W, c.actual.X_W);
    if (is_number) {
      EXPECT_FALSE(energy < S(0)) << energy;
    } else if (!test::all_finite<S>(c.commanded.X_W) || !test::all_finite<S>(c.actual.X_W)) {
      EXPECT_FALSE(is_finite(energy));
      EXPECT_TRUE(felt.force_W == Vec3<S>::Zero() && felt.moment_W == Vec3<S>::Zero());
    }
  });
}

TYPED_TEST(Haptics, SpringStretchedBeyondAllNumbers_PullsWithItsLimit) {
  using S = TypeParam;
  const S far = std::numeric_limits<S>::max() / 8;
  for (const S limit : {S(60), S(1e-20), S(1e20)}) {
    const CouplingSettings<S> settings{1, 0, 1, 0, limit, 1};
    for (const S way : {far, far / 2, far / 1024}) {
      MovingFrame<S> actual;
      actual.X_W.p_W = {7 * way, 7 * way, -7 * way};  // its length is no number any more
      const Vec3<S> force = coupling_wrench(settings, {}, actual).force_W;
      EXPECT_NEAR(static_cast<double>(force.x() / limit), std::sqrt(1. / 3), 1e-6) << limit << way;
      EXPECT_EQ(force, Vec3<S>(force.x(), force.x(), -force.x()));
    }
  }
}

template <class S>
struct Held {
  CouplingSettings<S> settings;
  MovingFrame<S> commanded = {{{S(0.5), 1, 0}}, {{1, 0, -1}, {0, 2, 0}}};
  Pose<S> X_WB;
  Momentum<S> momentum;
  S inverse_mass = 2;
  Vec3<S> inverse_moments = {10, 20, 30};
  S dt = S(0.001);
};

TYPED_TEST(Haptics, Couple_ChangesNothingWhereRefused_AndLeavesNumbers) {
  using S = TypeParam;
  int refused = 0;
  const auto judge = [&refused](const Held<S>& h, bool) {
    if (validate(h.settings) != Status::kOk) return;
    Body<S> body = {h.X_WB, h.momentum, h.inverse_mass, h.inverse_moments, false};
    const Result<Wrench<S>> felt = couple(h.settings, h.commanded, body, h.dt);
    EXPECT_TRUE((test::all_finite<S>(felt.value)));
    EXPECT_TRUE(is_within(felt.value.force_W, h.settings.max_force));
    const bool frame = test::all_finite<S>(h.commanded) && is_positive(h.dt);
    if (!frame) {
      EXPECT_FALSE(felt.ok());
    }
    if (felt.ok()) {
      EXPECT_TRUE((test::all_finite<S>(body.momentum)));
    } else {
      ++refused;
      EXPECT_TRUE(test::same_bytes(body.momentum, h.momentum));
    }
  };
  test::for_each_spoiled<S>(Held<S>{}, kDraws, judge);
  EXPECT_GT(refused, 1000);
}

template <class S>
HandState<S> good_hand() {
  HandState<S> state;
  state.commanded.X_WH.p_W = {1, 0, 2};
  state.commanded.jacobian.setConstant(S(0.5));
  state.held_W.p_W = {1, S(0.125), 2};
  state.blow = {{S(0.5), 0, 0}, {0, S(0.25), 0}};
  return state;
}

TYPED_TEST(Haptics, HostileHand_FeelsNothingBeyondTheLimit) {
  using S = TypeParam;
  const HandForceSettings<S> settings;
  const S most = settings.transient.max_force;
  HandForce<S> hand;
  ASSERT_EQ(hand.configure(settings), Status::kOk);
  const HandState<S> good = good_hand<S>();
  test::for_each_spoiled<S>(good, kDraws, [&](const HandState<S>& state, bool is_number) {
    const Vec2<S> felt = hand.advance(state, S(0.001));
    EXPECT_LE(felt.cwiseAbs().maxCoeff(), most);
    EXPECT_TRUE(is_finite(felt) && is_finite(hand.stored()) && hand.stored() >= S(0));
    if (!is_number) {
      EXPECT_EQ(felt, (Vec2<S>::Zero()));
      EXPECT_EQ(hand.stored(), S(0));
    }
    EXPECT_TRUE(is_finite(hand.advance(good, S(0.001)))) << "and it goes on";
  });
}

TYPED_TEST(Haptics, SideThatThereIsNot_FeelsTheBlowsOfTheRightOne) {
  using S = TypeParam;
  struct Event {
    Contact<S> contact = {{1, 2, 3}, {0, 1, 0}, S(0)};
    S impulse = 2;
  };
  const std::vector<Event> events(2);
  const auto blow = blow_about<S>({0, 0, 1}, Side::kRight, events);
  for (const int value : {2, 127, 255}) {
    const auto felt = blow_about<S>({0, 0, 1}, static_cast<Side>(value), events);
    EXPECT_TRUE(test::same_bytes(felt, blow));
  }
  EXPECT_EQ(blow.linear_W, Vec3<S>(0, -4, 0));
}

TYPED_TEST(Haptics, HostilePulses_StayWithinTheLimitAndEnd) {
  using S = TypeParam;
  for (int i = 0; i < kDraws; ++i) {
    const std::vector<S> n = test::some_of<S>(8, i);
    ImpactTransient<S> pulse;
    const TransientSettings<S> settings{std::abs(n[0]), S(0.004), S(0.03), std::abs(n[1])};
    if (pulse.configure(settings) != Status::kOk) continue;
    const bool taken = pulse.strike({n[2], n[3]}) == Status::kOk;
    EXPECT_EQ(taken, is_finite(Vec2<S>(settings.gain * Vec2<S>(n[2], n[3]))));
    for (int step = 0; step < 32; ++step) {
      EXPECT_LE(pulse.advance(S(0.001)).cwiseAbs().maxCoeff(), settings.max_force);
    }
    EXPECT_EQ(pulse.left(), (Vec2<S>::Zero()));
    const S limit = settings.max_force;
    const Vec2<S> rest(n[4], n[5]);
    if (!is_finite(rest)) continue;
    const Vec2<S> sum = mixed<S>({limit, -limit / 2}, rest, limit);
    EXPECT_LE(sum.cwiseAbs().maxCoeff(), limit);
  }
}

template <class S>
struct Advice {  // DeviceProfile without its whole number, and gains
  S period = S(0.001);
  S damping = S(0.5);
  S friction = S(0.1);
  S encoder_step = S(1e-4);
  S force_limit = 10;
  S travel = 1;
  S stiffness = 100;
  S damper = S(0.1);

  DeviceProfile<S> profile(int delay) const {
    return {period, delay, damping, friction, encoder_step, force_limit, travel};
  }
};

/// What is advised is inside; with twice as much of both gains it is not.
template <class S>
void judge_advice(const Advice<S>& a, int delay) {
  const DeviceProfile<S> profile = a.profile(delay);
  const auto K = largest_stiffness(profile, a.damper);
  const auto B = largest_damping(profile, a.stiffness);
  const auto unsaturated = unsaturated_stiffness(profile);
  EXPECT_TRUE(is_finite(K.value.largest) && is_finite(B.value.largest) &&
              is_finite(unsaturated.value));
  if (validate(profile) != Status::kOk) {
    EXPECT_FALSE(K.ok() || B.ok() || unsaturated.ok());
    EXPECT_EQ(check<S>(profile, {a.stiffness, a.damper}), GainVerdict::kInvalidProfile);
    return;
  }
  EXPECT_EQ(check<S>(profile, {0, 0}), GainVerdict::kInside);
  constexpr S kMost = std::numeric_limits<S>::max() / 2;
  const auto is_plain = [kMost](S x) {  // with room for rounding at either end
    return x >= std::numeric_limits<S>::min() / kRoundOff<S> && x <= kMost;
  };
  if (K.ok() && is_plain(K.value.largest) && is_plain(profile.damping)) {
    EXPECT_EQ(check<S>(profile, {K.value.largest, a.damper}), GainVerdict::kInside);
    EXPECT_NE(check<S>(profile, {2 * K.value.largest, 2 * a.damper}), GainVerdict::kInside);
  }
  const bool terms_are_plain = is_plain(B.value.largest) &&
                               is_plain(B.value.largest / profile.period) &&
                               is_plain(profile.damping);
  if (B.ok() && terms_are_plain) {
    EXPECT_EQ(check<S>(profile, {a.stiffness, B.value.largest}), GainVerdict::kInside);
  }
}

TYPED_TEST(Haptics, HostileProfiles_AreRefusedOrWhatIsAdvisedIsInside) {
  using S = TypeParam;
  const int most = std::numeric_limits<int>::max();
  for (const int delay : {0, 3, most, -1, std::numeric_limits<int>::min()}) {
    test::for_each_spoiled<S>(Advice<S>{}, kDraws,
                              [delay](const Advice<S>& a, bool) { judge_advice(a, delay); });
  }
}

/// The coordinate in another unit: u -> u / `unit`; and time in seconds / `second`.
TYPED_TEST(Haptics, AdviceIsTheSameInAnyUnit) {
  using S = TypeParam;
  const Advice<S> a;
  const S before = largest_stiffness(a.profile(2), a.damper).value.largest;
  for (const S unit : {S(0x1p-20), S(1), S(0x1p20)}) {
    for (const S second : {S(0x1p-20), S(1), S(0x1p20)}) {
      const S square = unit * unit;
      const DeviceProfile<S> other{a.period * second,
                                   2,
                                   a.damping * second / square,
                                   a.friction / unit,
                                   a.encoder_step * unit,
                                   a.force_limit / unit,
                                   a.travel * unit};
      const auto K = largest_stiffness<S>(other, a.damper * second / square);
      ASSERT_TRUE(K.ok());
      EXPECT_EQ(K.value.largest * square, before) << unit << " " << second;
    }
  }
}

TYPED_TEST(Haptics, HostileBook_StaysWithinItsBounds) {
  using S = TypeParam;
  for (int i = 0; i < kDraws; ++i) {
    const std::vector<S> n = test::some_of<S>(16, i);
    PassivityObserver<S> book;
    (void)book.configure({std::abs(n[0]), std::abs(n[1]), std::abs(n[2]), std::abs(n[3]),
                          std::abs(n[4]), std::abs(n[5]), std::abs(n[6])});
    const bool configured = book.settings().period > S(0);
    (void)book.restart({n[7], n[8]}, n[9]);
    (void)book.supply(n[10]);
    for (std::size_t k = 0; k + 4 < n.size(); ++k) {
      const Status status = book.observe({n[k], n[k + 1]}, {n[k + 2], n[k + 3]}, n[k + 4]);
      EXPECT_EQ(status == Status::kUnavailable, !configured);
      EXPECT_GE(book.credit(), -book.settings().most_debt);
      EXPECT_LE(book.credit(), book.settings().most_credit);
      EXPECT_TRUE(is_finite(book.moved()));
      EXPECT_GE(owed_damping(book), S(0));
      EXPECT_LE(owed_damping(book), book.settings().largest_damping);
      const auto force = passive_force<S>(book, {n[k], n[k + 1]});
      const Vec2<S> held = force.value.force;
      EXPECT_TRUE(is_finite(held) && is_finite(force.value.excess));
      EXPECT_TRUE((is_within<S>({held.x(), held.y(), 0}, book.settings().largest_force)));
    }
  }
}

TYPED_TEST(Haptics, PassiveForce_IsCutAtAnyScale) {
  using S = TypeParam;
  const int end = std::numeric_limits<S>::max_exponent - 4;
  for (int power = -end; power <= end; ++power) {
    const S limit = std::ldexp(S(1), power);
    PassivityObserver<S> book;
    ASSERT_EQ(book.configure({1, 0, 0, 0, 1, 0, limit}), Status::kOk);
    const auto force = passive_force<S>(book, {3 * limit, -4 * limit});
    ASSERT_TRUE(force.ok()) << power;
    EXPECT_NEAR(static_cast<double>(force.value.force.x() / limit), 0.6, 1e-6) << power;
    EXPECT_NEAR(static_cast<double>(force.value.force.y() / limit), -0.8, 1e-6) << power;
  }
}

}  // namespace
}  // namespace batuta
