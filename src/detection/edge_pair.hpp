// SPDX-License-Identifier: MIT
#pragma once
// What is closest of two axes at one instant, and the vectors that are
// perpendicular to it. Derivation: advancement.md, "Which normal".

#include "batuta/geometry/direction.hpp"
#include "batuta/geometry/segment.hpp"

namespace batuta {

/// Added to sin^2 of the angle between two edges. It only keeps the equations
/// solvable where they are parallel: from 1e-4 on it would cost the second
/// order where they nearly are (advancement.md).
template <class Scalar>
inline constexpr Scalar kDamping = 16 * kRoundOff<Scalar>;

/// The vectors along two axes. An axis whose closest point lies inside it holds
/// as an edge: the normal is perpendicular to it.
template <class Scalar>
struct EdgePair {
  Vec3<Scalar> a;
  Vec3<Scalar> b;
  Scalar along_a;  ///< n . a
  Scalar along_b;  ///< n . b
  bool on_A;
  bool on_B;

  EdgePair(const ClosestPoints<Scalar>& closest, const Vec3<Scalar>& along_A,
           const Vec3<Scalar>& along_B)
      : a(along_A),
        b(along_B),
        along_a(closest.normal_AB.dot(a)),
        along_b(closest.normal_AB.dot(b)) {
    const Scalar aa = a.squaredNorm();
    const Scalar bb = b.squaredNorm();
    on_A = holds(closest.s, along_a) && aa > kLeastSquare;
    on_B = holds(closest.u, -along_b) && bb > kLeastSquare;
    shear_ = 0;
    a_.setZero();
    b_.setZero();
    if (on_A) a_ = a * (1 / aa);
    if (on_B) b_ = b * (1 / bb);
    if (on_A && on_B) {
      shear_ = a_.dot(b);
      b_ = (b - a * shear_) / (a_.cross(b).squaredNorm() * aa + kDamping<Scalar> * bb);
    }
  }

  bool none_holds() const { return !on_A && !on_B; }

  /// The shortest vector in the plane of the edges with the given products with
  /// those that hold; where both are parallel, with a; zero where none holds.
  Vec3<Scalar> solve(Scalar with_a, Scalar with_b) const {
    return a_ * with_a + b_ * (with_b - shear_ * with_a);
  }

 private:
  static constexpr Scalar kLeastSquare = std::numeric_limits<Scalar>::min();

  /// Inside; or at an end, but the other body is nearer on the way in: rounding
  /// has taken the end of a near tie.
  /// @param inward  n . edge, from the first end on, towards the other body
  static bool holds(Scalar parameter, Scalar inward) {
    if (!(parameter > Scalar(0))) return inward > Scalar(0);
    return parameter < Scalar(1) || inward < Scalar(0);
  }

  Vec3<Scalar> a_;  ///< has the product 1 with a
  Vec3<Scalar> b_;  ///< has the product 1 with b, and 0 with a if that holds too
  Scalar shear_;    ///< product of a_ with b, if both hold
};

/// What a unit normal that is sharp may have along the edges.
template <class Scalar>
inline constexpr Scalar kSharp = 2 * kRoundOff<Scalar>;

/// Less than this is left, squared, of a normal that was none.
template <class Scalar>
inline constexpr Scalar kLeastSharp = Scalar(1) / 64;

/// The normal of the closest points, made perpendicular to the edges that hold
/// once more: where the axes are close to each other, its direction has lost
/// digits. Unit.
template <class Scalar>
Vec3<Scalar> sharpened(const Vec3<Scalar>& n, const EdgePair<Scalar>& edges) {
  const Vec3<Scalar> along_edges = edges.solve(edges.along_a, edges.along_b);
  if (!(detail::largest_component(along_edges) > kSharp<Scalar>)) return n;
  const Vec3<Scalar> sharp = n - along_edges;
  const Scalar square = sharp.squaredNorm();
  if (!(square > kLeastSharp<Scalar>)) return n;
  return sharp * (1 / std::sqrt(square));
}

}  // namespace batuta
