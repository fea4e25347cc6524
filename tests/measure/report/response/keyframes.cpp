// SPDX-License-Identifier: MIT
// Error of the interpolated hand against the number of keys. The truth is a smooth function from
// the stick to a pose; a grid of n x n keys samples it, and is asked in between.

#include "batuta/control/keyframes.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "draws.hpp"
#include "parts.hpp"

namespace batuta::report {
namespace {

constexpr std::uint64_t kSeed = 51;
constexpr int kLeastKeys = 2;   ///< along one coordinate
constexpr int kMostKeys = 17;   ///< the same
constexpr double kBlade = 0.9;  ///< from the hand to the tip, along x, m
/// A border of cells is looked at from this many roundings of the stick on either side, so that the
/// cell is surely the one meant.
constexpr int kRoundingsAside = 4;

/// What the hand does over the square of the stick, and how far it turns against the centre.
struct Truth {
  const char* name;
  double turn;  ///< about each of the three axes, rad
};
/// "arm": what an arm does, up to 0.8 rad. "wide": up to 1.7 rad.
constexpr std::array<Truth, 2> kTruths = {{{"arm", 0.5}, {"wide", 1.1}}};

Quat<double> turn_about(int axis, double angle) {
  Vec3<double> half = Vec3<double>::Zero();
  half[axis] = std::sin(angle / 2);
  return {std::cos(angle / 2), half.x(), half.y(), half.z()};
}

/// Turns about three fixed axes one after the other: not what the grid interpolates, which is one
/// rotation vector.
Pose<double> pose_of(const Truth& truth, const Vec2<double>& stick) {
  const double x = stick.x();
  const double y = stick.y();
  Pose<double> pose;
  pose.p_W = {0.7 + 0.4 * std::sin(1.2 * y + 0.3 * x), -0.1 - 0.3 * std::sin(1.4 * x),
              1.1 + 0.1 * std::cos(1.5 * x - 0.8 * y)};
  pose.q_WB = turn_about(2, truth.turn * std::sin(1.1 * x + 0.4 * y)) *
              turn_about(1, truth.turn * std::sin(0.9 * y - 0.5 * x)) *
              turn_about(0, truth.turn * std::sin(0.7 * x + 0.8 * y));
  return pose;
}

/// Keys of a grid of any size: what KeyframeGrid keeps, without its size in the type.
template <class S>
struct Grid {
  int n;
  Quat<S> q_ref;
  std::vector<detail::KeyPoint<S>> points;

  KeyedPose<S> at(const Vec2<S>& stick) const {
    const detail::KeyGridView<S> view{points.front().data(), detail::kKeyNumbers, n, n, q_ref};
    return detail::pose_on(view, stick);
  }
};

template <class S>
Grid<S> sampled(const Truth& truth, int n) {
  std::vector<Pose<S>> keys;
  for (int k = 0; k < n * n; ++k) {
    const Vec2<double> stick(-1 + 2.0 * (k % n) / (n - 1), -1 + 2.0 * (k / n) / (n - 1));
    const Pose<double> pose = pose_of(truth, stick);
    keys.push_back({pose.p_W.cast<S>(), pose.q_WB.cast<S>()});
  }
  const auto centre = static_cast<std::size_t>((n - 1) / 2 * (n + 1));
  Grid<S> grid{n, renewed(keys[centre].q_WB), std::vector<detail::KeyPoint<S>>(keys.size())};
  if (detail::relate_keys(keys.data(), grid.q_ref, grid.points.data(), n * n) != Status::kOk) {
    std::fprintf(stderr, "keyframes: the keys of '%s' are out of range\n", truth.name);
    std::exit(1);
  }
  return grid;
}

/// How far two poses are apart.
struct Difference {
  double place = 0;  ///< of the hand, m
  double turn = 0;   ///< rad
  double tip = 0;    ///< of a blade in the hand, m
};

Difference difference(const Pose<double>& P, const Pose<double>& Q) {
  const Quat<double> turn = P.q_WB.conjugate() * Q.q_WB;
  const Vec3<double> blade(kBlade, 0, 0);
  return {(P.p_W - Q.p_W).norm(), 2 * std::atan2(turn.vec().norm(), std::abs(turn.w())),
          (to_world(P, blade) - to_world(Q, blade)).norm()};
}

template <class S>
Pose<double> in_double(const Pose<S>& pose) {
  return {pose.p_W.template cast<double>(), pose.q_WB.template cast<double>().normalized()};
}

/// What is known of one grid; every member merges by adding or by the larger.
struct Account {
  std::uint64_t samples = 0;
  std::uint64_t borders = 0;
  Histogram place;
  Histogram turn;
  Histogram tip;
  Difference worst;
  Difference jump;
  double rate_jump = 0;  ///< of the velocity of place and turn per unit of stick, m or rad

