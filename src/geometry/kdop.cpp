// SPDX-License-Identifier: MIT
#include "batuta/geometry/kdop.hpp"

namespace batuta {
namespace {

/// In units of u: what a computed extent may fall short of the true one, relative to the sum of the
/// absolute values in it (kdop.md), and a little for the terms of second order.
template <class Scalar>
constexpr Scalar kOutward = Scalar(3.25) * kRoundOff<Scalar>;

/// The same where the radius is a sum.
template <class Scalar>
constexpr Scalar kOutwardOfSum = Scalar(4.25) * kRoundOff<Scalar>;

constexpr std::size_t kAxes = 3;
constexpr std::size_t kCubeDiagonals = 4;
constexpr std::size_t kEdgeDiagonals = 6;

struct Direction {
  std::int8_t x, y, z;
};

constexpr std::array<Direction, kAxes + kCubeDiagonals + kEdgeDiagonals> kDirectionTable = {{
    {1, 0, 0},
    {0, 1, 0},
    {0, 0, 1},  // axes
    {1, 1, 1},
    {1, 1, -1},
    {1, -1, 1},
    {1, -1, -1},  // cube diagonals
    {1, 1, 0},
    {1, -1, 0},
    {1, 0, 1},
    {1, 0, -1},
    {0, 1, 1},  // edge diagonals
    {0, 1, -1},
}};

/// 14 takes the axes and the cube diagonals, 18 the axes and the edge diagonals.
template <int K>
constexpr std::size_t table_index(std::size_t i) {
  return K == 18 && i >= kAxes ? i + kCubeDiagonals : i;
}

/// Length of the i-th direction, rounded up: 1, sqrt(2) or sqrt(3).
template <class Scalar, int K>
constexpr Scalar direction_length(std::size_t i) {
  constexpr Scalar kRoundUp = 1 + 2 * kRoundOff<Scalar>;
  const std::size_t j = table_index<K>(i);
  if (j < kAxes) return 1;
  if (j < kAxes + kCubeDiagonals) return Scalar(1.73205080756887729353) * kRoundUp;
  return Scalar(1.41421356237309504880) * kRoundUp;
}

template <class Scalar, int K>
Vec3<Scalar> direction(std::size_t i) {
  const Direction d = kDirectionTable[table_index<K>(i)];
  return {Scalar(d.x), Scalar(d.y), Scalar(d.z)};
}

/// Lowest and highest point along a direction.
template <class Scalar>
struct Extent {
  Scalar low;
  Scalar high;
};

template <class Scalar>
[[gnu::always_inline]] inline Extent<Scalar> extent_of(Scalar a, Scalar b) {
  return b < a ? Extent<Scalar>{b, a} : Extent<Scalar>{a, b};
}

/// Of both ends of an axis along the i-th direction; along an axis of the frame it is a component.
template <class Scalar, int K>
[[gnu::always_inline]] inline Extent<Scalar> extent_along(std::size_t i,
                                                          const Segment<Scalar>& axis) {
  const auto k = static_cast<Eigen::Index>(i);
  if (K == 6 || i < kAxes) return extent_of(axis.a[k], axis.b[k]);
  const Vec3<Scalar> d = direction<Scalar, K>(i);
  return extent_of(d.dot(axis.a), d.dot(axis.b));
}

/// What the terms of a height along the i-th direction come to at most, of a point between the ends
/// of these axes. @param along  their extent
template <class Scalar, int K>
[[gnu::always_inline]] inline Scalar terms(std::size_t i, const Segment<Scalar>& P,
                                           const Segment<Scalar>& Q, const Extent<Scalar>& along) {
  if (K == 6 || i < kAxes) return max_of(std::abs(along.low), std::abs(along.high));
  const auto largest = [](const Segment<Scalar>& axis) {
    return Vec3<Scalar>(axis.a.cwiseAbs().cwiseMax(axis.b.cwiseAbs()));
  };
  return direction<Scalar, K>(i).cwiseAbs().dot(largest(P).cwiseMax(largest(Q)));
}

}  // namespace

template <class Scalar, int K>
Vec3<Scalar> detail::kdop_direction(int i) {
  BATUTA_ASSERT(i >= 0 && i < K / 2);
  return direction<Scalar, K>(static_cast<std::size_t>(i));
}

template <class Scalar, int K>
Kdop<Scalar, K> detail::kdop_of(const Capsule<Scalar>& capsule) {
  return detail::kdop_of<Scalar, K>(capsule.axis, capsule.axis, capsule.radius);
}

template <class Scalar, int K>
Kdop<Scalar, K> detail::kdop_of(const Segment<Scalar>& P, const Segment<Scalar>& Q, Scalar radius) {
  Kdop<Scalar, K> result;
  for (std::size_t i = 0; i < result.low.size(); ++i) {  // Bound: K / 2
    const Extent<Scalar> along_P = extent_along<Scalar, K>(i, P);
    const Extent<Scalar> along_Q = extent_along<Scalar, K>(i, Q);
    const Extent<Scalar> along = {min_of(along_P.low, along_Q.low),
                                  max_of(along_P.high, along_Q.high)};
    const Scalar wide = radius * direction_length<Scalar, K>(i);
    const Scalar reach = wide + kOutwardOfSum<Scalar> * (wide + terms<Scalar, K>(i, P, Q, along));
    result.low[i] = along.low - reach;
    result.high[i] = along.high + reach;
  }
  return result;
}

template <class Scalar, int K>
Kdop<Scalar, K> merge(const Kdop<Scalar, K>& P, const Kdop<Scalar, K>& Q) {
  Kdop<Scalar, K> result;
  for (std::size_t i = 0; i < result.low.size(); ++i) {  // Bound: K / 2
    result.low[i] = min_of(P.low[i], Q.low[i]);
    result.high[i] = max_of(P.high[i], Q.high[i]);
  }
  return result;
}

template <class Scalar, int K>
bool overlaps(const Kdop<Scalar, K>& P, const Kdop<Scalar, K>& Q) {
  for (std::size_t i = 0; i < P.low.size(); ++i) {  // Bound: K / 2
    if (P.high[i] < Q.low[i] || Q.high[i] < P.low[i]) return false;
  }
  return true;
}

template <class Scalar, int K>
bool contains(const Kdop<Scalar, K>& P, const Vec3<Scalar>& point) {
  for (std::size_t i = 0; i < P.low.size(); ++i) {  // Bound: K / 2
    const Scalar x = direction<Scalar, K>(i).dot(point);
    if (!(P.low[i] <= x && x <= P.high[i])) return false;
  }
  return true;
}

template <class Scalar, int K>
Kdop<Scalar, K> inflated(const Kdop<Scalar, K>& P, Scalar margin) {
  BATUTA_ASSERT(margin >= 0);
  Kdop<Scalar, K> result = P;
  for (std::size_t i = 0; i < P.low.size(); ++i) {  // Bound: K / 2
    if (P.high[i] < P.low[i]) continue;             // empty stays empty
    const Scalar move = margin * direction_length<Scalar, K>(i);
    result.low[i] -= move + kOutward<Scalar> * (move + std::abs(P.low[i]));
    result.high[i] += move + kOutward<Scalar> * (move + std::abs(P.high[i]));
  }
  return result;
}

#define BATUTA_INSTANTIATE(Scalar, K)                                                  \
  template Vec3<Scalar> detail::kdop_direction<Scalar, K>(int);                        \
  template Kdop<Scalar, K> detail::kdop_of<Scalar, K>(const Capsule<Scalar>&);         \
  template Kdop<Scalar, K> detail::kdop_of<Scalar, K>(const Segment<Scalar>&,          \
                                                      const Segment<Scalar>&, Scalar); \
  template Kdop<Scalar, K> merge(const Kdop<Scalar, K>&, const Kdop<Scalar, K>&);      \
  template bool overlaps(const Kdop<Scalar, K>&, const Kdop<Scalar, K>&);              \
  template bool contains(const Kdop<Scalar, K>&, const Vec3<Scalar>&);                 \
  template Kdop<Scalar, K> inflated(const Kdop<Scalar, K>&, Scalar);
#define BATUTA_INSTANTIATE_ALL(Scalar) \
  BATUTA_INSTANTIATE(Scalar, 6)        \
  BATUTA_INSTANTIATE(Scalar, 14)       \
  BATUTA_INSTANTIATE(Scalar, 18)       \
  BATUTA_INSTANTIATE(Scalar, 26)

BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE_ALL)
#undef BATUTA_INSTANTIATE_ALL
#undef BATUTA_INSTANTIATE

}  // namespace batuta
