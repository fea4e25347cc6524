// SPDX-License-Identifier: MIT
#pragma once
// The map from the stick's two coordinates to the hand's six [Kavan §5, Fig. 5]: key poses on a
// grid over the square [-1, 1]^2, and a continuously differentiable surface through them. Frames:
// W, or any other in which the keys are given; H the hand. Mathematics: src/control/keyframes.md.

#include <array>

#include "batuta/mechanics/body.hpp"

namespace batuta {

namespace detail {

/// Largest turn of a key against the central key, rad. At pi the shortest way from one to the other
/// is not unique; a grid that comes close to it would turn the hand through an arbitrary side.
template <class Scalar>
inline constexpr Scalar kMaxKeyTurn = Scalar(3);

}  // namespace detail

/// Rows 0-2: velocity of H's origin, m; rows 3-5: angular velocity, rad; each per unit rate of the
/// stick, axes of W.
template <class Scalar>
using StickJacobian = Eigen::Matrix<Scalar, 6, 2>;

/// A hand pose on the surface of the keys, and how it changes with the stick.
template <class Scalar>
struct KeyedPose {
  Pose<Scalar> X_WH;  ///< of the hand
  /// Zero along a coordinate that is beyond the rim, where the pose does not change any more.
  StickJacobian<Scalar> jacobian = StickJacobian<Scalar>::Zero();
};

/// The velocity of the hand for a velocity of the stick (1/s).
template <class Scalar>
Twist<Scalar> hand_twist(const StickJacobian<Scalar>& jacobian, const Vec2<Scalar>& stick_rate);

namespace detail {

/// A key as the surface wants it: rows 0-2 the place in W, m; rows 3-5 the turn log(q_ref^-1 q),
/// rad.
template <class Scalar>
using KeyPoint = Eigen::Matrix<Scalar, 6, 1>;

/// How many numbers a KeyPoint has.
inline constexpr int kKeyNumbers = 6;

/// A grid of any size: what the kernels work on. Keys row by row: index = column + columns * row;
/// column 0 is x = -1 (left), row 0 is y = -1 (back).
template <class Scalar>
struct KeyGridView {
  /// Of columns * rows keys, `stride` for each; the first six of them are its KeyPoint.
  const Scalar* numbers = nullptr;
  int stride = kKeyNumbers;  ///< from one key to the next, >= kKeyNumbers
  int columns = 0;           ///< >= 2
  int rows = 0;              ///< >= 2
  /// rotation of the central key: turns are measured from it
  Quat<Scalar> q_ref = Quat<Scalar>::Identity();
};

/// Turns key poses into points relative to the central one.
/// @returns kOk | kInvalidArgument (a key is not finite, beyond kLargestCoordinate, has a
/// quaternion of length zero, or is turned by more than kMaxKeyTurn against the central key);
/// `points` may then be partly written
/// Bound: `count` keys.
template <class Scalar>
Status relate_keys(const Pose<Scalar>* poses, const Quat<Scalar>& q_ref, KeyPoint<Scalar>* points,
                   int count);

/// The surface at one stick position.
template <class Scalar>
struct KeySurface {
  KeyPoint<Scalar> value = KeyPoint<Scalar>::Zero();
  StickJacobian<Scalar> rate = StickJacobian<Scalar>::Zero();  ///< its two partial derivatives
  Scalar number = 0;  ///< of one more number of the keys, on the same surface
};

/// The surface through the KeyPoints, and through one number of the keys, by its index in a key;
/// clamped at the rim.
/// @pre stick finite; the grid has at least 2 x 2 keys; 0 <= number < stride
/// Bound: 16 keys are looked at, whatever the size of the grid.
template <class Scalar>
KeySurface<Scalar> surface_on(const KeyGridView<Scalar>& grid, const Vec2<Scalar>& stick,
                              int number);

/// The pose that a place of the surface means, and its Jacobian.
/// @param q_ref  the rotation from which turns are measured
template <class Scalar>
KeyedPose<Scalar> pose_of(const KeySurface<Scalar>& surface, const Quat<Scalar>& q_ref);

/// Pose and Jacobian at a stick position; clamped at the rim.
/// @pre stick finite; the grid has at least 2 x 2 keys
/// Bound: 16 keys are looked at, whatever the size of the grid.
template <class Scalar>
KeyedPose<Scalar> pose_on(const KeyGridView<Scalar>& grid, const Vec2<Scalar>& stick);

}  // namespace detail

/// M columns and N rows of keys, evenly spaced over the square. C1 everywhere; passes through every
/// key; three keys in a row give the parabola through them. RAM: 24 M N + 24 bytes in float.
template <class Scalar, int M, int N>
class KeyframeGrid {
  static_assert(M >= 2 && N >= 2, "KeyframeGrid: at least 2 x 2 keys");

 public:
  /// All keys at the origin, unturned: at() has an answer before there are keys.
  KeyframeGrid() { points_.fill(detail::KeyPoint<Scalar>::Zero()); }

  static constexpr int kColumns = M;  ///< M
  static constexpr int kRows = N;     ///< N
  /// M N
  static constexpr std::size_t kKeys = static_cast<std::size_t>(M) * static_cast<std::size_t>(N);
  /// Hand poses, row by row from the back, left to right.
  using Keys = std::array<Pose<Scalar>, kKeys>;

  /// @returns kOk | kInvalidArgument (see relate_keys(); the grid stays as it was)
  [[gnu::noinline]] Status set_keys(const Keys& keys_WH) {
    const Quat<Scalar> q_ref = renewed(keys_WH[kCentre].q_WB);
    std::array<detail::KeyPoint<Scalar>, kKeys> points{};
    const Status status =
        detail::relate_keys(keys_WH.data(), q_ref, points.data(), static_cast<int>(kKeys));
    if (status != Status::kOk) return status;
    points_ = points;
    q_ref_ = q_ref;
    return Status::kOk;
  }

  /// @pre stick finite
  KeyedPose<Scalar> at(const Vec2<Scalar>& stick) const {
    const detail::KeyGridView<Scalar> grid{points_[0].data(), detail::kKeyNumbers, M, N, q_ref_};
    return detail::pose_on(grid, stick);
  }

  /// Its state, for record/archive.hpp.
  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    auto& [points, q_ref] = *this;
    ar(points, q_ref);
  }

 private:
  static constexpr std::size_t kCentre =
      static_cast<std::size_t>((M - 1) / 2) +
      static_cast<std::size_t>(M) * static_cast<std::size_t>((N - 1) / 2);

  std::array<detail::KeyPoint<Scalar>, kKeys> points_;
  Quat<Scalar> q_ref_ = Quat<Scalar>::Identity();
};

}  // namespace batuta
