// SPDX-License-Identifier: MIT
#pragma once
// Truth about two moving capsules, for tests and reports. It shares no formula with the library's
// searches but the definition of the question: a pose is c + v t, exp(w t) q by Rodrigues' formula,
// the distance of two axes is the least over all candidates, and a claim "free" is proven by the
// plain march of a fixed normal with an acceleration bound, or attacked by sampling.
//
// Real is double (fast) or long double (to judge what happens within the rounding of double).

#include <array>
#include <cstdint>

#include "batuta/detection/moving_pair.hpp"

namespace batuta::test {

/// A capsule in motion, seen from A's centre of mass.
template <class Real>
struct MovingAxis {
  Vec3<Real> center = Vec3<Real>::Zero();     ///< at t = 0, m
  Vec3<Real> v = Vec3<Real>::Zero();          ///< m/s
  Vec3<Real> spin_axis = Vec3<Real>::Zero();  ///< unit, or zero
  Real turn_rate = 0;                         ///< rad/s
  std::array<Vec3<Real>, 2> levers;           ///< ends from the centre at t = 0, m
  Real radius = 0;                            ///< m
};

/// What sampling found.
template <class Real>
struct LeastGap {
  Real gap = 0;  ///< m; occurs at t, so it is an upper bound of the truth
  Real t = 0;    ///< s
};

enum class Verdict : std::uint8_t {
  kFree,     ///< proven: gap > 0 on all of [0, duration]
  kReached,  ///< proven free on [0, t_free], and the gap at t_free is at most the contact tolerance
  kUnknown,  ///< proven free on [0, t_free]; the evaluations did not suffice for more
};

template <class Real>
struct March {
  Verdict verdict = Verdict::kUnknown;
  Real t_free = 0;                ///< s
  std::uint32_t evaluations = 0;  ///< distance evaluations
};

template <class Real>
class Reference {
 public:
  /// The inputs as they are, but for the quaternions, which are made unit in Real.
  /// @pre equal durations, finite
  template <class Scalar>
  Reference(const MovingCapsule<Scalar>& A, const MovingCapsule<Scalar>& B);

  Real duration() const { return duration_; }
  /// S: distance of the centres + relative travel + bounding radii + radii, m.
  Real scale() const { return scale_; }
  /// What gap() may be wrong by, m: 32 u S (1 + turn).
  Real rounding() const { return rounding_; }
  /// Upper bound of |d gap / dt|, m/s.
  Real speed() const { return speed_; }

  /// Distance of the axes less the radii, m.
  Real gap(Real t) const;

  /// Tries to find overlap in [t0, t1]: equal samples, and golden sections about every sampled
  /// minimum that can be below the best. @pre samples >= 2
  /// Bound: samples + 1 evaluations, kSections more for each minimum.
  LeastGap<Real> least_gap(Real t0, Real t1, int samples) const;

  /// The same, but denser and denser towards t0: for an overlap that is known to begin there, if
  /// there is one, and may be brief.
  LeastGap<Real> least_gap_after(Real t0, Real t1, int samples) const;
  LeastGap<Real> least_gap_after(Real t0, int samples) const {
    return least_gap_after(t0, duration_, samples);
  }

  /// Proves the pair free step by step. @pre contact tolerance >= 2 rounding()
  /// Bound: max_evaluations.
  March<Real> march(Real contact_tolerance, std::uint32_t max_evaluations = kAmple) const {
    return march(contact_tolerance, Real(0), duration_, max_evaluations);
  }
  /// The same for [t0, t1]: kFree has t_free = t1, and nothing is said of [0, t0).
  March<Real> march(Real contact_tolerance, Real t0, Real t1,
                    std::uint32_t max_evaluations = kAmple) const;

  static constexpr std::uint32_t kAmple = 100'000;
  static constexpr int kSections = 48;  ///< golden sections: 0.618^48 = 1e-10 of two samples

 private:
  struct Ends {
    std::array<Vec3<Real>, 2> at;
    std::array<Vec3<Real>, 2> velocity;
  };
  struct Look {
    Real gap = 0;
    Real step = 0;  ///< surely free for so long
  };
  Ends ends_at(const MovingAxis<Real>& body, Real t) const;
  LeastGap<Real> section(Real low, Real high) const;
  Look look(Real t) const;

  MovingAxis<Real> A_;
  MovingAxis<Real> B_;
  Real duration_ = 0;
  Real scale_ = 0;
  Real speed_ = 0;
  std::array<Real, 4> bend_{};  ///< largest acceleration of A's two ends and of B's
  Real rounding_ = 0;
};

/// The points of two segments that are nearest to each other.
template <class Real>
struct NearestPoints {
  Vec3<Real> on_A = Vec3<Real>::Zero();
  Vec3<Real> on_B = Vec3<Real>::Zero();
  Real distance = 0;
};

/// @param A, B  the two ends of each segment; they may coincide
template <class Real>
NearestPoints<Real> nearest_points(const std::array<Vec3<Real>, 2>& A,
                                   const std::array<Vec3<Real>, 2>& B);

}  // namespace batuta::test
