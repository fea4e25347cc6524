// SPDX-License-Identifier: MIT
#pragma once
// One contact of two bodies that have little in common: masses up to 1e9 apart, moments up to 1e6,
// any restitution, friction up to 1e6. And what must hold after it, with the rounding that the
// notes of the kernels allow (src/response/impulse.md, friction.md), and the worst of it seen.

#include <algorithm>
#include <cmath>

#include "batuta/response/friction.hpp"
#include "batuta/response/separation.hpp"
#include "draws.hpp"

namespace batuta::test {

/// Two bodies about to meet, drawn by number.
template <class S>
struct StiffBlow {
  Collider<S> A;
  Collider<S> B;
  Contact<S> contact;
  FrictionLaw<S> law;
};

/// Ends of the ranges come as often as anything between.
inline double drawn_power(Draws& draw, double low, double high) {
  const double at = draw.unit();
  return std::pow(10, low + (high - low) * (at < 0.1 ? 0 : at > 0.9 ? 1 : at));
}

/// @param mass  kg. Moments of a body of about 1 m, apart by up to `anisotropy`
template <class S>
Collider<S> stiff_body(Draws& draw, double mass, double anisotropy) {
  Collider<S> body;
  body.X_WB.p_W = draw.in_ball(1).cast<S>();
  body.X_WB.q_WB = renewed(Quat<S>(draw.rotation().cast<S>()));
  body.twist.v_W = draw.in_ball(drawn_power(draw, -3, 3)).cast<S>();
  body.twist.w_W = draw.in_ball(drawn_power(draw, -3, 3)).cast<S>();
  body.inverse_mass = static_cast<S>(1 / mass);
  const double largest = mass * drawn_power(draw, -2, 0);
  // Two are alike, or one is the sum of the others, or anything between.
  const double least = largest / anisotropy;
  const double middle = least + draw.unit() * (largest - least);
  const Vec3<double> moments(least, draw.chance(0.3) ? largest : middle, largest);
  for (int i = 0; i < 3; ++i) body.inverse_moments(i) = static_cast<S>(1 / moments(i));
  return body;
}

/// @param ratio  of the masses, 1e-9 ... 1e9
template <class S>
StiffBlow<S> stiff_blow(std::uint64_t number, double ratio) {
  Draws draw(6, 2, number);
  StiffBlow<S> blow;
  const double mass = drawn_power(draw, -3, 3);
  blow.A = stiff_body<S>(draw, mass, drawn_power(draw, 0, 6));
  blow.B = stiff_body<S>(draw, mass * ratio, drawn_power(draw, 0, 6));
  if (draw.chance(0.05)) {  // against a wall
    blow.B.inverse_mass = 0;
    blow.B.inverse_moments.setZero();
    blow.B.twist = {};
  }
  blow.contact.point_W = draw.in_ball(1).cast<S>();
  blow.contact.normal_BA_W = draw.direction().cast<S>();
  blow.contact.gap = static_cast<S>(1e-4 * draw.signed_unit());
  blow.law.restitution = static_cast<S>(clamp(1.2 * draw.unit() - 0.1, 0.0, 1.0));
  blow.law.friction = draw.chance(0.3) ? S(0) : static_cast<S>(drawn_power(draw, -6, 6));
  blow.law.tangential = draw.chance(0.5) ? S(0) : static_cast<S>(draw.signed_unit());
  return blow;
}

using Wide = Vec3<long double>;

template <class S>
Wide wide(const Vec3<S>& v) {
  return v.template cast<long double>();
}

/// R d R^T x without a rounding that shows.
template <class S>
Wide turned_by(const Quat<S>& q, const Wide& diagonal, const Wide& x) {
  const Eigen::Matrix<long double, 3, 3> R =
      q.template cast<long double>().normalized().toRotationMatrix();
  return R * diagonal.cwiseProduct(Wide(R.transpose() * x));
}

/// What a blow does to one body, in long double, from what the kernel answered.
struct Side {
  long double energy_before = 0;
  long double energy_after = 0;
  long double size = 0;  ///< J: what the rounding of the energies is measured by
};

template <class S>
Side side_of(const Collider<S>& body, const Twist<S>& after, const Momentum<S>& push) {
  Side side;
  if (!(body.inverse_mass > S(0))) return side;
  const long double mass = 1 / static_cast<long double>(body.inverse_mass);
  const Wide moments = wide(body.inverse_moments).cwiseInverse();
  const auto energy = [&](const Twist<S>& twist) {
    const Wide w = wide(twist.w_W);
    return (mass * wide(twist.v_W).squaredNorm() + w.dot(turned_by(body.X_WB.q_WB, moments, w))) /
           2;
  };
  side.energy_before = energy(body.twist);
  side.energy_after = energy(after);
  const long double v = std::max(wide(body.twist.v_W).norm(), wide(after.v_W).norm());
  const long double w = std::max(wide(body.twist.w_W).norm(), wide(after.w_W).norm());
  // The rotation into W is off by up to 12 u, which puts as much of a change of spin about a soft
  // axis into a stiff one (friction.md).
  const long double spun = Wide(wide(after.w_W) - wide(body.twist.w_W)).norm();
  side.size = mass * v * v + moments.maxCoeff() * w * (w + 3 * spun) +
              v * wide(push.linear_W).norm() + w * wide(push.angular_W).norm();
  return side;
}

/// What was seen of a blow, or the worst of many.
struct StiffError {
  double energy = 0;  ///< gain of both bodies together, in u times the size that friction.md states
  double share = 0;   ///< the same over the energy before
  double linear = 0;  ///< of the sum of momenta as a world keeps them, in ulp of its largest term
  double angular = 0;      ///< the same about the origin
  bool finite = true;      ///< the answer is of numbers
  bool took_part = false;  ///< there was an impulse

