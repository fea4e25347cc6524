// SPDX-License-Identifier: MIT
#include "batuta/response/straight_impulse.hpp"

namespace batuta {

template <class Scalar>
detail::StraightHit<Scalar> detail::straight_impulse(StraightBody<Scalar>& A,
                                                     StraightBody<Scalar>& B,
                                                     const Vec3<Scalar>& normal_BA_W,
                                                     Scalar restitution) {
  const Vec3<Scalar>& n = normal_BA_W;
  detail::StraightHit<Scalar> hit;
  for (int i = 0; i < 3; ++i) {  // Bound: 3
    hit.v_rel += n[i] * (A.inverse_mass * A.momentum_W[i] - B.inverse_mass * B.momentum_W[i]);
  }
  const Scalar give = A.inverse_mass + B.inverse_mass;
  const Scalar j = -(Scalar(1) + restitution) * hit.v_rel / give;
  const bool collides = hit.v_rel < Scalar(0) && is_positive(j);
  if (!collides) return hit;
  hit.impulse = j;
  const Scalar j_A = A.inverse_mass > Scalar(0) ? j : Scalar(0);
  const Scalar j_B = B.inverse_mass > Scalar(0) ? j : Scalar(0);
  for (int i = 0; i < 3; ++i) {  // Bound: 3; by component: expressions double the code
    A.momentum_W[i] += j_A * n[i];
    B.momentum_W[i] -= j_B * n[i];
  }
  return hit;
}

#define BATUTA_INSTANTIATE(S)                                                                  \
  template detail::StraightHit<S> detail::straight_impulse(StraightBody<S>&, StraightBody<S>&, \
                                                           const Vec3<S>&, S);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
