// SPDX-License-Identifier: MIT
#include "batuta/control/keyframes.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <new>
#include <random>

namespace batuta {
namespace {

template <class S>
Pose<S> pose(double x, double y, double z, double rx, double ry, double rz) {
  const Vec3<S> turn(static_cast<S>(rx), static_cast<S>(ry), static_cast<S>(rz));
  return {{static_cast<S>(x), static_cast<S>(y), static_cast<S>(z)}, exp_map(turn)};
}

double angle_between(const Quat<double>& a, const Quat<double>& b) {
  return 2 * (a.coeffs() - (a.dot(b) < 0 ? -1.0 : 1.0) * b.coeffs()).norm();  // small angles
}

/// Keys at random: places within 1 m, turns up to 1.4 rad about a common orientation.
template <class S, int M, int N>
typename KeyframeGrid<S, M, N>::Keys random_keys(unsigned seed) {
  std::mt19937 random(seed);
  const auto unit = [&random] { return static_cast<double>(random() % 20001) / 10000.0 - 1.0; };
  typename KeyframeGrid<S, M, N>::Keys keys;
  const Pose<S> common = pose<S>(0, 0, 0, 1.1, -2.0, 0.7);
  for (auto& key : keys) {
    key = pose<S>(unit(), unit(), unit(), 0.8 * unit(), 0.8 * unit(), 0.8 * unit());
    key.q_WB = common.q_WB * key.q_WB;
  }
  return keys;
}

template <int M, int N>
void expect_exact_at_keys(unsigned seed) {
  KeyframeGrid<double, M, N> grid;
  const auto keys = random_keys<double, M, N>(seed);
  ASSERT_EQ(grid.set_keys(keys), Status::kOk);
  for (int j = 0; j < N; ++j) {
    for (int i = 0; i < M; ++i) {
      const Pose<double>& key = keys[static_cast<std::size_t>(i + M * j)];
      const Vec2<double> stick(-1.0 + 2.0 * i / (M - 1), -1.0 + 2.0 * j / (N - 1));
      const auto at = grid.at(stick);
      EXPECT_LE((at.X_WH.p_W - key.p_W).norm(), 1e-14);
      EXPECT_LE(angle_between(at.X_WH.q_WB, key.q_WB), 1e-14);
    }
  }
}

TEST(KeyframeGrid, AtKeys_IsTheKey) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    expect_exact_at_keys<2, 2>(seed);
    expect_exact_at_keys<3, 3>(seed);
    expect_exact_at_keys<4, 2>(seed);
    expect_exact_at_keys<5, 7>(seed);
  }
}

TEST(KeyframeGrid, AtKeysInFloat_PlacesAreTheKeysToTheBit) {
  KeyframeGrid<float, 3, 3> grid;
  const auto keys = random_keys<float, 3, 3>(3);
  ASSERT_EQ(grid.set_keys(keys), Status::kOk);
  for (int k = 0; k < 9; ++k) {
    const auto at = grid.at({static_cast<float>(k % 3 - 1), static_cast<float>(k / 3 - 1)});
    EXPECT_EQ(at.X_WH.p_W, keys[static_cast<std::size_t>(k)].p_W);
    EXPECT_LE((at.X_WH.q_WB.coeffs() - keys[static_cast<std::size_t>(k)].q_WB.coeffs()).norm(),
              4e-7F);
  }
}

/// Velocity and angular velocity by central differences of the pose itself.
template <class Grid>
StickJacobian<double> by_differences(const Grid& grid, const Vec2<double>& stick) {
  const double h = 1e-5;
  StickJacobian<double> J;
  for (int k = 0; k < 2; ++k) {
    Vec2<double> step = Vec2<double>::Zero();
    step[k] = h;
    const auto plus = grid.at(stick + step).X_WH;
    const auto minus = grid.at(stick - step).X_WH;
    const Quat<double> turn = plus.q_WB * minus.q_WB.conjugate();
    J.col(k).head<3>() = (plus.p_W - minus.p_W) / (2 * h);
    J.col(k).tail<3>() = (turn.w() < 0 ? -2.0 : 2.0) * turn.vec() / (2 * h);  // small turn
  }
  return J;
}

