// SPDX-License-Identifier: MIT
// Fencers who advance and retreat: what their feet do to hands, blades, bodies and distance.
#include "configured_duel.hpp"

namespace batuta {
using namespace fencing;
namespace {

struct Order {
  float stick_y = 0;
  float feet_y = 0;
  float stick_x = 0;
};

/// An attack into the high inside line, where nothing of a guard is in the way.
Order high_inside(float y, float feet_y = 0) {
  return {y, feet_y, -y};
}

template <class DuelT>
class DuelFeet : public test::ConfiguredDuel<DuelT> {
 protected:
  using Num = typename test::ConfiguredDuel<DuelT>::ScalarT;
  using test::ConfiguredDuel<DuelT>::duel;

  InputSample sample(const Order& order) const {
    InputSample s;
    s.time = 1000 * duel->steps();
    s.sequence = duel->steps();
    s.x = order.stick_x;
    s.y = order.stick_y;
    s.feet_y = order.feet_y;
    return s;
  }
  void step(const Order& left, const Order& right) {
    const InputSample l = sample(left);
    const InputSample r = sample(right);
    ASSERT_EQ(duel->step(&l, &r), Status::kOk);
  }
  void run(int steps, const Order& left, const Order& right) {
    for (int k = 0; k < steps && !duel->bout().is_over(); ++k) step(left, right);
  }
  double way(Side side) const { return static_cast<double>(duel->feet(side).way()); }
  double distance() const {
    return static_cast<double>(duel->X_WF(Side::kRight).p_W.x() - duel->X_WF(Side::kLeft).p_W.x());
  }
};
TYPED_TEST_SUITE(DuelFeet, test::Duels);

double ramp(int k) {
  return clamp((k - 100) / 250.0, 0.0, 1.0);
}

// F goes with the feet, and everything that is in F: hand, blade, body.
TYPED_TEST(DuelFeet, Retreat_CarriesHandBladeAndBody) {
  const auto seen = [this](Side side) {
    std::vector<double> all;
    const Pose<typename TestFixture::Num> X_WF = this->duel->X_WF(side);
    const auto add = [&](const auto& p_W) {
      const auto p_F = to_body(X_WF, p_W);
      for (int i = 0; i < 3; ++i) all.push_back(static_cast<double>(p_F[i]));
    };
    add(this->duel->hand(side).X_WH.p_W);
    add(this->duel->blade_W(side).axis.a);
    add(this->duel->blade_W(side).axis.b);
    for (const auto& part : this->duel->body_W(side)) {
      add(part.axis.a);
      add(part.axis.b);
    }
    return all;
  };
  this->step({}, {});
  const auto before = seen(Side::kRight);
  const auto jacobian = this->duel->hand(Side::kRight).jacobian;
  this->run(600, {}, {0, -1});
  EXPECT_NEAR(this->way(Side::kRight), -1.8 * (0.6 - 1.8 / 28), 4e-3);
  EXPECT_NEAR(this->distance(), 2.25 - this->way(Side::kRight), 1e-5);
  EXPECT_EQ(this->way(Side::kLeft), 0);
  const auto after = seen(Side::kRight);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 2e-4) << i;
  EXPECT_EQ(this->duel->hand(Side::kRight).jacobian, jacobian);
}

// The blade follows the hand at the speed of the feet.
TYPED_TEST(DuelFeet, Retreat_MovesTheBladeWithTheFeet) {
  this->run(800, {}, {0, -1});
  const double before = static_cast<double>(this->duel->blade_W(Side::kRight).axis.a.x());
  this->step({}, {0, -1});
  const double after = static_cast<double>(this->duel->blade_W(Side::kRight).axis.a.x());
  EXPECT_NEAR((after - before) / 1e-3, 1.8, 2e-3) << "the right fencer goes back along +x";
}

TYPED_TEST(DuelFeet, Advances_StopBeforeTheOpponent) {
  this->settings.target = 0;  // or a blade touches who walks into it
  ASSERT_EQ(this->configure(), Status::kOk);
  this->run(3000, {0, 1}, {0, 1});
  EXPECT_NEAR(this->distance(), 1.5, 1e-3);
  EXPECT_NEAR(this->way(Side::kLeft), this->way(Side::kRight), 1e-3);
}

TYPED_TEST(DuelFeet, Retreats_StopAtTheEndOfTheStrip) {
  this->run(6000, {0, -1}, {0, -1});
  EXPECT_NEAR(static_cast<double>(this->duel->X_WF(Side::kLeft).p_W.x()), -7 + 0.4, 1e-3);
  EXPECT_NEAR(static_cast<double>(this->duel->X_WF(Side::kRight).p_W.x()), 7 - 0.4, 1e-3);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    for (const BodyPart part : {BodyPart::kRearShin, BodyPart::kFrontShin}) {
      const auto foot = this->duel->body_W(side)[static_cast<std::size_t>(part)].axis.b;
      EXPECT_LT(std::abs(static_cast<double>(foot.x())), 7.0) << "both feet are on the strip";
    }
  }
}

