// SPDX-License-Identifier: MIT
#include "batuta/fencing/map.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "batuta/fencing/fencer.hpp"
#include "draws.hpp"

namespace batuta {
using namespace fencing;
namespace {

constexpr double kTurnSlack = 1e-14;  ///< of quaternions in double, rad

/// A map that keeps its keys: places within 1 m, turns of up to 0.9 rad about each axis.
template <class S>
struct OwnMap {
  std::vector<MapKey<S>> keys;
  FencerMap<S> map;

  OwnMap(int columns, int rows, std::uint64_t seed) {
    for (int i = 0; i < columns * rows; ++i) {
      test::Draws draw(seed, 15, static_cast<std::uint64_t>(i));
      MapKey<S> key{};
      for (S& x : key.hand_F) x = static_cast<S>(draw.signed_unit());
      for (S& x : key.turn_F) x = static_cast<S>(0.9 * draw.signed_unit());
      key.feet = static_cast<S>(draw.between(-3, 3));
      keys.push_back(key);
    }
    map = {keys.data(), columns, rows};
  }
  OwnMap(const OwnMap&) = delete;
  OwnMap& operator=(const OwnMap&) = delete;

  Vec2<S> stick_of(int i) const {
    const int column = i % map.columns;
    const int row = i / map.columns;
    return {static_cast<S>(-1 + 2.0 * column / (map.columns - 1)),
            static_cast<S>(-1 + 2.0 * row / (map.rows - 1))};
  }
};

Vec3<double> vector(const std::array<double, 3>& x) {
  return {x[0], x[1], x[2]};
}

/// A rotation by its vector, by Rodrigues' formula.
Mat3<double> turned_by(const Vec3<double>& turn) {
  const double angle = turn.norm();
  if (angle == 0) return Mat3<double>::Identity();
  const Vec3<double> n = turn / angle;
  Mat3<double> cross;
  cross << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
  return Mat3<double>::Identity() + std::sin(angle) * cross + (1 - std::cos(angle)) * cross * cross;
}

/// The ramp of the feet, told otherwise than by feet_at().
double ramp(double asked) {
  if (std::abs(asked) <= 0.25) return 0;
  if (std::abs(asked) >= 1) return asked > 0 ? 1 : -1;
  return asked > 0 ? (asked - 0.25) / 0.75 : (asked + 0.25) / 0.75;
}

TEST(Map, OfAnySize_GoesThroughItsKeys) {
  for (int columns = kFewestMapKeys; columns <= kMostMapKeys; ++columns) {
    for (int rows = kFewestMapKeys; rows <= kMostMapKeys; ++rows) {
      const OwnMap<double> own(columns, rows, static_cast<std::uint64_t>(100 * columns + rows));
      ASSERT_EQ(validate(own.map), Status::kOk);
      for (int i = 0; i < columns * rows; ++i) {
        const MapKey<double>& key = own.keys[static_cast<std::size_t>(i)];
        const auto hand = hand_at(own.map, own.stick_of(i)).X_WH;
        ASSERT_LE((hand.p_W - vector(key.hand_F)).norm(), kTurnSlack) << columns << " x " << rows;
        const Mat3<double> R = turned_by(vector(key.turn_F));
        ASSERT_LE((hand.q_WB.toRotationMatrix() - R).norm(), 10 * kTurnSlack) << i;
        ASSERT_NEAR(feet_at(own.map, own.stick_of(i)), ramp(key.feet), 10 * kTurnSlack) << i;
      }
    }
  }
}

// The columns and rows of the library's map lie at numbers of the format.
TEST(Map, OfTheLibrary_HasItsKeysToTheBit) {
  const FencerMap<float>& map = library_map<float>();
  for (int i = 0; i < map.columns * map.rows; ++i) {
    const Vec2<float> stick(-1 + 0.25F * static_cast<float>(i % 9),
                            -1 + 0.5F * static_cast<float>(i / 9));
    const auto hand = hand_at(map, stick).X_WH;
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(hand.p_W[k], map.keys[i].hand_F[static_cast<std::size_t>(k)]) << i;
    }
    EXPECT_EQ(map.keys[i].turn_F[0], 0.0F) << "the shortest turn onto the blade's aim";
  }
}

/// Velocity and angular velocity by central differences of the pose itself.
StickJacobian<double> by_differences(const FencerMap<double>& map, const Vec2<double>& stick) {
  const double h = 1e-5;
  StickJacobian<double> J;
  for (int k = 0; k < 2; ++k) {
    Vec2<double> step = Vec2<double>::Zero();
    step[k] = h;
    const auto plus = hand_at(map, Vec2<double>(stick + step)).X_WH;
    const auto minus = hand_at(map, Vec2<double>(stick - step)).X_WH;
    const Quat<double> turn = plus.q_WB * minus.q_WB.conjugate();
    J.col(k).head<3>() = (plus.p_W - minus.p_W) / (2 * h);
    J.col(k).tail<3>() = (turn.w() < 0 ? -2.0 : 2.0) * turn.vec() / (2 * h);  // small turn
  }
  return J;
}

TEST(Map, Jacobian_IsTheDerivativeOfTheHand) {
  const OwnMap<double> own(7, 5, 3);
  for (const FencerMap<double>& map : {own.map, library_map<double>()}) {
    for (std::uint64_t n = 0; n < 2000; ++n) {
      test::Draws draw(4, 0, n);
      const double x = 0.99 * draw.signed_unit();
      const double y = 0.99 * draw.signed_unit();
      const auto J = hand_at(map, Vec2<double>(x, y)).jacobian;
      ASSERT_LE((J - by_differences(map, {x, y})).norm(), 1e-6 * (1 + J.norm())) << x << " " << y;
    }
  }
}

// C1: across every border of the cells, hand, Jacobian and feet change by no more than the way.
TEST(Map, AcrossCellBorders_HandJacobianAndFeetAreContinuous) {
  const double h = 1e-9;
  const auto expect_smooth = [h](const FencerMap<double>& map, const Vec2<double>& at, int axis) {
    Vec2<double> step = Vec2<double>::Zero();
    step[axis] = h;
    const Vec2<double> before = at - step;
    const Vec2<double> after = at + step;
    const auto one = hand_at(map, before);
    const auto other = hand_at(map, after);
    EXPECT_LE((one.X_WH.p_W - other.X_WH.p_W).norm(), 100 * h) << at.x() << " " << at.y();
    EXPECT_LE((one.jacobian - other.jacobian).norm(), 1e4 * h) << at.x() << " " << at.y();
    EXPECT_NEAR(feet_at(map, before), feet_at(map, after), 100 * h) << at.x() << " " << at.y();
  };
  const OwnMap<double> own(6, 4, 8);
  for (const FencerMap<double>& map : {own.map, library_map<double>()}) {
    for (double along = -0.99; along <= 1; along += 0.06) {
      for (int c = 1; c < map.columns - 1; ++c) {
        expect_smooth(map, {-1 + 2.0 * c / (map.columns - 1), along}, 0);
      }
      for (int r = 1; r < map.rows - 1; ++r) {
        expect_smooth(map, {along, -1 + 2.0 * r / (map.rows - 1)}, 1);
      }
    }
  }
}

TEST(Map, BeyondTheRim_IsTheRim) {
  const OwnMap<double> own(4, 3, 21);
  const Vec2<double> rim(1, -0.4);
  const Vec2<double> beyond(3, -0.4);
  EXPECT_EQ(hand_at(own.map, rim).X_WH.p_W, hand_at(own.map, beyond).X_WH.p_W);
  EXPECT_EQ(hand_at(own.map, beyond).jacobian.col(0).norm(), 0.0);
  EXPECT_EQ(feet_at(own.map, rim), feet_at(own.map, beyond));
}

/// What is in F, seen from W.
TEST(Map, InW_IsTheHandOfFCarriedAlong) {
  const OwnMap<double> own(5, 5, 2);
  const Salle<double> salle;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const Pose<double> X_WF = salle.X_WF(side, 0.7);
    const Mat3<double> R = X_WF.q_WB.toRotationMatrix();
    for (std::uint64_t n = 0; n < 100; ++n) {
      test::Draws draw(5, 1, n);
      const double x = draw.signed_unit();
      const double y = draw.signed_unit();
      const auto in_F = hand_at(own.map, Vec2<double>(x, y));
      const auto in_W = hand_at(own.map, Vec2<double>(x, y), X_WF);
      EXPECT_LE((in_W.X_WH.p_W - X_WF.p_W - R * in_F.X_WH.p_W).norm(), kTurnSlack);
      EXPECT_LE((in_W.X_WH.q_WB.toRotationMatrix() - R * in_F.X_WH.q_WB.toRotationMatrix()).norm(),
                10 * kTurnSlack);
      for (int k = 0; k < 2; ++k) {
        const StickJacobian<double>& J = in_F.jacobian;
        EXPECT_LE((in_W.jacobian.col(k).head<3>() - R * J.col(k).head<3>()).norm(), kTurnSlack);
        EXPECT_LE((in_W.jacobian.col(k).tail<3>() - R * J.col(k).tail<3>()).norm(),
                  10 * kTurnSlack);
      }
    }
  }
}