TEST(KeyframeGrid, Jacobian_IsTheDerivativeOfThePose) {
  std::mt19937 random(11);
  const auto unit = [&random] { return static_cast<double>(random() % 20001) / 10100.0 - 0.99; };
  for (unsigned seed = 0; seed < 10; ++seed) {
    KeyframeGrid<double, 5, 4> grid;
    ASSERT_EQ(grid.set_keys(random_keys<double, 5, 4>(seed)), Status::kOk);
    for (int n = 0; n < 200; ++n) {
      const Vec2<double> stick(unit(), unit());
      const auto J = grid.at(stick).jacobian;
      ASSERT_LE((J - by_differences(grid, stick)).norm(), 1e-6 * (1 + J.norm()));
      const Twist<double> twist = hand_twist(J, Vec2<double>(2, -3));
      ASSERT_LE((twist.v_W - (2 * J.col(0) - 3 * J.col(1)).head<3>()).norm(), 1e-12);
      ASSERT_LE((twist.w_W - (2 * J.col(0) - 3 * J.col(1)).tail<3>()).norm(), 1e-12);
    }
  }
}

// C1: across every border of the cells, pose and Jacobian change by no more than the distance.
TEST(KeyframeGrid, AcrossCellBorders_PoseAndJacobianAreContinuous) {
  KeyframeGrid<double, 5, 5> grid;
  ASSERT_EQ(grid.set_keys(random_keys<double, 5, 5>(5)), Status::kOk);
  const double h = 1e-9;
  for (const double border : {-0.5, 0.0, 0.5}) {
    for (double along = -1; along <= 1; along += 0.0625) {
      const auto left = grid.at({border - h, along});
      const auto right = grid.at({border + h, along});
      EXPECT_LE((left.X_WH.p_W - right.X_WH.p_W).norm(), 1e-7);
      EXPECT_LE((left.jacobian - right.jacobian).norm(), 1e-6);
      const auto below = grid.at({along, border - h});
      const auto above = grid.at({along, border + h});
      EXPECT_LE((below.jacobian - above.jacobian).norm(), 1e-6);
    }
  }
}

TEST(KeyframeGrid, BeyondTheRim_IsTheRimAndDoesNotMoveAcross) {
  KeyframeGrid<double, 3, 4> grid;
  ASSERT_EQ(grid.set_keys(random_keys<double, 3, 4>(9)), Status::kOk);
  const auto rim = grid.at({1, 0.3});
  const auto beyond = grid.at({1.7, 0.3});
  EXPECT_EQ(rim.X_WH.p_W, beyond.X_WH.p_W);
  EXPECT_EQ(rim.X_WH.q_WB.coeffs(), beyond.X_WH.q_WB.coeffs());
  EXPECT_EQ(beyond.jacobian.col(0).norm(), 0.0);
  EXPECT_EQ(rim.jacobian.col(1), beyond.jacobian.col(1));
  EXPECT_EQ(grid.at({-9, 5}).X_WH.p_W, grid.at({-1, 1}).X_WH.p_W);
  EXPECT_EQ(grid.at({-9, 5}).jacobian.norm(), 0.0);
}

// Three keys in a row give the parabola through them; more keys still reproduce a parabola.
template <int M>
void expect_parabola() {
  const auto f = [](double x) { return 0.3 + 0.8 * x - 0.6 * x * x; };
  typename KeyframeGrid<double, M, 2>::Keys keys;
  for (int k = 0; k < 2 * M; ++k) {
    const double x = -1.0 + 2.0 * (k % M) / (M - 1);
    keys[static_cast<std::size_t>(k)] = pose<double>(f(x), 0, 0, 0, 0, 0.7 * x * x);
  }
  KeyframeGrid<double, M, 2> grid;
  ASSERT_EQ(grid.set_keys(keys), Status::kOk);
  for (double x = -1; x <= 1; x += 0.01) {
    const auto at = grid.at({x, 0.4});
    EXPECT_NEAR(at.X_WH.p_W.x(), f(x), 1e-14);
    EXPECT_NEAR(at.jacobian(0, 0), 0.8 - 1.2 * x, 1e-13);
    EXPECT_NEAR(at.jacobian(5, 0), 1.4 * x, 1e-13);
    EXPECT_NEAR(at.X_WH.q_WB.z(), std::sin(0.35 * x * x), 1e-14);
  }
}
TEST(KeyframeGrid, KeysOnAParabola_GiveTheParabola) {
  expect_parabola<3>();
  expect_parabola<4>();
  expect_parabola<7>();
}

