// SPDX-License-Identifier: MIT
#pragma once
// What is closest of two axes at one instant, and the vectors that are perpendicular to it.
// Derivation: advancement.md, "Which normal".

#include "batuta/geometry/direction.hpp"
#include "batuta/geometry/segment.hpp"

namespace batuta {

/// Added to sin^2 of the angle between two edges. It only keeps the equations solvable where they
/// are parallel: from 1e-4 on it would cost the second order where they nearly are
/// (advancement.md).
template <class Scalar>
inline constexpr Scalar kDamping = 16 * kRoundOff<Scalar>;

/// The vectors along two axes. An axis whose closest point lies inside it holds as an edge: the
/// normal is perpendicular to it.
template <class Scalar>
struct EdgePair {
  Vec3<Scalar> a;
  Vec3<Scalar> b;
  Scalar aa;  ///< |a|^2
  Scalar bb;  ///< |b|^2
  bool on_A;
  bool on_B;

  EdgePair(const ClosestPoints<Scalar>& closest, const Vec3<Scalar>& along_A,
           const Vec3<Scalar>& along_B)
      : a(along_A),
        b(along_B),
        aa(a.squaredNorm()),
        bb(b.squaredNorm()),
        on_A(holds(closest.s, closest.normal_AB.dot(a)) && aa > kLeastSquare),
        on_B(holds(closest.u, -closest.normal_AB.dot(b)) && bb > kLeastSquare) {}

  bool none_holds() const { return !on_A && !on_B; }

  /// The shortest vector in the plane of the edges with the given products with those that hold;
  /// where both are parallel, with a. @pre one holds
  Vec3<Scalar> solve(Scalar with_a, Scalar with_b) const {
    if (!on_A) return b * (with_b / bb);
    if (!on_B) return a * (with_a / aa);
    const Vec3<Scalar> along_a = a * (with_a / aa);
    const Vec3<Scalar> beside_a = b - a * (a.dot(b) / aa);
    const Scalar square = a.cross(b).squaredNorm() / aa + kDamping<Scalar> * bb;
    return along_a + beside_a * ((with_b - along_a.dot(b)) / square);
  }

 private:
  static constexpr Scalar kLeastSquare = std::numeric_limits<Scalar>::min();

  /// Inside; or at an end, but the other body is nearer on the way in: rounding has taken the end
  /// of a near tie.
  /// @param inward  n . edge, from the first end on, towards the other body
  static bool holds(Scalar parameter, Scalar inward) {
    if (!(parameter > Scalar(0))) return inward > Scalar(0);
    return parameter < Scalar(1) || inward < Scalar(0);
  }
};

/// What a unit normal that is sharp may have along the edges.
template <class Scalar>
inline constexpr Scalar kSharp = 2 * kRoundOff<Scalar>;

/// The unit normal n, made perpendicular to the edges that hold once more: where the axes are close
/// to each other, its direction has lost digits.
template <class Scalar>
Vec3<Scalar> sharpened(const Vec3<Scalar>& n, const EdgePair<Scalar>& edges) {
  if (edges.none_holds()) return n;
  const Vec3<Scalar> along_edges = edges.solve(n.dot(edges.a), n.dot(edges.b));
  if (!(largest_component(along_edges) > kSharp<Scalar>)) return n;
  const Vec3<Scalar> sharp = n - along_edges;
  return largest_component(sharp) > Scalar(0) ? unit(sharp) : n;
}

}  // namespace batuta
