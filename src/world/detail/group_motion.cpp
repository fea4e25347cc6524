// SPDX-License-Identifier: MIT
#include "batuta/world/detail/group_motion.hpp"

#include "batuta/geometry/direction.hpp"

namespace batuta::detail {
namespace {

/// x with A x = y of a symmetric A, by its cofactors; zero where A has none.
template <class Scalar>
Vec3<Scalar> solved(const Mat3<Scalar>& A, const Vec3<Scalar>& y) {
  const Vec3<Scalar> a = A.col(0);
  const Vec3<Scalar> b = A.col(1);
  const Vec3<Scalar> c = A.col(2);
  const Vec3<Scalar> first = b.cross(c);
  const Scalar volume = a.dot(first);
  if (!(volume > Scalar(0))) return Vec3<Scalar>::Zero();
  const Vec3<Scalar> x(y.dot(first), y.dot(c.cross(a)), y.dot(a.cross(b)));
  return x / volume;
}

}  // namespace

template <class Scalar>
void add_inertia(Mat3<Scalar>& inertia_W, const Body<Scalar>& body, const Vec3<Scalar>& r_W) {
  const Scalar mass = 1 / body.inverse_mass;
  for (int k = 0; k < 3; ++k) {  // Bound: 3 columns: the angular momentum of a turn about each axis
    const Vec3<Scalar> w_W = Vec3<Scalar>::Unit(k);
    const Momentum<Scalar> own = momentum_of(body, Twist<Scalar>{Vec3<Scalar>::Zero(), w_W});
    inertia_W.col(k) += own.angular_W + mass * r_W.cross(w_W.cross(r_W));
  }
}

template <class Scalar>
Vec3<Scalar> group_spin(const Mat3<Scalar>& inertia_W, const Vec3<Scalar>& L_W, Scalar duration) {
  constexpr Scalar kHalfTurn = Scalar(3.14159265358979323846);
  const Vec3<Scalar> start_W = spin_for(inertia_W, L_W);
  const Vec3<Scalar> half_W = (duration / 2) * start_W;
  if (!(2 * length(half_W) < kHalfTurn)) return Vec3<Scalar>::Zero();
  const Quat<Scalar> turn = exp_map(half_W);
  return turn * spin_for<Scalar>(inertia_W, turn.conjugate() * L_W);
}

/// In units in which the trace is one: the cube of a small moment would vanish.
template <class Scalar>
Vec3<Scalar> spin_for(const Mat3<Scalar>& inertia_W, const Vec3<Scalar>& L_W) {
  const Scalar size = inertia_W.trace();
  if (!(size > Scalar(0))) return Vec3<Scalar>::Zero();
  const Mat3<Scalar> unit = inertia_W / size;
  const Vec3<Scalar> wanted_W = L_W / size;
  Mat3<Scalar> stiffer = unit;
  constexpr Scalar kLeast = 4 * kRoundOff<Scalar>;
  for (int i = 0; i < 3; ++i) stiffer(i, i) += kLeast;  // Bound: 3
  const Vec3<Scalar> w_W = solved(stiffer, wanted_W);
  const Vec3<Scalar> left_W = wanted_W - unit * w_W;
  return w_W + solved<Scalar>(stiffer, left_W);
}

#define BATUTA_INSTANTIATE(S)                                          \
  template void add_inertia(Mat3<S>&, const Body<S>&, const Vec3<S>&); \
  template Vec3<S> group_spin(const Mat3<S>&, const Vec3<S>&, S);      \
  template Vec3<S> spin_for(const Mat3<S>&, const Vec3<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::detail