TEST(KeyframeGrid, TwoByTwo_IsBilinearInPlaces) {
  KeyframeGrid<double, 2, 2> grid;
  ASSERT_EQ(grid.set_keys({pose<double>(0, 0, 0, 0, 0, 0), pose<double>(1, 0, 0, 0, 0, 0),
                           pose<double>(0, 0, 1, 0, 0, 0), pose<double>(3, 0, 5, 0, 0, 0)}),
            Status::kOk);
  EXPECT_NEAR(grid.at({0, 0}).X_WH.p_W.x(), 1.0, 1e-15);
  EXPECT_NEAR(grid.at({0, 0}).X_WH.p_W.z(), 1.5, 1e-15);
}

TEST(KeyframeGrid, KeysOutOfRange_AreRefusedAndTheGridStays) {
  using Grid = KeyframeGrid<double, 2, 2>;
  Grid grid;
  const Grid::Keys good = random_keys<double, 2, 2>(1);
  ASSERT_EQ(grid.set_keys(good), Status::kOk);
  Grid::Keys bad = good;
  bad[3].p_W.y() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(grid.set_keys(bad), Status::kInvalidArgument);
  bad = good;
  bad[2].q_WB.w() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(grid.set_keys(bad), Status::kInvalidArgument);
  bad = good;
  bad[1].q_WB = good[0].q_WB * pose<double>(0, 0, 0, 0, 3.05, 0).q_WB;
  EXPECT_EQ(grid.set_keys(bad), Status::kInvalidArgument);
  bad[1].q_WB = good[0].q_WB * pose<double>(0, 0, 0, 0, 2.95, 0).q_WB;
  EXPECT_EQ(grid.at({1, 1}).X_WH.p_W, good[3].p_W);
  EXPECT_EQ(grid.set_keys(bad), Status::kOk);
}

// The key in the middle, from which all turns count, is one of them. However short a quaternion
// is: where it has a length, it has a direction.
TEST(KeyframeGrid, QuaternionOfNoLength_IsRefused_AndTheShortestIsNot) {
  KeyframeGrid<double, 3, 3> grid;
  const auto good = random_keys<double, 3, 3>(2);
  ASSERT_EQ(grid.set_keys(good), Status::kOk);
  const auto before = grid.at({1, 1});
  for (std::size_t k = 0; k < good.size(); ++k) {
    for (const double none : {0.0, -0.0}) {
      auto bad = good;
      bad[k].q_WB.coeffs().setConstant(none);
      EXPECT_EQ(grid.set_keys(bad), Status::kInvalidArgument) << k;
    }
    EXPECT_EQ(grid.at({1, 1}).X_WH.q_WB.coeffs(), before.X_WH.q_WB.coeffs()) << k;
  }
  auto shortest = good;
  for (auto& key : shortest) key.q_WB.coeffs() *= 1e-300;
  ASSERT_EQ(grid.set_keys(shortest), Status::kOk);
  EXPECT_LE(angle_between(grid.at({1, 1}).X_WH.q_WB, good[8].q_WB), 1e-14);
}

/// Half of the keys are turned one way by 1.6 rad, half the other way: none is too far from the
/// central one, which is not turned, and any other of them is.
template <int M, int N>
Status set_turned_both_ways(std::size_t unturned) {
  typename KeyframeGrid<double, M, N>::Keys keys;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    keys[k] = pose<double>(0, 0, 0, k % 2 == 0 ? 1.6 : -1.6, 0, 0);
  }
  keys[unturned] = Pose<double>();
  KeyframeGrid<double, M, N> grid;
  return grid.set_keys(keys);
}

TEST(KeyframeGrid, Turns_CountFromTheKeyInTheMiddle) {
  EXPECT_EQ((set_turned_both_ways<3, 3>(4)), Status::kOk);
  EXPECT_EQ((set_turned_both_ways<5, 3>(7)), Status::kOk);
  EXPECT_EQ((set_turned_both_ways<3, 7>(10)), Status::kOk);
  EXPECT_EQ((set_turned_both_ways<7, 5>(17)), Status::kOk);
  for (std::size_t k = 0; k < 15; ++k) {
    if (k != 7) {
      EXPECT_EQ((set_turned_both_ways<5, 3>(k)), Status::kInvalidArgument) << k;
    }
  }
}

