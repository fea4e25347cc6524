// SPDX-License-Identifier: MIT
#pragma once
// Distances and poses in double from float inputs, by means that share nothing with the library:
// textbook formulas and libm. Errors are a few units of 2^-53 over the lengths of the query, 2^29
// times below those of float; a distance is one of two points of the axes, so never too short by
// more than that. Compiled without sanitizers and without coverage: it is no part of what is
// searched, and most of the time.

#include "batuta/detection/moving_pair.hpp"

namespace batuta::fuzz {

using Real3 = Eigen::Vector3d;

struct RealAxis {
  Real3 a;
  Real3 b;
};

RealAxis real(const Segment<float>& segment);
/// s in [0, 1]
Real3 point_at(const RealAxis& axis, double s);
double distance_to(const RealAxis& axis, const Real3& point);
/// The least of four ends against the other axis, and of where the lines cross, there and back.
double least_distance(const RealAxis& A, const RealAxis& B);
/// S of the error bounds of a distance (src/geometry/segment.md).
double visible_length(const RealAxis& A, const RealAxis& B);

/// Where a frame starts in W, and how fast it goes on.
struct RealFrame {
  Real3 p = Real3::Zero();
  Real3 v = Real3::Zero();
};

/// A capsule on its way, seen from a frame: its axis ends as centre + v t + along + cos(rate t) arm
/// + sin(rate t) side.
class RealPath {
 public:
  explicit RealPath(const MovingCapsule<float>& moving, const RealFrame& from = {});
  RealAxis at(double t) const;
  double radius() const { return radius_; }
  /// |centre| + reach + radius + |v| t: the lengths that at(t) is rounded over.
  double lengths(double t) const;

 private:
  struct End {
    Real3 start, arm, side;
  };
  End a_, b_;
  Real3 v_;
  double rate_ = 0;
  double radius_ = 0;
};

/// Both seen from a frame that goes with B: a pair that travels far together is rounded by no more
/// than one that stays.
class RealPair {
 public:
  RealPair(const MovingCapsule<float>& A, const MovingCapsule<float>& B);
  double gap(double t) const;
  /// The least gap that samples over [0, end] and halvings about the best of them find.
  double least_gap(double end) const;

 private:
  RealPath A_;
  RealPath B_;
};

}  // namespace batuta::fuzz