// A lunge from the ordinary distance arrives, one from a step further away does not.
TYPED_TEST(DuelFeet, Distance_DecidesWhetherALungeArrives) {
  for (const bool retreats : {false, true}) {
    ASSERT_EQ(this->configure(), Status::kOk);
    for (int k = 0; k < 1000 && !this->duel->bout().is_over(); ++k) {
      const auto y = static_cast<float>(ramp(k));
      this->step(high_inside(y), {0, retreats && k >= 200 ? -1.0F : 0.0F});
    }
    EXPECT_EQ(this->duel->bout().is_over(), !retreats);
  }
}

// An advance and a lunge reach who has stepped back.
TYPED_TEST(DuelFeet, AdvanceAndLunge_ReachFurther) {
  this->run(400, {}, {0, -1});
  const double far = this->distance();
  EXPECT_GT(far, 2.8);
  this->run(600, {0, 1}, {});
  for (int k = 0; k < 1000 && !this->duel->bout().is_over(); ++k) {
    this->step(high_inside(static_cast<float>(ramp(k))), {});
  }
  ASSERT_EQ(this->duel->bout().state, BoutState::kTouched);
  EXPECT_EQ(this->duel->bout().touches[0].by, Side::kLeft);
}

TYPED_TEST(DuelFeet, SilentStick_StopsTheFeet) {
  this->run(300, {}, {0, -1});
  for (int k = 0; k < 600; ++k) ASSERT_EQ(this->duel->step(nullptr, nullptr), Status::kOk);
  EXPECT_EQ(this->duel->feet(Side::kRight).velocity(), 0);
}

TYPED_TEST(DuelFeet, AfterAHalt_BothAreWhereTheyBegan) {
  this->settings.touches = 2;
  ASSERT_EQ(this->configure(), Status::kOk);
  for (int k = 0; k < 1000 && this->duel->bout().state != BoutState::kHalt; ++k) {
    this->step(high_inside(static_cast<float>(ramp(k)), 0.5F), {0, 0.2F});
  }
  ASSERT_EQ(this->duel->bout().state, BoutState::kHalt);
  EXPECT_NE(this->way(Side::kLeft), 0);
  while (!this->duel->bout().is_halt_over()) this->step({}, {0, -1});
  EXPECT_LT(this->way(Side::kRight), -0.5) << "who likes may walk in the halt";
  this->step({}, {});
  EXPECT_EQ(this->way(Side::kLeft), 0);
  EXPECT_EQ(this->way(Side::kRight), 0);
  EXPECT_EQ(this->distance(), 2.25);
}

/// Two full lunges at the least distance: trunks and heads are apart.
TYPED_TEST(DuelFeet, LeastDistance_KeepsTrunksAndHeadsApart) {
  using S = typename TestFixture::Num;
  const Salle<S> salle;
  const Strip<S> strip;
  const S way = (salle.distance - strip.least_distance) / 2;
  std::array<BodyShape<S>, 2> shapes;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const Fencer<S> fencer = second_fencer<S>();
    const Pose<S> X_WF = salle.X_WF(side, way);
    const Pose<S> X_WH = hand_at(fencer.map, Vec2<S>(0, 1), X_WF).X_WH;
    shapes[index_of(side)] = pose_body(fencer.build, X_WF, X_WH);
  }
  for (const BodyPart a : {BodyPart::kPelvis, BodyPart::kTorso, BodyPart::kHead}) {
    for (const BodyPart b : {BodyPart::kPelvis, BodyPart::kTorso, BodyPart::kHead}) {
      const auto gap = capsule_gap(shapes[0][static_cast<std::size_t>(a)],
                                   shapes[1][static_cast<std::size_t>(b)]);
      EXPECT_GT(gap.gap, S(0)) << name_of(a) << ", " << name_of(b);
    }
  }
}

TYPED_TEST(DuelFeet, SettingsOutOfRange_AreRefused) {
  using S = typename TestFixture::Num;
  const S nan = std::numeric_limits<S>::quiet_NaN();
  EXPECT_TRUE(this->refuses([](auto& s) { s.feet.acceleration = 0; }));
  EXPECT_TRUE(this->refuses([nan](auto& s) { s.strip.length = nan; }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.strip.end_room = S(-1); }));
  EXPECT_TRUE(this->refuses([](auto& s) { s.strip.least_distance = S(1e30); }));
}

}  // namespace
}  // namespace batuta
