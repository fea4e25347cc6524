// SPDX-License-Identifier: MIT
#include "reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace batuta::test {

namespace {

template <class Real>
using Ends2 = std::array<Vec3<Real>, 2>;

/// Rodrigues' formula without the cancellation of 1 - cos.
template <class Real>
Vec3<Real> turned(const Vec3<Real>& v, const Vec3<Real>& axis, Real angle) {
  const Vec3<Real> side = axis.cross(v);
  const Real half = std::sin(angle / 2);
  return v + std::sin(angle) * side + (2 * half * half) * axis.cross(side);
}

template <class Real, class Scalar>
Vec3<Real> rotated(const Quat<Scalar>& q, const Vec3<Scalar>& v) {
  const Quat<Real> wide = q.template cast<Real>().normalized();
  const Vec3<Real> across = 2 * wide.vec().cross(v.template cast<Real>());
  return v.template cast<Real>() + wide.w() * across + wide.vec().cross(across);
}

template <class Real, class Scalar>
MovingAxis<Real> moving_axis(const MovingCapsule<Scalar>& moving, const Motion<Scalar>& origin) {
  const Motion<Scalar>& motion = moving.motion;
  MovingAxis<Real> body;
  body.center = motion.X_WB.p_W.template cast<Real>() - origin.X_WB.p_W.template cast<Real>();
  body.v = motion.twist.v_W.template cast<Real>() - origin.twist.v_W.template cast<Real>();
  const Vec3<Real> w = motion.twist.w_W.template cast<Real>();
  body.turn_rate = w.stableNorm();
  if (body.turn_rate > 0) body.spin_axis = w / body.turn_rate;
  body.levers = {rotated<Real>(motion.X_WB.q_WB, moving.capsule_B.axis.a),
                 rotated<Real>(motion.X_WB.q_WB, moving.capsule_B.axis.b)};
  body.radius = static_cast<Real>(moving.capsule_B.radius);
  return body;
}

/// How far an end is from the axis that it turns about.
template <class Real>
Real arm(const MovingAxis<Real>& body, std::size_t end) {
  return body.spin_axis.cross(body.levers[end]).norm();
}
template <class Real>
Real longest_arm(const MovingAxis<Real>& body) {
  return std::max(arm(body, 0), arm(body, 1));
}
template <class Real>
Real reach(const MovingAxis<Real>& body) {
  return std::max(body.levers[0].norm(), body.levers[1].norm());
}

template <class Real>
Real along(const Ends2<Real>& segment, const Vec3<Real>& point) {
  const Vec3<Real> d = segment[1] - segment[0];
  const Real square = d.squaredNorm();
  if (!(square > 0)) return Real(0);
  return std::clamp(d.dot(point - segment[0]) / square, Real(0), Real(1));
}

template <class Real>
void keep_nearer(NearestPoints<Real>& best, const Vec3<Real>& on_A, const Vec3<Real>& on_B) {
  const Real distance = (on_B - on_A).norm();
  if (distance < best.distance) best = {on_A, on_B, distance};
}

template <class Real>
Vec3<Real> point_at(const Ends2<Real>& segment, Real s) {
  return segment[0] + s * (segment[1] - segment[0]);
}

/// The time after which a parabola f0 + f1 h - M h^2 / 2 that is positive at 0 first is not.
template <class Real>
Real first_root(Real f0, Real f1, Real M) {
  const Real root = std::sqrt(f1 * f1 + 2 * M * f0);
  if (f1 < 0) return 2 * f0 / (root - f1);
  return M > 0 ? (f1 + root) / M : std::numeric_limits<Real>::max();
}

}  // namespace

