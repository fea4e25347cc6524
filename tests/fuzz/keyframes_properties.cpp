// SPDX-License-Identifier: MIT
// What must hold of the grid of key poses for any keys and any stick, as a libFuzzer target: keys
// that cannot be used change nothing, and the surface through the others is continuous with its
// derivative across the borders of its cells. Bounds: src/control/keyframes.md, "Error".

#include <algorithm>
#include <optional>

#include "batuta/control/keyframes.hpp"
#include "bytes.hpp"

namespace batuta::fuzz {
namespace {

/// |weights| sum up to 1.25 along a coordinate, and what is summed errs by 18 u of the largest key.
constexpr double kSurface = 18 * kU;
/// The largest |second derivative| of a cubic's cardinal weights, summed, over a cell: its slopes
/// are differences of keys, at most (3/2 + 2 + 1/2) at a rim, and the Hermite basis has 6 for
/// values, 4 and 2 for slopes: 12 + 6 * 4.
constexpr double kBend = 36;
/// The same of the third derivative, which the Hermite basis has 12 of for values, 6 for slopes.
constexpr double kJerk = 2 * 12 + 2 * 6 * 4;

template <int M, int N>
using Grid = KeyframeGrid<float, M, N>;

/// Turned by up to about 3 rad either way, so that some keys are refused.
Pose<float> draw_key(Bytes& bytes, Numbers from) {
  Pose<float> key;
  key.p_W = bytes.vector(from);
  if (from == Numbers::kAny) {
    key.q_WB.coeffs() << bytes.bits(), bytes.bits(), bytes.bits(), bytes.bits();
  } else {
    key.q_WB = bytes.turn();
  }
  return key;
}

template <int M, int N>
typename Grid<M, N>::Keys draw_keys(Bytes& bytes, Numbers from) {
  typename Grid<M, N>::Keys keys;
  for (Pose<float>& key : keys) key = draw_key(bytes, from);
  return keys;
}

double distance(const Quat<float>& a, const Quat<float>& b) {
  const Eigen::Vector4d x = a.coeffs().cast<double>();
  const Eigen::Vector4d y = b.coeffs().cast<double>();
  return std::min((x - y).norm(), (x + y).norm());
}

template <int M, int N>
double largest_key(const typename Grid<M, N>::Keys& keys) {
  double largest = 0;
  for (const Pose<float>& key : keys) largest = std::max(largest, key.p_W.cast<double>().norm());
  return largest;
}

/// At the keys' places the pose is theirs: q_ref exp(log(q_ref^-1 q)) errs by the 12 u of the
/// logarithm of at most 3 rad, (4 + 1.25 |phi|) u of the exponential, products and renewals.
template <int M, int N>
void check_keys(const Grid<M, N>& grid, const typename Grid<M, N>::Keys& keys) {
  const double place_slack = kSurface * largest_key<M, N>(keys);
  for (int k = 0; k < M * N; ++k) {
    const float x = -1 + 2 * static_cast<float>(k % M) / static_cast<float>(M - 1);
    const float y = -1 + 2 * static_cast<float>(k / M) / static_cast<float>(N - 1);
    const KeyedPose<float> at = grid.at({x, y});
    const Pose<float>& key = keys[static_cast<std::size_t>(k)];
    // A place between the numbers is off by u of a cell, times the steepest slope.
    const double off = 4 * kU * static_cast<double>(std::max(M, N)) * largest_key<M, N>(keys);
    require((at.X_WH.p_W - key.p_W).cast<double>().norm() <= place_slack + off, "through each key");
    require(
        distance(at.X_WH.q_WB, renewed(key.q_WB)) <= (64 + 18 * 3 + 4 * std::max(M, N) * 3) * kU,
        "turned as each key");
  }
}

/// Two places a hair apart: poses and Jacobians differ by no more than the derivative allows.
template <int M, int N>
void check_continuous(const Grid<M, N>& grid, const Vec2<float>& s, const Vec2<float>& t,
                      double largest) {
  const KeyedPose<float> one = grid.at(s);
  const KeyedPose<float> other = grid.at(t);
  const double cells = 0.5 * (std::max(M, N) - 1);
  const double apart = (s - t).cast<double>().norm();
  const double steep = 1.25 * 1.25 * 2 * 4 * cells * largest;  // of places, m per unit of stick
  const double moved = (one.X_WH.p_W - other.X_WH.p_W).cast<double>().norm();
  require(moved <= steep * apart + 2 * kSurface * largest, "places are continuous");
  const double bend = 1.25 * kBend * 4 * cells * cells * largest;
  const double bent = (one.jacobian - other.jacobian).topRows<3>().cast<double>().norm();
  require(bent <= bend * apart + 64 * kU * 8 * cells * largest, "and so are their rates");
}

constexpr float kStep = 0x1p-7F;

/// Two places a step to both sides along a coordinate.
struct Around {
  Vec2<float> low;
  Vec2<float> high;
};

/// None where they are not in one cell.
std::optional<Around> around_in_cell(const Vec2<float>& s, int axis, double cells) {
  const auto cell_of = [cells](float x) {
    return std::floor((static_cast<double>(x) + 1) * cells);
  };
  Around around = {s, s};
  around.low[axis] -= kStep;
  around.high[axis] += kStep;
  const float low = around.low[axis];
  const float high = around.high[axis];
  if (low < -1 || high >= 1 || cell_of(low) != cell_of(high)) return std::nullopt;
  return around;
}

/// How far the slope over both steps may be from the one in the middle.
double bent_by(double cells, double largest) {
  const double h = kStep;
  return 1.25 * kJerk * cells * cells * cells * largest * h * h / 6;
}

/// The Jacobian's upper half is the slope of the places.
template <int M, int N>
void check_slope(const Grid<M, N>& grid, const Vec2<float>& s, int axis, double largest) {
  const double cells = 0.5 * ((axis == 0 ? M : N) - 1);
  const std::optional<Around> around = around_in_cell(s, axis, cells);
  if (!around) return;
  const double h = kStep;
  const Eigen::Vector3d difference = grid.at(around->high).X_WH.p_W.template cast<double>() -
                                     grid.at(around->low).X_WH.p_W.template cast<double>();
  const Eigen::Vector3d slope =
      grid.at(s).jacobian.col(axis).template head<3>().template cast<double>();
  const double rounded = 2 * kSurface * largest / h + 64 * kU * 8 * cells * largest;
  require((difference / (2 * h) - slope).norm() <= bent_by(cells, largest) + rounded,
          "rates are those of the places");
}

template <int M, int N>
void check_surface(const Grid<M, N>& grid, const typename Grid<M, N>::Keys& keys, Bytes& bytes) {
  const double largest = largest_key<M, N>(keys);
  const auto column = static_cast<float>(bytes.choice(M));
  const float border = -1 + 2 * column / static_cast<float>(M - 1);
  const float y = clamp(bytes.grid() / 4, -1.5F, 1.5F);
  const float before = std::nextafter(border, -2.0F);
  const float after = std::nextafter(border, 2.0F);
  if (before >= -1 && after <= 1) check_continuous<M, N>(grid, {before, y}, {after, y}, largest);
  const auto row = static_cast<float>(bytes.choice(N));
  const float line = -1 + 2 * row / static_cast<float>(N - 1);
  const float below = std::nextafter(line, -2.0F);
  const float above = std::nextafter(line, 2.0F);
  if (below >= -1 && above <= 1) check_continuous<M, N>(grid, {y, below}, {y, above}, largest);
  const float x = bytes.grid() / kGridEnd;
  for (int axis = 0; axis < 2; ++axis) {
    check_slope<M, N>(grid, {x, bytes.grid() / kGridEnd}, axis, largest);
  }
  const KeyedPose<float> beyond = grid.at({1 + std::abs(bytes.grid()) + kGridStep, y});
  const KeyedPose<float> rim = grid.at({1, y});
  require(beyond.X_WH.p_W == rim.X_WH.p_W && beyond.X_WH.q_WB.coeffs() == rim.X_WH.q_WB.coeffs(),
          "the rim goes on");
  require(beyond.jacobian.col(0).isZero(0), "and stands still");
  require(is_finite(rim.jacobian) && is_finite(rim.X_WH.q_WB), "in numbers");
  require(std::abs(rim.X_WH.q_WB.coeffs().cast<double>().norm() - 1) <= 4 * kU, "unit");
}

/// Keys on a parabola in x and a line in y: the surface is that, to the rounding of its sum. Two
/// keys in a row tell of a line only.
template <int M, int N>
void check_parabola(Bytes& bytes) {
  const Vec3<float> start = bytes.vector(Numbers::kGrid);
  const Vec3<float> slope_x = bytes.vector(Numbers::kGrid);
  const Vec3<float> slope_y = bytes.vector(Numbers::kGrid);
  const Vec3<float> bend = M > 2 ? bytes.vector(Numbers::kGrid) : Vec3<float>(0, 0, 0);
  const auto place = [&](double x, double y) -> Eigen::Vector3d {
    return start.cast<double>() + x * slope_x.cast<double>() + y * slope_y.cast<double>() +
           x * x * bend.cast<double>();
  };
  typename Grid<M, N>::Keys keys;
  for (int k = 0; k < M * N; ++k) {
    const double x = 2.0 * (k % M) / (M - 1) - 1;
    const double y = 2.0 * (k / M) / (N - 1) - 1;
    keys[static_cast<std::size_t>(k)].p_W = place(x, y).template cast<float>();
  }
  Grid<M, N> grid;
  require(grid.set_keys(keys) == Status::kOk, "upright keys will do");
  const Vec2<float> stick(bytes.grid() / kGridEnd, bytes.grid() / kGridEnd);
  const Eigen::Vector3d wanted =
      place(static_cast<double>(stick.x()), static_cast<double>(stick.y()));
  const Eigen::Vector3d found = grid.at(stick).X_WH.p_W.template cast<double>();
  // Of three components; and the keys themselves are rounded: u more, times the sum of the weights.
  const double slack = 2 * (kSurface + 2 * kU) * largest_key<M, N>(keys);
  require((found - wanted).norm() <= slack, "a parabola through its keys");
}

/// Keys that turn about one axis by up to 1 rad: then the Jacobian's lower half is the axis, times
/// the slope of the angle. The turn of a pose errs by twice what check_keys() allows a quaternion.
template <int M, int N>
void check_turn_rates(Bytes& bytes) {
  const Vec3<float> along = bytes.vector(Numbers::kGrid);
  const Eigen::Vector3d axis =
      along.isZero(0) ? Eigen::Vector3d::UnitZ() : along.cast<double>().normalized().eval();
  typename Grid<M, N>::Keys keys;
  for (Pose<float>& key : keys) {
    const double half = static_cast<double>(bytes.share()) / 2;
    key.q_WB.w() = static_cast<float>(std::cos(half));
    key.q_WB.vec() = (std::sin(half) * axis).template cast<float>();
  }
  Grid<M, N> grid;
  require(grid.set_keys(keys) == Status::kOk, "keys near each other will do");
  const Vec2<float> s(bytes.grid() / kGridEnd, bytes.grid() / kGridEnd);
  for (int i = 0; i < 2; ++i) {
    const double cells = 0.5 * ((i == 0 ? M : N) - 1);
    const std::optional<Around> around = around_in_cell(s, i, cells);
    if (!around) continue;
    const Eigen::Quaterniond turn =
        grid.at(around->high).X_WH.q_WB.template cast<double>() *
        grid.at(around->low).X_WH.q_WB.template cast<double>().conjugate();
    const double angle = 2 * std::atan2(turn.vec().dot(axis), turn.w());
    const Eigen::Vector3d rate =
        grid.at(s).jacobian.col(i).template tail<3>().template cast<double>();
    const double h = kStep;
    const double rounded = 2 * (64 + 18 * 3) * kU / h + 64 * kU * 8 * cells;
    require((angle / (2 * h) * axis - rate).norm() <= bent_by(cells, 1) + rounded,
            "rates are those of the turns");
  }
}

template <int M, int N>
void check_grid(Bytes& bytes, Numbers from) {
  Grid<M, N> grid;
  typename Grid<M, N>::Keys upright;
  upright.fill({{1, 2, 3}, Quat<float>::Identity()});
  require(grid.set_keys(upright) == Status::kOk, "one pose for all keys will do");
  const typename Grid<M, N>::Keys keys = draw_keys<M, N>(bytes, from);
  if (grid.set_keys(keys) != Status::kOk) {
    const KeyedPose<float> at = grid.at({-1, -1});
    require(at.X_WH.p_W == upright[0].p_W && at.X_WH.q_WB.coeffs() == upright[0].q_WB.coeffs(),
            "keys that are refused change nothing");
    return;
  }
  require(std::all_of(keys.begin(), keys.end(),
                      [](const Pose<float>& key) { return is_finite(key.p_W); }),
          "keys that are taken are numbers");
  // A sum of three keys may overflow where each is a number: then there is nothing to weigh.
  if (from == Numbers::kAny) return void(grid.at({bytes.share(), bytes.share()}));
  check_keys<M, N>(grid, keys);
  check_surface<M, N>(grid, keys, bytes);
  check_parabola<M, N>(bytes);
  check_turn_rates<M, N>(bytes);
}

void check(Bytes bytes) {
  const Numbers from = bytes.numbers();
  switch (bytes.choice(3)) {
    case 0:
      return check_grid<2, 2>(bytes, from);
    case 1:
      return check_grid<3, 3>(bytes, from);
    default:
      return check_grid<5, 4>(bytes, from);
  }
}

}  // namespace
}  // namespace batuta::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  batuta::fuzz::check({data, size});
  return 0;
}