  void merge(const StiffError& other) {
    energy = std::max(energy, other.energy);
    share = std::max(share, other.share);
    linear = std::max(linear, other.linear);
    angular = std::max(angular, other.angular);
    finite = finite && other.finite;
    took_part = took_part || other.took_part;
  }
};

/// Momenta as a world keeps them: p += J, b += r x J, in S; and what became of their sums.
template <class S>
void judge_momenta(const StiffBlow<S>& blow, const Impulse<S>& hit, StiffError& error) {
  struct Kept {
    Wide before, after, spin_before, spin_after, lever;
  };
  long double largest_p = 0;
  long double largest_b = 0;
  const auto kept = [&](const Collider<S>& body, const Momentum<S>& push) {
    const Body<S> whole{body.X_WB, {}, body.inverse_mass, body.inverse_moments, false};
    const Momentum<S> before = momentum_of(whole, body.twist);
    const Momentum<S> after{before.linear_W + push.linear_W, before.angular_W + push.angular_W};
    const Kept k{wide(before.linear_W), wide(after.linear_W), wide(before.angular_W),
                 wide(after.angular_W), wide(body.X_WB.p_W)};
    largest_p = std::max({largest_p, k.before.norm(), k.after.norm()});
    // r x J may be small because r and J are along each other; it is rounded as |r| |J| is.
    const long double arm = (wide(blow.contact.point_W) - k.lever).norm();
    largest_b = std::max({largest_b, k.spin_before.norm(), k.spin_after.norm(),
                          k.lever.norm() * k.before.norm(), k.lever.norm() * k.after.norm(),
                          (arm + k.lever.norm()) * wide(push.linear_W).norm()});
    return k;
  };
  const Kept A = kept(blow.A, hit.on_A);
  const Kept B = kept(blow.B, hit.on_B);
  if (!(blow.B.inverse_mass > S(0))) return;  // a wall takes whatever comes
  const Wide linear = A.after + B.after - A.before - B.before;
  const Wide angular = A.spin_after + A.lever.cross(A.after) + B.spin_after +
                       B.lever.cross(B.after) - A.spin_before - A.lever.cross(A.before) -
                       B.spin_before - B.lever.cross(B.before);
  const auto ulps = [](const Wide& lost, long double largest) {
    const auto u = static_cast<long double>(kRoundOff<S>);
    return largest > 0 ? static_cast<double>(lost.norm() / (2 * u * largest)) : 0.0;
  };
  error.linear = ulps(linear, largest_p);
  error.angular = ulps(angular, largest_b);
}

/// Asks for the blow and holds the answer against what the notes promise.
template <class S>
StiffError judge(const StiffBlow<S>& blow) {
  StiffError error;
  const auto hit = friction_impulse(blow.A, blow.B, blow.contact, blow.law);
  const Impulse<S>& made = hit.value;
  error.finite = hit.ok() && is_finite(made.magnitude) && is_finite(made.twist_A.v_W) &&
                 is_finite(made.twist_A.w_W) && is_finite(made.twist_B.v_W) &&
                 is_finite(made.twist_B.w_W);
  error.took_part = made.magnitude > S(0);
  if (!error.finite || !error.took_part) return error;
  const Side A = side_of(blow.A, made.twist_A, made.on_A);
  const Side B = side_of(blow.B, made.twist_B, made.on_B);
  const long double gain = (A.energy_after - A.energy_before) + (B.energy_after - B.energy_before);
  error.energy =
      static_cast<double>(gain / (static_cast<long double>(kRoundOff<S>) * (A.size + B.size)));
  error.share = static_cast<double>(gain / (A.energy_before + B.energy_before));
  judge_momenta(blow, made, error);
  return error;
}

/// The same contact as a resting one: to D, and no further.
template <class S>
bool separates_to_distance(const StiffBlow<S>& blow) {
  SeparationOptions<S> options;
  options.distance = S(2e-4);
  options.rest_speed = S(0.01);
  options.min_duration = S(1e-4);
  const auto made =
      separate(blow.contact, S(-0.005), blow.A.inverse_mass, blow.B.inverse_mass, options);
  if (!made.ok()) return false;
  const Separation<S>& s = made.value;
  const S opened = blow.contact.normal_BA_W.dot(s.shift_A_W - s.shift_B_W);
  const S missing = max_of(S(0), options.distance - blow.contact.gap);
  return std::abs(opened - missing) <= 16 * kRoundOff<S> * missing && s.duration > S(0);
}

}  // namespace batuta::test
