// SPDX-License-Identifier: MIT
#include "shared/simulated/transition.hpp"

namespace batuta::port_simulated {
namespace {

using Square = Eigen::Matrix<double, 4, 4>;

constexpr int kTerms = 16;  // the next one is 2^-16 / 16! < 1e-18
constexpr int kMostSquarings = 40;
constexpr double kSmall = 0.5;

/// exp(A).
Square exponential(Square A) {
  int squarings = 0;
  double size = A.cwiseAbs().rowwise().sum().maxCoeff();
  while (size > kSmall && squarings < kMostSquarings) {  // Bound: kMostSquarings
    size /= 2;
    ++squarings;
  }
  A *= 1.0 / static_cast<double>(1ULL << static_cast<unsigned>(squarings));
  Square term = Square::Identity();
  Square sum = Square::Identity();
  for (int i = 1; i < kTerms; ++i) {  // Bound: kTerms
    term = (term * A / i).eval();
    sum += term;
  }
  for (int i = 0; i < squarings; ++i) sum = (sum * sum).eval();  // Bound: kMostSquarings
  return sum;
}

}  // namespace

Eigen::Matrix<double, 2, 4> transition_of(const Oscillator& oscillator, double span) {
  // In spans of time and with u over M every entry has the unit of q: the series is well scaled.
  Square A = Square::Zero();
  A(0, 1) = 1;
  A(1, 0) = -oscillator.stiffness / oscillator.mass * span * span;
  A(1, 1) = -oscillator.damping / oscillator.mass * span;
  A(1, 2) = 1;
  A(2, 3) = 1;
  const Square E = exponential(A);
  const double push = span * span / oscillator.mass;
  const Eigen::RowVector4d unit(1, span, push, push * span);
  Eigen::Matrix<double, 2, 4> result;
  result.row(0) = E.row(0).cwiseProduct(unit);
  result.row(1) = E.row(1).cwiseProduct(unit) / span;
  return result;
}

}  // namespace batuta::port_simulated
