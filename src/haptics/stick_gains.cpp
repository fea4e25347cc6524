// SPDX-License-Identifier: MIT

#include "batuta/haptics/stick_gains.hpp"

namespace batuta::haptics {
namespace {

/// The largest eigenvalue of J^T diag(along, along, along, about, about, about) J: of a symmetric
/// matrix of two rows, the mean of its diagonal and the radius of its Mohr's circle.
template <class Scalar>
Scalar largest_of(const StickJacobian<Scalar>& jacobian, Scalar along, Scalar about) {
  using std::sqrt;
  const auto entry = [&](int i, int k) {
    const Vec3<Scalar> moved_i = jacobian.col(i).template head<3>();
    const Vec3<Scalar> turned_i = jacobian.col(i).template tail<3>();
    return along * moved_i.dot(jacobian.col(k).template head<3>()) +
           about * turned_i.dot(jacobian.col(k).template tail<3>());
  };
  const Scalar xx = entry(0, 0);
  const Scalar yy = entry(1, 1);
  const Scalar xy = entry(0, 1);
  const Scalar half = (xx - yy) / 2;
  return (xx + yy) / 2 + sqrt(half * half + xy * xy);
}

}  // namespace

template <class Scalar>
Gains<Scalar> gains_at_stick(const StickJacobian<Scalar>& jacobian,
                             const CouplingSettings<Scalar>& settings) {
  return {largest_of(jacobian, settings.stiffness, settings.turn_stiffness),
          largest_of(jacobian, settings.damping, settings.turn_damping)};
}

#define BATUTA_INSTANTIATE(S) \
  template Gains<S> gains_at_stick(const StickJacobian<S>&, const CouplingSettings<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::haptics