// A row of two keys is a straight ramp, so that what is asked at each place is known.
TEST(Map, Feet_FollowTheRampFromNoOrderToAll) {
  std::vector<MapKey<double>> keys(4);
  keys[0].feet = keys[2].feet = -2;
  keys[1].feet = keys[3].feet = 2;
  const FencerMap<double> map{keys.data(), 2, 2};
  double last = -1;
  for (int i = -1000; i <= 1000; ++i) {
    const double x = i / 1000.0;
    const double order = feet_at(map, Vec2<double>(x, 0.3));
    EXPECT_NEAR(order, ramp(2 * x), 1e-14) << x;
    EXPECT_LE(std::abs(order - last), 2e-3 / 0.75 + 1e-12) << "no jump at " << x;
    last = order;
  }
  EXPECT_EQ(feet_at(map, Vec2<double>(0.125, 0)), 0.0) << "up to kNoOrder";
  EXPECT_GT(feet_at(map, Vec2<double>(0.126, 0)), 0.0);
  EXPECT_EQ(feet_at(map, Vec2<double>(0.5, 0)), 1.0);
  EXPECT_EQ(feet_at(map, Vec2<double>(-0.5, 0)), -1.0);
  EXPECT_EQ(feet_at(map, Vec2<double>(-1, 0)), -1.0);
}