// A quaternion and its negative are one key.
TEST(KeyframeGrid, NegatedQuaternions_ChangeNothing) {
  auto keys = random_keys<double, 3, 3>(21);
  KeyframeGrid<double, 3, 3> grid;
  ASSERT_EQ(grid.set_keys(keys), Status::kOk);
  const auto before = grid.at({0.37, -0.6});
  for (std::size_t k = 0; k < keys.size(); k += 2) keys[k].q_WB.coeffs() *= -1.0;
  ASSERT_EQ(grid.set_keys(keys), Status::kOk);
  const auto after = grid.at({0.37, -0.6});
  EXPECT_LE(angle_between(before.X_WH.q_WB, after.X_WH.q_WB), 1e-14);
  EXPECT_LE((before.jacobian - after.jacobian).norm(), 1e-13);
}

TEST(KeyframeGrid, Float_FollowsDouble) {
  KeyframeGrid<float, 3, 3> in_float;
  KeyframeGrid<double, 3, 3> in_double;
  const auto keys = random_keys<float, 3, 3>(17);
  KeyframeGrid<double, 3, 3>::Keys same_keys;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    same_keys[k] = {keys[k].p_W.cast<double>(), keys[k].q_WB.cast<double>()};
  }
  ASSERT_EQ(in_float.set_keys(keys), Status::kOk);
  ASSERT_EQ(in_double.set_keys(same_keys), Status::kOk);
  for (double y = -1; y <= 1; y += 0.03125) {
    for (double x = -1; x <= 1; x += 0.03125) {
      const auto f = in_float.at({static_cast<float>(x), static_cast<float>(y)});
      const auto d = in_double.at({x, y});
      ASSERT_LE((f.X_WH.p_W.cast<double>() - d.X_WH.p_W).norm(), 1e-6);
      ASSERT_LE(angle_between(f.X_WH.q_WB.cast<double>(), d.X_WH.q_WB), 2e-6);
      ASSERT_LE((f.jacobian.cast<double>() - d.jacobian).norm(), 1e-5);
    }
  }
}

// Seven numbers a key, of which one is asked for: it lies on the surface of the places.
TEST(KeyGridView, OneNumber_IsOnTheSurfaceOfItsKeys) {
  constexpr int kStride = 7;
  constexpr int kColumns = 5;
  constexpr int kRows = 4;
  std::mt19937 random(29);
  const auto unit = [&random] { return static_cast<double>(random() % 20001) / 10000.0 - 1.0; };
  std::array<double, kStride * kColumns * kRows> numbers;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = i % kStride == 6 ? numbers[i - 5] : 0.3 * unit();  // the last is the place's y
  }
  const detail::KeyGridView<double> grid{numbers.data(), kStride, kColumns, kRows,
                                         Quat<double>::Identity()};
  for (int n = 0; n < 500; ++n) {
    const Vec2<double> stick(1.2 * unit(), 1.2 * unit());
    const auto pose = detail::pose_on(grid, stick);
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_NEAR(detail::surface_on(grid, stick, axis).number, pose.X_WH.p_W[axis], 1e-15);
    }
    ASSERT_NEAR(detail::surface_on(grid, stick, 6).number, pose.X_WH.p_W.y(), 1e-15);
  }
  EXPECT_DEATH((void)detail::surface_on(grid, {0.0, 0.0}, kStride), "");
  EXPECT_DEATH((void)detail::surface_on(grid, {0.0, 0.0}, -1), "");
}

TEST(KeyGridView, OfNothing_HasNoKeys) {
  const detail::KeyGridView<float> view;
  EXPECT_EQ(view.numbers, nullptr);
  EXPECT_EQ(view.columns, 0);
  EXPECT_EQ(view.rows, 0);
  EXPECT_EQ(view.q_ref.coeffs(), Quat<float>::Identity().coeffs());
}

TEST(KeyframeGrid, BeforeThereAreKeys_IsTheOrigin) {
  // Where there was something else before.
  alignas(KeyframeGrid<float, 3, 3>) unsigned char place[sizeof(KeyframeGrid<float, 3, 3>)];
  std::memset(place, 0xA5, sizeof(place));
  const auto* grid = new (place) KeyframeGrid<float, 3, 3>;
  const KeyedPose<float> hand = grid->at({0.3F, -0.7F});
  EXPECT_EQ(hand.X_WH.p_W, Vec3<float>(0, 0, 0));
  EXPECT_EQ(hand.X_WH.q_WB.coeffs(), Quat<float>::Identity().coeffs());
  EXPECT_EQ(hand.jacobian.norm(), 0.0F);
}

}  // namespace
}  // namespace batuta
