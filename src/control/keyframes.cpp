// SPDX-License-Identifier: MIT
#include "batuta/control/keyframes.hpp"

#include "batuta/geometry/direction.hpp"

namespace batuta {
namespace {

constexpr int kTaps = 4;  ///< keys that a cubic sees along one coordinate

/// How much each of four neighbouring keys counts along one coordinate, and how fast that changes
/// with the stick.
template <class Scalar>
struct Taps {
  std::array<int, kTaps> index;
  std::array<Scalar, kTaps> weight;
  std::array<Scalar, kTaps> rate;
};

/// The cubic on [0, 1] by its values f0, f1 and slopes m0, m1; factored so that both ends are
/// exact.
template <class Scalar>
struct Hermite {
  Scalar f0;
  Scalar m0;
  Scalar f1;
  Scalar m1;
};

template <class Scalar>
Hermite<Scalar> hermite_value(Scalar u) {
  const Scalar v = Scalar(1) - u;
  return {(Scalar(1) + Scalar(2) * u) * v * v, u * v * v, u * u * (Scalar(3) - Scalar(2) * u),
          -(u * u * v)};
}

template <class Scalar>
Hermite<Scalar> hermite_rate(Scalar u) {
  const Scalar v = Scalar(1) - u;
  return {Scalar(-6) * u * v, v * (Scalar(1) - Scalar(3) * u), Scalar(6) * u * v,
          u * (Scalar(3) * u - Scalar(2))};
}

/// The slopes of a cell in terms of its keys and their neighbours: central inside, that of the
/// parabola through three keys at the rim, the chord where there are only two.
template <class Scalar>
struct Slopes {
  std::array<Scalar, kTaps> m0;
  std::array<Scalar, kTaps> m1;
};

template <class Scalar>
Slopes<Scalar> slopes_of(int cell, int count) {
  const Scalar half = Scalar(0.5);
  const Scalar three_halves = Scalar(1.5);
  if (count == 2) return {{0, -1, 1, 0}, {0, -1, 1, 0}};
  Slopes<Scalar> slopes{{-half, 0, half, 0}, {0, -half, 0, half}};
  if (cell == 0) slopes.m0 = {0, -three_halves, 2, -half};
  if (cell == count - 2) slopes.m1 = {half, -2, three_halves, 0};
  return slopes;
}

template <class Scalar>
std::array<Scalar, kTaps> taps_for(const Hermite<Scalar>& h, const Slopes<Scalar>& slopes,
                                   Scalar scale) {
  const auto sloped = [&](std::size_t k) {
    return scale * (h.m0 * slopes.m0[k] + h.m1 * slopes.m1[k]);
  };
  return {sloped(0), sloped(1) + scale * h.f0, sloped(2) + scale * h.f1, sloped(3)};
}

/// The cell's two keys and their neighbours; at the rim the key there once more.
std::array<int, kTaps> keys_around(int cell, int count) {
  return {max_of(cell - 1, 0), cell, cell + 1, min_of(cell + 2, count - 1)};
}

template <class Scalar>
Taps<Scalar> taps_at(Scalar stick, int count) {
  const Scalar cells_per_unit = static_cast<Scalar>(count - 1) / Scalar(2);
  const Scalar inside = clamp(stick, Scalar(-1), Scalar(1));
  const Scalar place = (inside + Scalar(1)) * cells_per_unit;
  const int cell = min_of(static_cast<int>(place), count - 2);
  const Scalar u = min_of(place - static_cast<Scalar>(cell), Scalar(1));

  const Slopes<Scalar> slopes = slopes_of<Scalar>(cell, count);
  const Scalar rate = inside == stick ? cells_per_unit : Scalar(0);
  return {keys_around(cell, count), taps_for(hermite_value(u), slopes, Scalar(1)),
          taps_for(hermite_rate(u), slopes, rate)};
}

/// The numbers of the key in a column and a row.
template <class Scalar>
const Scalar* key_at(const detail::KeyGridView<Scalar>& grid, int column, int row) {
  return grid.numbers + grid.stride * (column + grid.columns * row);
}

}  // namespace

template <class Scalar>
Twist<Scalar> hand_twist(const StickJacobian<Scalar>& jacobian, const Vec2<Scalar>& stick_rate) {
  const detail::KeyPoint<Scalar> rate = jacobian * stick_rate;
  return {rate.template head<3>(), rate.template tail<3>()};
}

template <class Scalar>
Status detail::relate_keys(const Pose<Scalar>* poses, const Quat<Scalar>& q_ref,
                           detail::KeyPoint<Scalar>* points, int count) {
  for (int i = 0; i < count; ++i) {  // Bound: `count` keys
    const Pose<Scalar>& key = poses[i];
    // Of length zero it is no rotation, and renewed() would take it for the one that turns nothing.
    if (!is_finite(key.p_W) || !detail::points(key.q_WB)) return Status::kInvalidArgument;
    if (detail::largest_component(key.p_W) > kLargestCoordinate<Scalar>)
      return Status::kInvalidArgument;
    const Vec3<Scalar> turn = log_map<Scalar>(q_ref.conjugate() * renewed(key.q_WB));
    if (!(turn.norm() <= detail::kMaxKeyTurn<Scalar>)) return Status::kInvalidArgument;
    points[i] << key.p_W, turn;
  }
  return Status::kOk;
}

template <class Scalar>
detail::KeySurface<Scalar> detail::surface_on(const detail::KeyGridView<Scalar>& grid,
                                              const Vec2<Scalar>& stick, int number) {
  BATUTA_ASSERT(is_finite(stick) && grid.columns >= 2 && grid.rows >= 2);
  BATUTA_ASSERT(number >= 0 && number < grid.stride);
  const Taps<Scalar> x = taps_at(stick.x(), grid.columns);
  const Taps<Scalar> y = taps_at(stick.y(), grid.rows);
  detail::KeySurface<Scalar> surface;
  for (std::size_t j = 0; j < y.index.size(); ++j) {  // Bound: kTaps
    detail::KeyPoint<Scalar> row = detail::KeyPoint<Scalar>::Zero();
    detail::KeyPoint<Scalar> row_rate = detail::KeyPoint<Scalar>::Zero();
    Scalar row_number = 0;
    for (std::size_t i = 0; i < x.index.size(); ++i) {  // Bound: kTaps
      const Scalar* numbers = key_at(grid, x.index[i], y.index[j]);
      const Eigen::Map<const detail::KeyPoint<Scalar>> key(numbers);
      row += x.weight[i] * key;
      row_rate += x.rate[i] * key;
      row_number += x.weight[i] * numbers[number];
    }
    surface.value += y.weight[j] * row;
    surface.rate.col(0) += y.weight[j] * row_rate;
    surface.rate.col(1) += y.rate[j] * row;
    surface.number += y.weight[j] * row_number;
  }
  return surface;
}

template <class Scalar>
KeyedPose<Scalar> detail::pose_of(const detail::KeySurface<Scalar>& surface,
                                  const Quat<Scalar>& q_ref) {
  const Vec3<Scalar> turn = surface.value.template tail<3>();

  KeyedPose<Scalar> result;
  result.X_WH.p_W = surface.value.template head<3>();
  result.X_WH.q_WB = detail::composed(q_ref, exp_map(turn));
  result.jacobian.template topRows<3>() = surface.rate.template topRows<3>();
  result.jacobian.template bottomRows<3>() = detail::to_matrix(q_ref) *
                                             detail::left_jacobian(turn) *
                                             surface.rate.template bottomRows<3>();
  return result;
}

template <class Scalar>
KeyedPose<Scalar> detail::pose_on(const detail::KeyGridView<Scalar>& grid,
                                  const Vec2<Scalar>& stick) {
  return detail::pose_of(detail::surface_on(grid, stick, 0), grid.q_ref);
}

#define BATUTA_INSTANTIATE(S)                                                                      \
  template Twist<S> hand_twist(const StickJacobian<S>&, const Vec2<S>&);                           \
  template Status detail::relate_keys(const Pose<S>*, const Quat<S>&, detail::KeyPoint<S>*, int);  \
  template detail::KeySurface<S> detail::surface_on(const detail::KeyGridView<S>&, const Vec2<S>&, \
                                                    int);                                          \
  template KeyedPose<S> detail::pose_of(const detail::KeySurface<S>&, const Quat<S>&);             \
  template KeyedPose<S> detail::pose_on(const detail::KeyGridView<S>&, const Vec2<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
