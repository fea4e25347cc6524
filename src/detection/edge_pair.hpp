// SPDX-License-Identifier: MIT
#pragma once
// What is closest of two axes at one instant, and the vectors that are perpendicular to it.
// Derivation: advancement.md, "Which normal".

#include "batuta/geometry/direction.hpp"
#include "batuta/geometry/segment.hpp"

namespace batuta {

/// Added to the determinant of the edge-edge equations, over the squares of both edges. It only
/// keeps them solvable: from 1e-4 on it would cost the second order where edges are nearly parallel
/// (algorithms: case T19b).
template <class Scalar>
inline constexpr Scalar kDamping = 16 * kRoundOff<Scalar>;

/// The vectors along two axes. An axis whose closest point lies inside it holds as an edge: the
/// normal is perpendicular to it.
template <class Scalar>
struct EdgePair {
  Vec3<Scalar> a;
  Vec3<Scalar> b;
  Scalar aa;           ///< |a|^2
  Scalar bb;           ///< |b|^2
  Scalar ab;           ///< a . b
  Scalar determinant;  ///< of the equations for both, damped
  bool on_A;
  bool on_B;

  EdgePair(const ClosestPoints<Scalar>& closest, const Vec3<Scalar>& along_A,
           const Vec3<Scalar>& along_B)
      : a(along_A),
        b(along_B),
        aa(a.squaredNorm()),
        bb(b.squaredNorm()),
        ab(a.dot(b)),
        determinant(a.cross(b).squaredNorm() + kDamping<Scalar> * (aa * bb)),
        on_A(is_inside(closest.s) && aa > std::numeric_limits<Scalar>::min()),
        on_B(is_inside(closest.u) && bb > std::numeric_limits<Scalar>::min()) {}

  bool none_holds() const { return !on_A && !on_B; }

  /// The shortest vector in the plane of the edges with the given products with those that hold.
  /// @pre one holds
  Vec3<Scalar> solve(Scalar with_a, Scalar with_b) const {
    if (!on_B) return a * (with_a / aa);
    if (!on_A) return b * (with_b / bb);
    const Scalar along_a = (with_a * bb - with_b * ab) / determinant;
    const Scalar along_b = (with_b * aa - with_a * ab) / determinant;
    return along_a * a + along_b * b;
  }

 private:
  static bool is_inside(Scalar parameter) { return parameter > Scalar(0) && parameter < Scalar(1); }
};

/// The unit normal n, made perpendicular to the edges that hold once more: where the axes are close
/// to each other, its direction has lost digits.
template <class Scalar>
Vec3<Scalar> sharpened(const Vec3<Scalar>& n, const EdgePair<Scalar>& edges) {
  if (edges.none_holds()) return n;
  const Vec3<Scalar> sharp = n - edges.solve(n.dot(edges.a), n.dot(edges.b));
  return largest_component(sharp) > Scalar(0) ? unit(sharp) : n;
}

}  // namespace batuta