template <class Real>
NearestPoints<Real> nearest_points(const Ends2<Real>& A, const Ends2<Real>& B) {
  NearestPoints<Real> best;
  best.distance = std::numeric_limits<Real>::max();
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: two ends
    keep_nearer<Real>(best, A[i], point_at(B, along(B, A[i])));
    keep_nearer<Real>(best, point_at(A, along(A, B[i])), B[i]);
  }
  const Vec3<Real> d_A = A[1] - A[0];
  const Vec3<Real> d_B = B[1] - B[0];
  const Vec3<Real> across = d_A.cross(d_B);
  const Real square = across.squaredNorm();
  if (!(square > 0)) return best;
  // Wherever the division lands, the points found are points of the segments.
  const Real s = std::clamp((B[0] - A[0]).cross(d_B).dot(across) / square, Real(0), Real(1));
  const Vec3<Real> on_B = point_at(B, along(B, point_at(A, s)));
  keep_nearer<Real>(best, point_at(A, along(A, on_B)), on_B);
  return best;
}

template <class Real>
template <class Scalar>
Reference<Real>::Reference(const MovingCapsule<Scalar>& A, const MovingCapsule<Scalar>& B)
    : A_(moving_axis<Real>(A, A.motion)),
      B_(moving_axis<Real>(B, A.motion)),
      duration_(static_cast<Real>(A.motion.duration)) {
  const Real v = B_.v.norm();
  const Real rates = A_.turn_rate + B_.turn_rate;
  scale_ = B_.center.norm() + v * duration_ + reach(A_) + reach(B_) + A_.radius + B_.radius;
  speed_ = v + A_.turn_rate * longest_arm(A_) + B_.turn_rate * longest_arm(B_);
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: two ends
    bend_[i] = A_.turn_rate * A_.turn_rate * arm(A_, i);
    bend_[2 + i] = B_.turn_rate * B_.turn_rate * arm(B_, i);
  }
  rounding_ = 16 * std::numeric_limits<Real>::epsilon() * scale_ * (1 + rates * duration_);
}

template <class Real>
typename Reference<Real>::Ends Reference<Real>::ends_at(const MovingAxis<Real>& body,
                                                        Real t) const {
  Ends ends;
  for (std::size_t i = 0; i < 2; ++i) {  // Bound: two ends
    const Vec3<Real> lever = body.turn_rate > 0
                                 ? turned<Real>(body.levers[i], body.spin_axis, body.turn_rate * t)
                                 : body.levers[i];
    ends.at[i] = body.center + body.v * t + lever;
    ends.velocity[i] = body.v + body.turn_rate * body.spin_axis.cross(lever);
  }
  return ends;
}

template <class Real>
Real Reference<Real>::gap(Real t) const {
  const Real distance = nearest_points<Real>(ends_at(A_, t).at, ends_at(B_, t).at).distance;
  return distance - (A_.radius + B_.radius);
}