TEST(Map, WhatCannotBe_IsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto verdict = [](std::size_t which, auto change) {
    OwnMap<double> own(3, 4, 6);
    change(own.keys[which]);
    return validate(own.map);
  };
  using Key = MapKey<double>;
  for (const std::size_t k : {std::size_t{0}, std::size_t{5}, std::size_t{11}}) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (const double bad : {nan, infinity, -infinity, 1000.1, -1000.1}) {
        EXPECT_EQ(verdict(k, [&](Key& key) { key.hand_F[i] = bad; }), Status::kInvalidArgument);
      }
      for (const double bad : {nan, infinity, -infinity, 3.01, -3.01}) {
        EXPECT_EQ(verdict(k, [&](Key& key) { key.turn_F[i] = bad; }), Status::kInvalidArgument);
      }
      EXPECT_EQ(verdict(k, [&](Key& key) { key.hand_F[i] = -1000; }), Status::kOk);
      const auto full = [&](Key& key) {
        key.turn_F = {0, 0, 0};
        key.turn_F[i] = 3;
      };
      EXPECT_EQ(verdict(k, full), Status::kOk);
    }
    for (const double bad : {nan, infinity, -infinity, 100.1, -100.1}) {
      EXPECT_EQ(verdict(k, [&](Key& key) { key.feet = bad; }), Status::kInvalidArgument);
    }
    EXPECT_EQ(verdict(k, [](Key& key) { key.feet = -100; }), Status::kOk);
    EXPECT_EQ(verdict(k,
                      [](Key& key) {
                        key.turn_F = {1.8, 1.8, 1.8};
                      }),
              Status::kInvalidArgument)
        << "it is the turn that counts, not its components";
  }
  const OwnMap<double> own(16, 16, 6);
  EXPECT_EQ(validate(FencerMap<double>{}), Status::kInvalidArgument);
  EXPECT_EQ(validate(FencerMap<double>{nullptr, 3, 3}), Status::kInvalidArgument);
  for (const int bad : {-1, 0, 1, 17, 1 << 30}) {
    EXPECT_EQ(validate(FencerMap<double>{own.keys.data(), bad, 3}), Status::kInvalidArgument);
    EXPECT_EQ(validate(FencerMap<double>{own.keys.data(), 3, bad}), Status::kInvalidArgument);
  }
}

template <class S>
class MapId : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(MapId, Scalars);

TYPED_TEST(MapId, EveryNumberAndTheSizes_ChangeIt) {
  using S = TypeParam;
  OwnMap<S> own(4, 3, 12);
  const OwnMap<S> same(4, 3, 12);
  std::set<std::uint32_t> seen{map_id(own.map)};
  EXPECT_EQ(map_id(same.map), map_id(own.map)) << "wherever it is";
  std::size_t changes = 0;
  const auto try_with = [&](S& number, S other) {
    const S kept = number;
    number = other;
    seen.insert(map_id(own.map));
    number = kept;
    ++changes;
  };
  for (MapKey<S>& key : own.keys) {
    for (auto* triple : {&key.hand_F, &key.turn_F}) {
      for (S& x : *triple) try_with(x, -x);
      for (S& x : *triple) try_with(x, std::nextafter(x, S(9)));
    }
    try_with(key.feet, -key.feet);
    try_with(key.feet, std::nextafter(key.feet, S(9)));
  }
  EXPECT_EQ(changes, 2U * 7U * 12U);
  EXPECT_EQ(seen.size(), 1 + changes);
  const std::size_t before = seen.size();
  const std::vector<std::array<int, 2>> sizes = {{3, 4}, {2, 6}, {6, 2}, {4, 2}, {2, 4}};
  for (const auto& size : sizes)
    seen.insert(map_id(FencerMap<S>{own.keys.data(), size[0], size[1]}));
  EXPECT_EQ(seen.size(), before + sizes.size());
}

