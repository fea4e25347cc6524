// SPDX-License-Identifier: MIT
#include "batuta/mechanics/mass.hpp"

#include <utility>

#include "batuta/geometry/direction.hpp"
#include "batuta/mechanics/rotation.hpp"

namespace batuta {
namespace {

/// Sweeps of the cyclic Jacobi method, which converges quadratically: four reach the rounding error
/// of double for every matrix tried, the rest is reserve (mass.md).
constexpr int kJacobiSweeps = 6;

/// An element this small beside 1 changes no moment and no axis; its square does not vanish.
template <class Scalar>
constexpr Scalar kNegligible = kRoundOff<Scalar>* kRoundOff<Scalar>;

template <class Scalar>
constexpr Scalar kPi = Scalar(0x1.921fb54442d18p+1);

/// Moments of a body of revolution about its centre.
template <class Scalar>
struct RevolutionMoments {
  Scalar axial;
  Scalar transverse;
};

/// The masses of a capsule's cylinder and of its two half balls together.
template <class Scalar>
struct CapsuleMasses {
  Scalar cylinder;
  Scalar caps;
};

template <class Scalar>
CapsuleMasses<Scalar> masses_of(Scalar radius, Scalar core, Scalar density) {
  const Scalar disc = density * kPi<Scalar> * radius * radius;
  return {disc * core, disc * radius * 4 / 3};
}

template <class Scalar>
RevolutionMoments<Scalar> capsule_moments(const CapsuleMasses<Scalar>& m, Scalar radius,
                                          Scalar core) {
  const Scalar rr = radius * radius;
  const Scalar ll = core * core;
  const Scalar axial = m.cylinder * rr / 2 + m.caps * rr * 2 / 5;
  const Scalar transverse =
      m.cylinder * (rr / 4 + ll / 12) + m.caps * (rr * 2 / 5 + radius * core * 3 / 8 + ll / 4);
  return {axial, transverse};
}

template <class Scalar>
bool is_usable(const MassProperties<Scalar>& m) {
  return m.mass > Scalar(0) && is_finite(m.mass) && is_finite(m.center_S) && is_finite(m.inertia_S);
}

template <class Scalar>
Result<MassProperties<Scalar>> usable_or_invalid(const MassProperties<Scalar>& m) {
  return is_usable(m) ? success(m) : failure<MassProperties<Scalar>>(Status::kInvalidArgument);
}

/// Cosine and sine of a plane rotation.
template <class Scalar>
struct PlaneRotation {
  Scalar c = 1;
  Scalar s = 0;
};

/// The smaller of the two rotations that clear the element (i, j) of a symmetric matrix.
template <class Scalar>
PlaneRotation<Scalar> clearing(Scalar ii, Scalar jj, Scalar ij) {
  const Scalar difference = jj - ii;
  const Scalar root = std::sqrt(difference * difference + Scalar(4) * ij * ij);
  const Scalar t =
      Scalar(2) * ij / (difference < Scalar(0) ? difference - root : difference + root);
  const Scalar c = Scalar(1) / std::sqrt(t * t + Scalar(1));
  return {c, t * c};
}

/// A := G^T A G, V := V G with the rotation G in the plane (i, j) that clears A(i, j).
template <class Scalar>
void clear_element(Mat3<Scalar>& A, Mat3<Scalar>& V, int i, int j) {
  if (std::abs(A(i, j)) <= kNegligible<Scalar>) return;
  const PlaneRotation<Scalar> g = clearing(A(i, i), A(j, j), A(i, j));
  const int k = 3 - i - j;
  const Scalar moved = g.s / g.c * A(i, j);
  A(i, i) -= moved;
  A(j, j) += moved;
  A(i, j) = A(j, i) = Scalar(0);
  const Scalar ik = A(i, k);
  const Scalar jk = A(j, k);
  A(i, k) = A(k, i) = g.c * ik - g.s * jk;
  A(j, k) = A(k, j) = g.s * ik + g.c * jk;
  const Vec3<Scalar> Vi = V.col(i);
  const Vec3<Scalar> Vj = V.col(j);
  V.col(i) = g.c * Vi - g.s * Vj;
  V.col(j) = g.s * Vi + g.c * Vj;
}

template <class Scalar>
struct Axes {
  Vec3<Scalar> moments;
  Mat3<Scalar> directions;  ///< columns, in the order of the moments
};

template <class Scalar>
void put_in_order(Axes<Scalar>& axes, int i, int j) {
  if (!(axes.moments(j) < axes.moments(i))) return;
  std::swap(axes.moments(i), axes.moments(j));
  axes.directions.col(i).swap(axes.directions.col(j));
}

/// Eigenvalues and eigenvectors of a symmetric matrix whose elements are at most about 1.
/// Bound: kJacobiSweeps sweeps of three rotations.
template <class Scalar>
Axes<Scalar> eigen_axes(Mat3<Scalar> A) {
  Mat3<Scalar> V = Mat3<Scalar>::Identity();
  for (int sweep = 0; sweep < kJacobiSweeps; ++sweep) {  // Bound: kJacobiSweeps
    clear_element(A, V, 0, 1);
    clear_element(A, V, 0, 2);
    clear_element(A, V, 1, 2);
  }
  Axes<Scalar> axes = {A.diagonal(), V};
  put_in_order(axes, 0, 1);
  put_in_order(axes, 1, 2);
  put_in_order(axes, 0, 1);
  return axes;
}

}  // namespace

template <class Scalar>
Scalar detail::axial_moment(const Capsule<Scalar>& capsule, Scalar density) {
  const Scalar core = length<Scalar>(capsule.axis.b - capsule.axis.a);
  return capsule_moments(masses_of(capsule.radius, core, density), capsule.radius, core).axial;
}

template <class Scalar>
Result<MassProperties<Scalar>> solid_capsule(const Capsule<Scalar>& capsule, Scalar density) {
  if (!is_valid(capsule) || !(density > Scalar(0))) {
    return failure<MassProperties<Scalar>>(Status::kInvalidArgument);
  }
  const Vec3<Scalar> along = capsule.axis.b - capsule.axis.a;
  const Scalar core = length(along);
  const CapsuleMasses<Scalar> masses = masses_of(capsule.radius, core, density);
  const RevolutionMoments<Scalar> moments = capsule_moments(masses, capsule.radius, core);

  MassProperties<Scalar> whole;
  whole.mass = masses.cylinder + masses.caps;
  whole.center_S = capsule.axis.a + along / 2;
  whole.inertia_S = moments.transverse * Mat3<Scalar>::Identity();
  if (core > Scalar(0)) {
    const Vec3<Scalar> e = along / core;
    whole.inertia_S += (moments.axial - moments.transverse) * (e * e.transpose());
  }
  // Of the two moments the axial one vanishes first.
  if (!(moments.axial > Scalar(0))) whole.mass = Scalar(0);
  return usable_or_invalid(whole);
}

template <class Scalar>
Result<MassProperties<Scalar>> point_mass(Scalar mass, const Vec3<Scalar>& position_S) {
  return usable_or_invalid(MassProperties<Scalar>{mass, position_S, Mat3<Scalar>::Zero()});
}

template <class Scalar>
MassProperties<Scalar> operator+(const MassProperties<Scalar>& P, const MassProperties<Scalar>& Q) {
  if (!(Q.mass > Scalar(0))) return P;
  if (!(P.mass > Scalar(0))) return Q;
  MassProperties<Scalar> sum = P;
  sum.mass = P.mass + Q.mass;
  const Vec3<Scalar> apart = Q.center_S - P.center_S;
  const Scalar share = Q.mass / sum.mass;
  const Scalar reduced = P.mass * share;
  sum.center_S = P.center_S + share * apart;
  sum.inertia_S += Q.inertia_S;
  sum.inertia_S +=
      reduced * (apart.squaredNorm() * Mat3<Scalar>::Identity() - apart * apart.transpose());
  return sum;
}

template <class Scalar>
PrincipalFrame<Scalar> principal_frame(const MassProperties<Scalar>& mass) {
  PrincipalFrame<Scalar> frame;
  frame.center_S = mass.center_S;
  // One scale for all elements: the squares in clearing() neither overflow nor vanish.
  const Scalar scale = mass.inertia_S.cwiseAbs().maxCoeff();
  if (!(scale > Scalar(0)) || !is_finite(scale)) return frame;
  Axes<Scalar> axes = eigen_axes(Mat3<Scalar>(mass.inertia_S / scale));
  axes.directions.col(2) = axes.directions.col(0).cross(axes.directions.col(1));
  frame.q_SB = detail::to_quaternion(axes.directions);
  for (int i = 0; i < 3; ++i) {  // Bound: three moments
    frame.moments(i) = max_of(Scalar(0), scale * axes.moments(i));
  }
  return frame;
}

#define BATUTA_INSTANTIATE(Scalar)                                                       \
  template Scalar detail::axial_moment(const Capsule<Scalar>&, Scalar);                  \
  template Result<MassProperties<Scalar>> solid_capsule(const Capsule<Scalar>&, Scalar); \
  template Result<MassProperties<Scalar>> point_mass(Scalar, const Vec3<Scalar>&);       \
  template MassProperties<Scalar> operator+(const MassProperties<Scalar>&,               \
                                            const MassProperties<Scalar>&);              \
  template PrincipalFrame<Scalar> principal_frame(const MassProperties<Scalar>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
