// SPDX-License-Identifier: MIT
#pragma once
// Discrete orientation polytopes [Kavan §5, refs 10 and 16]: the intersection of k half-spaces with
// fixed normals, in opposite pairs. k = 6 is the axis-aligned box. Frame: any, the same for all
// arguments; unit m. Directions have integer components (unnormalised): 3 axes, 4 cube diagonals, 6
// edge diagonals.

#include <array>

#include "batuta/geometry/capsule.hpp"

namespace batuta {

/// Half-width pairs along the K/2 directions kdop_direction<Scalar, K>(i).
/// @tparam K  6, 14, 18 or 26
template <class Scalar, int K>
struct Kdop {
  static_assert(K == 6 || K == 14 || K == 18 || K == 26, "Kdop: choose k = 6, 14, 18 or 26");
  static constexpr int kDirections = K / 2;  ///< K / 2

  /// Empty: low > high along every direction; merging with it changes nothing.
  std::array<Scalar, kDirections> low = filled(std::numeric_limits<Scalar>::max());
  /// in the order of kdop_direction()
  std::array<Scalar, kDirections> high = filled(std::numeric_limits<Scalar>::lowest());

 private:
  static constexpr std::array<Scalar, kDirections> filled(Scalar x) {
    std::array<Scalar, kDirections> values{};
    for (int i = 0; i < kDirections; ++i) {  // Bound: K / 2
      values[static_cast<std::size_t>(i)] = x;
    }
    return values;
  }
};

/// A box along the axes of the frame.
template <class Scalar>
using Aabb = Kdop<Scalar, 6>;

namespace detail {

/// The i-th direction, integer components in {-1, 0, 1}.
/// @pre 0 <= i < K / 2
template <class Scalar, int K>
Vec3<Scalar> kdop_direction(int i);

/// The tightest Kdop of a capsule, rounded outward so that it holds every point of it.
/// Bound: K / 2 directions.
template <class Scalar, int K>
Kdop<Scalar, K> kdop_of(const Capsule<Scalar>& capsule);

/// The tightest Kdop of the capsules of one radius about P, Q, and all that is between them;
/// rounded outward. @param radius  m, >= 0; may itself be a sum that was rounded once Bound: K / 2
/// directions.
template <class Scalar, int K>
Kdop<Scalar, K> kdop_of(const Segment<Scalar>& P, const Segment<Scalar>& Q, Scalar radius);

}  // namespace detail

/// The smallest Kdop that holds both.
template <class Scalar, int K>
Kdop<Scalar, K> merge(const Kdop<Scalar, K>& P, const Kdop<Scalar, K>& Q);

/// True where no direction separates the two; touching counts. False may be trusted, true is a
/// maybe.
template <class Scalar, int K>
bool overlaps(const Kdop<Scalar, K>& P, const Kdop<Scalar, K>& Q);

/// Whether a point is in it; on the faces counts. False for a point that is not finite.
template <class Scalar, int K>
bool contains(const Kdop<Scalar, K>& P, const Vec3<Scalar>& point);

/// Every face moved outward by `margin` metres (scaled by the direction's length).
/// @pre margin >= 0
template <class Scalar, int K>
Kdop<Scalar, K> inflated(const Kdop<Scalar, K>& P, Scalar margin);

}  // namespace batuta
