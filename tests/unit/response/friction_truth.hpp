// SPDX-License-Identifier: MIT
#pragma once
// The law of friction.hpp as it is written, with the matrix K and its inverse, in long double from
// the exact inputs; and how far rounding may lead from it.

#include "batuta/response/friction.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace batuta::exact {

using Real = long double;
using RealVec = Vec3<Real>;
using RealMat = Mat3<Real>;

template <class Scalar>
RealMat inverse_inertia(const Collider<Scalar>& body) {
  const RealMat R = body.X_WB.q_WB.template cast<Real>().toRotationMatrix();
  return R * body.inverse_moments.template cast<Real>().asDiagonal() * R.transpose();
}

inline RealMat cross_matrix(const RealVec& r) {
  RealMat m;
  m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m;
}

/// One body's part of K = 1/m - [r] I^-1 [r].
template <class Scalar>
RealMat give(const Collider<Scalar>& body, const Contact<Scalar>& contact) {
  const RealVec r = contact.point_W.template cast<Real>() - body.X_WB.p_W.template cast<Real>();
  return Real(body.inverse_mass) * RealMat::Identity() -
         cross_matrix(r) * inverse_inertia(body) * cross_matrix(r);
}

template <class Scalar>
RealVec velocity(const Collider<Scalar>& body, const Twist<Scalar>& twist,
                 const Contact<Scalar>& contact) {
  const RealVec r = contact.point_W.template cast<Real>() - body.X_WB.p_W.template cast<Real>();
  return twist.v_W.template cast<Real>() + twist.w_W.template cast<Real>().cross(r);
}

template <class Scalar>
Real kinetic_energy(const Collider<Scalar>& body, const Twist<Scalar>& twist) {
  const RealMat R = body.X_WB.q_WB.template cast<Real>().normalized().toRotationMatrix();
  const RealVec w_B = R.transpose() * twist.w_W.template cast<Real>();
  Real twice = body.inverse_mass > 0
                   ? twist.v_W.template cast<Real>().squaredNorm() / Real(body.inverse_mass)
                   : 0;
  for (int i = 0; i < 3; ++i) {
    if (body.inverse_moments[i] > 0) twice += w_B[i] * w_B[i] / Real(body.inverse_moments[i]);
  }
  return twice / 2;
}

struct FrictionTruth {
  RealMat K = RealMat::Zero();
  RealVec v0 = RealVec::Zero();
  RealVec J = RealVec::Zero();  ///< on A
  Real j = 0;                   ///< n . J
  bool sticks = true;
};

/// @pre K regular, v_n < 0
template <class Scalar>
FrictionTruth friction_truth(const Collider<Scalar>& A, const Collider<Scalar>& B,
                             const Contact<Scalar>& contact, const FrictionLaw<Scalar>& law) {
  FrictionTruth truth;
  const RealVec n = contact.normal_BA_W.template cast<Real>().normalized();
  truth.K = give(A, contact) + give(B, contact);
  truth.v0 = velocity(A, A.twist, contact) - velocity(B, B.twist, contact);
  const RealVec P_I = -n.dot(truth.v0) / n.dot(truth.K * n) * n;
  const RealVec P_II = -truth.K.fullPivLu().solve(truth.v0);
  const RealVec D = P_II - P_I;
  const Real e = Real(law.restitution);
  const Real mu = Real(law.friction);
  truth.J = (1 + e) * P_I + (1 + Real(law.tangential)) * D;
  const RealVec tangential = truth.J - n.dot(truth.J) * n;
  if (tangential.norm() > mu * n.dot(truth.J)) {
    truth.sticks = false;
    const Real kappa =
        mu * (1 + e) * n.dot(P_I) / ((P_II - n.dot(P_II) * n).norm() - mu * n.dot(D));
    truth.J = (1 + e) * P_I + kappa * D;
  }
  truth.j = n.dot(truth.J);
  return truth;
}

}  // namespace batuta::exact
