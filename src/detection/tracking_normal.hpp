// SPDX-License-Identifier: MIT
#pragma once
// The normal of a pair at one instant, and how it moves: so that it stays perpendicular to the
// edges that are closest, to second order. Any choice is safe; this one makes long steps.
// Derivation: advancement.md, "Which normal".

#include "certificate.hpp"

namespace batuta {

/// Added to the determinant of the edge-edge equations, over the squares of both edges. It only
/// keeps them solvable: from 1e-4 on it would cost the second order where edges are nearly parallel
/// (algorithms: case T19b).
template <class Scalar>
inline constexpr Scalar kDamping = 16 * kRoundOff<Scalar>;

/// A normal that moves faster than this, per duration, is not followed: its powers might overflow,
/// and a fixed one proves as much.
template <class Scalar>
inline constexpr Scalar kFastest = Scalar(16777216);

/// The vector along an axis and its derivatives.
template <class Scalar>
struct Edge {
  Vec3<Scalar> d;
  Vec3<Scalar> d1;
  Vec3<Scalar> d2;
  Scalar square = 0;  ///< |d|^2

  explicit Edge(const AxisExpansion<Scalar>& axis)
      : d(axis[1][0] - axis[0][0]),
        d1(axis[1][1] - axis[0][1]),
        d2(axis[1][2] - axis[0][2]),
        square(d.squaredNorm()) {}
  /// n'' . d that keeps n . d zero to second order, with n' = m.
  Scalar second_rate(const Vec3<Scalar>& n, const Vec3<Scalar>& m) const {
    return -(2 * m.dot(d1) + n.dot(d2));
  }
};

/// What is closest at one instant: an interior point of an axis makes it an edge.
template <class Scalar>
struct Feature {
  Edge<Scalar> A;
  Edge<Scalar> B;
  bool on_A;
  bool on_B;
  Scalar cosine;       ///< A.d . B.d
  Scalar determinant;  ///< of the edge-edge equations

  Feature(const ClosestPoints<Scalar>& closest, const PairExpansion<Scalar>& pair)
      : A(pair.A),
        B(pair.B),
        on_A(is_inside(closest.s) && A.square > std::numeric_limits<Scalar>::min()),
        on_B(is_inside(closest.u) && B.square > std::numeric_limits<Scalar>::min()),
        cosine(A.d.dot(B.d)),
        determinant(A.d.cross(B.d).squaredNorm() + kDamping<Scalar> * (A.square * B.square)) {}

  /// The shortest vector in the plane of the edges with the given products with those that hold.
  /// @pre on_A or on_B
  Vec3<Scalar> solve(Scalar on_d_A, Scalar on_d_B) const {
    if (!on_B) return A.d * (on_d_A / A.square);
    if (!on_A) return B.d * (on_d_B / B.square);
    const Scalar a = (on_d_A * B.square - on_d_B * cosine) / determinant;
    const Scalar b = (on_d_B * A.square - on_d_A * cosine) / determinant;
    return a * A.d + b * B.d;
  }

 private:
  static bool is_inside(Scalar parameter) { return parameter > Scalar(0) && parameter < Scalar(1); }
};

/// The normal of `closest`, made perpendicular to the edges that hold once more: where the axes are
/// close, its direction has lost digits.
template <class Scalar>
Vec3<Scalar> sharpened_normal(const Vec3<Scalar>& n, const Feature<Scalar>& feature) {
  if (!feature.on_A && !feature.on_B) return n;
  const Vec3<Scalar> sharp = n - feature.solve(n.dot(feature.A.d), n.dot(feature.B.d));
  return largest_component(sharp) > Scalar(0) ? unit(sharp) : n;
}

/// The path of the normal n: it turns with the closest points, and stays perpendicular to the edges
/// that hold, to second order.
template <class Scalar>
NormalPath<Scalar> tracking_path(const Vec3<Scalar>& n, const Feature<Scalar>& feature,
                                 const Vec3<Scalar>& relative_rate, Scalar distance) {
  NormalPath<Scalar> N;
  N.n = n;
  if (!(feature.on_A && feature.on_B)) {
    N.m = (relative_rate - n * n.dot(relative_rate)) / distance;
    if (!feature.on_A && !feature.on_B) return N;
  }
  const Edge<Scalar>& A = feature.A;
  const Edge<Scalar>& B = feature.B;
  N.m -= feature.solve(n.dot(A.d1) + N.m.dot(A.d), n.dot(B.d1) + N.m.dot(B.d));
  N.m2 = feature.solve(A.second_rate(n, N.m), B.second_rate(n, N.m));
  return N;
}

/// How the material points at the closest parameters part.
template <class Scalar>
Vec3<Scalar> relative_rate(const ClosestPoints<Scalar>& closest,
                           const PairExpansion<Scalar>& pair) {
  const Vec3<Scalar> on_A = pair.A[0][1] + closest.s * (pair.A[1][1] - pair.A[0][1]);
  const Vec3<Scalar> on_B = pair.B[0][1] + closest.u * (pair.B[1][1] - pair.B[0][1]);
  return on_B - on_A;
}

/// Whether its powers are harmless.
template <class Scalar>
bool can_be_followed(const NormalPath<Scalar>& N) {
  return largest_component(N.m) <= kFastest<Scalar> &&
         largest_component(N.m2) <= kFastest<Scalar> * kFastest<Scalar>;
}

}  // namespace batuta
