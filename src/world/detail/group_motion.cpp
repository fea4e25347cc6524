// SPDX-License-Identifier: MIT
#include "batuta/world/detail/group_motion.hpp"

namespace batuta::detail {

template <class Scalar>
Mat3<Scalar> inertia_about(const Body<Scalar>& body, const Vec3<Scalar>& r_W) {
  const Mat3<Scalar> R_WB = body.X_WB.q_WB.toRotationMatrix();
  Vec3<Scalar> moments = Vec3<Scalar>::Zero();
  for (int i = 0; i < 3; ++i) {  // Bound: 3
    if (body.inverse_moments[i] > Scalar(0)) moments[i] = 1 / body.inverse_moments[i];
  }
  Mat3<Scalar> inertia = R_WB * moments.asDiagonal() * R_WB.transpose();
  const Scalar mass = 1 / body.inverse_mass;
  for (int i = 0; i < 3; ++i) {  // Bound: 3
    inertia(i, i) += mass * r_W.squaredNorm();
    for (int k = 0; k < 3; ++k) inertia(i, k) -= mass * r_W[i] * r_W[k];  // Bound: 3
  }
  return inertia;
}

namespace {

/// A body with the sums of a group, its frame along the principal axes.
template <class Scalar>
Body<Scalar> body_of_group(const Mat3<Scalar>& inertia_W, const Vec3<Scalar>& L_W) {
  MassProperties<Scalar> properties;
  properties.mass = 1;
  properties.inertia_S = inertia_W;
  const PrincipalFrame<Scalar> frame = principal_frame(properties);
  Body<Scalar> body;
  body.X_WB.q_WB = frame.q_SB;
  const Scalar largest = frame.moments.maxCoeff();
  for (int i = 0; i < 3; ++i) {  // Bound: 3
    const Scalar moment = max_of(frame.moments[i], 4 * kRoundOff<Scalar> * largest);
    body.inverse_moments[i] = moment > Scalar(0) ? 1 / moment : Scalar(0);
  }
  body.momentum.angular_W = L_W;
  body.spin_shows = true;
  return body;
}

}  // namespace

template <class Scalar>
Vec3<Scalar> group_spin(const Mat3<Scalar>& inertia_W, const Vec3<Scalar>& L_W, Scalar duration) {
  const Motion<Scalar> flight = free_flight(body_of_group(inertia_W, L_W), duration);
  return is_valid(flight) ? flight.twist.w_W : Vec3<Scalar>(Vec3<Scalar>::Zero());
}

template <class Scalar>
Vec3<Scalar> spin_for(const Mat3<Scalar>& inertia_W, const Vec3<Scalar>& L_W) {
  Body<Scalar> body = body_of_group(inertia_W, L_W);
  const Vec3<Scalar> w_W = twist_of(body).w_W;
  body.momentum.angular_W = L_W - inertia_W * w_W;
  return w_W + twist_of(body).w_W;
}

#define BATUTA_INSTANTIATE(S)                                     \
  template Mat3<S> inertia_about(const Body<S>&, const Vec3<S>&); \
  template Vec3<S> group_spin(const Mat3<S>&, const Vec3<S>&, S); \
  template Vec3<S> spin_for(const Mat3<S>&, const Vec3<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::detail