  void add(const Difference& error) {
    ++samples;
    place.add(error.place);
    turn.add(error.turn);
    tip.add(error.tip);
    larger(worst, error);
  }
  void add_jump(const Difference& across, double rate) {
    ++borders;
    larger(jump, across);
    rate_jump = max_of(rate_jump, rate);
  }
  static void larger(Difference& most, const Difference& other) {
    most.place = max_of(most.place, other.place);
    most.turn = max_of(most.turn, other.turn);
    most.tip = max_of(most.tip, other.tip);
  }
};

template <class S>
Vec2<S> stick_at(std::uint64_t index) {
  test::Draws draws(kSeed, 0, index);
  const double x = draws.signed_unit();
  const double y = draws.signed_unit();
  return Vec2<double>(x, y).cast<S>();
}

/// The sample's stick, moved to both sides of a border of cells.
template <class S>
void look_across(const Grid<S>& grid, std::uint64_t index, Account& account) {
  if (grid.n < 3) return;
  const auto inner = static_cast<std::uint64_t>(grid.n - 2);
  const double border = -1 + 2.0 * static_cast<double>(1 + index % inner) / (grid.n - 1);
  const int along = static_cast<int>(index / inner % 2);
  const S aside = kRoundingsAside * std::numeric_limits<S>::epsilon();
  Vec2<S> before = stick_at<S>(index);
  Vec2<S> after = before;
  before[along] = static_cast<S>(border) - aside;
  after[along] = static_cast<S>(border) + aside;
  const KeyedPose<S> P = grid.at(before);
  const KeyedPose<S> Q = grid.at(after);
  account.add_jump(difference(in_double(P.X_WH), in_double(Q.X_WH)),
                   static_cast<double>((P.jacobian - Q.jacobian).cwiseAbs().maxCoeff()));
}

/// Nanoseconds for all sticks, median of a few rounds.
template <class S>
double time_of(const Grid<S>& grid) {
  constexpr int kSticks = 256;
  std::vector<Vec2<S>> sticks;
  for (std::uint64_t i = 0; i < kSticks; ++i) sticks.push_back(stick_at<S>(i));
  const double all = median_ns(8, [&] {
    for (const Vec2<S>& stick : sticks) {
      const KeyedPose<S> pose = grid.at(stick);
      keep(pose);
    }
  });
  return all / kSticks;
}

template <class S>
void add_row(Table& table, const Truth& truth, int n, Range samples) {
  const Grid<S> grid = sampled<S>(truth, n);
  Account account;
  for (std::uint64_t i = samples.first; i < samples.last; ++i) {
    const Vec2<S> stick = stick_at<S>(i);
    account.add(
        difference(in_double(grid.at(stick).X_WH), pose_of(truth, stick.template cast<double>())));
    look_across(grid, i, account);
  }
  const double ns = time_of(grid);
  table.key("truth", truth.name)
      .key("scalar", std::is_same_v<S, float> ? "float" : "double")
      .key("keys", n)
      .sum("samples", account.samples)
      .hist("place_m", account.place)
      .hist("turn_rad", account.turn)
      .hist("tip_m", account.tip)
      .max("worst_place_m", account.worst.place)
      .max("worst_turn_rad", account.worst.turn)
      .max("worst_tip_m", account.worst.tip)
      .sum("borders", account.borders)
      .max("jump_place_m", account.jump.place)
      .max("jump_turn_rad", account.jump.turn)
      .max("jump_rate", account.rate_jump)
      .min("time_ns", ns)
      .min("time_in_plain", ns / plain_ns());
  table.end_row();
}

}  // namespace

int report_keyframes(const Options& options) {
  const Range samples = share_of(options, pick(options, 200, 10000, 1000000));
  Table table(options, "keyframes");
  Progress progress("keyframes", 2 * kTruths.size() * (kMostKeys - kLeastKeys + 1));
  for (const Truth& truth : kTruths) {
    for (int n = kLeastKeys; n <= kMostKeys; ++n) {
      add_row<float>(table, truth, n, samples);
      add_row<double>(table, truth, n, samples);
      progress.advance(2);
    }
  }
  return table.write();
}

}  // namespace batuta::report
