// SPDX-License-Identifier: MIT
#include "oracle.hpp"

#include <algorithm>
#include <cmath>

namespace batuta::fuzz {
namespace {

/// Where on the axis the point nearest to `point` is, 0 ... 1.
double place_on(const RealAxis& axis, const Real3& point) {
  const Real3 d = axis.b - axis.a;
  const double dd = d.squaredNorm();
  return dd > 0 ? std::clamp((point - axis.a).dot(d) / dd, 0.0, 1.0) : 0.0;
}

RealFrame going_with(const MovingCapsule<float>& moving) {
  return {moving.motion.X_WB.p_W.cast<double>(), moving.motion.twist.v_W.cast<double>()};
}

}  // namespace

RealAxis real(const Segment<float>& segment) {
  return {segment.a.cast<double>(), segment.b.cast<double>()};
}

Real3 point_at(const RealAxis& axis, double s) {
  const bool nearer_b = s > 0.5;
  return (nearer_b ? axis.b : axis.a) + (nearer_b ? s - 1 : s) * (axis.b - axis.a);
}

double distance_to(const RealAxis& axis, const Real3& point) {
  return (point_at(axis, place_on(axis, point)) - point).norm();
}

double least_distance(const RealAxis& A, const RealAxis& B) {
  const double least = std::min(
      {distance_to(A, B.a), distance_to(A, B.b), distance_to(B, A.a), distance_to(B, A.b)});
  const Real3 d_B = B.b - B.a;
  const Real3 n = (A.b - A.a).cross(d_B);
  const double nn = n.squaredNorm();
  if (!(nn > 0)) return least;
  const double s = std::clamp((B.a - A.a).cross(d_B).dot(n) / nn, 0.0, 1.0);
  const Real3 on_B = point_at(B, place_on(B, point_at(A, s)));
  return std::min(least, distance_to(A, on_B));
}

double visible_length(const RealAxis& A, const RealAxis& B) {
  return std::max({(A.b - A.a).norm(), (B.b - B.a).norm(), (B.a - A.a).norm(), (B.b - A.b).norm()});
}

RealPath::RealPath(const MovingCapsule<float>& moving, const RealFrame& from) {
  const Pose<float>& X = moving.motion.X_WB;
  const Eigen::Quaterniond q = X.q_WB.cast<double>().normalized();
  const Real3 center = X.p_W.cast<double>() - from.p;
  const Real3 w = moving.motion.twist.w_W.cast<double>();
  rate_ = w.norm();
  v_ = moving.motion.twist.v_W.cast<double>() - from.v;
  radius_ = static_cast<double>(moving.capsule_B.radius);
  const auto end_of = [&](const Vec3<float>& end_B) -> End {
    const Real3 lever = q * end_B.cast<double>();
    if (!(rate_ > 0)) return {center + lever, Real3::Zero(), Real3::Zero()};
    const Real3 k = w / rate_;
    const Real3 along = k * k.dot(lever);
    return {center + along, lever - along, k.cross(lever)};
  };
  a_ = end_of(moving.capsule_B.axis.a);
  b_ = end_of(moving.capsule_B.axis.b);
}

RealAxis RealPath::at(double t) const {
  const double cos = std::cos(rate_ * t);
  const double sin = std::sin(rate_ * t);
  return {a_.start + t * v_ + cos * a_.arm + sin * a_.side,
          b_.start + t * v_ + cos * b_.arm + sin * b_.side};
}

double RealPath::lengths(double t) const {
  return a_.start.norm() + b_.start.norm() + a_.arm.norm() + b_.arm.norm() + v_.norm() * t +
         radius_;
}

RealPair::RealPair(const MovingCapsule<float>& A, const MovingCapsule<float>& B)
    : A_(A, going_with(B)), B_(B, going_with(B)) {}

double RealPair::gap(double t) const {
  return least_distance(A_.at(t), B_.at(t)) - (A_.radius() + B_.radius());
}

double RealPair::least_gap(double end) const {
  constexpr int kSamples = 16;
  constexpr int kRounds = 12;
  double best = 0;
  double least = gap(0);
  const auto look = [&](double t) {
    const double found = gap(t);
    if (!(found < least)) return;
    least = found;
    best = t;
  };
  for (int i = 1; i <= kSamples; ++i) look(end * i / kSamples);  // Bound: kSamples
  double step = end / kSamples;
  for (int i = 0; i < kRounds; ++i) {  // Bound: kRounds
    step /= 2;
    look(std::max(best - step, 0.0));
    look(std::min(best + step, end));
  }
  return least;
}

}  // namespace batuta::fuzz
