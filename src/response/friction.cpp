// SPDX-License-Identifier: MIT
#include "batuta/response/friction.hpp"

#include <utility>

#include "batuta/geometry/direction.hpp"
#include "lever.hpp"

namespace batuta {

namespace {

/// Two bodies at a common point.
template <class Scalar>
struct FrictionContact {
  const Collider<Scalar>* A;
  const Collider<Scalar>* B;
  Lever<Scalar> lever_A;
  Lever<Scalar> lever_B;
  Scalar softest;  ///< an upper bound of |K|
};

/// An impulse on A; B gets the opposite.
template <class Scalar>
struct Push {
  Vec3<Scalar> d_W;
  Vec3<Scalar> moment_A;  ///< r_A x d in A's axes
  Vec3<Scalar> moment_B;  ///< r_B x d in B's axes
};

template <class Scalar>
Push<Scalar> push_along(const FrictionContact<Scalar>& touch, const Vec3<Scalar>& d_W) {
  return {d_W, moment_of(touch.lever_A, d_W), moment_of(touch.lever_B, d_W)};
}

/// x . K y. Impulses are made velocities first: the square of one may vanish.
template <class Scalar>
Scalar give(const FrictionContact<Scalar>& touch, const Push<Scalar>& x, const Push<Scalar>& y) {
  const Scalar inverse_mass = touch.A->inverse_mass + touch.B->inverse_mass;
  const Scalar mass = Vec3<Scalar>(inverse_mass * x.d_W).dot(y.d_W);
  const Scalar turn_A = touch.A->inverse_moments.cwiseProduct(x.moment_A).dot(y.moment_A);
  const Scalar turn_B = touch.B->inverse_moments.cwiseProduct(x.moment_B).dot(y.moment_B);
  return mass + turn_A + turn_B;
}

/// d . (velocity of A's point - velocity of B's), by the same moments as give(): energies agree.
template <class Scalar>
Scalar rate(const FrictionContact<Scalar>& touch, const Push<Scalar>& x,
            const Impulse<Scalar>& hit) {
  const Vec3<Scalar> w_A = touch.lever_A.R_WB.transpose() * hit.twist_A.w_W;
  const Vec3<Scalar> w_B = touch.lever_B.R_WB.transpose() * hit.twist_B.w_W;
  return x.d_W.dot(hit.twist_A.v_W - hit.twist_B.v_W) + (x.moment_A.dot(w_A) - x.moment_B.dot(w_B));
}

/// x less its share of y, so that neither disturbs the other: y . K x = 0.
template <class Scalar>
Push<Scalar> without(const FrictionContact<Scalar>& touch, const Push<Scalar>& x,
                     const Push<Scalar>& y) {
  const Scalar s = give(touch, x, y) / give(touch, y, y);
  return {x.d_W - s * y.d_W, x.moment_A - s * y.moment_A, x.moment_B - s * y.moment_B};
}

/// An upper bound of |K| of one body.
template <class Scalar>
Scalar softest(const Collider<Scalar>& body, const Lever<Scalar>& lever) {
  return body.inverse_mass + body.inverse_moments.maxCoeff() * lever.arm_W.squaredNorm();
}

/// Whether k = x . K x is no more than what rounding leaves where nothing gives way (friction.md).
template <class Scalar>
bool is_noise(const FrictionContact<Scalar>& touch, const Push<Scalar>& x, Scalar k) {
  constexpr Scalar kUlps = 16 * kRoundOff<Scalar>;
  return k <= kUlps * kUlps * x.d_W.squaredNorm() * touch.softest;
}

/// The part of x that stops what moves along it; none where nothing gives way.
template <class Scalar>
Vec3<Scalar> stopping(const FrictionContact<Scalar>& touch, const Push<Scalar>& x,
                      const Impulse<Scalar>& hit) {
  const Scalar k = give(touch, x, x);
  const Scalar share = is_noise(touch, x, k) ? Scalar(0) : -rate(touch, x, hit) / k;
  return share * x.d_W;
}

/// P_II - P_I: stops the slip and leaves the normal velocity alone. Three directions that do not
/// disturb one another (x . K y = 0) are made of n and two tangents, the softer tangent first.
template <class Scalar>
Vec3<Scalar> stopping_impulse(const FrictionContact<Scalar>& touch, const Vec3<Scalar>& n,
                              const Impulse<Scalar>& hit) {
  const Push<Scalar> along = push_along(touch, n);
  const Vec3<Scalar> tangent = detail::perpendicular(n);
  Push<Scalar> first = without(touch, push_along(touch, tangent), along);
  Push<Scalar> second = without(touch, push_along<Scalar>(touch, n.cross(tangent)), along);
  Scalar k = give(touch, first, first);
  const Scalar k_second = give(touch, second, second);
  if (k < k_second) {
    std::swap(first, second);
    k = k_second;
  }
  if (is_noise(touch, first, k)) return Vec3<Scalar>::Zero();
  return stopping(touch, first, hit) + stopping(touch, without(touch, second, first), hit);
}

/// How much of the stopping impulse d there is: 1 + e_t where it sticks, what the cone has room for
/// where it slides.
/// @param j  the normal impulse without friction
template <class Scalar>
Scalar amount(const Push<Scalar>& d, const Vec3<Scalar>& n, Scalar stick, Scalar j, Scalar mu) {
  const Scalar along_n = d.d_W.dot(n);
  const Scalar excess = length<Scalar>(d.d_W - along_n * n) / mu - along_n;
  return stick * excess > j ? j / excess : stick;
}

/// What an impulse s d at the lever does to a body's twist.
/// @param moment  of d, in the body's axes
template <class Scalar>
void push(Twist<Scalar>& twist, const Collider<Scalar>& body, const Lever<Scalar>& lever,
          const Vec3<Scalar>& moment, const Vec3<Scalar>& d_W, Scalar s) {
  const Vec3<Scalar> turn = body.inverse_moments.cwiseProduct(moment);
  twist.v_W += s * body.inverse_mass * d_W;
  twist.w_W += s * (lever.R_WB * turn);
}

/// Adds s d to the impulse and to what it did.
template <class Scalar>
void add(Impulse<Scalar>& hit, const FrictionContact<Scalar>& touch, const Push<Scalar>& d,
         Scalar s, const Vec3<Scalar>& n) {
  const Vec3<Scalar> J_W = hit.on_A.linear_W + s * d.d_W;
  hit.magnitude = max_of(Scalar(0), hit.magnitude + s * d.d_W.dot(n));
  hit.on_A = impulse_on<Scalar>(touch.lever_A.arm_W, J_W);
  hit.on_B = impulse_on<Scalar>(touch.lever_B.arm_W, -J_W);
  push(hit.twist_A, *touch.A, touch.lever_A, d.moment_A, d.d_W, s);
  push(hit.twist_B, *touch.B, touch.lever_B, d.moment_B, d.d_W, -s);
}

/// Adds friction to the paper's impulse. False where the numbers do not suffice.
template <class Scalar>
bool rub(Impulse<Scalar>& hit, const Collider<Scalar>& A, const Collider<Scalar>& B,
         const Contact<Scalar>& contact, const FrictionLaw<Scalar>& law) {
  const Vec3<Scalar>& n = contact.normal_BA_W;
  const Lever<Scalar> lever_A = lever_of(A, contact);
  const Lever<Scalar> lever_B = lever_of(B, contact);
  const FrictionContact<Scalar> touch{&A, &B, lever_A, lever_B,
                                      softest(A, lever_A) + softest(B, lever_B)};
  const Push<Scalar> d = push_along<Scalar>(touch, stopping_impulse(touch, n, hit));
  const Scalar k = give(touch, d, d);
  const Scalar slip = rate(touch, d, hit);
  if (!is_finite(k) || !is_finite(slip)) return false;
  if (!(slip < Scalar(0)) || k == Scalar(0)) return true;

  // -slip / k is 1 but for rounding; with it, the energy along d is a parabola that ends where it
  // began at e_t = 1, however inaccurate d is.
  const Scalar stick = (Scalar(1) + law.tangential) * (-slip / k);
  add(hit, touch, d, amount(d, n, stick, hit.magnitude, law.friction), n);
  return is_sound(hit);
}

template <class Scalar>
bool is_valid(const FrictionLaw<Scalar>& law) {
  return is_finite(law.friction) && law.friction >= Scalar(0) && law.tangential >= Scalar(-1) &&
         law.tangential <= Scalar(1);
}

}  // namespace

template <class Scalar>
Result<Impulse<Scalar>> friction_impulse(const Collider<Scalar>& A, const Collider<Scalar>& B,
                                         const Contact<Scalar>& contact,
                                         const FrictionLaw<Scalar>& law) {
  Result<Impulse<Scalar>> hit;
  if (!is_valid(law)) return hit;
  hit = collision_impulse(A, B, contact, law.restitution);
  const bool rubs = hit.value.magnitude > Scalar(0) && law.friction > Scalar(0);
  if (rubs && !rub(hit.value, A, B, contact, law)) hit = {};
  return hit;
}

#define BATUTA_INSTANTIATE(Scalar)                                              \
  template Result<Impulse<Scalar>> friction_impulse(                            \
      const Collider<Scalar>&, const Collider<Scalar>&, const Contact<Scalar>&, \
      const FrictionLaw<Scalar>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
