// SPDX-License-Identifier: MIT
#pragma once
// A body that turns without torque, in long double: Euler's equations by classical Runge-Kutta, and
// the closed form of the angular velocity with Jacobi's elliptic functions [Landau, Lifshitz,
// Mechanics, §37]. Nothing here knows the library but by the numbers of a body.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "batuta/mechanics/compound.hpp"
#include "batuta/mechanics/motion.hpp"

namespace batuta::laws {

using Real = long double;
using WideVec = Vec3<Real>;
using WideQuat = Eigen::Quaternion<Real>;
constexpr Real kPi = 3.14159265358979323846264338327950288L;

/// Orientation and angular momentum in the body; that in the world is q_WB b_B.
struct Top {
  WideVec inverse_moments;
  WideQuat q_WB;
  WideVec b_B;
};

template <class Scalar>
Top top_of(const Body<Scalar>& body) {
  const WideQuat q = body.X_WB.q_WB.template cast<Real>().normalized();
  return {body.inverse_moments.template cast<Real>(), q,
          q.conjugate() * body.momentum.angular_W.template cast<Real>()};
}

inline Real turning_energy(const Top& top) {
  return top.inverse_moments.dot(top.b_B.cwiseProduct(top.b_B)) / 2;
}

/// A step of Runge-Kutta turns by so much at most, rad: its error is then below 1e-15 rad.
constexpr Real kTurnOfStep = 2e-3L;

/// The top after `time`: q' = q w / 2, b' = b x w in the body, w = J^-1 b. No body gets faster than
/// sqrt(2) of its angular speed at the start (src/mechanics/motion.md).
inline Top turned(Top top, Real time) {
  using State = Eigen::Matrix<Real, 7, 1>;  // x y z w of q, b
  const WideVec& J = top.inverse_moments;
  const auto rate = [&J](const State& s) {
    const WideVec b = s.tail<3>();
    const WideVec w = J.cwiseProduct(b);
    State r;
    r.head<4>() =
        (WideQuat(s[3], s[0], s[1], s[2]) * WideQuat(0, w.x(), w.y(), w.z())).coeffs() / 2;
    r.tail<3>() = b.cross(w);
    return r;
  };
  const Real most = std::sqrt(2.0L) * J.cwiseProduct(top.b_B).norm();
  const auto steps = static_cast<long>(std::ceil(most * time / kTurnOfStep)) + 10;
  const Real h = time / static_cast<Real>(steps);
  State s;
  s << top.q_WB.coeffs(), top.b_B;
  for (long i = 0; i < steps; ++i) {
    const State k1 = rate(s);
    const State k2 = rate(s + h / 2 * k1);
    const State k3 = rate(s + h / 2 * k2);
    const State k4 = rate(s + h * k3);
    s += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return {J, WideQuat(s[3], s[0], s[1], s[2]).normalized(), s.tail<3>()};
}

/// sn, cn and dn of u, and the quarter period, for the parameter m = k^2 < 1: descending Landen
/// transformations by the arithmetic-geometric mean [Abramowitz, Stegun, 16.4].
struct Jacobi {
  Real sn, cn, dn, quarter;
};

inline Jacobi jacobi(Real u, Real m) {
  constexpr int kMeans = 12;
  std::array<Real, kMeans + 1> a{}, c{};
  a[0] = 1;
  c[0] = std::sqrt(m);
  Real b = std::sqrt(1 - m);
  for (int i = 0; i < kMeans; ++i) {
    a[i + 1] = (a[i] + b) / 2;
    c[i + 1] = (a[i] - b) / 2;
    b = std::sqrt(a[i] * b);
  }
  Real phi = std::ldexp(a[kMeans] * u, kMeans);
  for (int i = kMeans; i > 0; --i) {
    phi = (phi + std::asin(c[i] / a[i] * std::sin(phi))) / 2;
  }
  const Real sn = std::sin(phi);
  return {sn, std::cos(phi), std::sqrt(1 - m * sn * sn), kPi / (2 * a[kMeans])};
}

/// Three numbers for a message.
inline std::string text(const Vec3<double>& v) {
  return std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z());
}

/// The angle between two orientations, rad.
template <class Scalar>
Real angle_between(const Quat<Scalar>& q, const WideQuat& truth) {
  const WideQuat apart = truth.conjugate() * q.template cast<Real>().normalized();
  return 2 * std::atan2(apart.vec().norm(), std::abs(apart.w()));
}

/// At rest in the origin, turning by w_B.
template <class Scalar>
Body<Scalar> turning(const Vec3<double>& moments, const Vec3<double>& w_B) {
  Body<Scalar> body = make_body<Scalar>({}, 1, moments.cast<Scalar>()).value;
  body.momentum.angular_W = moments.cwiseProduct(w_B).cast<Scalar>();
  return body;
}

/// One step of free flight. @returns whether there was one
template <class Scalar>
bool fly(Body<Scalar>& body, Scalar step) {
  const Motion<Scalar> motion = free_flight(body, step);
  if (!is_valid(motion)) return false;
  move_along(body, motion, step);
  return true;
}

/// When the unstable top of ../shared/cases turns over: moments 1, 2, 3, from (0.01, 5, 0.01 / 3)
/// rad/s. A flip takes 2 K of the closed form; the first one is integrated. Written
/// out: 2.93, 8.34, 13.74, 19.15 s.
struct UnstableTop {
  Vec3<double> moments = {1, 2, 3};
  Vec3<double> w_B = {0.01, 5, 0.01 / 3};

  std::array<double, 4> flips() const {
    const Vec3<double>& I = moments;
    const double E2 = I.dot(w_B.cwiseProduct(w_B)), M2 = I.cwiseProduct(w_B).squaredNorm();
    // M2 < E2 I[1]: around the axis of the smallest moment; 1 and 3 change places.
    const double low = M2 - E2 * I[0], high = E2 * I[2] - M2;
    const double pace = std::sqrt((I[1] - I[0]) * high / (I[0] * I[1] * I[2]));
    const double m = (I[2] - I[1]) * low / ((I[1] - I[0]) * high);
    const double half_period = static_cast<double>(2 * jacobi(0, Real(m)).quarter) / pace;
    Top truth = top_of(turning<double>(I, w_B));
    double first = 0;
    for (; truth.b_B.y() > 0; first += 1e-3) truth = turned(truth, 1e-3L);
    return {first, first + half_period, first + 2 * half_period, first + 3 * half_period};
  }
};

/// Blade 0.9 m x 5 mm, quillons 0.2 m x 6 mm along x, pommel; steel.
template <class Scalar>
Compound<Scalar, 3> sword() {
  const auto part = [](const Vec3<double>& a, const Vec3<double>& b, double radius) {
    return CapsulePart<Scalar>{{{a.cast<Scalar>(), b.cast<Scalar>()}, Scalar(radius)}, 7850};
  };
  return make_compound<Scalar>(
             {part({0, 0, 0}, {0, 0, 0.9}, 0.005), part({-0.1, 0, 0}, {0.1, 0, 0}, 0.006),
              part({0, 0, -0.15}, {0, 0, -0.12}, 0.015)},
             {})
      .value;
}

inline Vec3<double> moments_of_sword() {
  return sword<double>().body.inverse_moments.cwiseInverse();
}

}  // namespace batuta::laws
