// SPDX-License-Identifier: MIT
#pragma once
// A blow weighed in double: what two bodies had before and have after, and the error bounds that
// src/response/impulse.md and friction.md state for it.

#include <algorithm>

#include "batuta/response/friction.hpp"
#include "bytes.hpp"
#include "oracle.hpp"

namespace batuta::fuzz {

/// One body of a blow. What has no inverse mass or moment cannot be moved and carries nothing.
struct Weighed {
  Real3 v, w;      ///< before
  Real3 v1, w1;    ///< after
  Real3 J, b;      ///< impulse and impulsive torque
  Real3 r;         ///< lever
  Real3 moments;   ///< of inertia, along the axes of the body; 0 where it has no inverse
  Real3 inverses;  ///< of them
  double mass = 0;
  double inverse_mass = 0;
  Eigen::Matrix3d R_WB;

  double energy(const Real3& velocity, const Real3& turning) const {
    const Real3 w_B = R_WB.transpose() * turning;
    return 0.5 * (mass * velocity.squaredNorm() + moments.dot(w_B.cwiseAbs2()));
  }
  double gain() const { return energy(v1, w1) - energy(v, w); }
  double fastest() const { return std::max(v.norm(), v1.norm()); }
  double spin() const { return std::max(w.norm(), w1.norm()); }
};

inline Real3 inverse_of(const Real3& x) {
  return {x.x() > 0 ? 1 / x.x() : 0, x.y() > 0 ? 1 / x.y() : 0, x.z() > 0 ? 1 / x.z() : 0};
}

inline Weighed weighed(const Collider<float>& body, const Twist<float>& after,
                       const Momentum<float>& push, const Vec3<float>& point_W) {
  Weighed it;
  it.v = body.twist.v_W.cast<double>();
  it.w = body.twist.w_W.cast<double>();
  it.v1 = after.v_W.cast<double>();
  it.w1 = after.w_W.cast<double>();
  it.J = push.linear_W.cast<double>();
  it.b = push.angular_W.cast<double>();
  it.r = point_W.cast<double>() - body.X_WB.p_W.cast<double>();
  it.inverses = body.inverse_moments.cast<double>();
  it.moments = inverse_of(it.inverses);
  it.inverse_mass = body.inverse_mass;
  it.mass = it.inverse_mass > 0 ? 1 / it.inverse_mass : 0;
  it.R_WB = body.X_WB.q_WB.cast<double>().normalized().toRotationMatrix();
  return it;
}

/// How its point gives way along n to an impulse of one along n.
inline double yield_of(const Weighed& it, const Real3& n) {
  const Real3 s = it.R_WB.transpose() * it.r.cross(n);
  return it.inverse_mass + it.inverses.dot(s.cwiseAbs2());
}

/// e_k, and with e_j of both bodies e_v and e_w: "Conditioning" in impulse.md.
inline double yield_error(const Weighed& it, const Real3& n) {
  const Real3 s = it.R_WB.transpose() * it.r.cross(n);
  return it.inverse_mass + 2 * it.r.norm() * it.inverses.dot(s.cwiseAbs());
}

struct BlowErrors {
  double v_A, w_A, v_B, w_B;  ///< e_v, e_w of each body
};

inline BlowErrors errors_of(const Weighed& A, const Weighed& B, const Real3& n,
                            double restitution) {
  const auto point_speed = [](const Weighed& it) {
    return it.v.norm() + it.w.norm() * it.r.norm();
  };
  const double k = yield_of(A, n) + yield_of(B, n);
  const double j = A.J.norm();
  const double e_j = (1 + restitution) * (point_speed(A) + point_speed(B)) / k +
                     j * (1 + (yield_error(A, n) + yield_error(B, n)) / k);
  const auto e_v = [&](const Weighed& it) { return it.v.norm() + (j + e_j) * it.inverse_mass; };
  const auto e_w = [&](const Weighed& it) {
    const Real3 s = it.R_WB.transpose() * it.r.cross(n);
    return it.w.norm() + it.inverses.cwiseProduct(s).norm() * e_j +
           it.inverses.maxCoeff() * it.r.norm() * j;
  };
  return {e_v(A), e_w(A), e_v(B), e_w(B)};
}

/// What the energy may grow by in a blow without friction (impulse.md).
inline double frictionless_gain(const Weighed& A, const Weighed& B, const BlowErrors& e) {
  const auto share = [](const Weighed& it, double e_v, double e_w) {
    const double p = it.mass * it.fastest();
    const double b = it.moments.maxCoeff() * it.spin();
    return std::max(it.energy(it.v, it.w), it.energy(it.v1, it.w1)) + p * e_v + b * e_w;
  };
  return 2 * kU * (share(A, e.v_A, e.w_A) + share(B, e.v_B, e.w_B));
}

/// What friction adds to that, from the velocities after the blow without it (friction.md,
/// "Energy").
inline double rough_gain(const Weighed& A, const Weighed& B) {
  const auto share = [](const Weighed& it) {
    const double stiffest = it.moments.maxCoeff();
    const double turned = it.b.norm() + 3 * stiffest * (it.w1 - it.w).norm();
    return it.mass * it.fastest() * it.fastest() + stiffest * it.spin() * it.spin() +
           it.fastest() * it.J.norm() + it.spin() * turned;
  };
  return 4 * kU * (share(A) + share(B));
}

/// By how much |P_t| may exceed mu n.P (friction.md, "Error").
/// @param A  and B: with the velocities after the blow without friction, whose impulse is j
/// @param nu  how far the length of the normal is from 1
inline double cone_excess(const Weighed& A, const Weighed& B, double mu, double nu, double j) {
  const auto speed = [](const Weighed& it) { return it.v.norm() + it.w.norm() * it.r.norm(); };
  const auto softest = [](const Weighed& it) {
    return it.inverse_mass + it.inverses.maxCoeff() * it.r.squaredNorm();
  };
  const double least_give =
      std::max(A.inverse_mass + B.inverse_mass, 16 * kU * 16 * kU * (softest(A) + softest(B)));
  const double longest = 2 * (speed(A) + speed(B)) / least_give;  // |D|
  const double rounding = (13 + 7 * mu) * kU + 2 * (1 + mu) * nu;
  return rounding * (A.J.norm() + j) + (1 + mu) * kLeast * (8 + longest);
}

}  // namespace batuta::fuzz
