// SPDX-License-Identifier: MIT
#pragma once
// The same loops as in sampled_loop.hpp as matrices, from closed forms that owe nothing to the
// simulation: stable where the spectral radius is below 1. Double.

#include <algorithm>
#include <cmath>

#include "batuta/haptics/gain_advisor.hpp"

namespace batuta::test {

inline constexpr int kMostStates = 11;                               // delays up to 4
using LoopMatrix = Eigen::Matrix<double, kMostStates, kMostStates>;  ///< unused states are zero

/// By squaring: |A^(2^i)|^(2^-i) for i = 30.
inline double spectral_radius(LoopMatrix A) {
  constexpr int kSquarings = 30;
  double log_radius = 0;
  double power = 1;
  for (int i = 0; i < kSquarings; ++i) {
    const double size = A.cwiseAbs().maxCoeff();
    if (size == 0) return 0;
    A /= size;
    log_radius += std::log(size) / power;
    A = A.lazyProduct(A).eval();
    power *= 2;
  }
  return std::exp(log_radius);
}

/// A mass on a spring to the ground, with a damper: M q'' = f - c q' - k q.
struct Mass {
  double mass = 1;
  double damping = 0;
  double stiffness = 0;
};

/// What a period does to (q, q'), and what a held force of 1 adds.
struct Held {
  Eigen::Matrix2d A;
  Eigen::Vector2d from_force;
};

/// Textbook solutions. @pre c > 0 where k is 0; below critical damping where it is not
inline Held held_period(const Mass& plant, double T) {
  const double rate = plant.damping / plant.mass;
  Held held;
  if (plant.stiffness == 0) {
    const double decay = std::exp(-rate * T);
    const double way = -std::expm1(-rate * T) / rate;
    held.A << 1, way, 0, decay;
    held.from_force << (T - way) / plant.damping, way / plant.mass;
    return held;
  }
  const double a = rate / 2;
  const double w = std::sqrt(plant.stiffness / plant.mass - a * a);
  const double decay = std::exp(-a * T);
  const double c = decay * std::cos(w * T);
  const double s = decay * std::sin(w * T) / w;
  held.A << c + a * s, s, -plant.stiffness / plant.mass * s, c - a * s;
  held.from_force << (1 - held.A(0, 0)) / plant.stiffness, s / plant.mass;
  return held;
}

/// (q, q', q before, ...) around a mass.
inline LoopMatrix loop_around(const Mass& plant, const haptics::Gains<double>& gains, double T,
                              int delay) {
  const Held held = held_period(plant, T);
  const int last = delay + 2;  // of the positions before: states 2 ...
  const auto place = [](int age) { return age == 0 ? 0 : age + 1; };
  LoopMatrix A = LoopMatrix::Zero();
  A.topLeftCorner<2, 2>() = held.A;
  const double rate = gains.damping / T;
  A.block<2, 1>(0, place(delay)) -= (gains.stiffness + rate) * held.from_force;
  A.block<2, 1>(0, place(delay + 1)) += rate * held.from_force;
  for (int i = 2; i <= last; ++i) A(i, i == 2 ? 0 : i - 1) = 1;
  return A;
}

/// A stick without mass on an elastic line with a fixed far end, from which a wave comes back
/// turned round after delay + 1 periods: the hand for which a late damper is worst. The states are
/// the speeds of the waves that went out, the latest first; everything is constant over a period,
/// so the steps are exact. The stick is where the waves in the line put it: q = T (sum of delay + 1
/// waves).
/// @param impedance  of the line, J s/u^2
inline LoopMatrix loop_around_line(double impedance, double device_damping,
                                   const haptics::Gains<double>& gains, double T, int delay) {
  using Row = Eigen::Matrix<double, 1, kMostStates>;
  const int crossing = delay + 1;
  const double rate = gains.damping / T;
  Row force = Row::Zero();
  force.segment(delay, crossing).array() -= T * (gains.stiffness + rate);
  force.segment(delay + 1, crossing).array() += T * rate;
  // Balance at the stick: force - b v = Z (out - in), v = out + in, in = -(out a crossing ago).
  LoopMatrix A = LoopMatrix::Zero();
  A.row(0) = force / (device_damping + impedance);
  A(0, delay) += (device_damping - impedance) / (device_damping + impedance);
  for (int i = 1; i < 2 * crossing; ++i) A(i, i - 1) = 1;
  return A;
}

}  // namespace batuta::test