// A fencer seen in a mirror has the same sizes of numbers: signs alone tell the maps apart.
TYPED_TEST(MapId, AnyPairOfSigns_ChangesIt) {
  using S = TypeParam;
  OwnMap<S> own(2, 3, 9);
  std::vector<S*> numbers;
  for (MapKey<S>& key : own.keys) {
    for (S& x : key.hand_F) numbers.push_back(&x);
    for (S& x : key.turn_F) numbers.push_back(&x);
    numbers.push_back(&key.feet);
  }
  std::set<std::uint32_t> seen{map_id(own.map)};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      *numbers[i] = -*numbers[i];
      *numbers[j] = -*numbers[j];
      seen.insert(map_id(own.map));
      *numbers[i] = -*numbers[i];
      *numbers[j] = -*numbers[j];
    }
  }
  EXPECT_EQ(seen.size(), 1 + numbers.size() * (numbers.size() - 1) / 2);
}

TEST(Map, Float_FollowsDouble) {
  const FencerMap<float>& in_float = library_map<float>();
  const FencerMap<double>& in_double = library_map<double>();
  ASSERT_EQ(in_float.columns, in_double.columns);
  ASSERT_EQ(in_float.rows, in_double.rows);
  for (double y = -1; y <= 1; y += 0.03125) {
    for (double x = -1; x <= 1; x += 0.03125) {
      const Vec2<double> stick(x, y);
      const auto f = hand_at(in_float, Vec2<float>(stick.cast<float>()));
      const auto d = hand_at(in_double, stick);
      ASSERT_LE((f.X_WH.p_W.cast<double>() - d.X_WH.p_W).norm(), 1e-6);
      ASSERT_LE((f.X_WH.q_WB.coeffs().cast<double>() - d.X_WH.q_WB.coeffs()).norm(), 1e-6);
      ASSERT_LE((f.jacobian.cast<double>() - d.jacobian).norm(), 1e-5);
      const float feet = feet_at(in_float, Vec2<float>(stick.cast<float>()));
      ASSERT_NEAR(static_cast<double>(feet), feet_at(in_double, stick), 1e-5);
    }
  }
}

/// The straight way between two places of the stick, in hundred steps.
template <class Judge>
void along(const Vec2<double>& from, const Vec2<double>& to, const Judge& judge) {
  for (int i = 0; i <= 100; ++i) {
    const Vec2<double> stick = from + 0.01 * i * (to - from);
    judge(feet_at(library_map<double>(), stick), stick);
  }
}

TEST(LibraryMap, StraightBack_Retreats) {
  for (double x = -0.1; x <= 0.1; x += 0.02) {
    along({x, -0.5}, {x, -1}, [](double order, const Vec2<double>& stick) {
      EXPECT_EQ(order, -1) << stick.x() << " " << stick.y();
    });
  }
  double last = 0;
  along({0, 0}, {0, -0.3}, [&last](double order, const Vec2<double>& stick) {
    EXPECT_LE(order, last) << stick.x() << " " << stick.y();
    last = order;
  });
  EXPECT_EQ(last, -1);
}

// From guard, and from one parry to the other on the same side.
TEST(LibraryMap, Parries_DoNotWalk) {
  const auto stands = [](double order, const Vec2<double>& stick) {
    EXPECT_EQ(order, 0) << stick.x() << " " << stick.y();
  };
  for (const double side : {-1.0, 1.0}) {
    along({0, 0}, {side, 0}, stands);
    along({0, 0}, {side, -1}, stands);
    along({side, 0}, {side, -1}, stands);
    along({0, 0}, {side, -0.95}, stands);
  }
}

TEST(LibraryMap, AttacksDoNotWalkAndNothingGoesForward) {
  for (double y = -1; y <= 1; y += 0.01) {
    for (double x = -1; x <= 1; x += 0.01) {
      const double order = feet_at(library_map<double>(), Vec2<double>(x, y));
      EXPECT_LE(order, 0) << x << " " << y;
      EXPECT_TRUE(order == 0 || y < 0) << x << " " << y;
    }
  }
}

}  // namespace
}  // namespace batuta