template <class Real>
LeastGap<Real> Reference<Real>::section(Real low, Real high) const {
  const Real golden = (std::sqrt(Real(5)) - 1) / 2;
  Real left = high - golden * (high - low);
  Real right = low + golden * (high - low);
  Real at_left = gap(left);
  Real at_right = gap(right);
  for (int i = 0; i < kSections; ++i) {  // Bound: kSections
    if (at_left <= at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - golden * (high - low);
      at_left = gap(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + golden * (high - low);
      at_right = gap(right);
    }
  }
  return at_left <= at_right ? LeastGap<Real>{at_left, left} : LeastGap<Real>{at_right, right};
}

namespace {

/// The first where both are alike.
template <class Real>
LeastGap<Real> lesser(const LeastGap<Real>& a, const LeastGap<Real>& b) {
  return b.gap < a.gap ? b : a;
}

}  // namespace

template <class Real>
LeastGap<Real> Reference<Real>::least_gap(Real t0, Real t1, int samples) const {
  const auto n = static_cast<std::size_t>(samples);
  const Real step = (t1 - t0) / static_cast<Real>(samples);
  std::vector<Real> gaps(n + 1);
  LeastGap<Real> best{std::numeric_limits<Real>::max(), t0};
  for (std::size_t i = 0; i <= n; ++i) {  // Bound: samples + 1
    const Real t = i == n ? t1 : t0 + static_cast<Real>(i) * step;
    gaps[i] = gap(t);
    best = lesser(best, {gaps[i], t});
  }
  for (std::size_t i = 0; i <= n; ++i) {  // Bound: samples + 1
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = i == n ? n : i + 1;
    const bool least = gaps[i] <= gaps[before] && gaps[i] <= gaps[after];
    if (!least || gaps[i] - speed_ * step > best.gap) continue;
    best = lesser(best, section(t0 + static_cast<Real>(before) * step,
                                std::min(t1, t0 + static_cast<Real>(after) * step)));
  }
  return best;
}

template <class Real>
LeastGap<Real> Reference<Real>::least_gap_after(Real t0, Real t1, int samples) const {
  LeastGap<Real> best = least_gap(t0, t1, samples);
  Real width = t1 - t0;
  for (int zoom = 0; zoom < 8; ++zoom) {  // Bound: 8 zooms, to 2^-32 of what is left
    width /= 16;
    const LeastGap<Real> found = least_gap(t0, t0 + width, samples);
    best = lesser(best, found);
  }
  return best;
}

/// No overlap in [t, t + step]: every end of B stays on its side of the plane that today's normal
/// stands on, seen from every end of A.
template <class Real>
typename Reference<Real>::Look Reference<Real>::look(Real t) const {
  const Ends A = ends_at(A_, t);
  const Ends B = ends_at(B_, t);
  const Real R = A_.radius + B_.radius;
  const NearestPoints<Real> nearest = nearest_points<Real>(A.at, B.at);
  const Real margin = nearest.distance - R - rounding_;
  if (!(margin > 0)) return {nearest.distance - R, 0};
  const Vec3<Real> normal = (nearest.on_B - nearest.on_A) / nearest.distance;
  Real step = std::numeric_limits<Real>::max();
  for (std::size_t i = 0; i < 2; ++i) {    // Bound: two ends of A
    for (std::size_t j = 0; j < 2; ++j) {  // Bound: two ends of B
      const Real f0 = normal.dot(B.at[j] - A.at[i]) - R - rounding_;
      const Real f1 = normal.dot(B.velocity[j] - A.velocity[i]);
      step = std::min(step, first_root<Real>(std::max(f0, Real(0)), f1, bend_[i] + bend_[2 + j]));
    }
  }
  // Rounding of the normal can spoil the planes, never the plain speed bound.
  return {nearest.distance - R, std::max(step, speed_ > 0 ? margin / speed_ : step)};
}

template <class Real>
March<Real> Reference<Real>::march(Real contact_tolerance, Real t0, Real t1,
                                   std::uint32_t max_evaluations) const {
  March<Real> answer;
  answer.t_free = t0;
  while (answer.evaluations < max_evaluations) {  // Bound: max_evaluations
    ++answer.evaluations;
    const Look now = look(answer.t_free);
    if (now.gap <= contact_tolerance) {
      answer.verdict = Verdict::kReached;
      return answer;
    }
    const Real next = answer.t_free + now.step;
    if (next >= t1) return {Verdict::kFree, t1, answer.evaluations};
    if (!(next > answer.t_free)) return answer;
    answer.t_free = next;
  }
  return answer;
}

template class Reference<double>;
template class Reference<long double>;
template Reference<double>::Reference(const MovingCapsule<float>&, const MovingCapsule<float>&);
template Reference<double>::Reference(const MovingCapsule<double>&, const MovingCapsule<double>&);
template Reference<long double>::Reference(const MovingCapsule<float>&,
                                           const MovingCapsule<float>&);
template Reference<long double>::Reference(const MovingCapsule<double>&,
                                           const MovingCapsule<double>&);
template NearestPoints<double> nearest_points(const Ends2<double>&, const Ends2<double>&);
template NearestPoints<long double> nearest_points(const Ends2<long double>&,
                                                   const Ends2<long double>&);

}  // namespace batuta::test
